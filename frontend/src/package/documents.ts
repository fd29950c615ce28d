/** pose.json and camera.json (docs/formats.md), as far as a height needs them. */

export interface Camera {
  readonly model: "brown" | "fisheye";
  readonly width_px: number;
  readonly height_px: number;
  readonly fx_px: number;
  readonly fy_px: number;
  readonly cx_px: number;
  readonly cy_px: number;
  readonly distortion: readonly number[];
}

export type Vector = readonly [number, number, number];

export interface Pose {
  readonly camera: Camera;
  /** rows of R: x_cam = R x_road + t */
  readonly rotation: readonly [Vector, Vector, Vector];
  readonly translation: Vector;
  /** the camera's centre on the road, C = -R' t */
  readonly centre: Vector;
}

interface PoseDocument {
  camera: Camera;
  cam_from_road: { rotation: Pose["rotation"]; translation_m: Vector };
}

/** A road pose out of its document. Throws where something is missing. */
export function poseOf(document: unknown): Pose {
  const { camera, cam_from_road: place } = document as PoseDocument;
  const { rotation, translation_m: t } = place;
  const along = (axis: 0 | 1 | 2) =>
    -(rotation[0][axis] * t[0] + rotation[1][axis] * t[1] + rotation[2][axis] * t[2]);
  return { camera, rotation, translation: t, centre: [along(0), along(1), along(2)] };
}

/** A direction of the camera frame in the road frame, R' v. */
export function onRoad({ rotation: [a, b, c] }: Pose, [x, y, z]: Vector): Vector {
  return [a[0] * x + b[0] * y + c[0] * z, a[1] * x + b[1] * y + c[1] * z, a[2] * x + b[2] * y + c[2] * z];
}
