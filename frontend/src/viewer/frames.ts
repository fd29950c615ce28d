/** Fetches stills and lossless crops of one recording; the server is the only decoder. */
import { problemOf, toApiError } from "../core/api";
import { displayQuery } from "./display";

/** Address of a frame; its checksum tells the frames of a recording that was read anew from those before. */
export function frameUrl(recordingId: number, frame: number, crc?: number, isBright = false): string {
  const parts = [crc === undefined ? "" : `v=${crc}`, displayQuery(isBright)].filter(Boolean);
  const query = parts.length > 0 ? `?${parts.join("&")}` : "";
  return `/api/recordings/${recordingId}/frames/${frame}.jpg${query}`;
}

export interface Crop {
  readonly x: number;
  readonly y: number;
  readonly w: number;
  readonly h: number;
}

export function cropUrl(recordingId: number, frame: number, crop: Crop, isBright = false): string {
  const { x, y, w, h } = crop;
  const display = isBright ? `&${displayQuery(true)}` : "";
  return `/api/recordings/${recordingId}/frames/${frame}/crop.png?x=${x}&y=${y}&w=${w}&h=${h}${display}`;
}

/** A picture, decoded; throws an ApiError with the server's sentence. */
export async function fetchPicture(url: string, signal?: AbortSignal): Promise<ImageBitmap> {
  const answer = await fetch(url, { signal, credentials: "same-origin" });
  if (!answer.ok) throw toApiError(answer.status, await answer.json().catch(() => null));
  return createImageBitmap(await answer.blob());
}

/** A frame, checked to be the one asked for: a wrong picture is an error, never shown. */
export async function fetchFrame(url: string, frame: number, signal: AbortSignal): Promise<ImageBitmap> {
  const answer = await fetch(url, { signal, credentials: "same-origin" });
  if (!answer.ok) throw toApiError(answer.status, await answer.json().catch(() => null));
  const served = answer.headers.get("Sightline-Frame");
  if (served !== null && Number(served) !== frame) {
    throw problemOf("viewer-wrong-frame", { served, frame }, 500);
  }
  return createImageBitmap(await answer.blob());
}

export function isAbort(error: unknown): boolean {
  return error instanceof DOMException && error.name === "AbortError";
}
