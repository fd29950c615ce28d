import { render } from "preact";
import { expect, it, vi } from "vitest";
import { learn } from "../../core/messages";
import type { ScanTraffic, TrafficOfScans } from "../../core/types";
import { loadPlot } from "../../parts/figures/PlotFigure";
import { beganWords, OfScan } from "./Traffic";

class Wide {
  constructor(private readonly told: (entries: unknown[]) => void) {}
  observe() {
    this.told([{ contentRect: { width: 640 } }]);
  }
  disconnect() {}
}

it("draws plots from three intervals on, and says how long a scan is wanted where there are fewer", async () => {
  vi.stubGlobal("ResizeObserver", Wide);
  await Promise.all([learn("scans"), loadPlot()]);
  const figure = { value: 20, u: 0.1 };
  const interval = (minute: number) => ({
    begins_at: `2026-05-03T08:0${minute}:00.000+02:00`,
    watched_s: 60,
    vehicles: 12,
    refused: 0,
    flow_per_hour: 720,
    flow_low: 600,
    flow_high: 800,
    space_mean_speed_mps: figure,
    density_per_km: figure,
    occupancy_percent: figure,
    percentiles: [],
    reasons: [],
  });
  const told = (count: number) => {
    const intervals = [0, 1, 2].slice(0, count).map(interval);
    const scan = {
      scan_id: 3,
      name: "Hill",
      direction: "camera_1_first",
      lane: null,
      unplaced: 0,
      intervals,
    };
    const of = { minutes: 5, length_limits_m: [5] } as unknown as TrafficOfScans;
    render(<OfScan scan={scan as unknown as ScanTraffic} of={of} surveyId={1} />, document.body);
    const rows = document.querySelectorAll("[data-testid=traffic-3] tbody tr").length;
    const figures = [...document.querySelectorAll("[data-testid^=figure-]")];
    const dots = figures.map((one) => one.querySelectorAll("circle").length);
    return { rows, dots, said: document.body.textContent?.includes("a line scan of about 15 min") };
  };
  expect(told(2)).toEqual({ rows: 2, dots: [], said: true });
  await vi.waitFor(() => expect(told(3)).toEqual({ rows: 3, dots: [0, 0, 3, 3], said: false }));
  render(null, document.body);
  vi.unstubAllGlobals();
});

it("says that a figure's uncertainty is not known, with why in the title of its row", async () => {
  await learn("scans");
  const none = { value: null, u: null };
  const scan = {
    name: "Hill",
    direction: "camera_1_first",
    lane: null,
    unplaced: 0,
    intervals: [
      {
        begins_at: "2026-05-03T08:00:00.000+02:00",
        vehicles: 1,
        refused: 1,
        flow_per_hour: 60,
        flow_low: 1,
        flow_high: 300,
        space_mean_speed_mps: none,
        density_per_km: none,
        occupancy_percent: { value: 2.5, u: null },
        percentiles: [],
        reasons: [{ code: "scan-flow-no-u-occupancy", values: { count: 1 }, message: "Not known." }],
      },
    ],
  };
  const of = { minutes: 5, length_limits_m: [5] } as unknown as TrafficOfScans;
  render(<OfScan scan={scan as unknown as ScanTraffic} of={of} surveyId={1} />, document.body);
  const row = document.querySelector("tbody tr");
  const cells = [...(row?.querySelectorAll("td") ?? [])].map((cell) => cell.textContent);
  expect(cells.slice(3)).toEqual(["–", "2.50u\u00a0=\u00a0–", "–"]);
  expect(row?.getAttribute("title")).toContain("known");
  render(null, document.body);
});

it("an interval after midnight is told with its day, under the day of the first", () => {
  const first = "2026-05-03T23:55:00.000+02:00";
  expect(beganWords(first, first)).toBe("23:55:00");
  expect(beganWords("2026-05-04T00:00:00.000+02:00", first)).toMatch(/4 May 2026.*00:00:00/);
});
