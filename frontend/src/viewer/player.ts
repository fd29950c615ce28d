/**
 * Which frame of a recording is asked for and which is shown, and everything that moves it.
 * What is shown lags behind what is asked for while it loads; clicks belong to what is shown.
 */
import { batch, computed, signal } from "@preact/signals";
import { api, explain } from "../core/api";
import type { Recording } from "../core/types";
import { runsOf, standIn, worthHaving } from "./ahead";
import { BitmapCache } from "./bitmapCache";
import { bright } from "./display";
import { fetchFrame, fetchPicture, frameUrl, isAbort } from "./frames";
import { clamp } from "./view";

/** 256 MB of decoded frames: 200 at 640x480, 30 at 1080p. */
const CACHE_BYTES = 256e6;
const TABLE_PAGE = 5000;
/** The server's window is asked for no more often than this. */
const READY_MS = 3000;

export interface Shown {
  readonly frame: number;
  readonly picture: ImageBitmap;
}

export class Player {
  readonly frame = signal(0);
  readonly shown = signal<Shown | null>(null);
  /** A thumbnail that stands in after a jump until the frame is here; nothing is clicked on it. */
  readonly preview = signal<Shown | null>(null);
  readonly loading = signal(false);
  readonly problem = signal<string | null>(null);
  readonly playing = signal(false);
  readonly ranges = signal<readonly [number, number][]>([]);
  /** Runs of frames that the server answers without decoding. */
  readonly ready = signal<readonly [number, number][]>([]);
  readonly recording = signal<Recording | null>(null);
  readonly count = computed(() => this.recording.value?.frame_count ?? null);
  readonly vfr = computed(() => this.recording.value?.vfr ?? false);

  /** How often somebody has gone somewhere: an answer that was asked for before leaves them there. */
  wishes = 0;

  private readonly times = signal<ReadonlyMap<number, number>>(new Map());
  private readonly checksums = new Map<number, number>();
  private readonly pages = new Set<number>();
  private readonly plain: BitmapCache<number, ImageBitmap>;
  private readonly brightened: BitmapCache<number, ImageBitmap>;
  private readonly stopWatching: () => void;
  private direction: 1 | -1 = 1;
  private expected: readonly number[] = [];
  private rangesTimer: ReturnType<typeof setTimeout> | undefined;
  private readyTimer: ReturnType<typeof setTimeout> | undefined;
  private closed = false;
  /** The thumbnail that is on its way. */
  private coming: string | null = null;

  constructor(
    readonly recordingId: number,
    firstFrame: number,
  ) {
    this.plain = this.makeCache(false, CACHE_BYTES);
    this.brightened = this.makeCache(true, CACHE_BYTES / 2);
    this.turnTo(firstFrame);
    let before = bright.peek();
    this.stopWatching = bright.subscribe((now) => {
      if (now === before) return;
      before = now;
      this.turnTo(this.frame.peek());
      this.rangesSoon();
    });
  }

  /** Pictures of the kind that is shown now. */
  private get cache(): BitmapCache<number, ImageBitmap> {
    return bright.peek() ? this.brightened : this.plain;
  }

  private makeCache(isBright: boolean, bytes: number): BitmapCache<number, ImageBitmap> {
    return new BitmapCache<number, ImageBitmap>(
      (frame, abort) => {
        const url = frameUrl(this.recordingId, frame, this.checksums.get(frame), isBright);
        return fetchFrame(url, frame, abort);
      },
      { maxBytes: bytes, onChange: () => this.rangesSoon() },
    );
  }

  /** The recording's facts; the first frame may be on its way before they are known. */
  describe(recording: Recording): void {
    this.recording.value = recording;
    const count = recording.frame_count ?? 0;
    if (count > 0 && this.frame.value >= count) this.turnTo(count - 1);
    else this.prefetch();
    if (this.loading.value) void this.showStandIn();
    void this.loadTable(this.frame.value);
  }

  /** Frames that are likely to be asked for next, wherever they are: fetched when there is nothing else to do. */
  expect(frames: readonly number[]): void {
    this.expected = frames;
    if (!this.loading.value) this.prefetch();
  }

  /** Time of a frame in seconds, null until its part of the frame table is here. */
  timeOf(frame: number): number | null {
    return this.times.value.get(frame) ?? null;
  }

  /** Checksum of a frame's picture, undefined until its part of the frame table is here. */
  checksumOf(frame: number): number | undefined {
    return this.checksums.get(frame);
  }

  go(frame: number): void {
    this.wishes += 1;
    this.turnTo(frame);
  }

  /** Opens it at a frame that nobody chose. */
  openAt(frame: number): void {
    this.stop();
    this.turnTo(frame);
  }

