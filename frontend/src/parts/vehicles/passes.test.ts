import { describe, expect, it } from "vitest";
import type { Vehicle } from "../../core/types";
import { bestFrame, firstOpen, listed, neighbour, nextOpen } from "./passes";

const pass = (number: number, state: Vehicle["state"], first_frame = number * 10): Vehicle =>
  ({
    id: number,
    number,
    state,
    recording_id: 1,
    first_frame,
    last_frame: first_frame + 5,
    best_frame: null,
  }) as Vehicle;

const all = [
  pass(1, "measured"),
  pass(2, "to_do", 5),
  pass(3, "rejected"),
  pass(4, "partial"),
  pass(5, "accepted"),
];
const numbers = (list: readonly Vehicle[]) => list.map((vehicle) => vehicle.number);

describe("the list of passes", () => {
  it("filters and orders", () => {
    expect(numbers(listed(all, "to_do", "number"))).toEqual([2, 3, 4]);
    expect(numbers(listed(all, "measured", "number"))).toEqual([1, 5]);
    expect(numbers(listed(all, "all", "time"))).toEqual([2, 1, 3, 4, 5]);
    expect(numbers(listed(all, "all", "state"))).toEqual([3, 4, 2, 1, 5]);
  });

  it("finds next and previous, also from a pass the filter hides", () => {
    const open = listed(all, "to_do", "number");
    expect(neighbour(open, all[1], 1)?.number).toBe(3);
    expect(neighbour(open, all[0], 1)?.number).toBe(2);
    expect(neighbour(open, all[4], -1)?.number).toBe(4);
    expect(neighbour(open, all[3], 1)).toBeUndefined();
  });

  it("goes on to what is still to do, round the end", () => {
    expect(nextOpen(all, all[3])?.number).toBe(2);
    expect(nextOpen(all, all[1])?.number).toBe(3);
    expect(nextOpen([pass(1, "measured")], undefined)).toBeUndefined();
  });

  it("looks at the middle where no best frame is known", () => {
    expect(bestFrame(pass(1, "to_do"))).toBe(13);
  });

  it("begins with a pass that nobody has begun, not with one that was sent back", () => {
    const list = [pass(1, "rejected"), pass(2, "partial"), pass(3, "to_do")];
    expect(firstOpen(list)?.number).toBe(3);
    expect(firstOpen(list.slice(0, 2))?.number).toBe(1);
    expect(firstOpen([pass(1, "accepted")])).toBeUndefined();
  });
});
