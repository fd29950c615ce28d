import { TableScroll } from "../../components";
import { say } from "../../core/messages";
import type { RepeatSpread, Repeats, TargetRepeats } from "../../core/types";
import { fixed, formatSmall } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import { claimVerdict, spreadWords } from "./words";

/** Per target: the same person again, another person, and what the budgets claim for the clicks. */
export function TargetTable({ found }: { found: Repeats }) {
  return (
    <section class="panel" aria-labelledby="repeats-targets">
      <header class="panel__head">
        <h2 id="repeats-targets">{say("repeats-targets-title")}</h2>
        <span class="muted small">{say("repeats-targets-note")}</span>
      </header>
      <TableScroll label={say("repeats-targets-title")}>
        <table class="table repeats" data-testid="repeats-targets">
          <thead>
            <tr>
              <th>{say("repeats-target")}</th>
              <th class="num">{say("repeats-clicked-again")}</th>
              <th>{say("repeats-same-person")}</th>
              <th>{say("repeats-another-frame")}</th>
              <th>{say("repeats-another-person")}</th>
              <th>{say("repeats-claimed")}</th>
              <th>{say("repeats-seen")}</th>
            </tr>
          </thead>
          <tbody>
            {found.targets.map((one) => (
              <Row key={one.target ?? "all"} one={one} />
            ))}
          </tbody>
        </table>
      </TableScroll>
      <p class="repeats__note small muted">{say("repeats-targets-help")}</p>
    </section>
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
            <span class="muted small nowrap">
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
  if (!said) return <td class="small muted repeats__reason">{one.reason}</td>;
  return (
    <td>
      <span class="nowrap">{said.value}</span>
      <p class="small muted nowrap">{said.interval}</p>
    </td>
  );
}
