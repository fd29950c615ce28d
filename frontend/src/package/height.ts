/** A height from one frame: the contact's ray meets the road, the target's ray the plane of the vehicle's side
 *  (CONVENTIONS.md, Height). Written with points and planes, where the program that measured writes slopes. */
import { onRoad, type Pose, type Vector } from "./documents";
import { direction, type Point } from "./lens";

export interface Placed {
  height_m: number;
  x_m: number;
  y_m: number;
  distance_m: number;
}

const LEAST_DEPRESSION = Math.sin((0.2 * Math.PI) / 180);
const LEAST_EDGE = Math.sin(Math.PI / 180);
const LEAST_HEIGHT_M = 1e-6;

/** The unit vector of a pixel's ray in the road frame, null where there is none. */
export function rayOf(pose: Pose, pixel: Point): Vector | null {
  const seen = direction(pose.camera, pixel);
  if (seen === null) return null;
  const length = Math.hypot(seen[0], seen[1], 1);
  const [x, y, z] = onRoad(pose, [seen[0], seen[1], 1]);
  return [x / length, y / length, z / length];
}

/** Where the contact's ray meets the road, null where that is no place of a vehicle. */
export function contactOf(pose: Pose, contact: Point): Placed | null {
  const ray = rayOf(pose, contact);
  const above = pose.centre[2];
  if (ray === null || !(above > 0) || !(ray[2] < -LEAST_DEPRESSION) || !(ray[1] > LEAST_EDGE)) return null;
  const distance = -above / ray[2];
  return {
    height_m: 0,
    x_m: pose.centre[0] + distance * ray[0],
    y_m: pose.centre[1] + distance * ray[1],
    distance_m: distance,
  };
}

/** The height of the target and the place of the contact; null where the clicks give none. */
export function heightOf(pose: Pose, contact: Point, target: Point, inset: number): Placed | null {
  const at = contactOf(pose, contact);
  const ray = rayOf(pose, target);
  if (at === null || ray === null || !(Math.abs(ray[1]) > LEAST_EDGE)) return null;
  const plane = at.y_m + inset - pose.centre[1];
  const along = plane / ray[1];
  const height = pose.centre[2] + along * ray[2];
  return plane > 0 && along > 0 && height > LEAST_HEIGHT_M ? { ...at, height_m: height } : null;
}
