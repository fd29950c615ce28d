import { PictureStage } from "../../viewer/stage";
import type { Tool } from "../../viewer/tool";
import type { Size } from "../../viewer/view";
import { fitAll, type StripPoint, type Strips, type StripsView } from "./view";

export class StripStage extends PictureStage<StripPoint, StripsView> {
  private measured = false;

  constructor(
    tools: () => readonly Tool<StripPoint>[],
    /** Called once the strips lie in a window of a size. */
    private readonly arrived: () => void,
    /** Called when that window has got another size, with what it showed before. */
    private readonly resizedFrom: (before: StripsView) => void = () => {},
  ) {
    super(fitAll({ lines: 1, rows: 1 }, 1, 1), tools);
  }

  /** The size of the strips, once known; another size fits anew. */
  setStrips(strips: Strips): void {
    const now = this.view.value;
    if (now.strips.lines === strips.lines && now.strips.rows === strips.rows) return;
    this.view.value = fitAll(strips, now.width, now.height);
  }

  protected override resize(screen: Size): void {
    const before = this.view.value;
    super.resize(screen);
    if (this.measured) this.resizedFrom(before);
    else this.arrived();
    this.measured = true;
  }
}
