import { useState } from "preact/hooks";
import { api } from "../../api";
import {
  ask,
  Button,
  JobProgress,
  Notice,
  Problem,
  Segments,
  SelectField,
  StateMark,
} from "../../components";
import { cancelJob } from "../../state/jobs";
import { may } from "../../state/session";
import { toast } from "../../state/toasts";
import { formatDuration, formatMoment } from "../../times";
import type { Camera, Lighting, Recording } from "../../types";
import { formatBytes, plural } from "../../units";

interface Props {
  recording: Recording;
  cameras: Camera[];
  changed: (recording: Recording) => void;
  reload: () => Promise<void>;
}

export function RecordingCard({ recording, cameras, changed, reload }: Props) {
  const [problem, setProblem] = useState<unknown>(null);
  const canWork = may("operator");
  const run = async (work: () => Promise<unknown>) => {
    setProblem(null);
    try {
      await work();
    } catch (error) {
      setProblem(error);
    }
  };
  const put = (part: Partial<Pick<Recording, "name" | "camera_id" | "lighting">>) =>
    run(async () => changed(await api.put<Recording>(`/recordings/${recording.id}`, part)));
  const remove = () =>
    run(async () => {
      const yes = await ask({
        title: `Delete ${recording.name}?`,
        body: "The video, its frame table and its road poses go; a recording with measurements cannot be deleted.",
        action: "Delete the recording",
      });
      if (!yes) return;
      await api.del(`/recordings/${recording.id}`);
      toast(`${recording.name} was deleted.`);
      await reload();
    });
  return (
    <article class="panel recording">
      <Poster recording={recording} />
      <div class="recording__body">
        <header class="row row--apart">
          <Name recording={recording} rename={(name) => void put({ name })} />
          <div class="row">
            {recording.vfr && (
              <span
                class="badge badge--solid"
                title="Variable frame rate: times come from each frame's own time stamp"
              >
                VFR
              </span>
            )}
            <StateMark state={recording.state} />
          </div>
        </header>
        <Facts recording={recording} />
        {recording.state === "ingesting" && recording.job && (
          <JobProgress
            job={recording.job}
            onCancel={
              canWork && recording.job
                ? () =>
                    void run(async () => {
                      await cancelJob(recording.job?.id ?? 0);
                      await reload();
                    })
                : undefined
            }
          />
        )}
        {recording.state === "failed" && (
          <Notice
            kind="problem"
            actions={
              canWork && (
                <Button
                  small
                  icon="retry"
                  onClick={() =>
                    void run(async () => {
                      await api.post(`/recordings/${recording.id}/ingest`);
                      await reload();
                    })
                  }
                >
                  Read it again
                </Button>
              )
            }
          >
            {recording.error ?? "This recording could not be read."}
          </Notice>
        )}
        {recording.notes.length > 0 && (
          <ul class="recording__notes">
            {recording.notes.map((note) => (
              <li key={note}>{note}</li>
            ))}
          </ul>
        )}
        <Problem error={problem} />
        <footer class="recording__foot">
          {recording.state !== "failed" && (
            <>
              <CameraPick
                recording={recording}
                cameras={cameras}
                pick={(camera_id) => void put({ camera_id })}
              />
              <LightPick recording={recording} pick={(lighting) => void put({ lighting })} />
            </>
          )}
          <span class="grow" />
          {recording.state === "ready" && (
            <Button
              href={`/surveys/${recording.survey_id}/${recording.pose_id === null ? "pose" : "measure"}?recording=${recording.id}`}
              kind="plain"
            >
              {recording.pose_id === null ? "Find the road" : "Measure"}
            </Button>
          )}
          {canWork && recording.state !== "ingesting" && (
            <Button
              kind="quiet"
              icon="trash"
              label={`Delete ${recording.name}`}
              onClick={() => void remove()}
            />
          )}
        </footer>
      </div>
    </article>
  );
}

function Poster({ recording }: { recording: Recording }) {
  const thumb = recording.thumbs[Math.floor(recording.thumbs.length / 2)];
  return (
    <div class="recording__poster">
      {thumb ? (
        <img src={thumb.url} alt="" loading="lazy" />
      ) : (
        <span class="small">{recording.state === "failed" ? "no picture" : "no picture yet"}</span>
      )}
    </div>
  );
}

