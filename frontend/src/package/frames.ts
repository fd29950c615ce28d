/** A height from the same two points on several frames: least squares over a vehicle that travels straight and level
 *  (CONVENTIONS.md, Several frames). The unknowns: place of the first contact (2), travel to each further frame, heading,
 *  then the target ahead of the contact, inboard (the inset) and above the road. */
import type { Pose, Vector } from "./documents";
import { contactOf, rayOf } from "./height";
import { distorted, type Point } from "./lens";
import { condition, solved } from "./solving";

export interface Clicked {
  contact: Point;
  target: Point;
}

const U_HEADING = Math.PI / 180;
const LEAST_TRAVEL_M = 0.15;
const LEAST_EDGE = Math.sin(Math.PI / 180);
const ROUNDS = 100;

interface Linear {
  residual: number[];
  rows: number[][];
}

/** The height from all frames, the first one first; null where they give none. */
export function heightOfFrames(pose: Pose, frames: readonly Clicked[], sigma_px: number) {
  const start = startOf(pose, frames);
  if (start === null) return null;
  const travel = [0, ...start.slice(2, frames.length + 1)];
  if (Math.max(...travel) - Math.min(...travel) < LEAST_TRAVEL_M) return null;
  const theta = settled(pose, frames, start, Math.max(sigma_px, 1e-6));
  if (theta === null) return null;
  const [x = 0, y = 0] = theta;
  const [inset = 0, height = 0] = theta.slice(-2);
  if (!(height > 0)) return null;
  const [cx, cy, cz] = pose.centre;
  return {
    height_m: height,
    x_m: x,
    y_m: y,
    distance_m: Math.hypot(cx - x, cy - y, cz),
    solved_inset_m: inset,
  };
}

/** Contacts on the road, heading and travel from them, the target where its rays come closest on the moving vehicle. */
function startOf(pose: Pose, frames: readonly Clicked[]): number[] | null {
  const ground: Point[] = [];
  const rays: Vector[] = [];
  for (const { contact, target } of frames) {
    const at = contactOf(pose, contact);
    const ray = rayOf(pose, target);
    if (at === null || ray === null || !(Math.abs(ray[1]) > LEAST_EDGE)) return null;
    ground.push([at.x_m, at.y_m]);
    rays.push(ray);
  }
  const first = ground[0] as Point;
  const gone = ground.map(([x, y]): Point => [x - first[0], y - first[1]]);
  const far = gone.reduce((a, b) => (Math.hypot(b[0], b[1]) > Math.hypot(a[0], a[1]) ? b : a));
  const forward = far[0] < 0 ? -1 : 1;
  const heading = Math.atan2(forward * far[1], forward * far[0]);
  const [c, s] = [Math.cos(heading), Math.sin(heading)];
  const point = closest(pose, ground, rays);
  if (point === null) return null;
  const travel = gone.slice(1).map(([x, y]) => x * c + y * s);
  return [...first, ...travel, heading, c * point[0] + s * point[1], -s * point[0] + c * point[1], point[2]];
}

function closest(pose: Pose, ground: readonly Point[], rays: readonly Vector[]): Vector | null {
  const matrix = [0, 1, 2].map(() => [0, 0, 0]);
  const right = [0, 0, 0];
  rays.forEach((ray, f) => {
    const [gx, gy] = ground[f] as Point;
    const eye = [pose.centre[0] - gx, pose.centre[1] - gy, pose.centre[2]];
    for (let i = 0; i < 3; i++) {
      for (let j = 0; j < 3; j++) {
        const across = (i === j ? 1 : 0) - (ray[i] as number) * (ray[j] as number);
        (matrix[i] as number[])[j] = (matrix[i]?.[j] ?? 0) + across;
        right[i] = (right[i] as number) + across * (eye[j] as number);
      }
    }
  });
  return solved(matrix, right) as Vector | null;
}

/** The minimum by damped Gauss-Newton steps; null where there is none, or where the frames do not fix it. */
function settled(pose: Pose, frames: readonly Clicked[], start: number[], sigma: number): number[] | null {
  const at = frames.length + 1;
  const costOf = ({ residual }: Linear, theta: number[]) =>
    residual.reduce((sum, r) => sum + r * r, 0) / sigma ** 2 + ((theta[at] as number) / U_HEADING) ** 2;
  let theta = start;
  let now = linear(pose, frames, theta);
  let damping = 1e-6;
  for (let round = 0; round < ROUNDS && damping < 1e10; round++) {
    const [normal, gain] = equations(now, theta, at, sigma);
    const damped = normal.map((row, i) => row.map((value, j) => (i === j ? value * (1 + damping) : value)));
    const step = solved(damped, gain);
    if (step === null) return null;
    const next = theta.map((value, n) => value + (step[n] as number));
    const tried = linear(pose, frames, next);
    const better = costOf(tried, next) <= costOf(now, theta) + 1e-12;
    damping = better ? Math.max(0.1 * damping, 1e-14) : 10 * damping;
    if (better) [theta, now] = [next, tried];
    if (better && Math.max(...step.map(Math.abs)) < 1e-13) break;
  }
  return isSettled(now, theta, at, sigma, costOf(now, theta)) ? theta : null;
}

