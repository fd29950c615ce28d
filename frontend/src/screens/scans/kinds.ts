/** How the outbox brings what is done on the strips to the server: addresses, bodies, and when two of them are the same. */
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { outbox } from "../../core/outbox";
import type { BodyOf } from "../../core/routes";
import { sameValue } from "../../core/same";
import { shapeOf } from "../../core/shape";
import type {
  DriverSide,
  LineHeight,
  LineHeightAnswer,
  LinePose,
  RodMark,
  ScanVehicle,
  Target,
} from "../../core/types";
import { heightWords } from "../../core/words";
import type { Crossings } from "../../parts/strips/draw";
import { type Place, placeOf } from "../../parts/strips/view";
import { type Verdict, verdictKind } from "../../parts/verdicts/kind";
import { type Facts, type Hubs, rodWords, type ScannedWanted, scannedWords } from "./wanted";

/** An inset of its own, or the side of the driver, whose inset the survey has. */
export type Inset = { readonly inset_m: number; readonly u_inset_m: number } | { readonly side: DriverSide };

export interface Clicks {
  readonly contact: Place;
  readonly point: Place;
  readonly inset: Inset | null;
}

/** Clicks to be stored, or null: the height is to be withdrawn. */
export interface HeightWanted {
  readonly clicks: Clicks | null;
  /** The revision with the same clicks that is to be computed again. */
  readonly again?: number;
}

export interface HeightAbout {
  readonly id: number;
  readonly scanId: number;
  readonly target: Target;
  /** What was answered for the clicks before they were stored. */
  readonly answer: LineHeightAnswer | null;
}

type HeightBody = Omit<BodyOf<"POST /scan-vehicles/{vehicle_id}/heights">, "revision">;

const isHeight = shapeOf<LineHeight>({
  id: "number",
  revision: "number",
  vehicle_id: "number",
  target: "string",
  contact: "list",
  target_point: "list",
  withdrawn: "boolean",
});

const isScanned = shapeOf<ScanVehicle>({ id: "number", version: "number", deleted: "boolean" });

export const LINE_HEIGHT = outbox.register<LineHeight, HeightWanted, HeightAbout>("line-height", {
  once: true,
  send({ about: { id: vehicle_id, target }, saved, want }, sending) {
    const revision = saved?.revision ?? 0;
    if (!want.clicks) {
      const asked = { vehicle_id, target, revision };
      return api.write("DELETE /scan-vehicles/{vehicle_id}/heights", asked, sending);
    }
    const body = { ...clickBody(target, want.clicks), revision };
    const route = "POST /scan-vehicles/{vehicle_id}/heights";
    return api.write(route, { vehicle_id }, { body, ...sending });
  },
  read: ({ about: { id, target } }, _error, signal) => readHeight(id, target, signal),
  isSaved: isHeight,
  done({ saved, want: { clicks, again = 0 } }) {
    if (!saved || saved.withdrawn || !clicks) return !clicks && (!saved || saved.withdrawn);
    return saved.revision > again && sameClicks(clicksOf(saved), clicks);
  },
  version: (saved) => saved?.revision ?? 0,
  words: heightWords,
});

async function readHeight(
  vehicle_id: number,
  target: Target,
  signal: AbortSignal | undefined,
): Promise<LineHeight | null> {
  const all = await api.ask("GET /scan-vehicles/{vehicle_id}/heights", { vehicle_id }, { signal });
  return all.findLast((one) => one.target === target) ?? null;
}

export function clicksOf(one: LineHeight): Clicks {
  return { contact: placeOf(one.contact), point: placeOf(one.target_point), inset: insetSaid(one) };
}

/** What was said of a height's inset; null: nothing, so it is the survey's, whatever that is by now. */
export function insetSaid({ inset_from, inset_m, u_inset_m, side }: LineHeight): Inset | null {
  if (inset_from === "own" && inset_m !== null && u_inset_m !== null) return { inset_m, u_inset_m };
  return side && { side };
}

