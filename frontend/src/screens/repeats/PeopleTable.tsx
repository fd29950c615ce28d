import { Button, num, Panel, Table } from "../../components";
import { say, sentenceOf } from "../../core/messages";
import { may } from "../../core/session";
import type { PersonRepeats } from "../../core/types";
import { fixed, formatSmall } from "../../core/units";
import { SpreadCell } from "./TargetTable";
import { pixelWords } from "./words";

interface Props {
  people: readonly PersonRepeats[];
  busy: boolean;
  choose: (person: PersonRepeats, own: boolean) => Promise<unknown>;
}

/** Per person: clicks and heights of their own repeats, how they lean, and which sigma their clicks count with. */
export function PeopleTable({ people, busy, choose }: Props) {
  return (
    <Panel says="repeats-people-title" note={say("repeats-people-note")}>
      <Table
        label={say("repeats-people-title")}
        class="repeats"
        data-testid="repeats-people"
        heads={[
          say("repeats-person"),
          num(say("repeats-own")),
          say("repeats-contact"),
          say("repeats-target"),
          say("repeats-height"),
          say("repeats-against-others"),
          say("repeats-sigma"),
        ]}
      >
        {people.map((one) => (
          <tr key={one.person.id}>
            <td>
              <strong>{one.person.name}</strong>
            </td>
            <td class="num">{one.pairs}</td>
            {one.sigma.sd === null ? (
              <td class="small muted repeats__reason" colSpan={3}>
                {sentenceOf(one.sigma.reason)}
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
              <p class="small muted nowrap">{say("repeats-items", { count: one.items })}</p>
            </td>
            <td>
              <Sigma one={one} busy={busy} choose={choose} />
            </td>
          </tr>
        ))}
      </Table>
    </Panel>
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
      <strong>
        {chosen === null
          ? say("repeats-sigma-usual")
          : say("repeats-sigma-own", { sigma_px: fixed(chosen, 2) })}
      </strong>
      {chosen !== null && one.chosen && (
        <p class="small muted">
          {say("repeats-sigma-from", {
            count: one.chosen.pairs,
            person: one.chosen.created_by?.name ?? say("person-system"),
          })}
        </p>
      )}
      {found !== null && one.may_choose && reviewer && chosen !== Math.round(found * 1000) / 1000 && (
        <p>
          <Button
            small
            disabled={busy}
            title={say("repeats-sigma-use-title", { count: one.pairs })}
            onClick={() => void choose(one, true)}
          >
            {say("repeats-sigma-use", { sigma_px: fixed(found, 2) })}
          </Button>
        </p>
      )}
      {found !== null && !one.may_choose && <p class="small muted">{say("repeats-sigma-needs")}</p>}
      {chosen !== null && reviewer && (
        <p>
          <Button
            says="repeats-sigma-back"
            small
            kind="quiet"
            disabled={busy}
            onClick={() => void choose(one, false)}
          />
        </p>
      )}
    </>
  );
}
