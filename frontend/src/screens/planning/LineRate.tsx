/** Equation (2) of the line-scan paper, as printed and corrected, with what both say of a rig. */

import type { ComponentChildren } from "preact";
import { useEffect } from "preact/hooks";
import { Loading, Problem, TableScroll } from "../../components";
import { current, query, setQuery } from "../../core/address";
import { api } from "../../core/api";
import { useResource } from "../../core/resource";
import { fixed, formatCount, formatSmall, formatSpeed, lengthUnit, speedScale } from "../../core/units";
import { Advice } from "./Advice";
import type { LinePlan } from "./model";
import { Value } from "./PlanForm";
import { askLinePlan, completedLines, LINE_NAMES, type Values, valuesOf } from "./values";

export function LineRate({ surveyId }: { surveyId: number }) {
  const scans = useResource(
    (signal) => api.ask("GET /surveys/{survey_id}/scans", { survey_id: surveyId }, { signal }),
    [surveyId],
  );
  const values = scans.data && completedLines(valuesOf(query.value, LINE_NAMES), scans.data);
  const address = JSON.stringify(values);
  useEffect(() => {
    if (values && current.value?.place.name === "planning") setQuery({ ...values });
  }, [address]);
  if (!values)
    return scans.error ? (
      <Problem error={scans.error} again={scans.reload} />
    ) : (
      <Loading what="the survey's rig" />
    );
  return (
    <>
      <Form values={values} />
      <Planned values={values} />
    </>
  );
}

function Form({ values }: { values: Values }) {
  const length = lengthUnit.value;
  return (
    <form class="panel plan-form" onSubmit={(event) => event.preventDefault()}>
      <div class="plan-form__lines">
        <Value name="speed_mps" label="Fastest vehicle" unit={speedScale()[1]} values={values} />
        <Value name="error" label="Speed off by" unit="%" values={values} />
        <Value name="baseline_m" label="Baseline" unit={length} values={values} />
        <Value name="u_baseline_m" label="Its u (k = 1)" unit={length} values={values} />
        <Value
          name="line_rate_hz"
          label="Camera’s line rate"
          unit="Hz"
          values={values}
          placeholder="what it takes"
        />
      </div>
    </form>
  );
}

/** What the server makes of the values; what it says last stays until the next answer is there. */
function Planned({ values }: { values: Values }) {
  const plan = useResource((signal) => askLinePlan(values, signal), [JSON.stringify(values)], { keep: true });
  if (plan.error) return <Problem error={plan.error} />;
  if (!plan.data) return <Loading what="the plan" />;
  return <Result plan={plan.data} />;
}

const percent = (share: number) => `${Number((share * 100).toPrecision(3))}\u00a0%`;

function Result({ plan }: { plan: LinePlan }) {
  const { printed, corrected } = plan;
  return (
    <div class="stack" data-testid="line-plan">
      <section class="panel" aria-labelledby="plan-speed">
        <div class="panel__head">
          <h2 id="plan-speed">What a speed will be worth</h2>
        </div>
        <p class="panel__body plan-line__words">
          At {formatSpeed(plan.speed_mps)} a vehicle takes <b>{fixed(plan.lines, 1)} lines</b> from camera 1
          to camera 2 at {formatCount(plan.line_rate_hz)} lines a second, {formatSmall(plan.one_line_m)} of
          road a line. One line more or less changes its speed by{" "}
          <b>{formatSpeed(plan.one_line_mps, null, 2)}</b>. Read to whole lines its standard uncertainty is{" "}
          {formatSpeed(plan.u_lines_mps, null, 2)} from the lines and{" "}
          {formatSpeed(plan.u_baseline_mps, null, 2)} from the baseline:{" "}
          <b>{formatSpeed(plan.speed_mps, plan.U95_speed_mps, 2)}</b> in 95 of 100 cases.
        </p>
      </section>
      <section class="panel" aria-labelledby="plan-lines">
        <div class="panel__head">
          <h2 id="plan-lines">As printed and as corrected</h2>
        </div>
        <TableScroll label="Both forms of equation (2)">
          <table class="table plan-lines">
            <thead>
              <tr>
                <th>equation (2)</th>
                <th>as printed: its right side</th>
                <th>corrected: its middle term</th>
              </tr>
            </thead>
            <tbody>
              <Row what="error of the speed" printed="2 / (n + 2)" corrected="2 / n" />
              <Row
                what="what it says"
                printed={
                  "n + 2 lines are counted for n, divided by n + 2. The paper’s own 6600\u00a0Hz and 1.3\u00a0% come from it."
                }
                corrected="n + 2 lines are counted for n, divided by n as the middle term 2 s / (b f) is. A little more careful."
              />
              <Row
                what={`line rate for ${percent(plan.error)}`}
                printed={<b>{formatCount(printed.line_rate_hz)} Hz</b>}
                corrected={<b>{formatCount(corrected.line_rate_hz)} Hz</b>}
              />
              <Row
                what={`error at ${formatCount(plan.line_rate_hz)} Hz`}
                printed={`${percent(printed.error)}, ${formatSpeed(printed.error_mps, null, 2)}`}
                corrected={`${percent(corrected.error)}, ${formatSpeed(corrected.error_mps, null, 2)}`}
              />
            </tbody>
          </table>
        </TableScroll>
        <p class="plan-note field__hint">
          n = b f / s: the lines from camera 1 to camera 2, of the baseline b, the line rate f and the speed
          s.
        </p>
      </section>
      <Advice sentences={plan.advice} />
    </div>
  );
}

interface RowProps {
  what: string;
  printed: ComponentChildren;
  corrected: ComponentChildren;
}

function Row({ what, printed, corrected }: RowProps) {
  return (
    <tr>
      <th scope="row">{what}</th>
      <td>{printed}</td>
      <td>{corrected}</td>
    </tr>
  );
}
