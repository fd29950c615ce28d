import { say } from "../../core/messages";
import { lengthScale, speedScale } from "../../core/units";
import { PlotFigure } from "../../parts/figures/PlotFigure";
import { readable, readRows } from "../../parts/figures/reading";
import { CASE_WORDS, type Case, type Sight } from "./model";

const DASHES: Record<string, string | undefined> = { standard: "6 4", survey: undefined, mix: "2 3" };

type Row = ReturnType<typeof rowsOf>[number];

const AT = {
  x: (row: Row) => row.speed,
  y: (row: Row) => row.k,
  low: (row: Row) => row.low,
  high: (row: Row) => row.high,
};

export function KFigure({ sight }: { sight: Sight }) {
  const shown = sight.cases.filter((one) => one.crest !== null);
  const banded = shown.some((one) => one.name !== "standard" && one.k_m.some((k) => k.low !== null));
  return (
    <PlotFigure
      name="crest-k"
      title={say("sight-figure-title")}
      says={say("sight-figure-says")}
      note={say("sight-figure-note", { bands: banded ? 1 : 0 })}
      legend={shown.map((one) => ({
        word: CASE_WORDS[one.name],
        dash: DASHES[one.name],
        faint: one.name === "standard",
      }))}
      data={sight}
      options={(plot, unit) => {
        const [perX, speedUnit] = speedScale(unit);
        const [perY, long] = lengthScale(unit);
        const rows = new Map(shown.map((one) => [one.name, rowsOf(one, sight, perX, perY)]));
        return {
          x: { label: say("sight-figure-x", { unit: speedUnit }) },
          y: { label: say("sight-figure-y", { unit: long }), zero: true, nice: true },
          marks: shown.flatMap((one) => {
            const points = rows.get(one.name) ?? [];
            const ink = one.name === "standard" ? "var(--ink-3)" : "var(--ink)";
            const banded = points.filter((point) => point.low !== null);
            return [
              plot.areaY(banded, { x: AT.x, y1: AT.low, y2: AT.high, fill: "var(--ink)", fillOpacity: 0.14 }),
              readable(
                plot.line(points, {
                  ...{ x: AT.x, y: AT.y, stroke: ink },
                  strokeWidth: one.name === "standard" ? 3 : 1.8,
                  strokeDasharray: DASHES[one.name],
                }),
                readRows(points, AT, "line", CASE_WORDS[one.name]),
              ),
              plot.dot(points, { x: AT.x, y: AT.y, r: 2.5, fill: ink }),
            ];
          }),
        };
      }}
      table={() => ({
        columns: ["case", "speed_mps", "sight_distance_m", "k_m", "ci95_low_m", "ci95_high_m"],
        rows: shown.flatMap((one) =>
          one.k_m.map((k, i) => [
            one.name,
            sight.speeds_mps[i] ?? null,
            sight.distances_m[i] ?? null,
            k.value,
            k.low,
            k.high,
          ]),
        ),
      })}
    />
  );
}

function rowsOf(one: Case, sight: Sight, perX: number, perY: number) {
  const scaled = (value: number | null) => (value === null ? null : value * perY);
  return one.k_m.map((k, i) => ({
    speed: Number(((sight.speeds_mps[i] ?? 0) * perX).toFixed(6)), // 30 km/h, not 30.000000000000004
    k: k.value * perY,
    low: scaled(k.low),
    high: scaled(k.high),
  }));
}
