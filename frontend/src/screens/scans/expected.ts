/** A height as it will be once it is stored: its clicks, and what the server answered for them. */
import { say } from "../../core/messages";
import type { Wish } from "../../core/outbox";
import type { LineHeight, LineHeightAnswer } from "../../core/types";
import { fixed, formatHeight } from "../../core/units";
import type { Clicks, HeightAbout, HeightWanted, Inset } from "./kinds";

export type HeightWish = Wish<LineHeight, HeightWanted, HeightAbout>;

export function expected({
  about: { id, scanId, target, answer },
  saved,
  want: { clicks },
}: HeightWish): LineHeight {
  const [contact, point] = [clicks?.contact, clicks?.point];
  return {
    ...NOT_YET,
    ...saved,
    vehicle_id: id,
    scan_id: scanId,
    target,
    ...(clicks ? toldOf(clicks.inset) : {}),
    ...(contact ? { contact: [contact.line, contact.row] } : {}),
    ...(point ? { target_point: [point.line, point.row] } : {}),
    ...(clicks ? { ...NO_FIGURES, ...(answer && answer.status !== "contact" ? figuresOf(answer) : {}) } : {}),
    // the newest of its vehicle
    revision_id: Number.MAX_SAFE_INTEGER,
    older: false,
    withdrawn: clicks === null,
    // a new revision waits for a verdict, of somebody else
    mine: true,
    review: WAITS,
  };
}

/** What `insetSaid` reads back. */
function toldOf(inset: Inset | null): Partial<LineHeight> {
  const own = inset !== null && "inset_m" in inset;
  return { side: null, ...inset, inset_from: own ? "own" : "usual" };
}

const WAITS: LineHeight["review"] = {
  verdict: "to_review",
  reason: null,
  reviewer: null,
  at: null,
  lot_id: null,
};

const NO_FIGURES = {
  status: "not_measurable",
  reason: null,
  distance_m: null,
  U95_distance_m: null,
  height_m: null,
  u_height_m: null,
  U95_height_m: null,
  budget: [],
  flags: [],
} satisfies Partial<LineHeight>;

const NOT_YET = {
  ...NO_FIGURES,
  id: 0,
  revision: 0,
  line_pose_id: 0,
  code_version: "",
  sigma_px: 1,
  inset_m: 0,
  u_inset_m: 0,
  inset_from: "usual" as const,
  side: null,
  computing_id: null,
  contact: [0, 0] satisfies LineHeight["contact"],
  target_point: [0, 0] satisfies LineHeight["contact"],
  u_distance_m: null,
  created_by: null,
  created_at: "",
};

function figuresOf(answer: LineHeightAnswer): Partial<LineHeight> {
  const { status, reason, distance_m, U95_distance_m, height_m, u_height_m, U95_height_m, flags } = answer;
  if (status === "contact") return {};
  return { status, reason, distance_m, U95_distance_m, height_m, u_height_m, U95_height_m, flags };
}

/** What is wanted, in words: the height where it is known already, else the place of the click. */
export function wantedWords(answer: LineHeightAnswer | null, { point }: Clicks): string {
  if (answer?.status === "ok") return formatHeight(answer.height_m, answer.U95_height_m);
  return say("scan-wish-clicked", { line: fixed(point.line, 0), row: fixed(point.row, 0) });
}
