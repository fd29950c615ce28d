import { Button, Notice } from "../../components";
import { formatCount, formatLength, lengthScale, plural } from "../../core/units";
import { csvOf, download } from "../../parts/figures/csv";
import {
  type Curve,
  densityMarks,
  densityRows,
  ECDF_COLUMNS,
  ecdfMarks,
  ecdfRows,
  ecdfWord,
  nearby,
  standardMarks,
  valueAt,
} from "../../parts/figures/curves";
import { NONE, percent, scaled } from "../../parts/figures/numbers";
import { type Plot, PlotFigure } from "../../parts/figures/PlotFigure";
import type { Density, Ecdf, Standard } from "../../parts/figures/types";
import { isThere, type OfTarget, type Percentile, TARGET_TITLES } from "./model";

const RAW: Curve = { word: "as the paper measures", dash: "6 4", faint: true, band: true };
const CORRECTED: Curve = { word: "corrected", band: true };

interface Props {
  target: OfTarget;
  /** Those that are switched on. */
  standards: readonly Standard[];
}

/** One target: its distribution raw and corrected, its percentiles, and who sits below the standards. */
export function TargetSection({ target, standards }: Props) {
  const title = TARGET_TITLES[target.target];
  const { corrected } = target;
  return (
    <section
      class="panel stat-target"
      aria-labelledby={`stat-${target.target}`}
      data-testid={`target-${target.target}`}
    >
      <header class="panel__head">
        <h2 id={`stat-${target.target}`}>{title}</h2>
        <span class="muted small">
          {formatCount(target.raw.n)} heights
          {corrected.mean_m !== null && `, corrected mean ${formatLength(corrected.mean_m)}`}
          {corrected.sd_m !== null && `, SD ${formatLength(corrected.sd_m)}`}
        </span>
      </header>
      <div class="stat-target__words small">
        <p data-testid={`correction-${target.target}`}>{corrected.reason ?? corrected.words}</p>
        {corrected.warning && <Notice kind="warning">{corrected.warning}</Notice>}
      </div>
      <div class="stat-figures stat-figures--inside">
        <EcdfFigure target={target} standards={standards} title={title} />
        <HeightDensity target={target} title={title} />
      </div>
      <Shares target={target} standards={standards} />
      <Percentiles target={target} />
    </section>
  );
}

