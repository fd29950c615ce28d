import { expect, it } from "vitest";
import { readOf, typedOf } from "./References";

it("a corrected reference keeps the figure that nobody typed", () => {
  const before = { value: 19.4444444, u: 0.0277777 };
  const typed = typedOf("speed", before);
  expect(typed).toEqual({ value: "70.000", u: "0.100" });
  expect(readOf("speed", typed, before)).toEqual(before);
  const corrected = readOf("speed", { ...typed, value: "72" }, before);
  expect(corrected).toEqual({ value: 20, u: 0.0277777 });
  expect(readOf("speed", { value: "0", u: "" }, null)).toEqual({ value: null, u: null });
});
