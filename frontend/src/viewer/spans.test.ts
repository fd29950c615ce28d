import { describe, expect, it } from "vitest";
import { drawnSpans, type Span } from "./spans";

function span(id: number, first: number, last: number, kind: Span["kind"] = "todo"): Span {
  return { id: String(id), first, last, label: `V${id}`, title: "", kind };
}

describe("spans on the timeline", () => {
  it("are drawn as they are while there is room", () => {
    const few = [span(1, 0, 9), span(2, 5, 20, "done")];
    expect(drawnSpans(few, 100, 800)).toBe(few);
  });

  it("become bars of those that touch, by kind, and cover the same frames", () => {
    const many = Array.from({ length: 1000 }, (_, n) => span(n, 10 * n, 10 * n + 6, n % 2 ? "done" : "todo"));
    const drawn = drawnSpans(many, 10_000, 500); // 10 frames are half a pixel
    expect(drawn.length).toBe(2);
    expect(drawn.map((one) => [one.kind, one.first, one.last])).toEqual([
      ["done", 10, 9996],
      ["todo", 0, 9986],
    ]);
    expect(drawn[1]?.title).toContain("500 passes");
  });

  it("stay apart where there is a gap that can be seen, and the current one always does", () => {
    const crowd = Array.from({ length: 40 }, (_, n) => span(n, n, n + 1));
    const drawn = drawnSpans([...crowd, span(98, 500, 510), span(99, 20, 25, "current")], 1000, 500);
    expect(drawn.map((one) => [one.id, one.first, one.last])).toEqual([
      ["bar-0", 0, 40],
      ["98", 500, 510],
      ["99", 20, 25],
    ]);
  });

  it("a long span holds those that lie within it", () => {
    const crowd = Array.from({ length: 50 }, (_, n) => span(n, 10 * n, 10 * n + 1));
    const drawn = drawnSpans([span(200, 0, 900), ...crowd], 1000, 200);
    expect(drawn.map((one) => [one.first, one.last])).toEqual([[0, 900]]);
  });
});
