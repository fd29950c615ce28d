import { DataTable, num, Table } from "../../components";
import { say, sentenceOf, wordsOf } from "../../core/messages";
import type { Category, StudyResult } from "../../core/types";
import {
  formatCount,
  formatSmall,
  lengthScale,
  lengthUnit,
  plainHeight,
  plainPercent,
} from "../../core/units";
import { CATEGORY_WORDS, HEIGHT_WORDS, LIGHTING_WORDS } from "../../core/words";
import { Differences } from "../../parts/figures/Differences";
import { Bounded } from "../../parts/figures/FigureCell";
import { NONE, percent, scaled } from "../../parts/figures/numbers";
import { SameRule } from "../../parts/figures/SameRule";
import { CurveFigure } from "./CurveFigure";
import { Section } from "./Section";

type Found = StudyResult["found"];
type Row = Found["figures"][number];
type Year = Found["years"][number];

/** What came out of a study: percentiles with their total intervals first, then what they change. */
export function Figures({ found }: { found: Found }) {
  const targets = [...new Set(found.figures.map((one) => one.target))];
  const measured = targets.filter((one) => found.figures.some((row) => row.target === one && row.n > 0));
  const consequence = found.consequence?.[lengthUnit.value] ?? found.consequence?.m;
  return (
    <>
      <p data-testid="study-counted">
        {say("study-counted-words", {
          heights: found.heights,
          vehicles: found.vehicles,
          sites: new Set(found.packages.map((one) => one.site)).size,
        })}
      </p>
      <Percentiles found={found} targets={measured} />
      <SameRule rules={found.rules.map(asRule)} ofChosen={false} />
      {consequence && (
        <p class="panel panel__body" data-testid="study-consequence">
          {consequence}
        </p>
      )}
      {found.years.length > 0 && <Years years={found.years} />}
      <div class="study-figures">
        {found.curves.map((one) => (
          <CurveFigure key={one.target} curve={one} rules={found.rules} />
        ))}
      </div>
      <Effects rows={found.figures} targets={measured} />
      {found.errors.length > 0 && <Errors rows={found.errors} />}
      {found.classes.length > 0 && <Classes rows={found.classes} />}
      {found.plan.length > 0 && <Plan rows={found.plan} />}
    </>
  );
}

function asRule(one: Found["rules"][number]) {
  const { standard: name, standard_code: code, what, percent: at, vehicle_class, standard_m } = one;
  return {
    ...one,
    standard: { name, code, what, percent: at, vehicle_class, height_m: standard_m },
    U95_low_m: one.low_m,
    U95_high_m: one.high_m,
  };
}

const nameOf = (one: Row) =>
  one.figure === "percentile"
    ? `P${plainPercent(one.percent)}`
    : say(one.figure === "mean" ? "study-mean" : "study-sd");

export function Percentiles({ found, targets }: { found: Found; targets: readonly Row["target"][] }) {
  const unit = lengthScale()[1];
  const columns = found.figures.filter((one) => one.target === longest(found.figures));
  return (
    <Section id="study-percentiles" title={say("study-percentiles", { unit })} note={say("study-holds")}>
      <Table class="table--dense" heads={[say("study-target"), ...columns.map((one) => num(nameOf(one)))]}>
        {targets.map((target) => {
          const rows = found.figures.filter((one) => one.target === target);
          const reason = rows.length === 1 ? sentenceOf(rows[0]?.reason ?? null) : null; // no figure at all
          return (
            <tr key={target}>
              <th scope="row">
                {HEIGHT_WORDS[target]}
                <div class="stat-ci">{say("study-n", { n: rows[0]?.n ?? 0 })}</div>
              </th>
              {reason ? (
                <td colSpan={columns.length}>{reason}</td>
              ) : (
                rows.map((one) => (
                  <td key={nameOf(one)} class="num" title={sentenceOf(one.reason) ?? undefined}>
                    <Bounded value={one.value_m} low={one.low_m} high={one.high_m} print={plainHeight} />
                  </td>
                ))
              )}
            </tr>
          );
        })}
      </Table>
    </Section>
  );
}

/** The target with the most figures, whose names head the table. */
function longest(rows: readonly Row[]): Row["target"] | undefined {
  const counts = new Map<Row["target"], number>();
  for (const { target } of rows) counts.set(target, (counts.get(target) ?? 0) + 1);
  return [...counts].sort((a, b) => b[1] - a[1])[0]?.[0];
}

