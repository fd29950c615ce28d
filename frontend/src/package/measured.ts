/** Every height of the package once more from its clicks, beside the package's own number. */
import type { Row } from "./csv";
import type { Pose } from "./documents";
import { type Clicked, heightOfFrames } from "./frames";
import { heightOf } from "./height";

/** Half of the last decimal that a table carries, and a hair for the last binary digit. */
const TOLERANCE_M = 0.51e-6;
const COVERAGE_95 = 1.959964;
const LENGTHS = ["height_m", "uncorrected_height_m", "x_m", "y_m", "distance_m", "solved_inset_m"] as const;

type Length = (typeof LENGTHS)[number];

export interface Again {
  /** computed in the page, null where the clicks give none */
  lengths: Readonly<Record<Length, number | null>>;
  /** why it was not computed: not in this page's power */
  refused: "pose" | "form" | null;
  /** the package's numbers that are not those of the clicks */
  differs: readonly (Length | "status" | "u95" | "budget")[];
  /** this page's height less the package's, metres */
  off_m: number | null;
}

const NOTHING = Object.fromEntries(LENGTHS.map((name) => [name, null])) as Record<Length, null>;
const number = (text: string | undefined) => (text ? Number(text) : null);

function framesOf(row: Row): Clicked[] {
  const frames: Clicked[] = [];
  for (let k = 1; ; k++) {
    const name = (word: string, axis: string) => `${word}${k === 1 ? "" : k}_${axis}_px`;
    if (!row[name("contact", "x")]) return frames;
    const point = (word: string) => [Number(row[name(word, "x")]), Number(row[name(word, "y")])] as const;
    frames.push({ contact: point("contact"), target: point("target") });
  }
}

export function computedAgain(row: Row, pose: Pose | undefined, budget: readonly number[]): Again {
  const frames = framesOf(row);
  const refused = pose === undefined ? "pose" : String(frames.length) === row["frames"] ? null : "form";
  if (pose === undefined || refused !== null) return { lengths: NOTHING, refused, differs: [], off_m: null };
  const lengths = lengthsOf(pose, frames, row);
  const differs: Again["differs"] = [
    ...((lengths.height_m === null) === (row["status"] === "ok") ? (["status"] as const) : []),
    ...LENGTHS.filter((name) => !isSame(number(row[name]), lengths[name])),
    ...sumsThatDiffer(row, budget),
  ];
  const told = number(row["height_m"]);
  const off_m = told === null || lengths.height_m === null ? null : lengths.height_m - told;
  return { lengths, refused, differs, off_m };
}

function lengthsOf(pose: Pose, frames: readonly Clicked[], row: Row): Record<Length, number | null> {
  const { contact, target } = frames[0] as Clicked;
  const inset = number(row["inset_m"]);
  const several = frames.length > 1;
  const flat = inset === null && !several ? null : heightOf(pose, contact, target, 0);
  const found = several
    ? heightOfFrames(pose, frames, Number(row["sigma_px"]))
    : inset === null
      ? null
      : heightOf(pose, contact, target, inset);
  return { ...NOTHING, ...found, uncorrected_height_m: flat?.height_m ?? null };
}

function isSame(told: number | null, found: number | null): boolean {
  return told === null || found === null ? told === found : Math.abs(told - found) <= TOLERANCE_M;
}

/** U95 is 1.96 u, and u the root of the sum of the squares of its budget. */
function sumsThatDiffer(row: Row, budget: readonly number[]): ("u95" | "budget")[] {
  const u = number(row["u_height_m"]) ?? 0;
  const sum = Math.sqrt(budget.reduce((total, part) => total + part * part, 0));
  return [
    ...(Math.abs((number(row["U95_height_m"]) ?? 0) - COVERAGE_95 * u) > 2e-6 ? (["u95"] as const) : []),
    ...(Math.abs(sum - u) > 1e-6 * Math.max(2, budget.length) ? (["budget"] as const) : []),
  ];
}
