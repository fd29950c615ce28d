import { say } from "../../core/messages";
import { formatHeight } from "../../core/units";
import { STATE_WORDS } from "../../core/words";
import type { Entry } from "./records";

/** The stored height, or the one just answered while it is being stored. */
export function heightWords(entry: Entry): string {
  const source =
    entry.state === "saved"
      ? entry.saved
      : (entry.preview ?? (entry.state === "saving" ? entry.saved : null));
  if (!source) return entry.state === "failed" ? say("measure-not-stored") : "…";
  if (source.status !== "ok") return STATE_WORDS.not_measurable;
  return formatHeight(source.height_m, source.U95_height_m);
}