/** The design effect of each target's median and P10, and how many vehicles drawn one by one tell as much. */
function Effects({ rows, targets }: { rows: readonly Row[]; targets: readonly Row["target"][] }) {
  const shown = rows.filter(
    (one) =>
      targets.includes(one.target) &&
      one.design_effect !== null &&
      (one.figure === "mean" || one.percent === 10 || one.percent === 50),
  );
  if (shown.length === 0) return null;
  return (
    <Section id="study-effects" title={say("study-effects")} note={say("study-effects-note")}>
      <DataTable
        rows={shown}
        keyOf={(one) => one.target + nameOf(one)}
        columns={({ num, rowHead }) => [
          rowHead(say("study-figure"), (one) => (
            <>
              {HEIGHT_WORDS[one.target]}, {nameOf(one)}
            </>
          )),
          num(say("study-vehicles"), (one) => formatCount(one.n)),
          num(say("study-effect"), (one) => scaled(one.design_effect, 1, 2)),
          num(say("study-effective"), (one) =>
            one.effective_n === null ? NONE : formatCount(one.effective_n),
          ),
          num(say("study-weighting"), (one) => scaled(one.weighting_effect, 1, 2)),
        ]}
      />
    </Section>
  );
}

function Years({ years }: { years: readonly Year[] }) {
  const between = (one: Year) =>
    say("study-years-of", { first: String(one.first_year), second: String(one.second_year) });
  return (
    <Section id="study-years" title={say("study-years")} note={say("study-years-note")}>
      <Differences
        rows={years.map((one) => ({ ...one, between: between(one) }))}
        column={say("study-years-column")}
      />
    </Section>
  );
}

const ERRORS = wordsOf({
  bias_m: "study-bias",
  mae_m: "statistics-error-mae_m",
  rmse_m: "statistics-error-rmse_m",
  sd_m: "study-sd",
});

function Errors({ rows }: { rows: Found["errors"] }) {
  const groups = [...new Set(rows.map((one) => one.group))];
  const nOf = (group: string) => rows.find((one) => one.group === group)?.n ?? 0;
  return (
    <Section id="study-errors" title={say("study-errors")} note={say("study-errors-note")}>
      <DataTable
        rows={groups}
        keyOf={(group) => group}
        columns={({ num, rowHead }) => [
          rowHead(say("study-lighting"), lightingOf),
          num(say("study-vehicles"), (group) => formatCount(nOf(group))),
          ...Object.entries(ERRORS).map(([figure, word]) =>
            num(word, (group) => {
              const one = rows.find((row) => row.group === group && row.figure === figure);
              return <Bounded value={one?.value_m} low={one?.low_m} high={one?.high_m} print={formatSmall} />;
            }),
          ),
        ]}
      />
    </Section>
  );
}

function lightingOf(group: string): string {
  if (group === "daytime" || group === "low_light") return LIGHTING_WORDS[group];
  return say("study-all");
}

function Classes({ rows }: { rows: Found["classes"] }) {
  const all = rows.filter((one) => one.group === "all");
  return (
    <Section id="study-classes" title={say("study-classes")} note={say("study-classes-note")}>
      <DataTable
        rows={all}
        keyOf={(one) => one.category}
        columns={({ num, rowHead }) => [
          rowHead(say("study-class"), (one) => CATEGORY_WORDS[one.category as Category] ?? one.category),
          num(say("study-vehicles"), (one) => formatCount(one.n)),
          num(say("study-share"), ({ share, low, high }) => (
            <Bounded value={share} low={low} high={high} print={percent} />
          )),
          num(say("study-fleet-share"), (one) =>
            one.fleet_share === null ? NONE : percent(one.fleet_share),
          ),
        ]}
      />
    </Section>
  );
}

function Plan({ rows }: { rows: Found["plan"] }) {
  const targets = [...new Set(rows.map((one) => one.target))];
  const sites = [...new Set(rows.map((one) => one.sites))];
  const goal = formatSmall(rows[0]?.goal_U95_m ?? 0);
  return (
    <Section id="study-plan" title={say("study-plan", { goal })} note={say("study-plan-note")}>
      <DataTable
        rows={sites}
        keyOf={(count) => count}
        columns={({ num }) => [
          { ...num(say("study-plan-sites"), (count) => count), rowHead: true },
          ...targets.map((target) =>
            num(HEIGHT_WORDS[target], (count) => {
              const one = rows.find((row) => row.target === target && row.sites === count);
              return one?.vehicles_each ? formatCount(one.vehicles_each) : say("study-plan-none");
            }),
          ),
        ]}
      />
    </Section>
  );
}
