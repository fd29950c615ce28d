import type { CameraDocument, CameraView } from "../../core/types";

export type Figure = ReturnType<typeof figuresOf>[number];

const BROWN = ["k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"];
const FISHEYE = ["k1", "k2", "k3", "k4"];

/** Focal lengths, principal point and distortion, each with its standard uncertainty where the covariance tells it. */
export function figuresOf(camera: CameraDocument) {
  const sigma = (...names: string[]): number | null => {
    const at = camera.parameters.findIndex((parameter) => names.includes(parameter));
    const variance = at < 0 ? undefined : camera.covariance?.[at]?.[at];
    return variance === undefined || variance < 0 ? null : Math.sqrt(variance);
  };
  const pixels = (["fx", "fy", "cx", "cy"] as const).map((name) => ({
    name,
    value: camera[`${name}_px`],
    u: sigma(`${name}_px`, name),
    digits: 2,
    unit: "px",
  }));
  const names = camera.model === "fisheye" ? FISHEYE : BROWN;
  const bends = camera.distortion.map((value, i) => {
    const name = names[i] ?? `d${i + 1}`;
    return { name, value, u: sigma(name), digits: 5, unit: "" };
  });
  return [...pixels, ...bends];
}

/** Angle of view across the picture, degrees; for the ordinary model without distortion, good to a degree or two. */
export function angleOfView(camera: CameraDocument): number {
  const half = camera.width_px / 2 / camera.fx_px;
  return ((camera.model === "fisheye" ? 2 * half : 2 * Math.atan(half)) * 180) / Math.PI;
}

export function coveredShare(coverage: number[][]): number {
  const cells = coverage.flat();
  return cells.length === 0 ? 0 : cells.filter((count) => count > 0).length / cells.length;
}

export function worstView(views: CameraView[]): CameraView | null {
  const used = views.filter((view) => view.used && view.rms_px !== null);
  return used.reduce<CameraView | null>(
    (worst, view) => ((view.rms_px ?? 0) > (worst?.rms_px ?? -1) ? view : worst),
    null,
  );
}
