import { useState } from "preact/hooks";
import { ask, Button, JobProgress, Notice, Notices, Problem, StateMark } from "../../components";
import { useAction } from "../../core/action";
import { api } from "../../core/api";
import { sent } from "../../core/form";
import { cancelJob } from "../../core/jobs";
import { say, sentenceOf } from "../../core/messages";
import { may } from "../../core/session";
import { formatDuration, formatMoment } from "../../core/times";
import { toast } from "../../core/toasts";
import type { Camera, Recording, RecordingChange } from "../../core/types";
import { fixed, formatBytes } from "../../core/units";
import { DriftVerdict } from "../../parts/drift/Drift";
import { FindPasses } from "../../parts/vehicles/FindPasses";
import { Filmed } from "./Filmed";
import { CameraPick, LightPick } from "./pickers";
import { ReadAs } from "./ReadAs";

interface Props {
  recording: Recording;
  passes: number | undefined;
  cameras: Camera[];
  changed: (recording: Recording) => void;
  reload: () => Promise<void>;
}

export function RecordingCard({ recording, passes, cameras, changed, reload }: Props) {
  const { problem, run } = useAction();
  const canWork = may("operator");
  const change = async (body: RecordingChange) =>
    changed(await api.write("PUT /recordings/{recording_id}", { recording_id: recording.id }, { body }));
  const put = (part: RecordingChange) => run(() => change(part));
  const remove = () =>
    run(async () => {
      const yes = await ask({
        title: say("recordings-delete-title", { recording: recording.name }),
        body: say("recordings-delete-body"),
        action: say("recordings-delete"),
      });
      if (!yes) return;
      await api.write("DELETE /recordings/{recording_id}", { recording_id: recording.id });
      toast(say("recordings-deleted", { recording: recording.name }));
      await reload();
    });
  const cancel = () =>
    run(async () => {
      if (recording.job) await cancelJob(recording.job.id);
      await reload();
    });
  const readAgain = () =>
    run(async () => {
      await api.write("POST /recordings/{recording_id}/ingest", { recording_id: recording.id });
      await reload();
    });
  return (
    <article class="panel recording">
      <Poster recording={recording} />
      <div class="stack stack--near recording__body">
        <header class="row row--apart">
          <Name recording={recording} rename={(name) => void put({ name })} />
          <div class="row">
            {recording.vfr && (
              <span class="badge badge--solid" title={say("recordings-vfr-title")}>
                {say("vfr")}
              </span>
            )}
            <StateMark state={recording.state} />
            {recording.state !== "ingesting" && (
              <Button
                kind="quiet"
                icon="download"
                label={say("recordings-download-one", { recording: recording.name })}
                href={`/api/recordings/${recording.id}/video`}
                download
              />
            )}
            {canWork && recording.state !== "ingesting" && (
              <Button
                kind="quiet"
                icon="trash"
                label={say("recordings-delete-one", { recording: recording.name })}
                onClick={() => void remove()}
              />
            )}
          </div>
        </header>
        <Facts recording={recording} passes={passes} />
        <Filmed recording={recording} change={change} />
        <ReadAs recording={recording} run={run} reload={reload} />
        <Notices of={recording.misfits} kind="warning" />
        {recording.state === "ingesting" && recording.job && (
          <JobProgress job={recording.job} onCancel={canWork ? () => void cancel() : undefined} />
        )}
        {recording.state === "failed" && (
          <Failed reason={sentenceOf(recording.error)} again={canWork ? () => void readAgain() : undefined} />
        )}
        {recording.notes.length > 0 && (
          <ul class="recording__notes muted small">
            {recording.notes.map(sentenceOf).map((note) => (
              <li key={note}>{note}</li>
            ))}
          </ul>
        )}
        <Problem error={problem} />
        {recording.state === "ready" && (
          <DriftVerdict recordingId={recording.id} poseId={recording.pose_id} />
        )}
        {recording.state !== "failed" && (
          <footer class="row row--wrap row--end row--far recording__foot">
            <CameraPick
              recording={recording}
              cameras={cameras}
              pick={(camera_id) => void put({ camera_id })}
            />
            <LightPick recording={recording} pick={(lighting) => void put({ lighting })} />
            <span class="grow" />
            <FindPasses recording={recording} found={reload} />
            {recording.state === "ready" && (
              <Button
                says={recording.pose_id === null ? "recordings-find-road" : "recordings-measure"}
                href={`/surveys/${recording.survey_id}/${recording.pose_id === null ? "pose" : "measure"}?recording=${recording.id}`}
                kind="plain"
              />
            )}
          </footer>
        )}
      </div>
    </article>
  );
}

