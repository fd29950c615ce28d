import { expect, it } from "vitest";
import { partsOf } from "./readme";

it("takes the parts of a README with their items, which may be longer than a line", () => {
  const text =
    "A road, somewhere\n=================\n\nConclusion\n----------\n- P10 of eyes is\n  1.086 m.\n- More.\n\nNot covered\n-----------\n- Others.\n";
  expect(partsOf(text)).toEqual([
    { heading: "Conclusion", items: ["P10 of eyes is 1.086 m.", "More."] },
    { heading: "Not covered", items: ["Others."] },
  ]);
});
