import { expect, it } from "vitest";
import { vehicle } from "../../../testing/server";
import type { MeasureModel } from "./model";
import { progress } from "./PassList";
import { Standing } from "./standing";

it("a refused click is not counted as measured, and its target is missing; a refused change of what is stored is", () => {
  const entry = (target: string, state: string, saved: object | null) => ({
    values: { target, withdrawn: false },
    state,
    saved,
  });
  const of = (...entries: object[]) => ({ records: { of: () => entries } }) as unknown as MeasureModel;
  const roof = entry("roof", "saved", { review: { verdict: "to_review" } });
  const told = (...entries: object[]) => progress(of(...entries), vehicle());
  expect(told(roof, entry("taillight", "failed", null))).toBe(told(roof));
  expect(told(roof, entry("taillight", "failed", {}))).toBe("2 of 3");
  const missing = (...entries: object[]) => {
    const { records } = of(...entries);
    const desk = { records, vehicleId: { value: 9 }, asked: () => ["roof", "taillight"] };
    return new Standing(desk as never).missing();
  };
  expect(missing(roof, entry("taillight", "saving", null))).toEqual([]);
  expect(missing(roof, entry("taillight", "failed", {}))).toEqual([]);
  expect(missing(roof, entry("taillight", "failed", null))).toEqual(["taillight"]);
});
