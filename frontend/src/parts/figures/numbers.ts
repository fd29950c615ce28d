/** Numbers of the tables and axes, in the unit that the person reads. */
import { say } from "../../core/messages";
import type { Interval } from "../../core/types";
import { fixed, type LengthUnit, lengthUnit, type Scale, smallScale } from "../../core/units";

export const NONE = "–";
export function squareScale(unit: LengthUnit = lengthUnit.value): Scale {
  return unit === "ft" ? [smallScale("ft")[0] ** 2, "in²"] : [1e4, "cm²"];
}

export function scaled(value: number | null, factor: number, digits: number): string {
  return value === null ? NONE : fixed(value * factor, digits);
}

/** "9.1 to 16.2" */
export function range(interval: Interval | null, factor: number, digits: number): string | null {
  if (!interval) return null;
  return say("interval", {
    low: scaled(interval.low, factor, digits),
    high: scaled(interval.high, factor, digits),
  });
}

/** "12.3 %" */
export function percent(share: number, digits = 1): string {
  return say("percent", { percent: fixed(share * 100, digits) });
}

/** "4.2 mm" */
export function fixedRange(metres: number): string {
  const [factor, unit] = smallScale();
  return `${fixed(metres * factor, unit === "in" ? 2 : 1)}\u00a0${unit}`;
}
