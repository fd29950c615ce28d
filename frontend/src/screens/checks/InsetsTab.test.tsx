import { expect, it } from "vitest";
import { insetWithU } from "./InsetsTab";

it("an inset that many vehicles tell is not said to be exact", () => {
  expect(insetWithU({ inset_m: 0.2314, u_inset_m: 0.0041 })).toMatch(/^0\.231\sm \(u\s=\s0\.004\sm\)$/);
});
