/** Equation (2) of the line-scan paper, as printed and corrected, with what both say of a rig. */

import type { ComponentChildren } from "preact";
import { useEffect } from "preact/hooks";
import { Loading, Problem, TableScroll } from "../../components";
import { Said } from "../../components/Said";
import { current, query, setQuery } from "../../core/address";
import { api } from "../../core/api";
import { region, say } from "../../core/messages";
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
  }, [address, query.value]);
  if (!values)
    return scans.error ? (
      <Problem error={scans.error} again={scans.reload} />
    ) : (
      <Loading what={say("planning-loading-rig")} />
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
        <Value name="speed_mps" label={say("planning-speed")} unit={speedScale()[1]} values={values} />
        <Value name="error" label={say("planning-error")} unit="%" values={values} />
        <Value name="baseline_m" label={say("planning-baseline")} unit={length} values={values} />
        <Value name="u_baseline_m" label={say("planning-u-baseline")} unit={length} values={values} />
        <Value
          name="line_rate_hz"
          label={say("planning-line-rate")}
          unit={say("unit-hz")}
          values={values}
          placeholder={say("planning-line-rate-usual")}
        />
      </div>
    </form>
  );
}

/** What the server makes of the values; what it says last stays until the next answer is there. */
function Planned({ values }: { values: Values }) {
  const plan = useResource((signal) => askLinePlan(values, signal), [JSON.stringify(values)], { keep: true });
  if (plan.error) return <Problem error={plan.error} />;
  if (!plan.data) return <Loading what={say("planning-loading")} />;
  return <Result plan={plan.data} />;
}

/** "1.3 %" */
function percent(share: number): string {
  const digits = new Intl.NumberFormat(region.value, { maximumSignificantDigits: 3 });
  return `${digits.format(share * 100)}\u00a0%`;
}

const lineRateWords = (line_rate_hz: number) =>
  say("planning-forms-line-rate-value", { line_rate_hz: formatCount(line_rate_hz) });

const errorWords = (one: { error: number; error_mps: number }) =>
  say("planning-forms-error-value", {
    error: percent(one.error),
    speed: formatSpeed(one.error_mps, null, 2),
  });

function Result({ plan }: { plan: LinePlan }) {
  const { printed, corrected } = plan;
  return (
    <div class="stack" data-testid="line-plan">
      <section class="panel" aria-labelledby="plan-speed">
        <div class="panel__head">
          <h2 id="plan-speed">{say("planning-speed-title")}</h2>
        </div>
        <p class="panel__body plan-line__words">
          <Said
            what="planning-lines"
            values={{
              speed: formatSpeed(plan.speed_mps),
              lines: fixed(plan.lines, 1),
              line_rate_hz: formatCount(plan.line_rate_hz),
              one_line: formatSmall(plan.one_line_m),
            }}
          />{" "}
          <Said what="planning-one-line" values={{ speed: formatSpeed(plan.one_line_mps, null, 2) }} />{" "}
          <Said
            what="planning-speed-u"
            values={{
              u_lines: formatSpeed(plan.u_lines_mps, null, 2),
              u_baseline: formatSpeed(plan.u_baseline_mps, null, 2),
              speed: formatSpeed(plan.speed_mps, plan.U95_speed_mps, 2),
            }}
          />
        </p>
      </section>
      <section class="panel" aria-labelledby="plan-lines">
        <div class="panel__head">
          <h2 id="plan-lines">{say("planning-forms-title")}</h2>
        </div>
        <TableScroll label={say("planning-forms-label")}>
          <table class="table plan-lines">
            <thead>
              <tr>
                <th>{say("planning-forms-equation")}</th>
                <th>{say("planning-forms-printed")}</th>
                <th>{say("planning-forms-corrected")}</th>
              </tr>
            </thead>
            <tbody>
              <Row what={say("planning-forms-error")} printed="2 / (n + 2)" corrected="2 / n" />
              <Row
                what={say("planning-forms-says")}
                printed={say("planning-forms-says-printed")}
                corrected={say("planning-forms-says-corrected")}
              />
              <Row
                what={say("planning-forms-line-rate", { error: percent(plan.error) })}
                printed={<b>{lineRateWords(printed.line_rate_hz)}</b>}
                corrected={<b>{lineRateWords(corrected.line_rate_hz)}</b>}
              />
              <Row
                what={say("planning-forms-error-at", { line_rate_hz: formatCount(plan.line_rate_hz) })}
                printed={errorWords(printed)}
                corrected={errorWords(corrected)}
              />
            </tbody>
          </table>
        </TableScroll>
        <p class="plan-note field__hint">{say("planning-forms-note")}</p>
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
