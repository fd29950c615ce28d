/** The document of an evidence file, as the installation signed it, and the two pictures that it names. */
import type { Json } from "../canonical";
import type { Handing } from "../chain";

/** Of each thing what the page reads; the file holds more. */
interface Who {
  readonly name: string;
}

interface Rig {
  readonly baseline_m: number;
  readonly u_baseline_m: number;
  readonly line_rate_hz: number;
  readonly u_line_rate_ratio: number;
  readonly divergence_rad: number;
  readonly u_divergence_rad: number;
  readonly distance_m: number | null;
  readonly misalignment_px: number | null;
  readonly u_misalignment_px: number;
  readonly shadow_share: number;
  readonly lanes?: readonly unknown[];
}

export interface Lines {
  readonly front_line_1: number;
  readonly rear_line_1: number;
  readonly front_line_2: number;
  readonly rear_line_2: number;
}

interface Review {
  readonly verdict: "to_review" | "accepted" | "rejected" | "reopened";
  readonly reason: string | null;
  readonly reviewer: Who | null;
  readonly at: string | null;
}

interface Entry {
  readonly source: string;
  readonly u_speed_mps: number;
  readonly u_acceleration_mps2: number;
  readonly u_length_m: number;
}

export interface Measured extends Lines {
  readonly id: number;
  readonly revision: number;
  readonly created_at: string;
  readonly placed_by: number | null;
  readonly direction: "camera_1_first" | "camera_2_first";
  readonly lane: string | null;
  readonly axle_lines: readonly number[] | null;
  readonly axles_by: "machine" | "person" | null;
  readonly method: "direct" | "paper";
  readonly code_version: string;
  readonly speed_mps: number | null;
  readonly u_speed_mps: number | null;
  readonly acceleration_mps2: number | null;
  readonly u_acceleration_mps2: number | null;
  readonly length_m: number | null;
  readonly u_length_m: number | null;
  readonly rig: Rig;
  readonly budget: readonly Entry[];
}

export interface AuditEvent extends Record<string, Json> {
  readonly chain: string;
  readonly number: number;
  readonly at: string;
  readonly action:
    | "create"
    | "read"
    | "recorded"
    | "reading_failed"
    | "restart_reading"
    | "review"
    | "swap_cameras"
    | "update";
  readonly entity: "scan" | "scan_measurement" | "scan_review";
  readonly entity_id: number | null;
  readonly after: string | null;
  readonly previous_hash: string;
  readonly hash: string;
}

export interface PictureFacts {
  readonly name: string;
  readonly sha256: string;
  readonly first_line: number;
  readonly columns: number;
  readonly step_lines: number;
  readonly rows_px: number;
}

export interface Evidence {
  readonly made_at: string;
  readonly made_by: Who | null;
  readonly program: string;
  readonly survey: { readonly name: string; readonly site: string };
  readonly scan: {
    readonly name: string;
    readonly lines: number;
    readonly rows_px: number;
    readonly bits: number;
    readonly first_sha256: string;
    readonly second_sha256: string;
  };
  readonly vehicle: {
    readonly number: number;
    readonly make: string | null;
    readonly model: string | null;
  };
  readonly measurement: Measured;
  readonly review: Review;
  readonly gap: {
    readonly time_gap_s: number | null;
    readonly u_time_gap_s: number | null;
    readonly distance_gap_m: number | null;
    readonly u_distance_gap_m: number | null;
  } | null;
  readonly clock: {
    readonly started_at: string;
    readonly time_zone: string;
    readonly u_start_s: number;
  } | null;
  readonly time: {
    readonly since_start_s: number;
    readonly filmed_at: string | null;
    readonly u_filmed_at_s: number | null;
  };
  readonly at_vehicle: { readonly baseline_m: number; readonly u_baseline_m: number };
  /** What the codes of the import, of the motion and of the gap before it say. */
  readonly words: {
    readonly reason: string | null;
    readonly warnings: readonly string[];
    readonly gap: string | null;
    readonly notes: readonly string[];
  };
  readonly pictures: readonly PictureFacts[];
  readonly decision: {
    readonly answer: "conforming" | "not_conforming" | "undecided" | null;
    readonly words: string;
    readonly rule: { readonly source: string } | null;
  };
  readonly audit: {
    readonly chain: string;
    readonly count: number;
    readonly hash: string;
    readonly events: readonly AuditEvent[];
  };
  readonly keys: readonly Handing[];
  readonly key: string;
}

export interface Held {
  readonly text: string;
  readonly plain: Readonly<Record<string, Json>>;
  readonly evidence: Evidence;
  readonly signature: string;
  /** base64 of each PNG by its name */
  readonly pictures: ReadonlyMap<string, string>;
}

/** Throws where the page carries nothing, or nothing that is JSON. */
export function held(): Held {
  const text = document.getElementById("evidence")?.textContent ?? "";
  const plain = JSON.parse(text) as Record<string, Json>;
  const pictures = new Map<string, string>();
  for (const one of document.querySelectorAll<HTMLScriptElement>("script[data-picture]"))
    pictures.set(one.dataset["picture"] ?? "", one.textContent ?? "");
  const signature = document.getElementById("signature")?.textContent ?? "";
  return { text, plain, evidence: plain as unknown as Evidence, signature, pictures };
}
