import { Button, TableScroll } from "../../components";
import { may } from "../../core/session";
import type { PersonRepeats } from "../../core/types";
import { fixed, formatSmall, plural } from "../../core/units";
import { SpreadCell } from "./TargetTable";
import { pixelWords } from "./words";

interface Props {
  people: readonly PersonRepeats[];
  busy: boolean;
  choose: (person: PersonRepeats, own: boolean) => Promise<void>;
}

/** Per person: clicks and heights of their own repeats, how they lean, and which sigma their clicks count with. */
export function PeopleTable({ people, busy, choose }: Props) {
  return (
    <section class="panel" aria-labelledby="repeats-people">
      <header class="panel__head">
        <h2 id="repeats-people">Clicks, by person</h2>
        <span class="muted small">each coordinate of a click, from people’s repeats of their own</span>
      </header>
      <TableScroll label="Clicks, by person">
        <table class="table repeats" data-testid="repeats-people">
          <thead>
            <tr>
              <th>person</th>
              <th class="num">own repeats</th>
              <th>contact</th>
              <th>target</th>
              <th>height</th>
              <th>against others</th>
              <th>clicks count with</th>
            </tr>
          </thead>
          <tbody>
            {people.map((one) => (
              <tr key={one.person.id}>
                <td>
                  <strong>{one.person.name}</strong>
                </td>
                <td class="num">{one.pairs}</td>
                {one.sigma.sd === null ? (
                  <td class="small muted repeats__reason" colSpan={3}>
                    {one.sigma.reason}
                  </td>
                ) : (
                  <>
                    <SpreadCell one={one.contact} words={pixelWords} />
                    <SpreadCell one={one.target_point} words={pixelWords} />
                    <SpreadCell one={one.heights} />
                  </>
                )}
                <td>
                  {one.operator_bias_m === null ? "–" : biasWords(one.operator_bias_m)}
                  <p class="small muted nowrap">{plural(one.items, "item")}</p>
                </td>
                <td>
                  <Sigma one={one} busy={busy} choose={choose} />
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
    </section>
  );
}

function biasWords(operator_bias_m: number): string {
  return `${operator_bias_m > 0 ? "+" : ""}${formatSmall(operator_bias_m)}`;
}

function Sigma({ one, busy, choose }: { one: PersonRepeats } & Pick<Props, "busy" | "choose">) {
  const chosen = one.chosen?.sigma_px ?? null;
  const found = one.sigma.sd;
  const reviewer = may("reviewer");
  return (
    <>
      <strong class="nowrap">
        {chosen === null ? "1 px, as usual" : `${fixed(chosen, 2)} px of their own`}
      </strong>
      {chosen !== null && one.chosen && (
        <p class="small muted">
          from {plural(one.chosen.pairs, "repeat")}, chosen by {one.chosen.created_by?.name ?? "the system"}
        </p>
      )}
      {found !== null && one.may_choose && reviewer && chosen !== Math.round(found * 1000) / 1000 && (
        <p>
          <Button
            small
            disabled={busy}
            title={`From ${plural(one.pairs, "repeat")}; clicks that are stored keep theirs`}
            onClick={() => void choose(one, true)}
          >
            Use {fixed(found, 2)} px
          </Button>
        </p>
      )}
      {found !== null && !one.may_choose && <p class="small muted">ten own repeats are needed for another</p>}
      {chosen !== null && reviewer && (
        <p>
          <Button small kind="quiet" disabled={busy} onClick={() => void choose(one, false)}>
            Back to 1 px
          </Button>
        </p>
      )}
    </>
  );
}
