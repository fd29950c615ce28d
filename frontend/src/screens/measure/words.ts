import { say } from "../../core/messages";
import { heightWords } from "../../core/words";
import type { Entry } from "./records";

/** The stored height, or the one just answered while it is being stored. */
export function entryWords(entry: Entry): string {
  const source =
    entry.state === "saved"
      ? entry.saved
      : (entry.preview ?? (entry.state === "saving" ? entry.saved : null));
  if (!source) return entry.state === "failed" ? say("measure-not-stored") : "…";
  return heightWords({ ...source, withdrawn: false });
}
