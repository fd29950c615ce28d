/** Eight times the pixels under the pointer, lossless, with the exact position. Held with Z, switched, or while dragging. */
import { useSignal, useSignalEffect } from "@preact/signals";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { say } from "../core/messages";
import { fixed } from "../core/units";
import { BitmapCache } from "./bitmapCache";
import { bright } from "./display";
import { type Crop, cropUrl, fetchPicture } from "./frames";
import type { Player } from "./player";
import type { ImagePoint } from "./points";
import type { FrameStage } from "./stage";
import { clamp, type Size } from "./view";

const MAGNIFICATION = 8;
const SIDE_PX = 232;
/** Image pixels from the loupe's middle to its edge, and one to spare. */
const REACH = SIDE_PX / MAGNIFICATION / 2 + 1.5;
const TILE = 64;
const KEEP_BYTES = 2 ** 20;
const OFFSET_PX = 28;

export function Loupe({ player, stage }: { player: Player; stage: FrameStage }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const version = useSignal(0);
  const tiles = useMemo(() => new Crops(player.recordingId, () => version.value++), [player]);
  useEffect(() => () => tiles.clear(), [tiles]);
  const on = (stage.loupe.value || stage.dragging.value) && stage.pointer.value !== null;

  useSignalEffect(() => {
    void version.value;
    const shown = player.shown.value;
    const at = stage.pointer.value;
    if (!at || !shown || !(stage.loupe.value || stage.dragging.value)) return;
    const tile = tiles.at(shown.frame, at, shown.picture, bright.value);
    // the canvas appears with this same change, so draw once it is there
    requestAnimationFrame(() => canvas.current && drawLoupe(canvas.current, at, shown.picture, tile));
  });

  const at = stage.pointer.value;
  if (!on || !at) return null;
  return (
    <div class="loupe" style={place(stage, at)} aria-hidden="true" data-testid="loupe">
      <canvas ref={canvas} width={SIDE_PX} height={SIDE_PX} />
      <p>
        {say("viewer-pointer", { x: fixed(at[0], 1), y: fixed(at[1], 1) })}
        {bright.value && <span class="stage-note loupe__display">{say("viewer-bright")}</span>}
      </p>
    </div>
  );
}

/** True when the loupe hangs below the pointer, for want of room above it. */
export function loupeBelow(stage: FrameStage, at: ImagePoint): boolean {
  if (!stage.loupe.value && !stage.dragging.value) return false;
  return stage.view.value.toScreen(at)[1] - OFFSET_PX - SIDE_PX - 30 < 0;
}

/** Beside the pointer, on the side where there is room. */
function place(stage: FrameStage, at: ImagePoint): { left: string; top: string } {
  const view = stage.view.value;
  const [x, y] = view.toScreen(at);
  const side = SIDE_PX + 30;
  const left = x + OFFSET_PX + side > view.screen.width ? x - OFFSET_PX - SIDE_PX : x + OFFSET_PX;
  const top = y - OFFSET_PX - side < 0 ? y + OFFSET_PX : y - OFFSET_PX - side;
  return {
    left: `${clamp(left, 4, Math.max(4, view.screen.width - SIDE_PX - 4))}px`,
    top: `${clamp(top, 4, Math.max(4, view.screen.height - side - 4))}px`,
  };
}

interface Wanted {
  readonly frame: number;
  readonly crop: Crop;
  readonly isBright: boolean;
}

interface Tile {
  readonly crop: Crop;
  readonly picture: ImageBitmap;
}

/** Lossless crops on a coarse grid, so that a moving pointer rarely needs a new one. */
export class Crops {
  private readonly cache: BitmapCache<Wanted, ImageBitmap>;

  constructor(recordingId: number, onChange: () => void) {
    this.cache = new BitmapCache<Wanted, ImageBitmap>(
      ({ frame, crop, isBright }, abort) => fetchPicture(cropUrl(recordingId, frame, crop, isBright), abort),
      {
        maxBytes: KEEP_BYTES,
        nameOf: ({ frame, crop, isBright }) => `${frame}:${crop.x}:${crop.y}:${isBright}`,
        onChange,
      },
    );
  }

  at(frame: number, point: ImagePoint, size: Size, isBright: boolean): Tile | null {
    const crop = cropAround(point, size);
    const wanted = { frame, crop, isBright };
    const picture = this.cache.get(wanted);
    if (picture) return { crop, picture };
    // one that fails is asked for again when the pointer moves on
    this.cache.fetch(wanted).catch(() => {});
    return null;
  }

  clear(): void {
    this.cache.clear();
  }
}

export function cropAround(point: ImagePoint, size: Size): Crop {
  const x = clamp(Math.floor((point[0] - REACH) / TILE) * TILE, 0, Math.max(0, size.width - 1));
  const y = clamp(Math.floor((point[1] - REACH) / TILE) * TILE, 0, Math.max(0, size.height - 1));
  const side = TILE + 2 * Math.ceil(REACH);
  return { x, y, w: Math.min(side, size.width - x), h: Math.min(side, size.height - y) };
}

/** The surroundings of a point, with the point in the middle of a square canvas. */
export function drawLoupe(
  canvas: HTMLCanvasElement,
  at: ImagePoint,
  picture: ImageBitmap,
  tile: Tile | null,
): void {
  const context = canvas.getContext("2d");
  if (!context) return;
  context.imageSmoothingEnabled = false;
  context.fillStyle = "#000";
  context.fillRect(0, 0, canvas.width, canvas.width);
  const half = canvas.width / 2;
  const put = (source: ImageBitmap, x: number, y: number): void => {
    if (source.width === 0) return;
    const left = half + (x - at[0] - 0.5) * MAGNIFICATION;
    const top = half + (y - at[1] - 0.5) * MAGNIFICATION;
    context.drawImage(source, left, top, source.width * MAGNIFICATION, source.height * MAGNIFICATION);
  };
  put(picture, 0, 0);
  if (tile) put(tile.picture, tile.crop.x, tile.crop.y);
  cross(context, half);
}

/** A cross-hair that leaves the pixel itself free. */
function cross(context: CanvasRenderingContext2D, half: number): void {
  for (const [width, colour] of [
    [3, "rgb(0 0 0 / 55%)"],
    [1, "#fff"],
  ] as const) {
    context.lineWidth = width;
    context.strokeStyle = colour;
    context.beginPath();
    for (const [dx, dy] of [
      [1, 0],
      [-1, 0],
      [0, 1],
      [0, -1],
    ] as const) {
      context.moveTo(half + dx * 7, half + dy * 7);
      context.lineTo(half + dx * half, half + dy * half);
    }
    context.stroke();
  }
}
