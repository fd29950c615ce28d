/** Draws over camera 1 what belongs to heights: clicks, the ladder above the contact, the rod's marks. */
import { say } from "../../core/messages";
import type { LineHeight } from "../../core/types";
import { formatHeight, formatLength, formatRung } from "../../core/units";
import { heightWords, TARGET_WORDS } from "../../core/words";
import { cross, joined, type Pens, penOn, stroke, word } from "../../parts/strips/marks";
import { type Place, type StripsView, xOf, yOf } from "../../parts/strips/view";
import { type Clicks, clicksOf } from "./kinds";
import type { ScanModel } from "./model";

/** A vehicle that is narrower on the screen shows its points without words. */
const LABELLED_PX = 120;

export function drawHeights(canvas: HTMLCanvasElement, model: ScanModel, view: StripsView): void {
  const pens = penOn(canvas, view);
  if (!pens) return;
  if (model.mode.value === "rod") rodMarks(pens, model);
  else {
    stored(pens, model);
    inHand(pens, model);
  }
  pens.pen.restore();
}

function rodMarks(pens: Pens, model: ScanModel): void {
  const { marks } = model.rod.values.value;
  for (const mark of marks) {
    const at = { line: mark.line, row: mark.row_px };
    cross(pens, at, pens.accent);
    const top = marks.every((one) => one.distance_m !== mark.distance_m || one.height_m <= mark.height_m);
    const height = formatLength(mark.height_m, 2);
    const distance = formatLength(mark.distance_m, 2);
    word(pens, at, top ? say("scan-drawn-mark-away", { height, distance }) : height, { up: 0 });
  }
}

/** The chosen vehicle's stored heights, those in hand where they are held. */
function stored(pens: Pens, model: ScanModel): void {
  const lines = model.boundaries.crossings.value;
  const wide = lines ? (lines.rear_line_1 - lines.front_line_1) / pens.view.perPx : 0;
  for (const height of model.heights.ofChosen.value) storedHeight(pens, model, height, wide > LABELLED_PX);
}

function clicksShown({ heights }: ScanModel, height: LineHeight): Clicks {
  const moved = heights.moved.value;
  return moved?.target === height.target ? moved : clicksOf(height);
}

function storedHeight(pens: Pens, model: ScanModel, height: LineHeight, labelled: boolean): void {
  const { selected, target, live, ofChosen } = model.heights;
  const { contact, point } = clicksShown(model, height);
  const role = selected.value?.target === height.target ? selected.value.role : null;
  joined(pens, contact, point);
  cross(pens, contact, role === "contact" ? pens.accent : pens.ink);
  cross(pens, point, role === "point" ? pens.accent : pens.ink);
  const underWay = target.value !== null || live.value?.target === height.target;
  const words = { target: TARGET_WORDS[height.target], height: heightWords(height) };
  const crosses = ofChosen.value.map((one) => clicksShown(model, one).point);
  if (labelled && !underWay) word(pens, point, say("scan-drawn-height", words), { crosses });
}

function inHand(pens: Pens, model: ScanModel): void {
  const live = model.heights.live.value;
  const contact = model.heights.contact.value ?? live?.contact;
  if (!contact) return;
  for (const rung of live?.answer?.ladder ?? []) {
    const span = 0.5 * pens.view.width * pens.view.perPx;
    level(pens, { line: contact.line, row: rung.row_px }, span);
    word(pens, { line: contact.line - span, row: rung.row_px }, formatRung(rung.height_m), { up: 0 });
  }
  cross(pens, contact, pens.accent);
  if (!live?.point) {
    const away = live?.answer?.distance_m ?? null;
    if (away !== null) word(pens, contact, say("scan-drawn-away", { distance: formatLength(away, 2) }));
    return;
  }
  joined(pens, contact, live.point);
  cross(pens, live.point, pens.accent);
  const answer = live.answer;
  if (answer?.status === "ok")
    word(pens, live.point, formatHeight(answer.height_m, answer.U95_height_m), { strong: true });
}

function level(pens: Pens, at: Place, span: number): void {
  const { pen, view, ink } = pens;
  pen.globalAlpha = 0.55;
  const path = [-span, span].map((by) => [xOf(view, at.line + by), yOf(view, at.row)] as const);
  stroke(pens, { style: [ink, 1] }, path);
  pen.globalAlpha = 1;
}
