import { DataTable, Panel } from "../../components";
import { Said } from "../../components/Said";
import { say, sentenceOf, withUnit, wordsOf } from "../../core/messages";
import type { ErrorGroupBody, ErrorsBody } from "../../core/types";
import { formatCount, formatSmall, smallScale } from "../../core/units";
import { csvOf, download } from "../../parts/figures/csv";
import { Figure } from "../../parts/figures/FigureCell";
import { FileButton } from "../../parts/figures/FileButton";
import { NONE, range, scaled, squareScale } from "../../parts/figures/numbers";
import { asInPaper } from "./filters";
import { GROUP_WORDS, isThere } from "./model";

const HEADS = wordsOf("statistics-error-");

interface Column {
  key: keyof typeof HEADS;
  scale: () => [number, number];
  unit: () => string;
  paper?: "mae_m" | "rmse_m" | "mse_m2" | "sd_m";
}

const length = (): [number, number] => [smallScale()[0], smallScale()[1] === "in" ? 2 : 1];
const inSmall = () => smallScale()[1];
const COLUMNS: readonly Column[] = [
  { key: "bias_m", scale: length, unit: inSmall },
  { key: "mae_m", scale: length, unit: inSmall, paper: "mae_m" },
  { key: "rmse_m", scale: length, unit: inSmall, paper: "rmse_m" },
  {
    key: "mse_m2",
    scale: () => [squareScale()[0], squareScale()[1] === "in²" ? 3 : 2],
    unit: () => squareScale()[1],
    paper: "mse_m2",
  },
  { key: "sd_m", scale: length, unit: inSmall, paper: "sd_m" },
  { key: "pearson_error_vs_height", scale: () => [1, 2], unit: () => "" },
  { key: "pearson_abs_error_vs_height", scale: () => [1, 2], unit: () => "" },
];

function headOf({ key, unit }: Column): string {
  return unit() ? withUnit(HEADS[key], unit()) : HEADS[key];
}

/** The paper's Table 1 for this survey, each figure with its interval, the printed one below it. */
export function ErrorTable({ errors }: { errors: ErrorsBody }) {
  return (
    <Panel
      says="statistics-errors-title"
      aside={<FileButton as="csv" save={() => save(errors)} title={say("statistics-errors-save")} />}
    >
      <DataTable
        label={say("statistics-errors-title")}
        class="stat-errors"
        data-testid="error-table"
        rows={errors.groups.flatMap((group) => rowsOf(group, errors))}
        keyOf={(_, at) => at}
        rowAttributes={({ group: { group }, printed }) => ({
          class: printed ? "stat-paper" : undefined,
          "data-testid": printed ? `printed-${group}` : `errors-${group}`,
        })}
        columns={({ num, rowHead }) => [
          rowHead(say("statistics-errors-head"), nameOf),
          num("n", ({ group, paper, printed }) => (printed ? paper?.n : formatCount(group.n))),
          ...COLUMNS.map((column) => num(headOf(column), (row) => figureOf(column, row))),
        ]}
      />
      <div class="stat-notes small">
        <p>
          {sentenceOf(errors.words)} {say("statistics-errors-note")}
        </p>
        <Holds errors={errors} />
        <Agreement errors={errors} />
        <Shares errors={errors} />
        {asInPaper() && (
          <details>
            <summary>{say("statistics-paper-inconsistent")}</summary>
            <ul>
              {errors.paper.map((one) => (
                <li key={one.group}>
                  <Said
                    what="statistics-paper-note"
                    values={{ group: one.title, note: sentenceOf(one.note) }}
                  />
                </li>
              ))}
            </ul>
          </details>
        )}
      </div>
    </Panel>
  );
}

/** What the intervals hold: of all vehicles, or of the first group that has any. */
function Holds({ errors }: { errors: ErrorsBody }) {
  const words = [...errors.groups].reverse().find((group) => group.words)?.words;
  return words ? (
    <p data-testid="error-holds">{say("statistics-errors-holds", { words: sentenceOf(words) })}</p>
  ) : null;
}

const strong = (text: string) => <strong>{text}</strong>;
/** A figure without an interval is of too few vehicles to be stressed. */
const muted = (text: string) => <span class="muted">{text}</span>;

interface Row {
  group: ErrorGroupBody;
  paper: ErrorsBody["paper"][number] | undefined;
  /** What the paper printed of it. */
  printed?: boolean;
}

