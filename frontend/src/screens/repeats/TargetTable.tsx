import { type Column, type Columns, DataTable, Panel } from "../../components";
import { say, sentenceOf } from "../../core/messages";
import type { RepeatSpread, Repeats, TargetRepeats } from "../../core/types";
import { fixed, formatSmall } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import { claimVerdict, spreadWords } from "./words";

/** Per target: the same person again, another person, and what the budgets claim for the clicks. */
export function TargetTable({ found }: { found: Repeats }) {
  return (
    <Panel says="repeats-targets-title" note={say("repeats-targets-note")}>
      <DataTable
        label={say("repeats-targets-title")}
        class="repeats"
        data-testid="repeats-targets"
        rows={found.targets}
        keyOf={(one) => one.target ?? "all"}
        columns={(made) => [
          made.col(say("repeats-target"), ({ target, gauge }) => (
            <>
              <strong>{target === null ? say("repeats-all-targets") : TARGET_WORDS[target]}</strong>
              {gauge.interaction_p !== null && gauge.interaction_p < 0.05 && (
                <p class="small muted">{say("repeats-people-differ")}</p>
              )}
            </>
          )),
          made.num(
            say("repeats-clicked-again"),
            ({ gauge }) => say("repeats-items", { count: gauge.items }),
            "nowrap",
          ),
          ...spread(made, say("repeats-same-person"), (one) => one.gauge.repeatability),
          ...spread(made, say("repeats-another-frame"), (one) => one.another_frame),
          ...spread(made, say("repeats-another-person"), (one) => one.gauge.reproducibility),
          made.col(say("repeats-claimed"), ({ uncertainty_check: { claimed } }) =>
            claimed === null ? "–" : formatSmall(claimed),
          ),
          made.col(say("repeats-seen"), (one) => <Seen claim={one.uncertainty_check} />),
        ]}
      />
      <p class="panel__note words small muted">{say("repeats-targets-help")}</p>
    </Panel>
  );
}

function Seen({ claim }: { claim: TargetRepeats["uncertainty_check"] }) {
  return (
    <>
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
    </>
  );
}

export const NO_SPREAD = "repeats__reason";

/** The column of a spread with its interval, or why a row has none. */
export function spread<R>(
  { col, across }: Columns<R>,
  head: string,
  of: (row: R) => RepeatSpread,
  words = spreadWords,
): Column<R>[] {
  const cell = (row: R) => {
    const said = words(of(row));
    return (
      <>
        <span class="nowrap">{said?.value}</span>
        <p class="small muted nowrap">{said?.interval}</p>
      </>
    );
  };
  return across(
    (row) => (words(of(row)) ? undefined : sentenceOf(of(row).reason)),
    NO_SPREAD,
    col(head, cell),
  );
}