function sameClicks(a: Clicks, b: Clicks): boolean {
  const places = (one: Clicks) => clickBody("other", { ...one, inset: null });
  return sameValue(places(a), places(b)) && (!a.inset || !b.inset || sameValue(a.inset, b.inset));
}

export function contactBody(target: Target, contact: Place, inset: Inset | null) {
  return { target, contact_line: Math.max(contact.line, 0), contact_row_px: contact.row, ...(inset ?? {}) };
}

export function pointBody(point: Place) {
  return { target_line: Math.max(point.line, 0), target_row_px: point.row };
}

function clickBody(target: Target, { contact, point, inset }: Clicks): HeightBody {
  return { ...contactBody(target, contact, inset), ...pointBody(point) };
}

export interface RodValues {
  readonly marks: readonly RodMark[];
  readonly sigma_px: number;
  readonly u_distance_m: number;
  readonly u_lean_rad: number;
}

/** What is usual before anything is said of a rod. */
export const FRESH: RodValues = { marks: [], sigma_px: 1, u_distance_m: 0.005, u_lean_rad: 0 };

export function rodOf({ marks, sigma_px, u_distance_m, u_lean_rad }: LinePose): RodValues {
  return { marks, sigma_px: sigma_px ?? FRESH.sigma_px, u_distance_m, u_lean_rad };
}

/** Of a stored rod without one, the marks' uncertainty is from the residuals: another than the usual one. */
export function isRodOf(saved: LinePose, want: RodValues): boolean {
  return saved.sigma_px === want.sigma_px && sameValue(rodOf(saved), want);
}

export const ROD = outbox.register<LinePose, RodValues, { scanId: number }>("rod", {
  once: true,
  send: ({ about, saved, want }, sending) =>
    api.write(
      "PUT /scans/{scan_id}/line-pose",
      { scan_id: about.scanId },
      { body: { ...want, marks: [...want.marks], revision: saved?.revision ?? 0 }, ...sending },
    ),
  read: async ({ about }, _error, signal) =>
    (await api.ask("GET /scans/{scan_id}/line-pose", { scan_id: about.scanId }, { signal })).current,
  isSaved: shapeOf<LinePose>({ revision: "number", marks: "list" }),
  done: ({ saved, want }) => saved !== null && isRodOf(saved, want),
  version: (saved) => saved?.revision ?? 0,
  words: (saved) => (saved ? rodWords(saved.marks) : say("scan-wish-no-marks")),
});

interface ScannedAbout {
  readonly id: number;
  readonly scanId: number;
}

export const SCANNED = outbox.register<ScanVehicle, ScannedWanted, ScannedAbout>("scanned", {
  async send({ about: { id: vehicle_id }, saved, want }, sending) {
    const [at, version] = [{ vehicle_id }, saved?.version ?? 0];
    const { boundaries, hubs, axles, lane, facts } = leftOf(saved, want);
    if (saved?.deleted && want.there)
      return api.write("POST /scan-vehicles/{vehicle_id}/restore", at, sending);
    if (boundaries) {
      const body = { ...boundaries, version };
      return api.write("PUT /scan-vehicles/{vehicle_id}/boundaries", at, { body, ...sending });
    }
    if (hubs) {
      const body = { front_wheel_line: hubs[0], rear_wheel_line: hubs[1], version };
      return api.write("PUT /scan-vehicles/{vehicle_id}/wheels", at, { body, ...sending });
    }
    if (axles !== undefined) {
      const body = { axle_lines: axles && [...axles], version };
      return api.write("PUT /scan-vehicles/{vehicle_id}/axles", at, { body, ...sending });
    }
    if (lane !== undefined) {
      const body = { lane, version };
      return api.write("PUT /scan-vehicles/{vehicle_id}/lane", at, { body, ...sending });
    }
    if (facts) {
      const body = { ...facts, version };
      return api.write("PUT /scan-vehicles/{vehicle_id}/facts", at, { body, ...sending });
    }
    await api.write("DELETE /scan-vehicles/{vehicle_id}", { ...at, version }, sending);
    return saved && { ...saved, deleted: true, version: version + 1 };
  },
  read: ({ about: { id } }, _error, signal) => readVehicle(id, signal),
  isSaved: isScanned,
  done: ({ saved, want }) => Object.keys(leftOf(saved, want)).length === 0,
  version: (saved) => saved?.version ?? 0,
  words(saved) {
    if (!saved || saved.deleted) return say("scan-wish-taken-out");
    const { facts, boundaries, hubs } = standing(saved);
    return scannedWords(boundaries ? { facts, boundaries, hubs } : { facts });
  },
});

