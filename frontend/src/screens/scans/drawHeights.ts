/** Draws over camera 1 what belongs to heights: clicks, the ladder above the contact, the rod's marks. */

import { say } from "../../core/messages";
import type { LineHeight } from "../../core/types";
import { formatHeight, formatLength } from "../../core/units";
import { STATE_WORDS, TARGET_WORDS } from "../../core/words";
import { clicksOf } from "./kinds";
import type { ScanModel } from "./model";
import { type Place, type StripsView, xOf, yOf } from "./view";

interface Pens {
  readonly pen: CanvasRenderingContext2D;
  readonly view: StripsView;
  readonly ink: string;
  readonly accent: string;
  readonly paper: string;
}

/** A vehicle that is narrower on the screen shows its points without words. */
const LABELLED_PX = 120;
const DARK = "rgb(16 17 16 / 72%)";

export function drawHeights(canvas: HTMLCanvasElement, model: ScanModel, view: StripsView): void {
  const pen = canvas.getContext("2d");
  if (!pen) return;
  const style = getComputedStyle(canvas);
  const pens: Pens = {
    pen,
    view,
    ink: style.getPropertyValue("--stage-ink"),
    accent: style.getPropertyValue("--accent"),
    paper: style.getPropertyValue("--stage"),
  };
  pen.save();
  pen.beginPath();
  pen.rect(0, 0, view.width, view.height);
  pen.clip();
  pen.font = "600 12px system-ui, sans-serif";
  pen.textBaseline = "middle";
  if (model.mode.value === "rod") rodMarks(pens, model);
  else {
    stored(pens, model);
    inHand(pens, model);
  }
  pen.restore();
}

function rodMarks(pens: Pens, model: ScanModel): void {
  const { marks } = model.rod.values.value;
  for (const mark of marks) {
    const at = { line: mark.line, row: mark.row_px };
    cross(pens, at, pens.accent);
    const top = marks.every((one) => one.distance_m !== mark.distance_m || one.height_m <= mark.height_m);
    const height = formatLength(mark.height_m, 2);
    const distance = formatLength(mark.distance_m, 2);
    word(pens, at, top ? say("scan-drawn-mark-away", { height, distance }) : height, false, 0);
  }
}

/** The chosen vehicle's stored heights, those in hand where they are held. */
function stored(pens: Pens, model: ScanModel): void {
  const lines = model.crossings.value;
  const wide = lines ? (lines.rear_line_1 - lines.front_line_1) / pens.view.perPx : 0;
  for (const height of model.heights.ofChosen.value) storedHeight(pens, model, height, wide > LABELLED_PX);
}

function storedHeight(pens: Pens, model: ScanModel, height: LineHeight, labelled: boolean): void {
  const { selected, moved, target, live } = model.heights;
  const inHand = moved.value?.target === height.target ? moved.value : null;
  const { contact, point } = inHand ?? clicksOf(height);
  const role = selected.value?.target === height.target ? selected.value.role : null;
  joined(pens, contact, point);
  cross(pens, contact, role === "contact" ? pens.accent : pens.ink);
  cross(pens, point, role === "point" ? pens.accent : pens.ink);
  const underWay = target.value !== null || live.value?.target === height.target;
  const words = { target: TARGET_WORDS[height.target], height: heightWords(height) };
  if (labelled && !underWay) word(pens, point, say("scan-drawn-height", words));
}

function heightWords(height: LineHeight): string {
  return height.status === "ok"
    ? formatHeight(height.height_m, height.U95_height_m)
    : STATE_WORDS.not_measurable;
}

function inHand(pens: Pens, model: ScanModel): void {
  const live = model.heights.live.value;
  const contact = model.heights.contact.value ?? live?.contact;
  if (!contact) return;
  for (const rung of live?.answer?.ladder ?? []) {
    const span = 0.5 * pens.view.width * pens.view.perPx;
    level(pens, { line: contact.line, row: rung.row_px }, span);
    word(pens, { line: contact.line - span, row: rung.row_px }, formatLength(rung.height_m, 1), false, 0);
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
    word(pens, live.point, formatHeight(answer.height_m, answer.U95_height_m), true);
}

/** From the contact up and across to the target: a point at another line stands at the same distance. */
function joined({ pen, view, ink }: Pens, contact: Place, point: Place): void {
  pen.strokeStyle = ink;
  pen.lineWidth = 1;
  pen.setLineDash([3, 3]);
  pen.beginPath();
  pen.moveTo(xOf(view, contact.line), yOf(view, contact.row));
  pen.lineTo(xOf(view, contact.line), yOf(view, point.row));
  pen.lineTo(xOf(view, point.line), yOf(view, point.row));
  pen.stroke();
  pen.setLineDash([]);
}

function level({ pen, view, ink }: Pens, at: Place, span: number): void {
  pen.strokeStyle = ink;
  pen.globalAlpha = 0.55;
  pen.lineWidth = 1;
  pen.beginPath();
  pen.moveTo(xOf(view, at.line - span), yOf(view, at.row));
  pen.lineTo(xOf(view, at.line + span), yOf(view, at.row));
  pen.stroke();
  pen.globalAlpha = 1;
}

function cross({ pen, view }: Pens, at: Place, colour: string): void {
  const x = xOf(view, at.line);
  const y = yOf(view, at.row);
  for (const [style, width] of [
    [DARK, 4],
    [colour, 1.5],
  ] as const) {
    pen.strokeStyle = style;
    pen.lineWidth = width;
    pen.beginPath();
    pen.moveTo(x - 9, y);
    pen.lineTo(x + 9, y);
    pen.moveTo(x, y - 9);
    pen.lineTo(x, y + 9);
    pen.stroke();
  }
}

function word(
  { pen, view, ink, accent, paper }: Pens,
  at: Place,
  text: string,
  strong = false,
  up = 12,
): void {
  const wide = pen.measureText(text).width + 10;
  const x = Math.max(Math.min(xOf(view, at.line) + 12, view.width - wide), 0);
  const y = Math.max(Math.min(yOf(view, at.row) - up, view.height - 10), 10);
  pen.fillStyle = strong ? accent : DARK;
  pen.fillRect(x, y - 9, wide, 18);
  pen.fillStyle = strong ? paper : ink;
  pen.fillText(text, x + 5, y + 1);
}
