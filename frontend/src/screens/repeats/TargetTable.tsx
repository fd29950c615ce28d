import { TableScroll } from "../../components";
import type { RepeatSpread, Repeats, TargetRepeats } from "../../core/types";
import { fixed, formatSmall, plural } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import { claimVerdict, spreadWords } from "./words";

/** Per target: the same person again, another person, and what the budgets claim for the clicks. */
export function TargetTable({ found }: { found: Repeats }) {
  return (
    <section class="panel" aria-labelledby="repeats-targets">
      <header class="panel__head">
        <h2 id="repeats-targets">Heights, by target</h2>
        <span class="muted small">standard deviations with their 95 % intervals</span>
      </header>
      <TableScroll label="Heights, by target">
        <table class="table repeats" data-testid="repeats-targets">
          <thead>
            <tr>
              <th>target</th>
              <th class="num">clicked again</th>
              <th>the same person</th>
              <th>… on another frame</th>
              <th>another person adds</th>
              <th>clicks’ part, claimed</th>
              <th>clicks’ part, seen</th>
            </tr>
          </thead>
          <tbody>
            {found.targets.map((one) => (
              <Row key={one.target ?? "all"} one={one} />
            ))}
          </tbody>
        </table>
      </TableScroll>
      <p class="repeats__note small muted">
        One spread for near and far vehicles alike, though in millimetres it grows with the distance. Lens,
        road pose, board and inset are the same for all clicks on a frame and cancel in their differences, so
        only the clicks’ part of the budgets is compared. On another frame they do not cancel: step to it
        while you click again.
      </p>
    </section>
  );
}

function Row({ one }: { one: TargetRepeats }) {
  const { gauge, uncertainty_check: claim } = one;
  const leaning = gauge.interaction_p !== null && gauge.interaction_p < 0.05;
  return (
    <tr>
      <td>
        <strong>{one.target === null ? "all targets" : TARGET_WORDS[one.target]}</strong>
        {leaning && (
          <p class="small muted">
            People differ from vehicle to vehicle by more than their own repeats; “the same person” contains
            that.
          </p>
        )}
      </td>
      <td class="num nowrap">{plural(gauge.items, "item")}</td>
      <SpreadCell one={gauge.repeatability} />
      <SpreadCell one={one.another_frame} />
      <SpreadCell one={gauge.reproducibility} />
      <td>{claim.claimed === null ? "–" : formatSmall(claim.claimed)}</td>
      <td>
        {claim.observed !== null && claim.ratio !== null && (
          <>
            {formatSmall(claim.observed)}{" "}
            <span class="muted small nowrap">
              × {fixed(claim.ratio, 2)} ({fixed(claim.low ?? 0, 2)} to {fixed(claim.high ?? 0, 2)})
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
