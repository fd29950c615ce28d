import { formatHeight } from "../../core/units";
import type { Entry } from "./records";

/** The stored height, or the one just answered while it is being stored. */
export function heightWords(entry: Entry): string {
  const source =
    entry.state === "saved"
      ? entry.saved
      : (entry.preview ?? (entry.state === "saving" ? entry.saved : null));
  if (!source) return entry.state === "failed" ? "not stored" : "…";
  if (source.status !== "ok") return "not measurable";
  return formatHeight(source.height_m, source.U95_height_m);
}
