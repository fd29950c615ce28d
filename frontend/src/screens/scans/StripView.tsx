/** Both strips on one time axis: drag to pan, wheel to zoom the time, with Shift the height; boundaries are dragged. */
import { say } from "../../core/messages";
import { theme } from "../../core/theme";
import { draw } from "../../parts/strips/draw";
import { OverStrips } from "../../parts/strips/OverStrips";
import { tilesSeen } from "../../parts/strips/tiles";
import type { StripsView } from "../../parts/strips/view";
import { Picture } from "../../viewer/Picture";
import { Asked } from "./Asked";
import { drawHeights } from "./drawHeights";
import type { ScanModel } from "./model";

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
          <OverStrips tiles={model.tiles} />
          <Asked model={model} />
        </>
      }
    />
  );
}

function drawStrips(canvas: HTMLCanvasElement, model: ScanModel, view: StripsView): void {
  const scan = model.scan.value;
  if (!scan) return;
  void [model.tiles.arrived.value, theme.value]; // drawn again for these too
  model.tiles.want(tilesSeen(scan, view));
  draw(canvas, {
    scan,
    view,
    tiles: model.tiles,
    vehicles: model.vehicles.value,
    chosen: model.chosenId.value,
    crossings: model.boundaries.crossings.value,
    edge: model.boundaries.edge.value,
    wheels: model.wheels.value,
    axles: model.axlesOfChosen.value,
  });
  drawHeights(canvas, model, view);
}
