import type { ComponentChildren } from "preact";
import "./figures.css";
import { say } from "../../core/messages";
import type { Interval } from "../../core/types";
import { NONE, range, scaled } from "./numbers";

interface FigureProps {
  figure: { value: number | null; ci95?: Interval | null } | undefined;
  /** What a number is multiplied by to be shown, and its decimals. */
  factor: number;
  digits: number;
  drawn?: (text: string) => ComponentChildren;
}

/** A figure over its 95 % interval. */
export function Figure({ figure, factor, digits, drawn = (text) => text }: FigureProps) {
  return (
    <>
      {drawn(scaled(figure?.value ?? null, factor, digits))}
      <div class="stat-ci">{range(figure?.ci95 ?? null, factor, digits) ?? NONE}</div>
    </>
  );
}

type Told = number | null | undefined;

interface BoundedProps {
  value: Told;
  low: Told;
  high: Told;
  print: (value: number) => string;
  /** How the ends of the interval are printed, where that is shorter. */
  within?: (value: number) => string;
}

/** A value over the interval that holds it. */
export function Bounded({ value, low, high, print, within = print }: BoundedProps) {
  return (
    <>
      <strong>{value == null ? NONE : print(value)}</strong>
      {low != null && high != null && (
        <div class="stat-ci">{say("interval", { low: within(low), high: within(high) })}</div>
      )}
    </>
  );
}
