/** Both strips of a scan with its vehicles; boundaries are dragged. */
import { theme } from "../../core/theme";
import { draw } from "../../parts/strips/draw";
import { StripsPicture } from "../../parts/strips/StripsPicture";
import { tilesSeen } from "../../parts/strips/tiles";
import type { StripsView } from "../../parts/strips/view";
import { Asked } from "./Asked";
import { drawHeights } from "./drawHeights";
import type { ScanModel } from "./model";

export function StripView({ model }: { model: ScanModel }) {
  return (
    <StripsPicture
      stage={model.stage}
      tiles={model.tiles}
      draw={(canvas, view) => drawStrips(canvas, model, view)}
      fit={() => model.show("fit")}
    >
      <Asked model={model} />
    </StripsPicture>
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
