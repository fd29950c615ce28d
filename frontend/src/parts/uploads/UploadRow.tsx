import { ask, Button, Notice, Progress } from "../../components";
import { api } from "../../core/api";
import { formatDuration } from "../../core/times";
import { toastProblem } from "../../core/toasts";
import type { UnfinishedUpload } from "../../core/types";
import { formatBytes } from "../../core/units";
import { cancelUpload, forget, pauseUpload, resumeUpload, type UploadItem } from "./uploads";
import "./uploads.css";

export function UploadRow({ item }: { item: UploadItem }) {
  const resting = item.state === "paused" || item.state === "failed" || item.state === "retrying";
  return (
    <div class="upload">
      <div class="row">
        <div class="grow">
          <Progress
            value={item.size ? item.sent / item.size : 0}
            label={`${item.name}: ${words(item)}`}
            figure={figure(item)}
            still={resting}
          />
        </div>
        {item.state === "sending" && (
          <Button small icon="pause" onClick={() => void pauseUpload(item.key)}>
            Pause
          </Button>
        )}
        {(item.state === "paused" || (item.state === "failed" && item.size > 0)) && (
          <Button small icon="play" onClick={() => resumeUpload(item.key)}>
            Resume
          </Button>
        )}
        {item.state !== "done" && (
          <Button
            small
            kind="quiet"
            icon="close"
            label={`Cancel the upload of ${item.name}`}
            onClick={() => void (item.size === 0 ? forget(item.key) : cancelUpload(item.key))}
          />
        )}
      </div>
      {item.problem && <Notice kind="problem">{item.problem}</Notice>}
    </div>
  );
}

function words(item: UploadItem): string {
  switch (item.state) {
    case "waiting":
      return "about to start";
    case "paused":
      return "paused";
    case "retrying":
      return "connection broken, trying again";
    case "failed":
      return "stopped";
    case "done":
      return item.purpose === "strip" ? "here" : "here, being read";
    case "sending":
      return item.resumedFrom > 0 ? `sending, resumed at ${formatBytes(item.resumedFrom)}` : "sending";
  }
}

function figure(item: UploadItem): string {
  const amount = `${formatBytes(item.sent)} of ${formatBytes(item.size)}`;
  if (!item.speed || item.state !== "sending") return amount;
  return `${amount} · ${formatBytes(item.speed)}/s · ${formatDuration((item.size - item.sent) / item.speed)} left`;
}

/** An upload that another page, or this one before a reload, did not finish. */
export function UnfinishedRow({ upload, gone }: { upload: UnfinishedUpload; gone: () => Promise<void> }) {
  const discard = async () => {
    const yes = await ask({
      title: "Throw away the part that arrived?",
      body: `${formatBytes(upload.offset)} of ${upload.filename} are on the server.`,
      action: "Throw it away",
    });
    if (!yes) return;
    try {
      await api.write("DELETE /uploads/{upload_id}", { upload_id: upload.id });
      await gone();
    } catch (error) {
      toastProblem(error);
    }
  };
  return (
    <div class="upload">
      <div class="row">
        <div class="grow">
          <Progress
            value={upload.size_bytes ? upload.offset / upload.size_bytes : 0}
            label={`${upload.filename}: not finished; drop the same file again and it goes on from here`}
            figure={`${formatBytes(upload.offset)} of ${formatBytes(upload.size_bytes)}`}
            still
          />
        </div>
        <Button
          small
          kind="quiet"
          icon="trash"
          label={`Throw away the unfinished upload of ${upload.filename}`}
          onClick={discard}
        />
      </div>
    </div>
  );
}
