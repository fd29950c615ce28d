import { expect, it } from "vitest";
import { beside } from "./worklist";

const list = [{ id: 3 }, { id: 5 }, { id: 9 }];

it("goes from one to the next and back, and from none to either end", () => {
  expect([beside(list, 5, 1)?.id, beside(list, 5, -1)?.id]).toEqual([9, 3]);
  expect([beside(list, 9, 1), beside(list, 3, -1)]).toEqual([undefined, undefined]);
  expect([beside(list, null, 1)?.id, beside(list, null, -1)?.id]).toEqual([3, 9]);
});

it("takes one that is not listed to stand before the list: nothing comes before it", () => {
  expect([beside(list, 7, 1)?.id, beside(list, 7, -1)]).toEqual([3, undefined]);
});
