/**
 * Decoded pictures, bounded in bytes, least recently used out first; one request per picture at a time, stale requests dropped.
 * Generic over its key (a frame's number, a tile's place) and over the picture, so that it is tested without a browser.
 */
export interface Picture {
  readonly width: number;
  readonly height: number;
  close(): void;
}

export type LoadPicture<K, P extends Picture> = (key: K, signal: AbortSignal) => Promise<P>;

export interface CacheOptions<K> {
  readonly maxBytes: number;
  /** What tells two keys apart; the key itself unless said otherwise. */
  readonly nameOf?: (key: K) => unknown;
  readonly onChange?: () => void;
}

interface Request<P> {
  readonly promise: Promise<P>;
  readonly abort: AbortController;
}

const BYTES_PER_PIXEL = 4;

export class BitmapCache<K, P extends Picture> {
  private readonly pictures = new Map<unknown, { readonly key: K; readonly picture: P }>();
  private readonly requests = new Map<unknown, Request<P>>();
  private readonly nameOf: (key: K) => unknown;
  private readonly onChange: () => void;
  private bytes = 0;

  constructor(
    private readonly load: LoadPicture<K, P>,
    private readonly options: CacheOptions<K>,
  ) {
    this.nameOf = options.nameOf ?? ((key) => key);
    this.onChange = options.onChange ?? (() => {});
  }

  /** The picture if it is here; counts as a use. */
  get(key: K): P | undefined {
    const name = this.nameOf(key);
    const kept = this.pictures.get(name);
    if (!kept) return undefined;
    this.pictures.delete(name);
    this.pictures.set(name, kept);
    return kept.picture;
  }

  /** Keys of the pictures that are here, the least recently used first. */
  keys(): K[] {
    return [...this.pictures.values()].map(({ key }) => key);
  }

  /** The picture, fetched if need be. Rejects with an AbortError when it was dropped as stale. */
  fetch(key: K): Promise<P> {
    const here = this.get(key);
    if (here) return Promise.resolve(here);
    const name = this.nameOf(key);
    const running = this.requests.get(name);
    if (running) return running.promise;
    const abort = new AbortController();
    const promise = this.load(key, abort.signal).then(
      (picture) => this.arrived(key, abort, picture),
      (error: unknown) => {
        this.forget(name, abort);
        throw error;
      },
    );
    this.requests.set(name, { promise, abort });
    return promise;
  }

  /** Drop every request that is not in `wanted`: the operator has moved on. */
  keepOnly(wanted: Iterable<K>): void {
    const names = new Set([...wanted].map(this.nameOf));
    for (const [name, request] of this.requests) {
      if (names.has(name)) continue;
      this.requests.delete(name);
      request.promise.catch(() => {});
      request.abort.abort();
    }
  }

  /** Everything goes; what is still on its way is closed when it comes. */
  clear(): void {
    this.keepOnly([]);
    for (const { picture } of this.pictures.values()) picture.close();
    this.pictures.clear();
    this.bytes = 0;
    this.onChange();
  }

  private arrived(key: K, abort: AbortController, picture: P): P {
    const name = this.nameOf(key);
    this.forget(name, abort);
    if (abort.signal.aborted) {
      picture.close();
      throw new DOMException("The picture is no longer wanted.", "AbortError");
    }
    this.pictures.set(name, { key, picture });
    this.bytes += sizeOf(picture);
    this.evict(name);
    this.onChange();
    return picture;
  }

  private forget(name: unknown, abort: AbortController): void {
    if (this.requests.get(name)?.abort === abort) this.requests.delete(name);
  }

  private evict(keep: unknown): void {
    for (const [name, { picture }] of this.pictures) {
      if (this.bytes <= this.options.maxBytes) return;
      if (name === keep) continue;
      this.pictures.delete(name);
      this.bytes -= sizeOf(picture);
      picture.close();
    }
  }
}

function sizeOf(picture: Picture): number {
  return picture.width * picture.height * BYTES_PER_PIXEL;
}