function isSettled(now: Linear, theta: number[], at: number, sigma: number, cost: number): boolean {
  const [normal, gain] = equations(now, theta, at, sigma);
  const scale = normal.map((row, n) => 1 / Math.sqrt(row[n] as number));
  const scaled = normal.map((row, i) =>
    row.map((value, j) => value * (scale[i] as number) * (scale[j] as number)),
  );
  const pull = gain.map((value, n) => value * (scale[n] as number));
  const step = solved(scaled, pull);
  if (step === null || !(condition(scaled) < 1e12)) return false;
  const left = Math.abs(step.reduce((sum, value, n) => sum + value * (pull[n] as number), 0));
  return left <= 1e-8 * (1 + cost);
}

function equations(
  { residual, rows }: Linear,
  theta: number[],
  at: number,
  sigma: number,
): [number[][], number[]] {
  const size = theta.length;
  const normal = Array.from({ length: size }, () => new Array<number>(size).fill(0));
  const gain = new Array<number>(size).fill(0);
  rows.forEach((row, n) => {
    for (let i = 0; i < size; i++) {
      const value = (row[i] as number) / sigma ** 2;
      gain[i] = (gain[i] as number) + value * (residual[n] as number);
      for (let j = 0; j < size; j++)
        (normal[i] as number[])[j] = (normal[i]?.[j] ?? 0) + value * (row[j] as number);
    }
  });
  const prior = 1 / U_HEADING ** 2;
  (normal[at] as number[])[at] = (normal[at]?.[at] ?? 0) + prior;
  gain[at] = (gain[at] as number) - prior * (theta[at] as number);
  return [normal, gain];
}

/** Pixels seen less those modelled, and the model's derivatives: a row a coordinate. */
function linear(pose: Pose, frames: readonly Clicked[], theta: number[]): Linear {
  const count = frames.length;
  const size = count + 5;
  const [heading = 0, ahead = 0, inset = 0, height = 0] = theta.slice(count + 1);
  const [c, s] = [Math.cos(heading), Math.sin(heading)];
  const found: Linear = { residual: [], rows: [] };
  frames.forEach(({ contact, target }, f) => {
    const gone = f === 0 ? 0 : (theta[1 + f] as number);
    const [x, y] = [(theta[0] as number) + gone * c, (theta[1] as number) + gone * s];
    const derivatives = (further: number, inward: number): Vector[] => {
      const by = Array.from({ length: size }, (): Vector => [0, 0, 0]);
      by[0] = [1, 0, 0];
      by[1] = [0, 1, 0];
      if (f > 0) by[1 + f] = [c, s, 0];
      const turn = gone + further;
      by[count + 1] = [-turn * s - inward * c, turn * c - inward * s, 0];
      return by;
    };
    const ofTarget = derivatives(ahead, inset);
    ofTarget[count + 2] = [c, s, 0];
    ofTarget[count + 3] = [-s, c, 0];
    ofTarget[count + 4] = [0, 0, 1];
    add(found, pose, [x, y, 0], derivatives(0, 0), contact);
    add(found, pose, [x + ahead * c - inset * s, y + ahead * s + inset * c, height], ofTarget, target);
  });
  return found;
}

function add(found: Linear, pose: Pose, point: Vector, by: readonly Vector[], seen: Point): void {
  const [rx, ry, rz] = pose.rotation;
  const t = pose.translation;
  const dot = (a: Vector, b: Vector) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const z = dot(rz, point) + t[2];
  const [mx, my] = [(dot(rx, point) + t[0]) / z, (dot(ry, point) + t[1]) / z];
  const { fx_px: fx, fy_px: fy, cx_px: cx, cy_px: cy } = pose.camera;
  const d = distorted(pose.camera, mx, my);
  found.residual.push(seen[0] - fx * d.x - cx, seen[1] - fy * d.y - cy);
  const [across, down]: [number[], number[]] = [[], []];
  for (const move of by) {
    const dz = dot(rz, move);
    const [dx, dy] = [(dot(rx, move) - mx * dz) / z, (dot(ry, move) - my * dz) / z];
    across.push(fx * (d.xx * dx + d.xy * dy));
    down.push(fy * (d.xy * dx + d.yy * dy));
  }
  found.rows.push(across, down);
}