function rowsOf(group: ErrorGroupBody, errors: ErrorsBody): Row[] {
  const paper = asInPaper() ? errors.paper.find((one) => one.group === group.group) : undefined;
  return paper
    ? [
        { group, paper },
        { group, paper, printed: true },
      ]
    : [{ group, paper }];
}

function nameOf({ group, paper, printed }: Row) {
  if (printed) return say("statistics-paper-printed");
  return (
    <>
      {GROUP_WORDS[group.group] ?? group.group}
      {paper && <div class="stat-ci">{say("statistics-stands-for", { group: group.title })}</div>}
      {group.reason && <div class="stat-ci">{sentenceOf(group.reason)}</div>}
      <NoIntervals group={group} />
    </>
  );
}

function figureOf({ key, scale, paper: name }: Column, { group, paper, printed }: Row) {
  const [factor, digits] = scale();
  const figure = group.figures[key];
  if (printed) return scaled((name && paper?.[name]) ?? null, factor, digits);
  return <Figure figure={figure} factor={factor} digits={digits} drawn={figure?.ci95 ? strong : muted} />;
}

function NoIntervals({ group }: { group: ErrorGroupBody }) {
  const without = COLUMNS.filter((column) => group.figures[column.key]?.reason);
  const reason = without[0] && group.figures[without[0].key]?.reason;
  if (!reason) return null;
  return (
    <div class="stat-ci">
      {say("statistics-no-interval", {
        figures: without.map((column) => HEADS[column.key]).join(", "),
        reason: sentenceOf(reason),
      })}
    </div>
  );
}

/** What the paper leaves out: how lopsided the errors are, and how many lie within so many centimetres. */
function Shares({ errors }: { errors: ErrorsBody }) {
  return (
    <DataTable
      label={say("statistics-shares-title")}
      class="stat-errors"
      data-testid="error-shares"
      caption={say("statistics-shares-title")}
      rows={errors.groups}
      keyOf={({ group }) => group}
      columns={({ num, rowHead }) => [
        rowHead(say("statistics-errors-head"), ({ group }) => GROUP_WORDS[group] ?? group),
        num(say("statistics-skewness"), ({ figures }) => (
          <Figure figure={figures["skewness"]} factor={1} digits={2} drawn={strong} />
        )),
        ...WITHIN_MM.map((mm) =>
          num(say("statistics-within", { within: formatSmall(mm / 1000) }), ({ figures }) => (
            <Figure figure={figures[`share_within_${mm}_mm`]} factor={100} digits={0} drawn={strong} />
          )),
        ),
      ]}
    />
  );
}

const WITHIN_MM = [10, 15, 20, 30, 40] as const;

/** The reference's own part of the variance, and Bland and Altman's limits. */
function Agreement({ errors }: { errors: ErrorsBody }) {
  const part = errors.reference_part;
  const limits = errors.bland_altman;
  const [factor, unit] = smallScale();
  const digits = unit === "in" ? 2 : 1;
  return (
    <>
      <p data-testid="reference-part">
        {isThere(part)
          ? `${sentenceOf(part.words)} ${say("statistics-reference-part", {
              correlation: scaled(part.correlation_alone, 1, 2),
              u_reference: formatSmall(part.u_reference_m),
            })}`
          : sentenceOf(part.reason)}
      </p>
      <p data-testid="bland-altman">
        {isThere(limits)
          ? say("statistics-bland-altman", {
              unit,
              lower: scaled(limits.lower_m, factor, digits),
              lower_interval: range(limits.lower_ci95, factor, digits) ?? NONE,
              upper: scaled(limits.upper_m, factor, digits),
              upper_interval: range(limits.upper_ci95, factor, digits) ?? NONE,
              n: limits.n,
            })
          : sentenceOf(limits.reason)}
      </p>
    </>
  );
}

function save(errors: ErrorsBody): void {
  const columns = ["source", "group", "n"];
  for (const { key } of COLUMNS) columns.push(key, `${key}_ci95_low`, `${key}_ci95_high`);
  const own = errors.groups.map((group) => [
    "survey",
    group.group,
    group.n,
    ...COLUMNS.flatMap(({ key }) => {
      const figure = group.figures[key];
      return [figure?.value, figure?.ci95?.low, figure?.ci95?.high];
    }),
  ]);
  const paper = errors.paper.map((one) => [
    "dupuis_et_al_2019_as_printed",
    one.group,
    one.n,
    ...COLUMNS.flatMap((column) => [column.paper ? one[column.paper] : null, null, null]),
  ]);
  download("sightline-error-table.csv", "text/csv;charset=utf-8", csvOf(columns, [...own, ...paper]));
}
