/** Did the camera move: the verdict in words, a plot over the recording's time, looking again, and a person's decision. */
import { useState } from "preact/hooks";
import { Button, JobProgress, type MarkShape, Problem, Shape, TextField } from "../../components";
import { api } from "../../core/api";
import { useJobAction } from "../../core/jobs";
import { say, sentenceOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { may } from "../../core/session";
import type { Drift } from "../../core/types";
import { DriftPlot } from "./DriftPlot";
import "./drift.css";

interface Props {
  recordingId: number;
  poseId: number | null;
  /** Open at once where the page is about the pose. */
  open?: boolean;
}

export function DriftVerdict({ recordingId, poseId, open }: Props) {
  const drift = useAsked(
    "GET /recordings/{recording_id}/drift",
    { recording_id: recordingId },
    { also: [poseId] },
  );
  const { job, problem, setProblem, start } = useJobAction({
    known: drift.data?.job?.id ?? null,
    stopped: say("drift-stopped"),
    over: drift.reload,
  });
  if (poseId === null) return null;
  if (!drift.data) return <Problem error={drift.error} again={drift.reload} />;
  const { check, decision, flagged } = drift.data;
  const look = () =>
    start(() => api.write("POST /recordings/{recording_id}/drift", { recording_id: recordingId }));
  const lookButton = (words: string) =>
    may("operator") &&
    !job && (
      <Button small onClick={() => void look()}>
        {words}
      </Button>
    );
  return (
    <div role="group" class="stack stack--dense drift" aria-label={say("drift-title")} data-testid="drift">
      <p class="drift__words">
        <Shape shape={shapeOf(drift.data)} />
        <span>
          {check
            ? check.words.map(sentenceOf).join(" ")
            : job
              ? say("drift-under-way")
              : say("drift-not-yet")}
        </span>
      </p>
      {decision?.holds && (
        <p class="small">{say("drift-holds", { person: decision.by, reason: decision.reason })}</p>
      )}
      {job && <JobProgress job={job} />}
      <Problem error={problem} />
      {check ? (
        <details open={open ?? flagged.length > 0}>
          <summary>{say("drift-over-time")}</summary>
          <DriftPlot check={check} />
          <div class="row row--wrap">
            <Decide recordingId={recordingId} drift={drift.data} set={drift.set} onProblem={setProblem} />
            {lookButton(say("drift-again"))}
          </div>
        </details>
      ) : (
        lookButton(say("drift-title"))
      )}
    </div>
  );
}

function shapeOf({ check, flagged }: Drift): MarkShape {
  if (check === null) return "empty";
  if (check.state === "unknown") return "dash";
  return flagged.length > 0 ? "warning" : "check";
}

interface DecideProps {
  recordingId: number;
  drift: Drift;
  set(drift: Drift): void;
  onProblem(error: unknown): void;
}

function Decide({ recordingId, drift, set, onProblem }: DecideProps) {
  const [reason, setReason] = useState("");
  if (!may("operator")) return null;
  const send = async (work: () => Promise<Drift>): Promise<void> => {
    onProblem(null);
    try {
      set(await work());
      setReason("");
    } catch (error) {
      onProblem(error);
    }
  };
  if (drift.decision) {
    return (
      <Button
        says="drift-take-back"
        small
        onClick={() =>
          void send(() =>
            api.write("DELETE /recordings/{recording_id}/drift/decision", { recording_id: recordingId }),
          )
        }
      />
    );
  }
  if (drift.flagged.length === 0) return null;
  return (
    <form
      class="row row--wrap row--end"
      onSubmit={(event) => {
        event.preventDefault();
        void send(() =>
          api.write(
            "PUT /recordings/{recording_id}/drift/decision",
            { recording_id: recordingId },
            { body: { reason } },
          ),
        );
      }}
    >
      <TextField says="drift-reason" value={reason} onInput={setReason} />
      <Button says="drift-decide" small type="submit" disabled={reason.trim() === ""} />
    </form>
  );
}
