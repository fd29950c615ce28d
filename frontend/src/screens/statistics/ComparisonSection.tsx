import { num, Panel, Table } from "../../components";
import { say, sentenceOf } from "../../core/messages";
import { formatSmall, plainPercent } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import { NONE } from "../../parts/figures/numbers";
import type { Comparison } from "./model";

type Figure = Comparison["figures"][number];

/** Where what counts is of two surveys or years: whether they differ by more than noise. */
export function ComparisonSection({ compared }: { compared: Comparison }) {
  const title = say("statistics-compared-title", {
    first: compared.first.name,
    second: compared.second.name,
  });
  return (
    <Panel label={title} data-testid="comparison">
      {compared.figures.length === 0 ? (
        <p class="stat-notes small">{say("statistics-compared-none")}</p>
      ) : (
        <Table
          label={title}
          heads={[
            say("statistics-compared-figure"),
            num(say("statistics-compared-heights")),
            num(say("statistics-compared-difference")),
            say("statistics-compared-verdict"),
          ]}
        >
          {compared.figures.map((one) => (
            <Row key={`${one.target}|${one.percent}`} one={one} />
          ))}
        </Table>
      )}
      <p class="stat-notes small">{say("statistics-compared-note")}</p>
    </Panel>
  );
}

function Row({ one }: { one: Figure }) {
  const { U95_low_m: low, U95_high_m: high } = one;
  const figure = one.percent === null ? say("statistics-compared-mean") : `P${plainPercent(one.percent)}`;
  return (
    <tr>
      <th scope="row">
        {TARGET_WORDS[one.target]}, {figure}
      </th>
      <td class="num">{say("statistics-compared-of", { first: one.n_first, second: one.n_second })}</td>
      <td class="num">
        {one.value_m === null ? NONE : <strong>{formatSmall(one.value_m)}</strong>}
        {low !== null && high !== null && (
          <div class="stat-ci">
            {say("statistics-compared-interval", { low: formatSmall(low), high: formatSmall(high) })}
          </div>
        )}
      </td>
      <td>{verdict(one)}</td>
    </tr>
  );
}

function verdict({ verdict: word, reason }: Figure): string {
  if (word === "higher") return say("statistics-compared-higher");
  if (word === "lower") return say("statistics-compared-lower");
  if (word === "not_told_apart") return say("statistics-compared-alike");
  return say("statistics-compared-unknown", { reason: sentenceOf(reason) ?? "" });
}
