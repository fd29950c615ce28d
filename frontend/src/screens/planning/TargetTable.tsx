import { useState } from "preact/hooks";
import { DataTable, Panel } from "../../components";
import { say, sentenceOf } from "../../core/messages";
import { formatLength, formatSmall } from "../../core/units";
import { budgetSource } from "../../core/words";
import { type PlannedTarget, wordOf } from "./model";

/** Each target's expected uncertainty; the parts it is made of below. */
export function TargetTable({ targets, travelM }: { targets: readonly PlannedTarget[]; travelM: number }) {
  return (
    <Panel says="planning-targets-title">
      <DataTable
        label={say("planning-targets-title")}
        rows={targets}
        keyOf={(one) => one.target}
        columns={({ col, num }) => [
          col(
            say("planning-target"),
            ({ target, reason, two_frames }) => (
              <>
                {wordOf(target)}
                {(reason ?? two_frames.reason) && (
                  <div class="field__hint">{sentenceOf(reason ?? two_frames.reason)}</div>
                )}
              </>
            ),
            "plan-target",
          ),
          num(say("planning-planned-height"), (one) => formatLength(one.height_m, 2)),
          num(say("planning-inset"), (one) =>
            say("with-u", { value: formatLength(one.inset_m, 2), u: formatLength(one.u_inset_m, 2) }),
          ),
          num("u", (one) => formatSmall(one.u_height_m)),
          num("U95", (one) => <strong>{formatSmall(one.U95_height_m)}</strong>),
          num(say("planning-two-frames"), (one) => formatSmall(one.two_frames.U95_height_m)),
          num(say("planning-inset-ignored"), (one) => formatSmall(one.bias_if_ignored_m)),
        ]}
      />
      <p class="field__hint panel__note">
        {say("planning-targets-note", { travel: formatLength(travelM, 2) })}
      </p>
      <Contributions targets={targets} />
    </Panel>
  );
}

/** The budget of every target side by side: which part to work on. */
function Contributions({ targets }: { targets: readonly PlannedTarget[] }) {
  const [open, setOpen] = useState(true);
  const measured = targets.filter((one) => one.budget.length > 0);
  const sources = measured[0]?.budget.map((part) => part.source) ?? [];
  if (sources.length === 0) return null;
  return (
    <details class="plan-parts" open={open} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>{say("planning-parts-title")}</summary>
      <DataTable
        label={say("planning-parts-label")}
        rows={[...sources.keys(), null]}
        keyOf={(row) => row ?? "sum"}
        rowAttributes={(row) => (row === null ? { class: "plan-parts__sum" } : {})}
        columns={({ col, num }) => [
          col(say("planning-parts-source"), (row) =>
            row === null ? say("planning-parts-sum") : budgetSource(sources[row] ?? ""),
          ),
          ...measured.map((one) =>
            num(wordOf(one.target), (row) =>
              row === null ? formatSmall(one.u_height_m) : <Part one={one} row={row} />,
            ),
          ),
        ]}
      />
    </details>
  );
}

function Part({ one, row }: { one: PlannedTarget; row: number }) {
  const part = one.budget[row];
  const most = Math.max(...one.budget.map((other) => other.u_m));
  const words = formatSmall(part?.u_m ?? null);
  return part?.u_m === most ? <strong>{words}</strong> : words;
}
