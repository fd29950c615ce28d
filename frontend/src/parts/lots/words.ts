/** What accepted heights rest on, and what lots that were accepted by a sample let through at most. */
import { say } from "../../core/messages";
import type { LotSummary } from "../../core/types";
import { fixed, formatCount } from "../../core/units";
import { percent } from "../figures/numbers";

export function lotWords({ individual, by_lot, waiting, outgoing }: LotSummary): string {
  const words = [say("lots-summary", { individual: formatCount(individual), by_lot: formatCount(by_lot) })];
  if (outgoing.count > 0)
    words.push(
      say("lots-outgoing", {
        count: outgoing.count,
        estimate: fixed(outgoing.estimate, 1),
        most: formatCount(outgoing.at_most),
        share: percent(outgoing.at_most / outgoing.count),
      }),
    );
  if (waiting > 0) words.push(say("lots-held", { count: waiting }));
  return words.join(" ");
}