/** What of it is not so yet. */
function leftOf(saved: ScanVehicle | null, want: ScannedWanted): ScannedWanted {
  const now: Readonly<Record<string, unknown>> = standing(saved);
  const left = Object.entries(want).filter(([part, wanted]) => {
    // facts that are left out stay
    const then = part === "facts" ? { ...saved, ...(wanted as Facts) } : wanted;
    return wanted !== undefined && !sameValue(then, part === "facts" ? saved : now[part]);
  });
  return Object.fromEntries(left);
}

/** A vehicle as one would want it for it to be as it is. */
export function standing(saved: ScanVehicle | null) {
  const m = saved?.measurement;
  return {
    ...(m && { boundaries: crossingsOf(m) }),
    hubs: [m?.front_wheel_line ?? null, m?.rear_wheel_line ?? null] as Hubs,
    axles: m?.axles_by === "person" ? (m.axle_lines ?? []) : null,
    lane: laneByPerson(m),
    ...(saved && { there: !saved.deleted, facts: factsOf(saved) }),
  };
}

async function readVehicle(vehicle_id: number, signal: AbortSignal): Promise<ScanVehicle> {
  return (await api.ask("GET /scan-vehicles/{vehicle_id}", { vehicle_id }, { signal })).vehicle;
}

/** The lane that a person chose of a vehicle; null: none did. */
export function laneByPerson(m: ScanVehicle["measurement"] | undefined): string | null {
  return m?.lane_by === "person" ? m.lane : null;
}

export function crossingsOf({ front_line_1, rear_line_1, front_line_2, rear_line_2 }: Crossings): Crossings {
  return { front_line_1, rear_line_1, front_line_2, rear_line_2 };
}

function factsOf({ make, model, category, true_length_m, true_wheelbase_m, run_of }: ScanVehicle): Facts {
  return { make, model, category, true_length_m, true_wheelbase_m, run_of };
}

interface Added {
  readonly front_line_1: number;
  readonly rear_line_1: number;
}

export const ADDED = outbox.register<ScanVehicle, Added, { scanId: number }>("added", {
  once: true,
  send: ({ about, want }, sending) =>
    api.write("POST /scans/{scan_id}/vehicles", { scan_id: about.scanId }, { body: want, ...sending }),
  read: async () => null,
  isSaved: isScanned,
  version: () => 0,
  words: () => "",
});

/** A motion is not fixed by its reviewer. */
export type MotionVerdict = Verdict & { readonly verdict: Exclude<Verdict["verdict"], "fixed"> };

export interface VerdictAbout {
  readonly id: number;
  readonly measurementId: number;
  readonly by: number;
}

const motionVerdict = verdictKind<ScanVehicle, MotionVerdict, VerdictAbout>({
  send: ({ about }, body, sending) =>
    api.write(
      "POST /scan-measurements/{measurement_id}/review",
      { measurement_id: about.measurementId },
      { body, ...sending },
    ),
  read: ({ about: { id } }, _error, signal) => readVehicle(id, signal),
  isSaved: isScanned,
  review: ({ measurement: m }) => m && { of: m.id, review: m.review },
  isOn: (saved, { about }) => saved.measurement?.id === about.measurementId,
});

export const SCAN_VERDICT = outbox.register("scan-verdict", motionVerdict);
