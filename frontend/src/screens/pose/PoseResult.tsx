/** What the pose is worth, in plain words: the expected uncertainty of heights, warnings, and other poses to choose from. */
import { useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import { Button, Notices, Shape } from "../../components";
import { say, sentenceOf, sentencesOf } from "../../core/messages";
import { canWork } from "../../core/session";
import { formatMoment } from "../../core/times";
import type { Pose } from "../../core/types";
import { fixed, formatAway, formatLength, formatSmall } from "../../core/units";
import { DriftVerdict } from "../../parts/drift/Drift";
import type { PoseModel } from "./model";

export function PoseResult({ model }: { model: PoseModel }) {
  const pose = model.pose.value;
  const recording = model.reel.recording.value;
  const box = useRef<HTMLElement>(null);
  // the form was scrolled to its end to press the button: what came of it is above
  useSignalEffect(() => {
    if (model.found.value > 0) requestAnimationFrame(() => box.current?.scrollIntoView({ block: "start" }));
  });
  if (!pose && model.poses.value.length === 0) return null;
  const inUse = pose !== null && recording?.pose_id === pose.id;
  return (
    <section class="stack stack--near pose-result" ref={box}>
      {pose && (
        <>
          <header class="row">
            <h2 class="grow">{say(inUse ? "pose-result" : "pose-result-earlier")}</h2>
            {inUse && (
              <span class="mark">
                <Shape shape="check" /> {say("in-use")}
              </span>
            )}
          </header>
          <Verdict pose={pose} />
          {inUse && <DriftVerdict recordingId={recording.id} poseId={recording.pose_id} open />}
          <Button
            says="pose-download"
            small
            icon="download"
            href={`/api/poses/${pose.id}/pose.json`}
            download
          />
          {!inUse && canWork.value && <Button says="pose-use" onClick={() => void model.choose(pose.id)} />}
          {inUse && (
            <Button
              says="pose-measure"
              kind="primary"
              href={`/surveys/${model.surveyId}/measure?recording=${recording.id}`}
            />
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
      <p>{sentencesOf(pose.summary)}</p>
      <table class="expected">
        <caption class="visually-hidden">{say("pose-expected")}</caption>
        <thead>
          <tr>
            <th scope="col">{say("pose-expected-distance")}</th>
            {pose.expected.map((one) => (
              <th key={one.distance_m} scope="col" class="num">
                {formatAway(one.distance_m)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          <tr>
            <th scope="row">{say("pose-expected-good")}</th>
            {pose.expected.map((one) => (
              <td key={one.distance_m} class="num" title={sentenceOf(one.reason) ?? undefined}>
                <strong>
                  {one.U95_height_m === null
                    ? "–"
                    : say("pose-expected-U95", { U95: formatSmall(one.U95_height_m) })}
                </strong>
              </td>
            ))}
          </tr>
        </tbody>
      </table>
      {pose.expected.map(
        (one) =>
          one.reason && (
            <p key={one.distance_m} class="small muted">
              {say("pose-expected-reason", {
                distance: formatAway(one.distance_m),
                reason: sentenceOf(one.reason),
              })}
            </p>
          ),
      )}
      <Notices of={pose.warnings} kind="warning" />
      <p class="small muted">
        {say("pose-facts", {
          ...framesOf(pose),
          fit: pose.rms_px === null ? "–" : say("value-px", { value: fixed(pose.rms_px, 2) }),
          distance: formatLength(pose.distance_m, 2),
        })}
      </p>
    </div>
  );
}

function framesOf(pose: Pick<Pose, "first_frame" | "last_frame">) {
  return { first_frame: String(pose.first_frame), last_frame: String(pose.last_frame) };
}

function PoseHistory({ model }: { model: PoseModel }) {
  const recording = model.reel.recording.value;
  const poses = [...model.poses.value].sort((a, b) => b.id - a.id);
  if (poses.length < 2 && poses[0]?.id === recording?.pose_id) return null;
  const name = (id: number): string =>
    model.reel.recordings.value.find((one) => one.id === id)?.name ?? say("pose-other-recording");
  return (
    <details class="pose-history">
      <summary>{say("pose-poses", { count: poses.length })}</summary>
      <ul class="below">
        {poses.map((one) => (
          <li key={one.id} class="row row--apart">
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
                {say("pose-made", { time: formatMoment(one.created_at), ...framesOf(one) })}
              </span>
            </button>
            {recording?.pose_id === one.id ? (
              <span class="small">{say("in-use")}</span>
            ) : (
              canWork.value && (
                <Button says="pose-use-short" small onClick={() => void model.choose(one.id)} />
              )
            )}
          </li>
        ))}
      </ul>
    </details>
  );
}
