import { DataTable, Notice, Panel } from "../../components";
import { Said } from "../../components/Said";
import { allOf, say, sentenceOf } from "../../core/messages";
import type { Density, Ecdf, Percentile, Standard, TargetBody } from "../../core/types";
import { fixed, formatLength, lengthScale, plainHeight, plainPercent } from "../../core/units";
import { HEIGHT_WORDS } from "../../core/words";
import { csvOf, download } from "../../parts/figures/csv";
import {
  type Curve,
  DENSITY_COLUMNS,
  densityMarks,
  densityRows,
  ECDF_COLUMNS,
  ecdfMarks,
  ecdfRows,
  middleOf,
  nearby,
  noBandWords,
  shareStep,
  standardAxes,
  standardMarks,
  standardTiers,
} from "../../parts/figures/curves";
import { FileButton } from "../../parts/figures/FileButton";
import { percent } from "../../parts/figures/numbers";
import { PlotFigure } from "../../parts/figures/PlotFigure";
import { formatLimit, inWords } from "../../parts/figures/standards";
import { asInPaper } from "./filters";
import { isThere } from "./model";

const rawCurve = (): Curve => ({ word: say("statistics-curve-raw"), dash: "6 4", faint: true });
const correctedCurve = (): Curve => ({ word: say("statistics-curve-corrected"), band: true });

interface Props {
  target: TargetBody;
  standards: readonly Standard[];
}

/** One target: its distribution raw and corrected, its percentiles, and who sits below the standards. */
export function TargetSection({ target, standards }: Props) {
  const title = HEIGHT_WORDS[target.target];
  const { corrected } = target;
  return (
    <Panel
      id={`stat-${target.target}`}
      label={title}
      note={heightsWords(target)}
      class="stat-target"
      data-testid={`target-${target.target}`}
    >
      <div class="stack stack--tight pad stat-target__words small">
        <p data-testid={`correction-${target.target}`}>{sentenceOf(corrected.reason ?? corrected.words)}</p>
        {corrected.warning && <Notice kind="warning">{sentenceOf(corrected.warning)}</Notice>}
      </div>
      <div class={`stat-figures stat-figures--inside${asInPaper() ? "" : " stat-figures--one"}`}>
        <EcdfFigure target={target} standards={standards} title={title} />
        {asInPaper() && <HeightDensity target={target} title={title} />}
      </div>
      <Shares target={target} standards={standards} />
      <Percentiles target={target} />
    </Panel>
  );
}

function heightsWords({ raw: { n: count }, corrected: { mean_m, sd_m } }: TargetBody): string {
  if (mean_m === null) return say("statistics-heights", { count });
  const mean = formatLength(mean_m);
  if (sd_m === null) return say("statistics-heights-mean", { count, mean });
  return say("statistics-heights-mean-sd", { count, mean, sd: formatLength(sd_m) });
}

function EcdfFigure({ target, standards, title }: Props & { title: string }) {
  const paper = asInPaper();
  const raw = paper && isThere<Ecdf>(target.raw.ecdf) ? target.raw.ecdf : null;
  const corrected = isThere<Ecdf>(target.corrected.ecdf) ? target.corrected.ecdf : null;
  const both = [raw, corrected].filter((one) => one !== null);
  const shown = nearby(standards, both);
  const away = standards.length - shown.length;
  const note = [noBandWords(target.corrected.n) ?? say("statistics-target-ecdf-note")];
  if (away > 0) note.push(say("statistics-target-ecdf-away", { count: away }));
  const { dash, faint } = rawCurve();
  return (
    <PlotFigure
      name={`${target.target}-ecdf`}
      title={say("statistics-target-ecdf-title", { target: title })}
      says={say("statistics-target-ecdf-says", { target: title, count: target.raw.n })}
      note={note.join(" ")}
      legend={
        paper ? [{ word: correctedCurve().word }, { word: say("statistics-legend-raw"), dash, faint }] : []
      }
      reason={both.length === 0 ? say("statistics-target-nothing") : null}
      data={[target, paper, shown.map((one) => one.name + one.height_m).join()]}
      options={(plot, unit) => {
        const [perX, long] = lengthScale(unit);
        const tiers = standardTiers(shown, perX, long, middleOf(both));
        return {
          ...standardAxes(tiers, long),
          marks: [
            ...standardMarks(plot, tiers),
            ...(raw ? ecdfMarks(plot, raw, rawCurve(), perX) : []),
            ...(corrected ? ecdfMarks(plot, corrected, correctedCurve(), perX) : []),
          ],
        };
      }}
      table={() => ({
        columns: ["distribution", "height_m", ...ECDF_COLUMNS],
        rows: [...(raw ? ecdfRows("raw", raw) : []), ...(corrected ? ecdfRows("corrected", corrected) : [])],
      })}
    />
  );
}

