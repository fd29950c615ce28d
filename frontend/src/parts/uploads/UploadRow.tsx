import { ask, Button, IconButton, Notice, Progress } from "../../components";
import { api } from "../../core/api";
import { say } from "../../core/messages";
import { formatDuration } from "../../core/times";
import { telling } from "../../core/toasts";
import type { UnfinishedUpload } from "../../core/types";
import { formatBytes } from "../../core/units";
import { cancelUpload, forget, pauseUpload, resumeUpload, type UploadItem } from "./uploads";
import "./uploads.css";

export function UploadRow({ item }: { item: UploadItem }) {
  const resting = item.state === "paused" || item.state === "failed" || item.state === "retrying";
  return (
    <div class="stack stack--tight upload">
      <div class="row">
        <div class="grow">
          <Progress
            value={item.size ? item.sent / item.size : 0}
            label={words(item)}
            figure={figure(item)}
            still={resting}
          />
        </div>
        {item.state === "sending" && (
          <Button says="upload-pause" small icon="pause" onClick={() => void pauseUpload(item.key)} />
        )}
        {(item.state === "paused" || (item.state === "failed" && item.size > 0)) && (
          <Button says="upload-resume" small icon="play" onClick={() => resumeUpload(item.key)} />
        )}
        {item.state !== "done" && (
          <IconButton
            icon="close"
            label={say("upload-cancel", { file: item.name })}
            onClick={() => void (item.size === 0 ? forget(item.key) : cancelUpload(item.key))}
          />
        )}
      </div>
      {item.problem && <Notice kind="problem">{item.problem}</Notice>}
    </div>
  );
}

function words(item: UploadItem): string {
  const { name: file, state, purpose, resumedFrom } = item;
  if (state === "sending" && resumedFrom > 0)
    return say("upload-resumed", { file, arrived: formatBytes(resumedFrom) });
  const arrived = purpose === "strip" ? "kept" : "read";
  return say("upload-state", { file, state: state === "done" ? arrived : state });
}

function figure(item: UploadItem): string {
  const amount = { arrived: formatBytes(item.sent), size: formatBytes(item.size) };
  if (!item.speed || item.state !== "sending") return say("upload-amount", amount);
  const time = formatDuration((item.size - item.sent) / item.speed);
  return say("upload-rate", { ...amount, speed: formatBytes(item.speed), time });
}

/** An upload that another page, or this one before a reload, did not finish. */
export function UnfinishedRow({ upload, gone }: { upload: UnfinishedUpload; gone: () => Promise<void> }) {
  const discard = async () => {
    const yes = await ask({
      title: say("upload-discard-title"),
      body: say("upload-discard-body", { arrived: formatBytes(upload.offset), file: upload.filename }),
      action: say("upload-discard"),
    });
    if (!yes) return;
    await telling(async () => {
      await api.write("DELETE /uploads/{upload_id}", { upload_id: upload.id });
      await gone();
    });
  };
  return (
    <div class="stack stack--tight upload">
      <div class="row">
        <div class="grow">
          <Progress
            value={upload.size_bytes ? upload.offset / upload.size_bytes : 0}
            label={say("upload-unfinished", { file: upload.filename })}
            figure={say("upload-amount", {
              arrived: formatBytes(upload.offset),
              size: formatBytes(upload.size_bytes),
            })}
            still
          />
        </div>
        <IconButton
          icon="trash"
          label={say("upload-discard-one", { file: upload.filename })}
          onClick={discard}
        />
      </div>
    </div>
  );
}