function EcdfFigure({ target, standards, title }: Props & { title: string }) {
  const raw = isThere<Ecdf>(target.raw.ecdf) ? target.raw.ecdf : null;
  const corrected = isThere<Ecdf>(target.corrected.ecdf) ? target.corrected.ecdf : null;
  const both = [raw, corrected].filter((one) => one !== null);
  const shown = nearby(standards, both);
  const away = standards.length - shown.length;
  return (
    <PlotFigure
      name={`${target.target}-ecdf`}
      title={`${title}, cumulative`}
      says={`Cumulative distribution of ${title} heights as the paper measures them and corrected, ${target.raw.n} vehicles`}
      note={`Bands at 95 % hold everywhere at once. ${away > 0 ? `${away} standard${away > 1 ? "s" : ""} far outside not drawn.` : ""}`}
      legend={[{ word: CORRECTED.word }, { word: `${RAW.word} (inset 0)`, dash: RAW.dash, faint: true }]}
      reason={both.length === 0 ? "Nothing to draw: no height of this target is left by the filter." : null}
      data={[target, shown.map((one) => one.name + one.height_m).join()]}
      options={(plot, unit) => {
        const [perX, long] = lengthScale(unit);
        return {
          x: {
            label: `height above the road (${long})`,
            labelArrow: "none",
            labelAnchor: "center",
            labelOffset: 34,
            nice: true,
            inset: 16,
          },
          y: { label: "share of vehicles (%)", labelArrow: "none", grid: true, domain: [0, 100] },
          marks: [
            ...standardMarks(plot, shown, perX, long),
            ...(raw ? ecdfMarks(plot, raw, RAW, perX) : []),
            ...(corrected ? ecdfMarks(plot, corrected, CORRECTED, perX) : []),
            ...words(plot, raw, corrected, perX),
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

/** The words of both curves, on their outer sides. */
function words(plot: Plot, raw: Ecdf | null, corrected: Ecdf | null, perX: number) {
  const both = [
    ...(raw ? [{ ecdf: raw, curve: RAW }] : []),
    ...(corrected ? [{ ecdf: corrected, curve: CORRECTED }] : []),
  ].sort((a, b) => valueAt(a.ecdf, 0.5) - valueAt(b.ecdf, 0.5));
  return both.map(({ ecdf, curve }, i) => {
    const left = i === 0 && both.length > 1;
    return ecdfWord(
      plot,
      ecdf,
      { ...curve, wordAt: left ? 0.8 : 0.25 },
      perX,
      Number.POSITIVE_INFINITY,
      left,
    );
  });
}

function HeightDensity({ target, title }: { target: OfTarget; title: string }) {
  const density = isThere<Density>(target.density) ? target.density : null;
  return (
    <PlotFigure
      name={`${target.target}-density`}
      title={`${title}, density`}
      says={`Density of corrected ${title} heights`}
      note="Corrected heights, Gaussian kernel, pointwise 95 % band."
      reason={"reason" in target.density ? target.density.reason : null}
      data={target}
      options={(plot, unit) => {
        const [perX, long] = lengthScale(unit);
        return {
          x: {
            label: `height above the road (${long})`,
            labelArrow: "none",
            labelAnchor: "center",
            labelOffset: 34,
            nice: true,
          },
          y: { label: `density (per ${long})`, labelArrow: "none", grid: true, zero: true, nice: true },
          marks: [...(density ? densityMarks(plot, density, CORRECTED, perX) : [])],
        };
      }}
      table={() => ({
        columns: ["distribution", "height_m", "density_per_m", "band95_low_per_m", "band95_high_per_m", "n"],
        rows: density ? densityRows("corrected", density) : [],
      })}
    />
  );
}

const WHO: Record<string, string> = {
  driver_eye: "drivers",
  taillight: "taillights",
  headlight: "headlights",
};

/** "Which share of drivers sits below it", with its interval. */
function Shares({ target, standards }: Props) {
  const names = new Set(standards.map((one) => `${one.name}|${one.height_m}`));
  const shares = target.corrected.shares.filter((one) =>
    names.has(`${one.standard.name}|${one.standard.height_m}`),
  );
  if (shares.length === 0) return null;
  return (
    <ul class="stat-shares" data-testid={`shares-${target.target}`}>
      {shares.map((one) => (
        <li key={`${one.standard.name}${one.standard.height_m}`}>
          Share of {WHO[target.target]} below {formatLength(one.standard.height_m, 2)} ({one.standard.name}):{" "}
          <strong>{percent(one.share)}</strong>{" "}
          <span class="muted">
            ({(100 * one.low).toFixed(1)} to {(100 * one.high).toFixed(1)}; {one.below} of {one.n})
          </span>
        </li>
      ))}
    </ul>
  );
}

function Percentiles({ target }: { target: OfTarget }) {
  const rows = target.corrected.percentiles;
  const raw = new Map(target.raw.percentiles.map((one) => [one.percent, one]));
  if (raw.size === 0) return null;
  const [factor, unit] = lengthScale();
  const shown = rows.length > 0 ? rows : target.raw.percentiles;
  return (
    <div class="stat-percentiles">
      <div class="table-scroll">
        <table class="table" data-testid={`percentiles-${target.target}`}>
          <caption class="visually-hidden">Percentiles, {TARGET_TITLES[target.target]}</caption>
          <thead>
            <tr>
              <th>Percentile</th>
              {shown.map((one) => (
                <th key={one.percent} class="num">
                  {one.percent}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.length > 0 && (
              <PercentileRow head={`corrected (${unit})`} rows={rows} factor={factor} strong />
            )}
            <PercentileRow head={`as the paper (${unit})`} rows={target.raw.percentiles} factor={factor} />
          </tbody>
        </table>
      </div>
      <div class="row row--apart stat-notes small">
        <div class="grow">
          95 % intervals below each value.
          <NoIntervals rows={shown} />
        </div>
        <Button
          small
          icon="download"
          class="stat-noprint"
          onClick={() => save(target)}
          title="Percentiles as CSV"
        >
          CSV
        </Button>
      </div>
    </div>
  );
}

/** Why some percentiles have no interval, each reason once. */
function NoIntervals({ rows }: { rows: readonly Percentile[] }) {
  const byReason = new Map<string, number[]>();
  for (const one of rows) {
    if (one.reason) byReason.set(one.reason, [...(byReason.get(one.reason) ?? []), one.percent]);
  }
  if (byReason.size === 0) return null;
  return (
    <details>
      <summary>
        Why {plural([...byReason.values()].flat().length, "percentile has", "percentiles have")} none
      </summary>
      <ul>
        {[...byReason].map(([reason, percents]) => (
          <li key={reason}>
            {percents.join(" and ")}: {reason}.
          </li>
        ))}
      </ul>
    </details>
  );
}

function PercentileRow({
  head,
  rows,
  factor,
  strong,
}: {
  head: string;
  rows: readonly Percentile[];
  factor: number;
  strong?: boolean;
}) {
  return (
    <tr>
      <th scope="row">{head}</th>
      {rows.map((one) => (
        <td key={one.percent} class="num">
          {strong ? <strong>{scaled(one.value, factor, 3)}</strong> : scaled(one.value, factor, 3)}
          <div class="stat-ci">
            {one.low === null ? NONE : scaled(one.low, factor, 3)}
            <br />
            {one.high === null ? "" : scaled(one.high, factor, 3)}
          </div>
        </td>
      ))}
    </tr>
  );
}

function save(target: OfTarget): void {
  const rows = (["raw", "corrected"] as const).flatMap((which) =>
    target[which].percentiles.map((one) => [
      which,
      one.percent,
      one.value,
      one.low,
      one.high,
      target[which].n,
      one.reason,
    ]),
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