function HeightDensity({ target, title }: { target: TargetBody; title: string }) {
  const density = isThere<Density>(target.density) ? target.density : null;
  return (
    <PlotFigure
      name={`${target.target}-density`}
      title={say("statistics-target-density-title", { target: title })}
      says={say("statistics-target-density-says", { target: title })}
      note={say("statistics-target-density-note")}
      reason={"reason" in target.density ? sentenceOf(target.density.reason) : null}
      data={target}
      options={(plot, unit) => {
        const [perX, long] = lengthScale(unit);
        return {
          x: { label: say("statistics-height-x", { unit: long }), nice: true },
          y: { label: say("statistics-density-y", { unit: shareStep(unit).name }), zero: true, nice: true },
          marks: [...(density ? densityMarks(plot, density, correctedCurve(), perX, shareStep(unit).m) : [])],
        };
      }}
      table={() => ({
        columns: ["distribution", "height_m", ...DENSITY_COLUMNS],
        rows: density ? densityRows("corrected", density) : [],
      })}
    />
  );
}

type TotalFigure = NonNullable<TargetBody["total"]>["shares"][number];

/** The share of true heights in place of that of the corrected ones, where it has an interval. */
function inTotal(one: TotalFigure | undefined) {
  if (!one || one.value === null || one.U95_low === null || one.U95_high === null) return {};
  return { share: one.value, low: one.U95_low, high: one.U95_high };
}

/** "Which share of drivers sits below it", with its interval. */
export function Shares({ target, standards }: Props) {
  const of = target.target;
  const names = new Set(standards.map((one) => `${one.name}|${one.height_m}`));
  const { shares: total } = target.total ?? { shares: [] };
  const shares = target.corrected.shares
    .map((one, i) => ({ ...one, ...inTotal(total[i]) }))
    .filter((one) => names.has(`${one.standard.name}|${one.standard.height_m}`));
  if (of === "roof" || shares.length === 0) return null; // no standard speaks of roofs
  return (
    <ul class="stack stack--dense stat-shares" data-testid={`shares-${target.target}`}>
      {shares.map((one) => (
        <li key={`${one.standard.name}${one.standard.height_m}`}>
          <Said
            what="statistics-share"
            values={{
              target: of,
              height: formatLimit(one.standard.height_m),
              standard: inWords(one.standard).name,
              share: percent(one.share),
              low: fixed(100 * one.low, 1),
              high: fixed(100 * one.high, 1),
              below: one.below,
              n: one.n,
            }}
          />
        </li>
      ))}
    </ul>
  );
}

/** Percentiles that no rule asks for. */
const ONLY_IN_PAPER: readonly number[] = [2, 98];