function Failed({ reason, again }: { reason: string | null; again?: () => void }) {
  return (
    <Notice
      kind="problem"
      actions={again && <Button says="recordings-read-again" small icon="retry" onClick={again} />}
    >
      {reason ?? say("recordings-unreadable")}
    </Notice>
  );
}

function Poster({ recording }: { recording: Recording }) {
  const thumb = recording.thumbs[Math.floor(recording.thumbs.length / 2)];
  return (
    <div class="recording__poster">
      {thumb ? (
        <img src={thumb.url} alt="" loading="lazy" />
      ) : (
        <span class="small">
          {say(recording.state === "failed" ? "recordings-no-picture" : "recordings-no-picture-yet")}
        </span>
      )}
    </div>
  );
}

function Name({ recording, rename }: { recording: Recording; rename: (name: string) => void }) {
  const [typed, setTyped] = useState<string | null>(null);
  if (typed === null) {
    return (
      <h2 class="row clip recording__name">
        {recording.name}
        {may("operator") && (
          <Button
            says="recordings-rename"
            small
            kind="quiet"
            onClick={() => setTyped(recording.name)}
            label={say("recordings-rename-one", { recording: recording.name })}
          />
        )}
      </h2>
    );
  }
  const done = () => {
    const name = typed.trim();
    if (name && name !== recording.name) rename(name);
    setTyped(null);
  };
  return (
    <form class="row grow" onSubmit={sent(done)}>
      <input
        class="input"
        aria-label={say("recordings-name")}
        value={typed}
        ref={(input) => {
          if (input && document.activeElement !== input) input.focus();
        }}
        onInput={(event) => setTyped(event.currentTarget.value)}
        onKeyDown={(event) => event.key === "Escape" && setTyped(null)}
      />
      <Button says="action-save" type="submit" />
    </form>
  );
}

/** The kind of a file, of those that its reader serves ("mov,mp4,m4a"): the one that its name ends in, else the first two. */
function kindOf(name: string, container: string): string {
  const kinds = container.split(",");
  const ending = name.split(".").at(-1)?.toLowerCase() ?? "";
  return kinds.includes(ending) ? ending : kinds.slice(0, 2).join("/");
}

/** It ends a line and begins none. */
const BETWEEN = "\u00a0\u00a0·  ";

function Facts({ recording, passes }: Pick<Props, "recording" | "passes">) {
  const { width_px, height_px, frame_count, duration_s, codec, container } = recording;
  const rate = frame_count && duration_s ? frame_count / duration_s : null;
  const facts = [
    width_px && height_px ? `${width_px} × ${height_px}` : null,
    frame_count !== null ? say("recordings-frames", { count: frame_count }) : null,
    duration_s !== null ? formatDuration(duration_s) : null,
    rate
      ? say(recording.vfr ? "recordings-rate-average" : "recordings-rate", { rate: fixed(rate, 2) })
      : null,
    codec && container
      ? say("recordings-codec", { codec, container: kindOf(recording.name, container) })
      : codec,
    formatBytes(recording.size_bytes),
  ].filter(Boolean);
  return (
    <p class="recording__facts small">
      {recording.state === "ready" && passes !== undefined && (
        <>
          <strong data-testid={`passes-of-${recording.id}`}>
            {say("recordings-passes", { count: passes })}
          </strong>
          {BETWEEN}
        </>
      )}
      {facts.join(BETWEEN)}
      <span
        class="muted"
        title={recording.sha256 ? say("recordings-sha256", { sha256: recording.sha256 }) : undefined}
      >
        {BETWEEN}
        {formatMoment(recording.created_at)}
        {recording.sha256 && (
          <>
            {BETWEEN}
            <code>{recording.sha256.slice(0, 12)}</code>
          </>
        )}
      </span>
    </p>
  );
}
