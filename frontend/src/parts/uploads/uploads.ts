/** Uploads of video: several at once, paused and resumed, going on after a broken connection or a reload (tus 1.0). They live
 *  beside the screens, so that going to another page does not stop them. */
import { signal } from "@preact/signals";
import type { DetailedError, Upload as TusUpload } from "tus-js-client";
import { toApiError } from "../../core/api";
import { say } from "../../core/messages";

type UploadState = "waiting" | "sending" | "paused" | "retrying" | "done" | "failed";

/** A video becomes a recording; a strip waits for its line scan. */
export type UploadPurpose = "video" | "strip";

export interface UploadItem {
  key: number;
  surveyId: number;
  purpose: UploadPurpose;
  name: string;
  size: number;
  sent: number;
  /** bytes per second over the last seconds; null when not known yet */
  speed: number | null;
  state: UploadState;
  problem: string | null;
  /** bytes that were already on the server when it began */
  resumedFrom: number;
  recordingId: number | null;
}

export const uploads = signal<UploadItem[]>([]);

/** Bytes in one request; small enough for proxies with limits, large enough to be quick. */
const CHUNK_BYTES = 16 * 2 ** 20;
const RETRY_DELAYS_MS = [0, 500, 1000, 2000, 4000, 8000, 15000, 15000, 15000, 15000, 15000, 15000];

const running = new Map<number, { upload: TusUpload; samples: [at: number, sent: number][] }>();
let nextKey = 1;

function change(key: number, part: Partial<UploadItem>): void {
  uploads.value = uploads.value.map((item) => (item.key === key ? { ...item, ...part } : item));
}

function itemOf(key: number): UploadItem | undefined {
  return uploads.value.find((item) => item.key === key);
}

/** Comes when the first file is dropped; null where it cannot be loaded. */
const tus = (): Promise<typeof TusUpload | null> =>
  import("tus-js-client").then(
    (module) => module.Upload,
    () => null,
  );

export async function startUpload(
  surveyId: number,
  file: File,
  onDone: (recordingId: number | null) => void,
  purpose: UploadPurpose = "video",
): Promise<void> {
  const key = nextKey++;
  uploads.value = [
    ...uploads.value,
    {
      key,
      surveyId,
      purpose,
      name: file.name,
      size: file.size,
      sent: 0,
      speed: null,
      state: "waiting",
      problem: null,
      resumedFrom: 0,
      recordingId: null,
    },
  ];
  if (file.size === 0) {
    change(key, { state: "failed", problem: say("upload-empty", { file: file.name }) });
    return;
  }
  let recordingId: number | null = null;
  let finished = false;
  const Upload = await tus();
  if (!Upload || !itemOf(key)) {
    change(key, { state: "failed", problem: say("upload-not-loaded") });
    return;
  }
  const upload = new Upload(file, {
    endpoint: `/api/surveys/${surveyId}/uploads`,
    headers: { "X-Sightline": "1" },
    metadata: { filename: file.name, ...(purpose === "strip" ? { purpose } : {}) },
    chunkSize: CHUNK_BYTES,
    retryDelays: RETRY_DELAYS_MS,
    removeFingerprintOnSuccess: true,
    onShouldRetry: (error) => {
      const status = error.originalResponse?.getStatus() ?? 0;
      const again = status === 0 || status === 409 || status === 423 || status === 429 || status >= 502;
      if (again) change(key, { state: "retrying", speed: null });
      return again;
    },
    onAfterResponse: (request, response) => {
      const made = response.getHeader("Sightline-Recording");
      if (made) recordingId = Number(made);
      finished = request.getMethod() !== "HEAD" || response.getHeader("Sightline-Finished") === "1";
    },
    onProgress: (sent) => progress(key, sent),
    onError: (error) => {
      change(key, { state: "failed", problem: sentence(error, file.name), speed: null });
    },
    onSuccess: async () => {
      if (!finished && upload.url) {
        // All bytes were there before, and the server was stopped behind the last one.
        const answer = await finish(upload.url, file.size);
        if (!answer.ok) {
          const body: unknown = await answer.json().catch(() => null);
          change(key, { state: "failed", problem: toApiError(answer.status, body).message, speed: null });
          return;
        }
        const made = answer.headers.get("Sightline-Recording");
        if (made) recordingId = Number(made);
      }
      running.delete(key);
      change(key, { state: "done", sent: file.size, recordingId });
      onDone(recordingId);
      setTimeout(() => forget(key), 4000);
    },
  });
  running.set(key, { upload, samples: [] });
  const before = await upload.findPreviousUploads().catch(() => []);
  const last = before[0];
  if (last) {
    upload.resumeFromPreviousUpload(last);
    change(key, { resumedFrom: -1 });
  }
  change(key, { state: "sending" });
  upload.start();
}

/** An empty piece behind the last byte: the server makes the recording, or keeps the strip. */
function finish(url: string, size: number): Promise<Response> {
  return fetch(url, {
    method: "PATCH",
    headers: {
      "X-Sightline": "1",
      "Tus-Resumable": "1.0.0",
      "Content-Type": "application/offset+octet-stream",
      "Upload-Offset": String(size),
    },
    body: "",
  });
}

function progress(key: number, sent: number): void {
  const own = running.get(key);
  const item = itemOf(key);
  if (!own || !item) return;
  if (item.resumedFrom === -1) change(key, { resumedFrom: sent });
  const now = performance.now();
  own.samples = [...own.samples.filter(([at]) => now - at < 5000), [now, sent]];
  const [first] = own.samples;
  const seconds = first ? (now - first[0]) / 1000 : 0;
  const speed = first && seconds > 0.5 ? (sent - first[1]) / seconds : null;
  change(key, { sent, speed, state: item.state === "paused" ? "paused" : "sending" });
}

function sentence(error: Error | DetailedError, name: string): string {
  if ("originalResponse" in error && error.originalResponse) {
    let body: unknown = null;
    try {
      body = JSON.parse(error.originalResponse.getBody());
    } catch {
      // a proxy's page: the status has to do
    }
    return toApiError(error.originalResponse.getStatus(), body).message;
  }
  return say("upload-broken", { file: name });
}

export async function pauseUpload(key: number): Promise<void> {
  change(key, { state: "paused", speed: null });
  await running.get(key)?.upload.abort();
}

export function resumeUpload(key: number): void {
  const own = running.get(key);
  if (!own) return;
  own.samples = [];
  change(key, { state: "sending", problem: null });
  own.upload.start();
}

export async function cancelUpload(key: number): Promise<void> {
  const own = running.get(key);
  running.delete(key);
  forget(key);
  await own?.upload.abort(true).catch(() => undefined);
}

export function forget(key: number): void {
  uploads.value = uploads.value.filter((item) => item.key !== key);
}

window.addEventListener("beforeunload", (event) => {
  if (uploads.value.some((item) => item.state === "sending" || item.state === "retrying"))
    event.preventDefault();
});