function Name({ recording, rename }: { recording: Recording; rename: (name: string) => void }) {
  const [typed, setTyped] = useState<string | null>(null);
  if (typed === null) {
    return (
      <h2 class="clip recording__name">
        {recording.name}
        {may("operator") && (
          <Button
            small
            kind="quiet"
            onClick={() => setTyped(recording.name)}
            label={`Rename ${recording.name}`}
          >
            Rename
          </Button>
        )}
      </h2>
    );
  }
  const done = (event: Event) => {
    event.preventDefault();
    const name = typed.trim();
    if (name && name !== recording.name) rename(name);
    setTyped(null);
  };
  return (
    <form class="row grow" onSubmit={done}>
      <input
        class="input"
        aria-label="Name of the recording"
        value={typed}
        ref={(input) => {
          if (input && document.activeElement !== input) input.focus();
        }}
        onInput={(event) => setTyped(event.currentTarget.value)}
        onKeyDown={(event) => event.key === "Escape" && setTyped(null)}
      />
      <Button type="submit">Save</Button>
    </form>
  );
}

function Facts({ recording }: { recording: Recording }) {
  const { width_px, height_px, frame_count, duration_s, codec, container } = recording;
  const rate = frame_count && duration_s ? frame_count / duration_s : null;
  const facts = [
    width_px && height_px ? `${width_px} × ${height_px}` : null,
    frame_count !== null ? plural(frame_count, "frame") : null,
    duration_s !== null ? formatDuration(duration_s) : null,
    rate ? `${rate.toFixed(2)} per second${recording.vfr ? " on average" : ""}` : null,
    codec ? `${codec}${container ? ` in ${container.split(",")[0]}` : ""}` : null,
    formatBytes(recording.size_bytes),
  ].filter(Boolean);
  return (
    <p class="recording__facts">
      {facts.join("  ·  ")}
      <span class="muted" title={recording.sha256 ? `SHA-256 ${recording.sha256}` : undefined}>
        {"  ·  "}
        {formatMoment(recording.created_at)}
        {recording.sha256 && (
          <>
            {"  ·  "}
            <code>{recording.sha256.slice(0, 12)}</code>
          </>
        )}
      </span>
    </p>
  );
}

function CameraPick({
  recording,
  cameras,
  pick,
}: {
  recording: Recording;
  cameras: Camera[];
  pick: (id: number | null) => void;
}) {
  if (cameras.length === 0) {
    return (
      <p class="small">
        No camera yet: <a href={`/surveys/${recording.survey_id}/camera`}>calibrate one</a>.
      </p>
    );
  }
  return (
    <div class="recording__pick">
      <SelectField
        label="Camera"
        value={String(recording.camera_id ?? "")}
        disabled={!may("operator")}
        options={[
          { value: "", label: "not said yet" },
          ...cameras.map((camera) => ({
            value: String(camera.id),
            label: camera.current_calibration_id === null ? `${camera.name} (not calibrated)` : camera.name,
          })),
        ]}
        onChange={(value) => pick(value === "" ? null : Number(value))}
      />
    </div>
  );
}

function LightPick({ recording, pick }: { recording: Recording; pick: (lighting: Lighting) => void }) {
  const proposed = recording.lighting === null && recording.lighting_proposed !== null;
  const value = recording.lighting ?? recording.lighting_proposed;
  return (
    <div class="field">
      <span class="field__label">Lighting{proposed && <span class="muted"> (proposed)</span>}</span>
      <Segments<Lighting | "none">
        label={`Lighting of ${recording.name}${proposed ? ", proposed by the machine" : ""}`}
        value={recording.lighting ?? "none"}
        disabled={!may("operator")}
        options={[
          { value: "daytime", label: value === "daytime" && proposed ? "Daytime ?" : "Daytime" },
          { value: "low_light", label: value === "low_light" && proposed ? "Low light ?" : "Low light" },
        ]}
        onChange={(next) => next !== "none" && pick(next)}
      />
    </div>
  );
}
