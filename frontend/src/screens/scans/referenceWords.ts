/** Reference values in words and units. */
import { say, wordsOf } from "../../core/messages";
import type { ReferenceQuantity, ReferenceSource, ScanReference } from "../../core/types";
import { formatSmall, formatSpeed } from "../../core/units";
import { formatMeasured } from "./words";

export const QUANTITY_WORDS = wordsOf("scan-reference-", "speed", "length", "wheelbase");
export const SOURCE_WORDS: Readonly<Record<ReferenceSource, string>> = wordsOf("scan-reference-source-");

interface Shown {
  quantity: ReferenceQuantity;
  value: number;
  U95: number | null;
}

/** "70.0 ± 1.0 km/h", "4.390 ± 0.010 m" */
export function referenceValue({ quantity, value, U95 }: Shown): string {
  return quantity === "speed" ? formatSpeed(value, U95) : formatMeasured(value, U95);
}

export function differenceWords(quantity: ReferenceQuantity, difference: number): string {
  const sign = difference < 0 ? "" : "+";
  return sign + apartWords(quantity, difference);
}

/** The same without a sign: a spread, an uncertainty. */
export function apartWords(quantity: ReferenceQuantity, value: number): string {
  return quantity === "speed" ? formatSpeed(value, null, 2) : formatSmall(value);
}

/** How far ours is from it, and whether the combined uncertainty holds that. */
export function agreementWords({ quantity, agreement }: ScanReference): string {
  if (!agreement) return say("scan-reference-nothing");
  return say(agreement.within ? "scan-reference-within" : "scan-reference-outside", {
    difference: differenceWords(quantity, agreement.difference),
    U95: apartWords(quantity, agreement.U95_difference),
  });
}
