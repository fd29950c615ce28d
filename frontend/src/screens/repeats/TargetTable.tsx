import { num, Panel, Table } from "../../components";
import { say, sentenceOf } from "../../core/messages";
import type { RepeatSpread, Repeats, TargetRepeats } from "../../core/types";
import { fixed, formatSmall } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import { claimVerdict, spreadWords } from "./words";

/** Per target: the same person again, another person, and what the budgets claim for the clicks. */
export function TargetTable({ found }: { found: Repeats }) {
  return (
    <Panel says="repeats-targets-title" note={say("repeats-targets-note")}>
      <Table
        label={say("repeats-targets-title")}
        class="repeats"
        data-testid="repeats-targets"
        heads={[
          say("repeats-target"),
          num(say("repeats-clicked-again")),
          say("repeats-same-person"),
          say("repeats-another-frame"),
          say("repeats-another-person"),
          say("repeats-claimed"),
          say("repeats-seen"),
        ]}
      >
        {found.targets.map((one) => (
          <Row key={one.target ?? "all"} one={one} />
        ))}
      </Table>
      <p class="panel__note words small muted">{say("repeats-targets-help")}</p>
    </Panel>
  );
}

function Row({ one }: { one: TargetRepeats }) {
  const { gauge, uncertainty_check: claim } = one;
  const leaning = gauge.interaction_p !== null && gauge.interaction_p < 0.05;
  return (
    <tr>
      <td>
        <strong>{one.target === null ? say("repeats-all-targets") : TARGET_WORDS[one.target]}</strong>
        {leaning && <p class="small muted">{say("repeats-people-differ")}</p>}
      </td>
      <td class="num nowrap">{say("repeats-items", { count: gauge.items })}</td>
      <SpreadCell one={gauge.repeatability} />
      <SpreadCell one={one.another_frame} />
      <SpreadCell one={gauge.reproducibility} />
      <td>{claim.claimed === null ? "–" : formatSmall(claim.claimed)}</td>
      <td>
        {claim.observed !== null && claim.ratio !== null && (
          <>
            {formatSmall(claim.observed)}{" "}
            <span class="muted small">
              {say("repeats-ratio", {
                ratio: fixed(claim.ratio, 2),
                low: fixed(claim.low ?? 0, 2),
                high: fixed(claim.high ?? 0, 2),
              })}
            </span>
          </>
        )}
        <p class="small">{claimVerdict(claim)}</p>
      </td>
    </tr>
  );
}

export function SpreadCell({ one, words = spreadWords }: { one: RepeatSpread; words?: typeof spreadWords }) {
  const said = words(one);
  if (!said) return <td class="small muted repeats__reason">{sentenceOf(one.reason)}</td>;
  return (
    <td>
      <span class="nowrap">{said.value}</span>
      <p class="small muted nowrap">{said.interval}</p>
    </td>
  );
}
