/** On demand: where the uncertainty comes from, the inset, the points, and every revision so far. */
import { useEffect, useState } from "preact/hooks";
import { api } from "../api";
import { Button, Problem, StateMark } from "../components";
import { canWork } from "../state/session";
import { formatMoment } from "../times";
import type { History, Measurement } from "../types";
import { fixed, formatHeight, formatLength, lengthUnit, parseLength } from "../units";
import { Budget } from "./Budget";
import { CommitField } from "./CommitField";
import { lengthProblem, lengthText } from "./lengths";
import type { MeasureModel } from "./model";
import type { Entry } from "./records";
import { Frames } from "./SecondFrameParts";

import type { Inset } from "./values";

export function MeasurementDetail({ model, entry }: { model: MeasureModel; entry: Entry }) {
  const source = entry.preview ?? entry.saved;
  return (
    <div class="height-detail">
      <Frames model={model} entry={entry} />
      <InsetEditor model={model} entry={entry} />
      {source && source.budget.length > 0 && <Budget entries={source.budget} total_m={source.u_height_m} />}
      <dl class="facts small">
        <dt>Frame</dt>
        <dd>{entry.values.frame}</dd>
        <dt>Contact</dt>
        <dd>{pixels(entry.values.contact)}</dd>
        <dt>Target</dt>
        <dd>{pixels(entry.values.point)}</dd>
        {entry.saved && (
          <>
            <dt>Distance</dt>
            <dd>{formatLength(entry.saved.distance_m, 2)}</dd>
            <dt>Without inset</dt>
            <dd>{formatLength(entry.saved.uncorrected_height_m)}</dd>
          </>
        )}
      </dl>
      {entry.saved && <Revisions id={entry.saved.id} revision={entry.saved.revision} />}
      {canWork.value && (
        <Button small icon="trash" onClick={() => model.points.withdraw(entry.key)}>
          Withdraw
        </Button>
      )}
    </div>
  );
}

function pixels(point: readonly number[]): string {
  return `${fixed(point[0] ?? 0, 1)}, ${fixed(point[1] ?? 0, 1)} px`;
}

/** How far the target lies behind the side plane: an estimate, with its own uncertainty. */
function InsetEditor({ model, entry }: { model: MeasureModel; entry: Entry }) {
  const unit = lengthUnit.value;
  const usual = model.usualInset(entry.values.target);
  const now: Inset | null = entry.values.inset ?? usual;
  if (!now) return null;
  const set = (change: Partial<Inset>): void => model.points.setInset(entry.key, { ...now, ...change });
  const check = (text: string) => lengthProblem(text, { empty: false });
  const own = usual && (usual.inset_m !== now.inset_m || usual.u_inset_m !== now.u_inset_m);
  return (
    <div>
      <p class="small">
        <strong>Inset</strong> <span class="badge">estimate</span>{" "}
        <span class="muted">
          {entry.values.more.length > 0
            ? "not used while several frames are clicked: they solve for it"
            : "how far the target lies behind the side of the vehicle"}
        </span>
      </p>
      <div class="height-detail__inset">
        <CommitField
          label="Inset"
          unit={unit}
          numeric
          disabled={!canWork.value}
          value={lengthText(now.inset_m, unit)}
          check={check}
          onCommit={(text) => set({ inset_m: parseLength(text) ?? now.inset_m })}
        />
        <CommitField
          label="± u"
          unit={unit}
          numeric
          disabled={!canWork.value}
          value={lengthText(now.u_inset_m, unit)}
          check={check}
          onCommit={(text) => set({ u_inset_m: parseLength(text) ?? now.u_inset_m })}
        />
      </div>
      {own && usual && canWork.value && (
        <Button
          small
          kind="quiet"
          onClick={() => set({ inset_m: usual.inset_m, u_inset_m: usual.u_inset_m })}
        >
          As the survey has it: {formatLength(usual.inset_m, 2)} ± {formatLength(usual.u_inset_m, 2)}
        </Button>
      )}
    </div>
  );
}

function revisionWords(m: Measurement): string {
  if (m.withdrawn) return "withdrawn";
  return m.status === "ok" ? formatHeight(m.height_m, m.U95_height_m) : "not measurable";
}

/** Every revision with its value and every verdict, newest first. */
export function Revisions({ id, revision }: { id: number; revision: number }) {
  const [history, setHistory] = useState<History | null>(null);
  const [error, setError] = useState<unknown>(null);
  useEffect(() => {
    const stop = new AbortController();
    api.get<History>(`/measurements/${id}/history`, { signal: stop.signal }).then(setHistory, (problem) => {
      if (!stop.signal.aborted) setError(problem);
    });
    return () => stop.abort();
  }, [id, revision]);
  if (error) return <Problem error={error} />;
  if (!history) return null;
  return (
    <div class="revisions small">
      <p>
        <strong>History</strong>
      </p>
      <ol>
        {[...history.revisions].reverse().map((m) => (
          <li key={m.revision}>
            <span class="revisions__line">
              <span class="muted">{m.revision}</span>
              <span class="grow">{revisionWords(m)}</span>
            </span>
            <span class="revisions__who muted">
              {m.created_by?.name ?? "unknown"}, {formatMoment(m.created_at)}
            </span>
            {history.reviews
              .filter((review) => review.revision === m.revision)
              .map((review) => (
                <span key={review.id} class="revisions__review">
                  <StateMark state={review.verdict} /> {review.reviewer?.name}{" "}
                  {review.reason && `– ${review.reason}`}
                </span>
              ))}
          </li>
        ))}
      </ol>
    </div>
  );
}
