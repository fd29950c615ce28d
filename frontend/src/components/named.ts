/** How a part is called: by the key of a sentence that takes no values, or by what stands there. */
import type { ComponentChildren } from "preact";
import { type PlainKey, say } from "../core/messages";

export type Named<L = ComponentChildren> =
  | { says: PlainKey; label?: undefined }
  | { label: L; says?: undefined };

export function nameOf<L>({ says, label }: Named<L>): L | string {
  return says === undefined ? (label as L) : say(says);
}