  private turnTo(frame: number): void {
    const wanted = clamp(Math.round(frame), 0, Math.max(0, this.last));
    const move = wanted - this.frame.value;
    if (Math.abs(move) <= 12 && move !== 0) this.direction = move > 0 ? 1 : -1;
    const here = this.cache.get(wanted);
    batch(() => {
      this.frame.value = wanted;
      this.problem.value = null;
      this.loading.value = here === undefined;
      if (here) this.show(wanted, here);
    });
    if (here) this.prefetch();
    else {
      void this.load(wanted);
      void this.showStandIn();
    }
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
    this.wishes += 1;
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
    clearTimeout(this.readyTimer);
    this.dropPreview();
    this.stopWatching();
    this.plain.clear();
    this.brightened.clear();
  }

  retry(): void {
    this.turnTo(this.frame.value);
  }

  /** Endless until the recording's facts are here. */
  private get last(): number {
    return (this.count.value ?? Number.POSITIVE_INFINITY) - 1;
  }

  private async play(): Promise<void> {
    if (this.frame.value >= this.last) this.go(0);
    this.playing.value = true;
    this.direction = 1;
    let clock = performance.now();
    let time = this.timeOf(this.frame.value);
    while (this.playing.value && !this.closed && this.frame.value < this.last) {
      await nextPaint();
      if (this.loading.value || time === null) {
        clock = performance.now();
        time = this.timeOf(this.frame.value);
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
    const cache = this.cache;
    cache.keepOnly([frame, ...ahead]);
    try {
      const picture = await cache.fetch(frame);
      // of the other kind meanwhile: brightened and plain are never mixed up
      if (this.closed || cache !== this.cache) return;
      const asked = this.frame.value;
      if (asked === frame) {
        batch(() => {
          this.show(frame, picture);
          this.loading.value = false;
        });
        this.prefetch();
      } else if (this.loading.value && this.isNearer(frame, asked)) {
        // a held key outruns the server: show the way, not a standing picture
        batch(() => this.show(frame, picture));
      }
    } catch (error) {
      if (isAbort(error) || this.frame.value !== frame || this.closed || cache !== this.cache) return;
      batch(() => {
        this.loading.value = false;
        this.problem.value = explain(error);
      });
    }
  }

  private show(frame: number, picture: ImageBitmap): void {
    this.dropPreview();
    this.shown.value = { frame, picture };
  }

  private dropPreview(): void {
    this.preview.value?.picture.close();
    this.preview.value = null;
  }

  /** The nearest thumbnail at once; then no frame is shown, so that nothing can be clicked on. One that is on its way, or
   *  shown, is not asked for again. */
  private async showStandIn(): Promise<void> {
    const wanted = () => standIn(this.recording.value, this.frame.value, this.shown.value?.frame ?? null);
    const thumb = wanted();
    if (!thumb || thumb.url === this.coming || thumb.frame === this.preview.value?.frame) return;
    this.coming = thumb.url;
    const picture = await fetchPicture(thumb.url).catch(() => null);
    if (this.coming === thumb.url) this.coming = null;
    if (this.closed || !picture || !this.loading.value || wanted()?.url !== thumb.url) {
      picture?.close();
      return;
    }
    batch(() => {
      this.dropPreview();
      this.preview.value = { frame: thumb.frame, picture };
      this.shown.value = null;
    });
  }

  private isNearer(frame: number, asked: number): boolean {
    const shown = this.shown.value ?? this.preview.value;
    return shown === null || Math.abs(frame - asked) < Math.abs(shown.frame - asked);
  }

  private wanted(frame: number): number[] {
    const bytes = bright.peek() ? CACHE_BYTES / 2 : CACHE_BYTES;
    return worthHaving(frame, this.direction, this.recording.value, this.expected, bytes);
  }

  /** Neighbours one after the other, nearest first, so that the frame asked for next is never queued behind. */
  private prefetch(): void {
    const frame = this.frame.value;
    const ahead = this.wanted(frame);
    this.cache.keepOnly([frame, ...ahead]);
    void (async () => {
      for (const next of ahead) {
        if (this.closed || this.frame.value !== frame) return;
        await this.cache.fetch(next).catch(() => {});
      }
      void this.loadTable(frame);
      this.readySoon();
    })();
  }

  private async loadTable(around: number): Promise<void> {
    const first = Math.floor(around / TABLE_PAGE) * TABLE_PAGE;
    if (this.pages.has(first)) return;
    this.pages.add(first);
    try {
      const table = await api.ask("GET /recordings/{recording_id}/frames", {
        recording_id: this.recordingId,
        first,
        count: TABLE_PAGE,
      });
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

  private readySoon(): void {
    if (this.readyTimer !== undefined || this.closed) return;
    this.readyTimer = setTimeout(() => {
      this.readyTimer = undefined;
      void api
        .ask("GET /recordings/{recording_id}/frames/ready", { recording_id: this.recordingId })
        .then((found) => {
          if (!this.closed) this.ready.value = found.runs;
        })
        .catch(() => {});
    }, READY_MS);
  }

  private rangesSoon(): void {
    if (this.rangesTimer !== undefined || this.closed) return;
    this.rangesTimer = setTimeout(() => {
      this.rangesTimer = undefined;
      this.ranges.value = runsOf(this.cache.keys());
    }, 120);
  }
}

function nextPaint(): Promise<void> {
  return new Promise((done) => requestAnimationFrame(() => done()));
}
