import { expect, it } from "vitest";
import { vehicle } from "../../testing/server";
import type { MeasureModel } from "./model";
import { progress } from "./PassList";

it("a refused click is not counted as measured; a refused change of what is stored is", () => {
  const entry = (target: string, state: string, saved: object | null) => ({
    values: { target, withdrawn: false },
    state,
    saved,
  });
  const of = (...entries: object[]) => ({ records: { of: () => entries } }) as unknown as MeasureModel;
  const roof = entry("roof", "saved", {});
  const told = (...entries: object[]) => progress(of(...entries), vehicle());
  expect(told(roof, entry("taillight", "failed", null))).toBe(told(roof));
  expect(told(roof, entry("taillight", "failed", {}))).toBe("2 of 3");
});
