/** From a pixel to its direction, by the lens models of CONVENTIONS.md (Lens). Written for this page alone: it shares no
 *  line with the program that measured, so that a fault of the one is not a fault of the other. */
import type { Camera } from "./documents";

export type Point = readonly [number, number];

const FARTHEST = 11.43;
const RADII = 512;
const ANGLES = 72;

/** A normalised point through the lens, and the 2x2 derivative there, which is symmetric. */
export function distorted({ model, distortion: k }: Camera, x: number, y: number) {
  const r2 = x * x + y * y;
  const [gain, slope] = model === "fisheye" ? fisheye(k, r2) : brown(k, r2);
  const [p1, p2] = model === "fisheye" ? [0, 0] : [k[2] ?? 0, k[3] ?? 0];
  return {
    x: x * gain + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
    y: y * gain + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y,
    xx: gain + 2 * slope * x * x + 2 * p1 * y + 6 * p2 * x,
    xy: 2 * slope * x * y + 2 * p1 * x + 2 * p2 * y,
    yy: gain + 2 * slope * y * y + 6 * p1 * y + 2 * p2 * x,
  };
}

/** The gain of the radial part and its derivative by r^2: Brown 1966, as a quotient where there are k4 to k6. */
function brown(k: readonly number[], r2: number): [number, number] {
  const [k1 = 0, k2 = 0, , , k3 = 0, k4 = 0, k5 = 0, k6 = 0] = k;
  const top = 1 + k1 * r2 + k2 * r2 ** 2 + k3 * r2 ** 3;
  const slope = k1 + 2 * k2 * r2 + 3 * k3 * r2 ** 2;
  const bottom = 1 + k4 * r2 + k5 * r2 ** 2 + k6 * r2 ** 3;
  const gain = top / bottom;
  return [gain, (slope - gain * (k4 + 2 * k5 * r2 + 3 * k6 * r2 ** 2)) / bottom];
}

/** Kannala and Brandt 2006: theta_d / r; a series near the axis. */
function fisheye(k: readonly number[], r2: number): [number, number] {
  const [k1 = 0, k2 = 0, k3 = 0, k4 = 0] = k;
  if (r2 < 1e-8) return [1 + (k1 - 1 / 3) * r2, k1 - 1 / 3];
  const r = Math.sqrt(r2);
  const t = Math.atan(r);
  const gain = (t + k1 * t ** 3 + k2 * t ** 5 + k3 * t ** 7 + k4 * t ** 9) / r;
  const slope = 1 + 3 * k1 * t ** 2 + 5 * k2 * t ** 4 + 7 * k3 * t ** 6 + 9 * k4 * t ** 8;
  return [gain, (slope / (1 + r2) - gain) / (2 * r2)];
}

const limits = new WeakMap<Camera, number>();

/** The largest radius up to which the lens is one-to-one in every direction, normalised. */
function limitOf(camera: Camera): number {
  const known = limits.get(camera);
  if (known !== undefined) return known;
  const found = firstFold(camera);
  limits.set(camera, found);
  return found;
}

function firstFold(camera: Camera): number {
  let [low, high] = [0, FARTHEST];
  for (let round = 0; round < 4; round++) {
    const radius = (n: number) => low + ((high - low) * n) / RADII;
    let n = 1;
    while (n <= RADII && isOneToOne(camera, radius(n))) n++;
    if (n > RADII) return high;
    [low, high] = [radius(n - 1), radius(n)];
  }
  return low;
}

function isOneToOne(camera: Camera, r: number): boolean {
  const gain = (camera.model === "fisheye" ? fisheye : brown)(camera.distortion, r * r)[0];
  if (!(gain > 0)) return false;
  for (let n = 0; n < ANGLES; n++) {
    const angle = (2 * Math.PI * n) / ANGLES;
    const d = distorted(camera, r * Math.cos(angle), r * Math.sin(angle));
    if (!(d.xx * d.yy - d.xy * d.xy > 1e-6 && d.xx + d.yy > 0 && Number.isFinite(d.x))) return false;
  }
  return true;
}

/** The direction (x/z, y/z) of a pixel; null outside the picture or where the lens gives none. */
export function direction(camera: Camera, [u, v]: Point): Point | null {
  const { width_px: width, height_px: height } = camera;
  if (!(u >= -0.5 && v >= -0.5 && u <= width - 0.5 && v <= height - 0.5)) return null;
  const wanted: Point = [(u - camera.cx_px) / camera.fx_px, (v - camera.cy_px) / camera.fy_px];
  const limit = limitOf(camera);
  let [x, y] = radialStart(camera, wanted, limit);
  let step = Number.POSITIVE_INFINITY;
  for (let round = 0; round < 40 && step > 1e-15; round++) {
    const d = distorted(camera, x, y);
    const [ex, ey] = [d.x - wanted[0], d.y - wanted[1]];
    const scale = d.xx * d.yy - d.xy * d.xy;
    const [dx, dy] = [(d.yy * ex - d.xy * ey) / scale, (d.xx * ey - d.xy * ex) / scale];
    [x, y, step] = [x - dx, y - dy, Math.max(Math.abs(dx), Math.abs(dy))];
  }
  return step <= 1e-7 && Math.hypot(x, y) <= limit ? [x, y] : null;
}

/** Where the radial part alone puts the point, by bisection: it grows up to the limit. */
function radialStart(camera: Camera, [x, y]: Point, limit: number): [number, number] {
  const wanted = Math.hypot(x, y);
  if (wanted === 0) return [0, 0];
  const gainOf = camera.model === "fisheye" ? fisheye : brown;
  let [low, high] = [0, limit];
  for (let round = 0; round < 40; round++) {
    const r = (low + high) / 2;
    if (r * gainOf(camera.distortion, r * r)[0] < wanted) low = r;
    else high = r;
  }
  return [(x * high) / wanted, (y * high) / wanted];
}
