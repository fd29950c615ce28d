/** What the pose is worth, in plain words: the expected uncertainty of heights, warnings, and other poses to choose from. */
import { Button, Notice, Shape } from "../../components";
import { canWork } from "../../core/session";
import { formatMoment } from "../../core/times";
import type { Pose } from "../../core/types";
import { fixed, formatLength, formatSmall } from "../../core/units";
import { DriftVerdict } from "../../parts/drift/Drift";
import type { PoseModel } from "./model";

export function PoseResult({ model }: { model: PoseModel }) {
  const pose = model.pose.value;
  const recording = model.reel.recording.value;
  if (!pose && model.poses.value.length === 0) return null;
  const inUse = pose !== null && recording?.pose_id === pose.id;
  return (
    <section class="pose-result">
      {pose && (
        <>
          <header class="row">
            <h2 class="grow">{inUse ? "The recording's road pose" : "An earlier road pose"}</h2>
            {inUse && (
              <span class="mark">
                <Shape shape="check" /> in use
              </span>
            )}
          </header>
          <Verdict pose={pose} />
          {inUse && <DriftVerdict recordingId={recording.id} poseId={recording.pose_id} open />}
          {!inUse && canWork.value && (
            <Button onClick={() => void model.choose(pose.id)}>Use this pose for the recording</Button>
          )}
          {inUse && (
            <Button kind="primary" href={`/surveys/${model.surveyId}/measure?recording=${recording.id}`}>
              Measure with it
            </Button>
          )}
        </>
      )}
      <PoseHistory model={model} />
    </section>
  );
}

function Verdict({ pose }: { pose: Pose }) {
  return (
    <div data-testid="pose-verdict" class="stack stack--tight">
      <p>{pose.summary}</p>
      <table class="expected">
        <caption class="visually-hidden">Expected uncertainty of a height</caption>
        <thead>
          <tr>
            <th scope="col">at a distance of</th>
            {pose.expected.map((one) => (
              <th key={one.distance_m} scope="col" class="num">
                {formatLength(one.distance_m, 0)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          <tr>
            <th scope="row">a height is good to (95 %)</th>
            {pose.expected.map((one) => (
              <td key={one.distance_m} class="num" title={one.reason ?? undefined}>
                <strong>{one.U95_height_m === null ? "–" : `± ${formatSmall(one.U95_height_m)}`}</strong>
              </td>
            ))}
          </tr>
        </tbody>
      </table>
      {pose.expected.map(
        (one) =>
          one.reason && (
            <p key={one.distance_m} class="small muted">
              At {formatLength(one.distance_m, 0)}: {one.reason}
            </p>
          ),
      )}
      {pose.warnings.map((warning) => (
        <Notice key={warning} kind="warning">
          {warning}
        </Notice>
      ))}
      <p class="small muted">
        Frames {pose.first_frame} to {pose.last_frame}; corners fit to{" "}
        {pose.rms_px === null ? "–" : `${fixed(pose.rms_px, 2)} px`}; board at{" "}
        {formatLength(pose.distance_m, 2)}.
      </p>
    </div>
  );
}

function PoseHistory({ model }: { model: PoseModel }) {
  const recording = model.reel.recording.value;
  const poses = [...model.poses.value].sort((a, b) => b.id - a.id);
  if (poses.length < 2 && poses[0]?.id === recording?.pose_id) return null;
  const name = (id: number): string =>
    model.reel.recordings.value.find((one) => one.id === id)?.name ?? "another recording";
  return (
    <details class="pose-history">
      <summary>{poses.length} poses in this survey</summary>
      <ul>
        {poses.map((one) => (
          <li key={one.id}>
            <button
              type="button"
              class="pose-history__show"
              onClick={() => void model.showPose(one.id)}
              aria-current={model.pose.value?.id === one.id ? "true" : undefined}
            >
              <span>
                <strong>{one.id}</strong> {name(one.recording_id)}
              </span>
              <span class="small muted">
                {formatMoment(one.created_at)}, frames {one.first_frame} to {one.last_frame}
              </span>
            </button>
            {recording?.pose_id === one.id ? (
              <span class="small">in use</span>
            ) : (
              canWork.value && (
                <Button small onClick={() => void model.choose(one.id)}>
                  Use
                </Button>
              )
            )}
          </li>
        ))}
      </ul>
    </details>
  );
}
