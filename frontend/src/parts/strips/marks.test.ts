import { expect, it, vi } from "vitest";
import { type Pens, word } from "./marks";
import { fitAll, xOf, yOf } from "./view";

const view = fitAll({ lines: 1000, rows: 200 }, 1000, 200);

/** Where the words of a target stand, 100 px wide: left and upper edge, of a box 18 px high. */
function boxOf(at: { line: number; row: number }, crosses: { line: number; row: number }[]) {
  const fillRect = vi.fn();
  const pen = { measureText: () => ({ width: 90 }), fillText: () => {}, fillRect };
  word({ pen, view, ink: "", accent: "", paper: "" } as unknown as Pens, at, "words", { crosses });
  const [left, top] = fillRect.mock.calls[0] as [number, number];
  return { left, top };
}

it("stands right above its place, and elsewhere where it would cover another cross", () => {
  const eye = { line: 500, row: 100 };
  const roof = { line: 560, row: 85 };
  const [x, y] = [xOf(view, eye.line), yOf(view, eye.row)];
  expect(boxOf(eye, [eye])).toEqual({ left: x + 12, top: y - 21 });
  expect(boxOf(eye, [eye, roof])).toEqual({ left: x + 12, top: y + 3 });
  const both = boxOf(eye, [eye, roof, { line: 560, row: 115 }]);
  expect(both.left + 100).toBeLessThan(x);
});
