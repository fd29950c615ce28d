/** What a rig of line cameras will be worth, and equation (2) of the line-scan paper beside it. */
import { useEffect } from "preact/hooks";
import { DataTable, Loaded, Panel } from "../../components";
import { Said } from "../../components/Said";
import { current, query, setQuery } from "../../core/address";
import { region, say, wordsOf } from "../../core/messages";
import { useAsked, useResource } from "../../core/resource";
import { fixed, formatHeight, formatSeconds, formatSmall, formatSpeed } from "../../core/units";
import { Advice } from "./Advice";
import type { LinePlan } from "./model";
import { ValueFields } from "./PlanForm";
import { askLinePlan, completedLines, LINE_NAMES, type Values, valuesOf } from "./values";

export function LineRate({ surveyId }: { surveyId: number }) {
  const scans = useAsked("GET /surveys/{survey_id}/scans", { survey_id: surveyId });
  const values = scans.data && completedLines(valuesOf(query.value, LINE_NAMES), scans.data);
  const address = JSON.stringify(values);
  useEffect(() => {
    if (values && current.value?.place.name === "planning") setQuery({ ...values });
  }, [address, query.value]);
  if (!values) return <Loaded of={scans} what={say("planning-loading-rig")} />;
  return (
    <>
      <form class="panel panel__body stack plan-form" onSubmit={(event) => event.preventDefault()}>
        <div class="grid grid--fit grid--low" style={{ "--least": "132px" }}>
          <ValueFields words={LINES} values={values} />
        </div>
      </form>
      <Planned values={values} />
    </>
  );
}

const LINES = wordsOf("planning-lines-", ...LINE_NAMES);

/** What the server makes of the values; what it says last stays until the next answer is there. */
function Planned({ values }: { values: Values }) {
  const plan = useResource((signal) => askLinePlan(values, signal), [JSON.stringify(values)], { keep: true });
  if (plan.error || !plan.data) return <Loaded of={plan} what={say("planning-loading")} />;
  return <Result plan={plan.data} />;
}

function percent(share: number): string {
  const digits = new Intl.NumberFormat(region.value, { maximumSignificantDigits: 3 });
  return `${digits.format(share * 100)}\u00a0%`;
}

const lineRateWords = (line_rate_hz: number) =>
  say("planning-forms-line-rate-value", { line_rate_hz: fixed(line_rate_hz, 0) });

const errorWords = (one: { error: number; error_mps: number }) =>
  say("planning-forms-error-value", {
    error: percent(one.error),
    speed: formatSpeed(one.error_mps, null, 2),
  });

function Result({ plan }: { plan: LinePlan }) {
  const { printed, corrected } = plan;
  return (
    <div class="stack" data-testid="line-plan">
      <Panel says="planning-speed-title">
        <p class="panel__body words">
          <Said
            what="planning-lines"
            values={{
              speed: formatSpeed(plan.speed_mps),
              lines: fixed(plan.lines, 1),
              line_rate_hz: fixed(plan.line_rate_hz, 0),
              one_line: formatSmall(plan.one_line_m),
            }}
          />{" "}
          <Said
            what="planning-speed-u"
            values={{
              u_strips: formatSpeed(plan.u_strips_mps, null, 2),
              u_baseline: formatSpeed(plan.u_baseline_mps, null, 2),
              speed: formatSpeed(plan.speed_mps, plan.U95_speed_mps, 2),
            }}
          />
        </p>
      </Panel>
      <ExpectedValues plan={plan} />
      {plan.exposure && <Exposure plan={plan} exposure={plan.exposure} />}
      <Panel says="planning-forms-title">
        <DataTable
          label={say("planning-forms-label")}
          class="plan-lines"
          rows={[
            [say("planning-forms-error"), "2 / (n + 2)", "2 / n"],
            [
              say("planning-forms-says"),
              say("planning-forms-says-printed"),
              say("planning-forms-says-corrected"),
            ],
            [
              say("planning-forms-line-rate", { error: percent(plan.error) }),
              <b>{lineRateWords(printed.line_rate_hz)}</b>,
              <b>{lineRateWords(corrected.line_rate_hz)}</b>,
            ],
            [
              say("planning-forms-error-at", { line_rate_hz: fixed(plan.line_rate_hz, 0) }),
              errorWords(printed),
              errorWords(corrected),
            ],
          ]}
          keyOf={(_, at) => at}
          columns={({ col, rowHead }) => [
            rowHead(say("planning-forms-equation"), ([what]) => what),
            col(say("planning-forms-printed"), ([, inPrint]) => inPrint),
            col(say("planning-forms-corrected"), ([, , right]) => right),
          ]}
        />
        <p class="panel__note field__hint">{say("planning-forms-note")}</p>
      </Panel>
      <Advice advice={plan.advice} />
    </div>
  );
}

const QUANTITIES = wordsOf("planning-values-", "speed", "length", "time_gap", "distance_gap");

/** Speed, length and gaps with what their uncertainty is made of. */
function ExpectedValues({ plan }: { plan: LinePlan }) {
  return (
    <Panel says="planning-values-title" note={say("planning-values-note")}>
      <DataTable
        label={say("planning-values-title")}
        data-testid="line-plan-values"
        rows={plan.values}
        keyOf={(one) => one.quantity}
        columns={({ num, rowHead }) => [
          rowHead(say("planning-values-quantity"), (one) => QUANTITIES[one.quantity]),
          num(say("planning-values-value"), (one) => valueWords(one)),
          num(say("planning-values-strips"), (one) => partWords(one.quantity, one.u_strips)),
          num(say("planning-values-baseline"), (one) => partWords(one.quantity, one.u_baseline)),
          num(say("planning-values-edges"), (one) => partWords(one.quantity, one.u_edges)),
        ]}
      />
    </Panel>
  );
}

type PlannedValue = LinePlan["values"][number];

function valueWords({ quantity, value, U95 }: PlannedValue): string {
  if (quantity === "speed") return formatSpeed(value, U95, 2);
  if (quantity !== "time_gap") return formatHeight(value, U95, quantity === "length" ? 3 : 2);
  return formatSeconds(value, U95, 4);
}

function partWords(quantity: PlannedValue["quantity"], u: number): string {
  if (quantity === "speed") return formatSpeed(u, null, 2);
  return quantity === "time_gap" ? say("planning-ms", { value: fixed(1000 * u, 2) }) : formatSmall(u);
}

function Exposure({ plan, exposure }: { plan: LinePlan; exposure: NonNullable<LinePlan["exposure"]> }) {
  return (
    <Panel says="planning-exposure-title">
      <div class="panel__body words" data-testid="line-plan-exposure">
        <p>
          <Said
            what="planning-exposure-blur"
            values={{
              exposure_us: fixed(exposure.exposure_us, 0),
              blur: formatSmall(exposure.blur_m),
              line: formatSmall(plan.one_line_m),
              width: formatSmall(exposure.pixel_width_m),
              height: formatSmall(exposure.pixel_height_m),
              smear: formatSmall(exposure.smear_m),
            }}
          />{" "}
          <Said
            what="planning-exposure-shape"
            values={{ shape: fixed(exposure.shape, 2), row_error: percent(exposure.row_error) }}
          />{" "}
          <Said what="planning-exposure-light" values={{ light: fixed(exposure.light, 2) }} />
        </p>
        {exposure.hints.map((hint) => (
          <p key={hint}>{HINTS[hint]}</p>
        ))}
      </div>
    </Panel>
  );
}

const HINTS = wordsOf("planning-exposure-", "dark", "wide", "tall");
