/** The strips in which a height was clicked, as large around its two points as shows the vehicle. */
import { signal } from "@preact/signals";
import { api } from "../../core/api";
import { theme } from "../../core/theme";
import { telling } from "../../core/toasts";
import type { LineHeight, Scan } from "../../core/types";
import { formatHeight } from "../../core/units";
import { draw } from "../../parts/strips/draw";
import { cross, joined, penOn, word } from "../../parts/strips/marks";
import { StripStage } from "../../parts/strips/stage";
import { Tiles, tileAddress, tilesSeen } from "../../parts/strips/tiles";
import { placeOf, type StripsView, showLines } from "../../parts/strips/view";

/** A vehicle is seldom longer than its strip is high. */
const LINES_PER_ROW = 2;
const NOTHING_ELSE = { vehicles: [], chosen: null, crossings: null, edge: null, wheels: [], axles: [] };

interface Strips {
  readonly scan: Scan;
  readonly tiles: Tiles;
}

/** To fit shows the height again, not the whole recording. */
class HeightStage extends StripStage {
  constructor(private readonly aim: () => void) {
    super(() => [], aim);
  }

  override fit(): void {
    this.aim();
  }
}

export class LinePicture {
  readonly strips = signal<Strips | null>(null);
  readonly stage = new HeightStage(() => this.aim());
  private readonly height = signal<LineHeight | null>(null);

  /** Null: a height of a frame is open. */
  show(height: LineHeight | null): void {
    this.height.value = height;
    if (height === null) return;
    if (this.strips.value?.scan.id === height.scan_id) this.aim();
    else void this.read(height.scan_id);
  }

  close(): void {
    this.strips.value?.tiles.close();
    this.strips.value = null;
  }

  draw(canvas: HTMLCanvasElement, view: StripsView): void {
    const strips = this.strips.value;
    const height = this.height.value;
    if (!strips || !height) return;
    void [strips.tiles.arrived.value, theme.value]; // drawn again for these too
    strips.tiles.want(tilesSeen(strips.scan, view));
    draw(canvas, { ...strips, view, ...NOTHING_ELSE });
    const pens = penOn(canvas, view);
    if (!pens) return;
    const [contact, point] = [placeOf(height.contact), placeOf(height.target_point)];
    joined(pens, contact, point);
    cross(pens, contact, pens.ink);
    cross(pens, point, pens.accent);
    if (height.status === "ok") word(pens, point, formatHeight(height.height_m, height.U95_height_m));
    pens.pen.restore();
  }

  private async read(scan_id: number): Promise<void> {
    this.close();
    await telling(async () => {
      const scan = await api.ask("GET /scans/{scan_id}", { scan_id });
      if (this.height.value?.scan_id !== scan_id) return;
      this.strips.value = { scan, tiles: new Tiles((key) => tileAddress(scan, key)) };
      if (scan.lines && scan.rows_px) this.stage.setStrips({ lines: scan.lines, rows: scan.rows_px });
      this.aim();
    });
  }

  private aim(): void {
    const height = this.height.value;
    if (!height) return;
    const lines = [height.contact[0], height.target_point[0]];
    const about = (this.stage.view.value.strips.rows * LINES_PER_ROW) / 2;
    this.stage.view.value = showLines(
      this.stage.view.value,
      Math.min(...lines) - about,
      Math.max(...lines) + about,
    );
  }
}