/** The percentiles of one target: of the true heights, where they are known. */
export function Percentiles({ target }: { target: TargetBody }) {
  if (target.raw.percentiles.length === 0) return null;
  const paper = asInPaper();
  const kept = <T extends { percent: number }>(list: readonly T[]) =>
    paper ? list : list.filter((one) => !ONLY_IN_PAPER.includes(one.percent));
  const rows = kept(target.corrected.percentiles);
  const unit = lengthScale()[1];
  const shown = rows.length > 0 ? rows : kept(target.raw.percentiles);
  const { total } = target;
  const first = total ? kept(total.percentiles).map(ofTotal) : shown;
  const title = say("statistics-percentiles", { target: HEIGHT_WORDS[target.target] });
  const told: { of: "true" | "corrected" | "raw"; list: readonly Percentile[]; strong?: boolean }[] = [];
  if (total) told.push({ of: "true", list: first, strong: true });
  if (rows.length > 0 && (paper || !total)) told.push({ of: "corrected", list: rows, strong: !total });
  if (paper || rows.length === 0) told.push({ of: "raw", list: kept(target.raw.percentiles) });
  return (
    <div class="stat-percentiles">
      <DataTable
        label={title}
        aria-label={title}
        data-testid={`percentiles-${target.target}`}
        rows={told}
        keyOf={({ of }) => of}
        columns={({ num, rowHead }) => [
          rowHead(say("statistics-percentile"), ({ of }) => say(`statistics-percentiles-${of}`, { unit })),
          ...shown.map((one, at) =>
            num(plainPercent(one.percent), ({ list, strong }) => <At one={list[at]} strong={strong} />),
          ),
        ]}
      />
      <div class="row row--apart stat-notes small">
        <div class="grow">
          {total && (
            <span data-testid={`holds-${target.target}`}>
              {say("statistics-percentiles-total", { words: sentenceOf(total.words) })}{" "}
            </span>
          )}
          {say("statistics-percentiles-note")}
          <NoIntervals rows={first} />
        </div>
        <FileButton as="csv" save={() => save(target)} title={say("statistics-percentiles-save")} />
      </div>
    </div>
  );
}

type TotalPercentile = NonNullable<TargetBody["total"]>["percentiles"][number];

/** A percentile of the true heights with its total interval. */
function ofTotal({ percent, value, U95_low, U95_high, needs, reason }: TotalPercentile): Percentile {
  return { percent, value, low: U95_low, high: U95_high, needs, reason: reason ?? null };
}

function NoIntervals({ rows }: { rows: readonly Percentile[] }) {
  const byReason = new Map<string, number[]>();
  for (const one of rows) {
    const reason = sentenceOf(one.reason);
    if (reason) byReason.set(reason, [...(byReason.get(reason) ?? []), one.percent]);
  }
  if (byReason.size === 0) return null;
  return (
    <details>
      <summary>
        {say("statistics-percentiles-without", { count: [...byReason.values()].flat().length })}
      </summary>
      <ul>
        {[...byReason].map(([reason, percents]) => (
          <li key={reason}>
            {say("statistics-percentiles-reason", { percentiles: allOf(percents.map(plainPercent)), reason })}
          </li>
        ))}
      </ul>
    </details>
  );
}

function At({ one, strong }: { one: Percentile | undefined; strong?: boolean }) {
  if (!one) return null;
  return (
    <>
      {strong ? <strong>{plainHeight(one.value)}</strong> : plainHeight(one.value)}
      <div class="stat-ci">
        {plainHeight(one.low)}
        <br />
        {one.high === null ? "" : plainHeight(one.high)}
      </div>
    </>
  );
}

function save(target: TargetBody): void {
  const { raw, corrected, total } = target;
  const distributions = [
    ...(total ? [{ which: "true", n: total.n, percentiles: total.percentiles.map(ofTotal) }] : []),
    { which: "corrected", n: corrected.n, percentiles: corrected.percentiles },
    { which: "raw", n: raw.n, percentiles: raw.percentiles },
  ];
  const rows = distributions.flatMap(({ which, n, percentiles }) =>
    percentiles.map((one) => [which, one.percent, one.value, one.low, one.high, n, sentenceOf(one.reason)]),
  );
  const columns = [
    "distribution",
    "percentile_percent",
    "height_m",
    "ci95_low_m",
    "ci95_high_m",
    "n",
    "reason",
  ];
  download(`sightline-${target.target}-percentiles.csv`, "text/csv;charset=utf-8", csvOf(columns, rows));
}
