/**
 * Which frame of a recording is asked for and which is shown, and everything that moves it.
 * What is shown lags behind what is asked for while it loads; clicks belong to what is shown.
 */
import { batch, computed, signal } from "@preact/signals";
import { api, explain } from "../api";
import type { FrameTable, Recording } from "../types";
import { FrameCache, neighbours } from "./frameCache";
import { fetchFrame, frameUrl, isAbort } from "./frames";
import { clamp } from "./viewport";

/** 256 MB of decoded frames: 200 at 640x480, 30 at 1080p. */
const CACHE_BYTES = 256e6;
const TABLE_PAGE = 5000;

export interface Shown {
  readonly frame: number;
  readonly picture: ImageBitmap;
}

export class Player {
  readonly frame = signal(0);
  readonly shown = signal<Shown | null>(null);
  readonly loading = signal(false);
  readonly problem = signal<string | null>(null);
  readonly playing = signal(false);
  readonly ranges = signal<readonly [number, number][]>([]);
  readonly recording = signal<Recording | null>(null);
  readonly count = computed(() => this.recording.value?.frame_count ?? null);
  readonly vfr = computed(() => this.recording.value?.vfr ?? false);

  private readonly times = signal<ReadonlyMap<number, number>>(new Map());
  private readonly checksums = new Map<number, number>();
  private readonly pages = new Set<number>();
  private readonly cache: FrameCache<ImageBitmap>;
  private direction: 1 | -1 = 1;
  private rangesTimer: ReturnType<typeof setTimeout> | undefined;
  private closed = false;

  constructor(
    readonly recordingId: number,
    firstFrame: number,
  ) {
    this.cache = new FrameCache<ImageBitmap>(
      (frame, abort) => fetchFrame(frameUrl(recordingId, frame, this.checksums.get(frame)), frame, abort),
      CACHE_BYTES,
      () => this.rangesSoon(),
    );
    this.go(firstFrame);
  }

  /** The recording's facts; the first frame may be on its way before they are known. */
  describe(recording: Recording): void {
    this.recording.value = recording;
    const count = recording.frame_count ?? 0;
    if (count > 0 && this.frame.value >= count) this.go(count - 1);
    else this.prefetch();
    void this.loadTable(this.frame.value);
  }

  /** Time of a frame in seconds, null until its part of the frame table is here. */
  timeOf(frame: number): number | null {
    return this.times.value.get(frame) ?? null;
  }

  go(frame: number): void {
    const last = (this.count.value ?? Number.POSITIVE_INFINITY) - 1;
    const wanted = clamp(Math.round(frame), 0, Math.max(0, last));
    const move = wanted - this.frame.value;
    if (Math.abs(move) <= 12 && move !== 0) this.direction = move > 0 ? 1 : -1;
    const here = this.cache.get(wanted);
    batch(() => {
      this.frame.value = wanted;
      this.problem.value = null;
      this.loading.value = here === undefined;
      if (here) this.shown.value = { frame: wanted, picture: here };
    });
    if (here) this.prefetch();
    else void this.load(wanted);
  }

  step(frames: number): void {
    this.stop();
    this.go(this.frame.value + frames);
  }

  /** One second on or back by the frames' own times, which a VFR recording needs. */
  stepSeconds(seconds: number): void {
    this.stop();
    const now = this.timeOf(this.frame.value);
    // before the frame table is here, a second is 25 frames
    this.go(now === null ? this.frame.value + Math.sign(seconds) * 25 : this.frameAt(now + seconds));
  }

  /** The frame shown at a time. */
  frameAt(time_s: number): number {
    const last = (this.count.value ?? this.times.value.size) - 1;
    let low = 0;
    let high = Math.max(0, last);
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if ((this.timeOf(middle) ?? Number.POSITIVE_INFINITY) <= time_s + 1e-6) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  toggle(): void {
    if (this.playing.value) this.stop();
    else void this.play();
  }

  stop(): void {
    this.playing.value = false;
  }

  close(): void {
    this.closed = true;
    this.stop();
    clearTimeout(this.rangesTimer);
    this.cache.clear();
  }

  retry(): void {
    this.go(this.frame.value);
  }

  private async play(): Promise<void> {
    const last = (this.count.value ?? 1) - 1;
    if (this.frame.value >= last) this.go(0);
    this.playing.value = true;
    this.direction = 1;
    let clock = performance.now();
    let time = this.timeOf(this.frame.value) ?? 0;
    while (this.playing.value && !this.closed && this.frame.value < last) {
      await nextPaint();
      if (this.loading.value) {
        clock = performance.now();
        time = this.timeOf(this.frame.value) ?? time;
        continue;
      }
      const due = this.frameAt(time + (performance.now() - clock) / 1000);
      // a machine that cannot keep up plays slower; it does not skip what the operator looks for
      if (due > this.frame.value) this.go(Math.min(due, this.frame.value + 2));
    }
    this.playing.value = false;
  }

  private async load(frame: number): Promise<void> {
    const ahead = this.wanted(frame);
    this.cache.keepOnly(new Set([frame, ...ahead]));
    try {
      const picture = await this.cache.fetch(frame);
      if (this.closed) return;
      const asked = this.frame.value;
      if (asked === frame) {
        batch(() => {
          this.shown.value = { frame, picture };
          this.loading.value = false;
        });
        this.prefetch();
      } else if (this.loading.value && this.isNearer(frame, asked)) {
        // a held key outruns the server: show the way, not a standing picture
        this.shown.value = { frame, picture };
      }
    } catch (error) {
      if (isAbort(error) || this.frame.value !== frame || this.closed) return;
      batch(() => {
        this.loading.value = false;
        this.problem.value = explain(error);
      });
    }
  }

  private isNearer(frame: number, asked: number): boolean {
    const shown = this.shown.value;
    return shown === null || Math.abs(frame - asked) < Math.abs(shown.frame - asked);
  }

  private wanted(frame: number): number[] {
    return neighbours(frame, this.direction, this.count.value ?? 0);
  }

  /** Neighbours one after the other, nearest first, so that the frame asked for next is never queued behind. */
  private prefetch(): void {
    const frame = this.frame.value;
    const ahead = this.wanted(frame);
    this.cache.keepOnly(new Set([frame, ...ahead]));
    void (async () => {
      for (const next of ahead) {
        if (this.closed || this.frame.value !== frame) return;
        await this.cache.fetch(next).catch(() => {});
      }
      void this.loadTable(frame);
    })();
  }

  private async loadTable(around: number): Promise<void> {
    const first = Math.floor(around / TABLE_PAGE) * TABLE_PAGE;
    if (this.pages.has(first)) return;
    this.pages.add(first);
    try {
      const table = await api.get<FrameTable>(
        `/recordings/${this.recordingId}/frames?first=${first}&count=${TABLE_PAGE}`,
      );
      const times = new Map(this.times.value);
      table.time_s.forEach((time, i) => {
        times.set(table.first + i, time);
        this.checksums.set(table.first + i, table.crc[i] ?? 0);
      });
      this.times.value = times;
    } catch {
      this.pages.delete(first);
    }
  }

  private rangesSoon(): void {
    if (this.rangesTimer !== undefined || this.closed) return;
    this.rangesTimer = setTimeout(() => {
      this.rangesTimer = undefined;
      this.ranges.value = this.cache.ranges();
    }, 120);
  }
}

function nextPaint(): Promise<void> {
  return new Promise((done) => requestAnimationFrame(() => done()));
}
