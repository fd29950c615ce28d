/** What a thing is to become, and how things of a kind are brought to the server. */
import type { ApiError } from "./api";

export interface Wish<S = unknown, W = unknown, A = unknown> {
  /** The thing it is about; for a new one the key that the server knows it by. */
  readonly key: string;
  readonly kind: string;
  readonly lane: string;
  /** The numbers that the kind needs to address it. */
  readonly about: A;
  /** In words, for whoever is asked: "roof of vehicle 7", what it is to become, and the page where it was done. */
  readonly what: string;
  readonly mine: string;
  readonly page: string;
  /** What the server had when it was last seen; null: nothing. */
  readonly saved: S | null;
  readonly want: W;
  /** "held": kept, and sent when its owner says so. */
  readonly state: "held" | "saving" | "conflict" | "failed" | "saved" | "dropped";
  readonly problem: string | null;
  readonly theirs: S | null;
}

export type Wanted<S, W, A> = Omit<Wish<S, W, A>, "state" | "problem" | "theirs">;

export interface Sending {
  readonly signal: AbortSignal;
  readonly idempotencyKey: string;
}

export interface Kind<S, W, A> {
  /** One write, which brings it nearer to what is wanted; answers what the server has then. */
  send(wish: Wish<S, W, A>, sending: Sending): Promise<S | null>;
  /** What the server has; `error` is the refusal that made it worth asking. */
  read(wish: Wish<S, W, A>, error: ApiError, signal: AbortSignal): Promise<S | null>;
  /** Whether an answer is such a thing, with all that is read of it here. */
  isSaved(answer: unknown): answer is S;
  /** Nothing is left to write; left out where that is so as soon as the one write is stored. */
  done?(wish: Wish<S, W, A>): boolean;
  /** Another one means that somebody changed it. */
  version(saved: S | null): string | number;
  /** The value in words, for whoever has to choose. */
  words(saved: S | null): string;
  /** One write is all it takes; else writes go on until `done`. */
  readonly once?: boolean;
  /** Both changed it, but not the same of it: mine can be put on top of theirs. */
  fits?(wish: Wish<S, W, A>, theirs: S): boolean;
  /** What is still wanted once `sent` is stored. */
  left?(sent: W, want: W): W;
}

/** What the server has where it refused; undefined where that cannot be had. */
export async function readInstead<S, W, A>(
  kind: Kind<S, W, A>,
  sent: Wish<S, W, A>,
  refusal: ApiError,
  signal: AbortSignal,
): Promise<S | null | undefined> {
  try {
    const found = await kind.read(sent, refusal, signal);
    return found === null || kind.isSaved(found) ? found : undefined;
  } catch {
    return undefined;
  }
}
