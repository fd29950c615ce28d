/**
 * Decoded frames, bounded in bytes, least recently used out first; one request per frame at a time,
 * stale requests dropped. Generic over the picture so that it is tested without a browser.
 */
export interface Picture {
  readonly width: number;
  readonly height: number;
  close(): void;
}

export type LoadFrame<P extends Picture> = (frame: number, signal: AbortSignal) => Promise<P>;

interface Request<P> {
  readonly promise: Promise<P>;
  readonly abort: AbortController;
}

const BYTES_PER_PIXEL = 4;

export class FrameCache<P extends Picture> {
  private readonly pictures = new Map<number, P>();
  private readonly requests = new Map<number, Request<P>>();
  private bytes = 0;

  constructor(
    private readonly load: LoadFrame<P>,
    private readonly maxBytes: number,
    private readonly onChange: () => void = () => {},
  ) {}

  /** The picture if it is here; counts as a use. */
  get(frame: number): P | undefined {
    const picture = this.pictures.get(frame);
    if (picture) {
      this.pictures.delete(frame);
      this.pictures.set(frame, picture);
    }
    return picture;
  }

  has(frame: number): boolean {
    return this.pictures.has(frame);
  }

  get usedBytes(): number {
    return this.bytes;
  }

  /** The picture, fetched if need be. Rejects with an AbortError when it was dropped as stale. */
  fetch(frame: number): Promise<P> {
    const here = this.get(frame);
    if (here) return Promise.resolve(here);
    const running = this.requests.get(frame);
    if (running) return running.promise;
    const abort = new AbortController();
    const promise = this.load(frame, abort.signal).then(
      (picture) => this.arrived(frame, abort, picture),
      (error: unknown) => {
        this.forget(frame, abort);
        throw error;
      },
    );
    this.requests.set(frame, { promise, abort });
    return promise;
  }

  /** Drop every request that is not in `wanted`: the operator has moved on. */
  keepOnly(wanted: ReadonlySet<number>): void {
    for (const [frame, request] of this.requests) {
      if (wanted.has(frame)) continue;
      this.requests.delete(frame);
      request.promise.catch(() => {});
      request.abort.abort();
    }
  }

  /** Runs of consecutive loaded frames, for the timeline. */
  ranges(): [number, number][] {
    const frames = [...this.pictures.keys()].sort((a, b) => a - b);
    const runs: [number, number][] = [];
    for (const frame of frames) {
      const last = runs.at(-1);
      if (last && last[1] === frame - 1) last[1] = frame;
      else runs.push([frame, frame]);
    }
    return runs;
  }

  clear(): void {
    this.keepOnly(new Set());
    for (const picture of this.pictures.values()) picture.close();
    this.pictures.clear();
    this.bytes = 0;
    this.onChange();
  }

  private arrived(frame: number, abort: AbortController, picture: P): P {
    this.forget(frame, abort);
    if (abort.signal.aborted) {
      picture.close();
      throw new DOMException("The frame is no longer wanted.", "AbortError");
    }
    this.pictures.set(frame, picture);
    this.bytes += sizeOf(picture);
    this.evict(frame);
    this.onChange();
    return picture;
  }

  private forget(frame: number, abort: AbortController): void {
    if (this.requests.get(frame)?.abort === abort) this.requests.delete(frame);
  }

  private evict(keep: number): void {
    for (const [frame, picture] of this.pictures) {
      if (this.bytes <= this.maxBytes) return;
      if (frame === keep) continue;
      this.pictures.delete(frame);
      this.bytes -= sizeOf(picture);
      picture.close();
    }
  }
}

function sizeOf(picture: Picture): number {
  return picture.width * picture.height * BYTES_PER_PIXEL;
}

/** Frames worth having next: mostly ahead in the direction of travel, a few behind. */
export function neighbours(frame: number, direction: 1 | -1, count: number, ahead = 8, behind = 2): number[] {
  const wanted: number[] = [];
  for (let step = 1; step <= ahead; step += 1) wanted.push(frame + direction * step);
  for (let step = 1; step <= behind; step += 1) wanted.push(frame - direction * step);
  return wanted.filter((n) => n >= 0 && n < count);
}
