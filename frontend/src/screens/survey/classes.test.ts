import { describe, expect, it } from "vitest";
import { euOf, fhwaOf } from "./ClassesDialog";

describe("classes as they are typed", () => {
  it("reads classes of the EU, however they are parted", () => {
    expect(euOf("m1, N1;O4")).toEqual(["M1", "N1", "O4"]);
    expect(euOf("")).toEqual([]);
    expect(euOf("M4")).toBeNull();
  });

  it("reads numbers and spans of FHWA's thirteen, and no other", () => {
    expect(fhwaOf("5 6, 8-11")).toEqual([5, 6, 8, 9, 10, 11]);
    for (const wrong of ["0", "14", "9-8", "12-14", "x", "3.5"]) expect(fhwaOf(wrong)).toBeNull();
  });
});
