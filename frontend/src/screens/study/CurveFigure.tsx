import { say } from "../../core/messages";
import type { Standard, StudyResult } from "../../core/types";
import { lengthScale } from "../../core/units";
import { HEIGHT_WORDS } from "../../core/words";
import { standardAxes, standardMarks, standardTiers } from "../../parts/figures/curves";
import { hueOf } from "../../parts/figures/hues";
import { PlotFigure } from "../../parts/figures/PlotFigure";
import { readable, readRows } from "../../parts/figures/reading";

type Found = StudyResult["found"];
type Curve = Found["curves"][number];
type Point = Curve["points"][number];

const TRUE_HEIGHTS = {};
const RAW = { dash: "6 4", faint: true };
const REACH_M = 0.15;

/** A target's distribution: percentiles of true heights with their total intervals as a band. */
export function CurveFigure({ curve, rules }: { curve: Curve; rules: Found["rules"] }) {
  const title = HEIGHT_WORDS[curve.target];
  const { points } = curve;
  const first = points[0]?.value_m ?? 0;
  const last = points.at(-1)?.value_m ?? 0;
  const standards = rules
    .filter((one) => one.target === curve.target)
    .filter((one) => one.standard_m > first - REACH_M && one.standard_m < last + REACH_M)
    .map((one) => ({ name: one.standard, code: one.standard_code, height_m: one.standard_m }) as Standard);
  const known = points.filter((one) => one.low_m !== null && one.high_m !== null);
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
        const y = (one: Point) => one.percent;
        const ofRaw = { x: (one: Point) => one.raw_m * perX, y };
        const ofTrue = { x: (one: Point) => one.value_m * perX, y };
        return {
          ...standardAxes(tiers, long),
          marks: [
            ...standardMarks(plot, tiers),
            plot.areaX(known, {
              y,
              x1: (one) => (one.low_m ?? 0) * perX,
              x2: (one) => (one.high_m ?? 0) * perX,
              fill: hueOf(TRUE_HEIGHTS),
              fillOpacity: 0.13,
            }),
            readable(
              plot.line(points, {
                ...ofRaw,
                stroke: hueOf(RAW),
                strokeWidth: 1.5,
                strokeDasharray: RAW.dash,
              }),
              readRows(points, ofRaw, "line", say("study-curve-raw")),
            ),
            readable(
              plot.line(points, { ...ofTrue, stroke: hueOf(TRUE_HEIGHTS), strokeWidth: 2 }),
              readRows(points, ofTrue, "line", say("study-curve-true")),
            ),
          ],
        };
      }}
      table={() => ({
        columns: ["percent", "true_height_m", "total95_low_m", "total95_high_m", "random_error_left_in_m"],
        rows: points.map((one) => [one.percent, one.value_m, one.low_m, one.high_m, one.raw_m]),
      })}
    />
  );
}
