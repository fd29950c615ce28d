import { say } from "../../core/messages";
import type { StudyResult } from "../../core/types";
import { lengthScale } from "../../core/units";
import { HEIGHT_WORDS } from "../../core/words";
import { marginOf, standardMarks, standardTiers } from "../../parts/figures/curves";
import { hueOf } from "../../parts/figures/hues";
import { PlotFigure } from "../../parts/figures/PlotFigure";
import { readable } from "../../parts/figures/reading";
import type { Standard } from "../../parts/figures/types";

type Found = StudyResult["found"];
type Curve = Found["curves"][number];

const TRUE_HEIGHTS = {};
const RAW = { dash: "6 4", faint: true };
const REACH_M = 0.15;

/** A target's distribution: percentiles of true heights with their total intervals as a band. */
export function CurveFigure({ curve, rules }: { curve: Curve; rules: Found["rules"] }) {
  const title = HEIGHT_WORDS[curve.target];
  const first = curve.points[0]?.value_m ?? 0;
  const last = curve.points.at(-1)?.value_m ?? 0;
  const standards = rules
    .filter((one) => one.target === curve.target)
    .filter((one) => one.standard_m > first - REACH_M && one.standard_m < last + REACH_M)
    .map((one) => ({ name: one.standard, code: one.standard_code, height_m: one.standard_m }) as Standard);
  const known = curve.points.filter((one) => one.low_m !== null && one.high_m !== null);
  return (
    <PlotFigure
      name={`study-${curve.target}`}
      title={say("study-curve-title", { target: title })}
      says={say("study-curve-says", { target: title })}
      note={say("study-curve-note")}
      legend={[{ word: say("study-curve-true") }, { word: say("study-curve-raw"), ...RAW }]}
      data={[curve]}
      options={(plot, unit) => {
        const [perX, long] = lengthScale(unit);
        const tiers = standardTiers(standards, perX, long, (first + last) / 2);
        const band = known.map((one) => ({
          y: one.percent,
          low: (one.low_m ?? 0) * perX,
          high: (one.high_m ?? 0) * perX,
        }));
        const points = curve.points.map((one) => ({
          y: one.percent,
          x: one.value_m * perX,
          raw: one.raw_m * perX,
        }));
        return {
          marginTop: marginOf(tiers),
          height: 296 + marginOf(tiers),
          x: { label: say("statistics-height-x", { unit: long }), nice: true, inset: 16 },
          y: { label: say("figure-share-of-vehicles"), domain: [0, 100] },
          marks: [
            ...standardMarks(plot, tiers),
            plot.areaX(band, { y: "y", x1: "low", x2: "high", fill: hueOf(TRUE_HEIGHTS), fillOpacity: 0.13 }),
            readable(
              plot.line(points, {
                x: "raw",
                y: "y",
                stroke: hueOf(RAW),
                strokeWidth: 1.5,
                strokeDasharray: RAW.dash,
              }),
              {
                word: say("study-curve-raw"),
                x: points.map((one) => one.raw),
                y: points.map((one) => one.y),
                way: "line",
              },
            ),
            readable(plot.line(points, { x: "x", y: "y", stroke: hueOf(TRUE_HEIGHTS), strokeWidth: 2 }), {
              word: say("study-curve-true"),
              x: points.map((one) => one.x),
              y: points.map((one) => one.y),
              way: "line",
            }),
          ],
        };
      }}
      table={() => ({
        columns: ["percent", "true_height_m", "total95_low_m", "total95_high_m", "random_error_left_in_m"],
        rows: curve.points.map((one) => [one.percent, one.value_m, one.low_m, one.high_m, one.raw_m]),
      })}
    />
  );
}
