/** Differences of figures, each with its interval and whether it is more than noise. */
import { DataTable } from "../../components";
import { say, sentenceOf } from "../../core/messages";
import type { StudyDifference } from "../../core/types";
import { formatSmall, plainPercent } from "../../core/units";
import { HEIGHT_WORDS } from "../../core/words";
import { Bounded } from "./FigureCell";

type Difference = StudyDifference & {
  /** What the row compares, where the rows are not all of the same two. */
  between?: string;
};

interface Props {
  rows: readonly Difference[];
  label?: string;
  column?: string;
}

export function Differences({ rows, label, column }: Props) {
  return (
    <DataTable
      label={label}
      rows={rows}
      keyOf={(one) => `${one.target}|${one.between}|${one.percent}`}
      columns={({ col, num, rowHead }) => [
        rowHead(say("statistics-compared-figure"), ({ target, percent }) => (
          <>
            {HEIGHT_WORDS[target]},{" "}
            {percent === null ? say("statistics-compared-mean") : `P${plainPercent(percent)}`}
          </>
        )),
        ...(column ? [col(column, (one) => one.between)] : []),
        num(say("statistics-compared-heights"), ({ n_first: first, n_second: second }) =>
          say("statistics-compared-of", { first, second }),
        ),
        num(say("statistics-compared-difference"), ({ value_m, low_m, high_m }) => (
          <Bounded value={value_m} low={low_m} high={high_m} print={formatSmall} />
        )),
        col(say("statistics-compared-verdict"), verdictOf),
      ]}
    />
  );
}

function verdictOf({ verdict, reason }: Difference): string {
  if (verdict === "higher") return say("statistics-compared-higher");
  if (verdict === "lower") return say("statistics-compared-lower");
  if (verdict === "not_told_apart") return say("statistics-compared-alike");
  return say("statistics-compared-unknown", { reason: sentenceOf(reason) ?? "" });
}
