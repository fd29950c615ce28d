/** Figures of repeats in words; every number is the server's. */
import { say, sentenceOf } from "../../core/messages";
import type { ProposedTarget, RepeatSpread, TargetRepeats } from "../../core/types";
import { fixed, formatSmall, smallNumber } from "../../core/units";

/** "4.1 mm" with "3.2 to 5.6 mm"; null where there is none. */
export function spreadWords(one: RepeatSpread): { value: string; interval: string } | null {
  if (one.sd === null) return null;
  const interval = say("interval", { low: smallNumber(one.low), high: formatSmall(one.high) });
  return { value: formatSmall(one.sd), interval };
}

/** "0.62 px" with "0.54 to 0.72 px". */
export function pixelWords(one: RepeatSpread): { value: string; interval: string } | null {
  if (one.sd === null || one.low === null || one.high === null) return null;
  return {
    value: `${fixed(one.sd, 2)} px`,
    interval: say("interval", { low: fixed(one.low, 2), high: `${fixed(one.high, 2)} px` }),
  };
}

/** What the interval of observed over claimed says: 1 is "as claimed". */
export function claimVerdict(claim: TargetRepeats["uncertainty_check"]): string {
  if (claim.low === null || claim.high === null) return sentenceOf(claim.reason) ?? "–";
  if (claim.low > 1) return say("repeats-more");
  return say(claim.high < 1 ? "repeats-less" : "repeats-as");
}

/** "-0.8 ± 1.4 mm", both to the same digit; null where too few vehicles tell. */
export function shiftWords(shift: ProposedTarget["shift"]): string | null {
  const { shift_m, U95_shift_m } = shift;
  if (shift_m === null) return null;
  const digits = (U95_shift_m ?? 0) < 0.01 ? 1 : 0;
  const written = [smallNumber(shift_m, undefined, digits), formatSmall(U95_shift_m, undefined, digits)];
  return written.join("\u00a0±\u00a0");
}
