/** Errors against heights that were known before, a row a target, and check targets. */
import { TableScroll } from "../../components";
import { say, wordsOf } from "../../core/messages";
import { formatCount, smallScale } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import { NONE, range, scaled } from "../../parts/figures/numbers";
import { type ErrorGroup, isThere, type KnownErrors } from "./model";

const FIGURES = ["bias_m", "mae_m", "rmse_m", "sd_m"] as const;
const HEADS = wordsOf({
  bias_m: "statistics-bias",
  mae_m: "statistics-mae",
  rmse_m: "statistics-rmse",
  sd_m: "statistics-sd",
});

export function KnownErrorsTable({ found }: { found: readonly KnownErrors[] }) {
  const unit = smallScale()[1];
  return (
    <section class="panel" aria-labelledby="stat-known">
      <header class="panel__head">
        <h2 id="stat-known">{say("statistics-known-title")}</h2>
      </header>
      {found.length === 0 ? (
        <p class="stat-notes small">{say("statistics-known-none")}</p>
      ) : (
        <TableScroll label={say("statistics-known-title")}>
          <table class="table stat-errors" data-testid="known-errors">
            <thead>
              <tr>
                <th>{say("statistics-known-target")}</th>
                <th class="num">n</th>
                {FIGURES.map((key) => (
                  <th key={key} class="num">
                    {say("with-unit", { name: HEADS[key], unit })}
                  </th>
                ))}
                <th class="num">{say("with-unit", { name: say("statistics-known-bias"), unit })}</th>
                <th class="num">{say("statistics-known-inside")}</th>
              </tr>
            </thead>
            <tbody>
              {found.map((one) => (
                <Row key={`${one.target}-${one.check_target}`} one={one} />
              ))}
            </tbody>
          </table>
        </TableScroll>
      )}
      {found.length > 0 && <p class="stat-notes small">{say("statistics-known-help")}</p>}
    </section>
  );
}

function Row({ one }: { one: KnownErrors }) {
  const overall = one.groups.find(({ group }) => group === "overall");
  const target = TARGET_WORDS[one.target];
  if (!overall) return null;
  return (
    <tr data-testid={`known-${one.target}${one.check_target ? "-check" : ""}`}>
      <th scope="row">
        {one.check_target ? say("statistics-known-check", { target }) : target}
        {overall.reason && <div class="stat-ci">{overall.reason}</div>}
      </th>
      <td class="num">{formatCount(overall.n)}</td>
      {FIGURES.map((key) => (
        <Length key={key} figure={overall.figures[key]} words={overall.words} />
      ))}
      <TotalBias one={one} />
      <Inside one={one} />
    </tr>
  );
}

interface LengthProps {
  figure: ErrorGroup["figures"][string] | undefined;
  words: string;
}

function Length({ figure, words }: LengthProps) {
  const [factor, unit] = smallScale();
  const digits = unit === "in" ? 2 : 1;
  return (
    <td class="num" title={words ? say("statistics-known-holds", { words }) : undefined}>
      {scaled(figure?.value ?? null, factor, digits)}
      <div class="stat-ci">{range(figure?.ci95 ?? null, factor, digits) ?? NONE}</div>
    </td>
  );
}

function TotalBias({ one: { bias, words } }: { one: KnownErrors }) {
  const [factor, unit] = smallScale();
  const { U95_low: low, U95_high: high } = bias;
  const found = low === null || high === null ? null : { low, high };
  return (
    <td class="num" title={say("statistics-known-holds", { words })}>
      {range(found, factor, unit === "in" ? 2 : 1) ?? NONE}
    </td>
  );
}

function Inside({ one: { inside } }: { one: KnownErrors }) {
  if (!isThere(inside)) return <td class="small muted">{inside.reason}</td>;
  return (
    <td class="num">
      {say("statistics-known-inside-of", { inside: inside.inside, n: inside.n })}
      <div class="stat-ci">{range(inside, 100, 0) ?? NONE} %</div>
    </td>
  );
}
