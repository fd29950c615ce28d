import { num, Table } from "../../components";
import { say, sentenceOf } from "../../core/messages";
import type { StudiesBeside } from "../../core/types";
import { formatSmall, plainPercent } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import { NONE } from "../../parts/figures/numbers";
import { Bounded } from "./Section";

type Difference = StudiesBeside["differences"][number];

interface Props {
  /** `between`: what the row compares, where the rows are not all of the same two. */
  rows: readonly (Difference & { between?: string })[];
  column?: string;
}

/** Differences of figures, each with its interval and whether it is more than noise. */
export function Differences({ rows, column }: Props) {
  return (
    <Table
      heads={[
        say("study-figure"),
        ...(column ? [column] : []),
        num(say("statistics-compared-heights")),
        num(say("statistics-compared-difference")),
        say("statistics-compared-verdict"),
      ]}
    >
      {rows.map((one) => (
        <tr key={`${one.target}|${one.between}|${one.percent}`}>
          <th scope="row">
            {TARGET_WORDS[one.target]},{" "}
            {one.percent === null ? say("study-mean") : `P${plainPercent(one.percent)}`}
          </th>
          {column && <td>{one.between}</td>}
          <td class="num">{say("statistics-compared-of", { first: one.n_first, second: one.n_second })}</td>
          <Bounded
            value={one.value_m === null ? NONE : formatSmall(one.value_m)}
            low={one.low_m === null ? null : formatSmall(one.low_m)}
            high={one.high_m === null ? null : formatSmall(one.high_m)}
          />
          <td>{verdictOf(one)}</td>
        </tr>
      ))}
    </Table>
  );
}

function verdictOf({ verdict, reason }: Difference): string {
  if (verdict === "higher") return say("statistics-compared-higher");
  if (verdict === "lower") return say("statistics-compared-lower");
  if (verdict === "not_told_apart") return say("statistics-compared-alike");
  return say("statistics-compared-unknown", { reason: sentenceOf(reason) ?? "" });
}
