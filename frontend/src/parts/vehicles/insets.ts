/** Which of the survey's insets a target of a vehicle has: an eye's by the driver's side, a roof's by the class. */
import type { Category, DriverSide, InsetChoice, InsetName, Survey, Target } from "../../core/types";

type Usual = Survey["insets"][InsetName];

export function usualInset(
  of: Survey | null,
  target: Target,
  side: DriverSide | null,
  category: Category | null,
): Usual | null {
  if (!of) return null;
  if (target === "driver_eye") return side && of.insets[`driver_eye_${side}`];
  return of.insets[target === "roof" ? roofOf(of, category) : target];
}

/** What can be told apart by looking at the vehicle; the edge of its roof lies where its class has it. */
export function insetChoices(
  of: Survey | null,
  target: Target,
  category: Category | null,
): readonly InsetChoice[] {
  const choices = of?.inset_choices[target] ?? [];
  if (!of || target !== "roof") return choices;
  const { inset_m, u_inset_m } = of.insets[roofOf(of, category)];
  return choices.map((one) => (one.place === "near_edge" ? { ...one, inset_m, u_inset_m } : one));
}

/** Whether the number depends on a class that nobody has said. */
export function classIsMissing(target: Target, category: Category | null): boolean {
  return target === "roof" && category === null;
}

function roofOf(of: Survey, category: Category | null): InsetName {
  return (category && of.roof_insets[category]) || "roof_unknown";
}
