/** The surroundings of one point of the frame that is seen, lossless: it stays where it is, whatever the pointer does. */
import { useSignal, useSignalEffect } from "@preact/signals";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { bright } from "./display";
import { Crops, drawLoupe } from "./Loupe";
import type { Player } from "./player";
import type { ImagePoint } from "./points";

const SIDE_PX = 136;

export function PointLoupe({ player, at }: { player: Player; at: ImagePoint }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const version = useSignal(0);
  const place = useSignal(at);
  place.value = at;
  const crops = useMemo(() => new Crops(player.recordingId, () => version.value++), [player]);
  useEffect(() => () => crops.clear(), [crops]);
  useSignalEffect(() => {
    void version.value;
    const shown = player.shown.value;
    if (!shown) return;
    const tile = crops.at(shown.frame, place.value, shown.picture, bright.value);
    const point = place.value;
    requestAnimationFrame(() => canvas.current && drawLoupe(canvas.current, point, shown.picture, tile));
  });
  return (
    <span class="point-loupe" aria-hidden="true">
      <canvas ref={canvas} width={SIDE_PX} height={SIDE_PX} />
    </span>
  );
}
