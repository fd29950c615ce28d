/** Both strips on one time axis: drag to pan, wheel to zoom the time, with Shift the height; boundaries are dragged. */
import { say } from "../../core/messages";
import { theme } from "../../core/theme";
import { Picture } from "../../viewer/Picture";
import { Asked } from "./Asked";
import { draw } from "./draw";
import { drawHeights } from "./drawHeights";
import type { ScanModel } from "./model";
import type { TileKey } from "./tiles";
import { levelFor, type StripsView, tilesIn } from "./view";

export function StripView({ model }: { model: ScanModel }) {
  return (
    <Picture
      stage={model.stage}
      class="strips"
      testId="strips"
      what={say("scan-strips")}
      label={say("scan-strips-label")}
      panByDrag
      draw={(canvas, view) => drawStrips(canvas, model, view)}
      onDblClick={() => model.show("fit")}
      above={
        <>
          <span class="strips__name">{say("scan-camera-1")}</span>
          <span class="strips__name strips__name--second">{say("scan-camera-2")}</span>
          <Asked model={model} />
          {model.tiles.failed.value && (
            <div class="strips__problem" role="alert">
              {say("scan-strips-missing")}{" "}
              <button type="button" class="btn btn--small" onClick={() => model.tiles.retry()}>
                {say("action-try-again")}
              </button>
            </div>
          )}
        </>
      }
    />
  );
}

function drawStrips(canvas: HTMLCanvasElement, model: ScanModel, view: StripsView): void {
  const scan = model.scan.value;
  if (!scan) return;
  void [model.tiles.arrived.value, theme.value]; // drawn again for these too
  model.tiles.want(wanted(model, view));
  draw(canvas, {
    scan,
    view,
    tiles: model.tiles,
    vehicles: model.vehicles.value,
    chosen: model.chosenId.value,
    crossings: model.crossings.value,
    edge: model.edge.value,
    wheels: model.wheels.value,
    axles: model.axlesOfChosen.value,
  });
  drawHeights(canvas, model, view);
}

/** Tiles of the level that fits, and of the coarsest, which stands in until they are here. */
function wanted(model: ScanModel, view: StripsView): TileKey[] {
  const scan = model.scan.value;
  if (!scan || scan.levels.length === 0) return [];
  const finest = levelFor(view.perPx, scan.levels.length, window.devicePixelRatio || 1);
  const keys: TileKey[] = [];
  for (const level of new Set([finest, scan.levels.length - 1])) {
    const about = scan.levels[level];
    if (!about) continue;
    const [first, last] = tilesIn(view, about.step, scan.tile_lines, about.tiles);
    for (let index = first; index <= last; index++)
      for (const camera of [1, 2] as const) keys.push({ camera, level, index });
  }
  return keys;
}
