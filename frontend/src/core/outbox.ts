/**
 * Everything a person does to the work goes through here: what a thing is to become is kept in local storage until the
 * server has it, so that a lost connection, a closed lid or a crash loses nothing.
 *
 * One wish per thing: a change of mind replaces what was wanted. Wishes of one lane go out one after the other, in the
 * order in which they were made, each until the server has it. Each write bears a key that is kept with it until its answer
 * is here: whoever sends it again, this page or the next, is answered as the first time and stores nothing twice.
 *
 * Whatever the server answers, a wish is done, waits for the connection, or rests with a reason until it is sent again or
 * taken back; and the next one goes out. An answer of another shape than its kind's is no answer.
 */
import { computed, signal } from "@preact/signals";
import { ApiError, connection, explain, isStoredAlready, problemOf } from "./api";
import { type Begun, Keeping, type Kept } from "./keeping";
import { say } from "./messages";
import { newKey } from "./random";
import { changeSave } from "./save";
import { until } from "./until";
import { type Kind, readInstead, type Wanted, type Wish } from "./wish";

export type { Kind, Sending, Wanted, Wish } from "./wish";

// biome-ignore lint/suspicious/noExplicitAny: a registry holds kinds of all types; `register` and `listen` give them back
type AnyKind = Kind<any, any, any>;
type Listener = (wish: Wish) => void;

/** Nothing takes more steps than to restore, to revise, and one for a change that came between. */
const MOST_STEPS = 4;

export class Outbox {
  readonly wishes = signal<ReadonlyMap<string, Wish>>(new Map());
  /** How many are kept here, on their way or not; of these how many wait behind others; and how many want a decision. */
  readonly counts = computed(() => {
    const every = [...this.wishes.value.values()];
    const all = every.filter(({ state }) => state === "saving" || state === "held");
    const lanes = new Set(all.filter(({ state }) => state === "saving").map(({ lane }) => lane));
    return { kept: all.length, queued: all.length - lanes.size, resting: every.length - all.length };
  });
  bringKinds: () => Promise<unknown> = async () => undefined;
  private readonly kinds = new Map<string, AnyKind>();
  private readonly listeners = new Map<string, Set<Listener>>();
  private readonly lanes = new Map<string, Promise<void>>();
  private readonly orders = new Map<string, number>();
  private readonly begun = new Map<string, Begun>();
  private readonly refusals = new Map<string, ApiError>();
  private readonly sending = new Map<string, AbortController>();
  private ended = new AbortController();
  private readonly keeping: Keeping;

  constructor(...storage: ConstructorParameters<typeof Keeping>) {
    this.keeping = new Keeping(...storage);
  }

  /** Answers the name, by which the wishes of the kind are known. */
  register<S, W, A>(name: string, kind: Kind<S, W, A>): string {
    this.kinds.set(name, kind);
    return name;
  }

  /** Tells each change of a kind's wishes, its end ("saved", "dropped") among them. */
  listen<S, W, A>(kind: string, told: (wish: Wish<S, W, A>) => void): () => void {
    const all = this.listeners.get(kind) ?? new Set();
    this.listeners.set(kind, all.add(told as Listener));
    return () => {
      all.delete(told as Listener);
    };
  }

  /** Another person, or the same one after a reload: what was left unsaved is sent, once. */
  open(person: number | string | null): void {
    this.close();
    this.keeping.open(person, this.ended.signal, (left) => this.adopt(left));
  }

  /** Stops sending; what is kept stays kept. */
  close(): void {
    this.ended.abort();
    this.ended = new AbortController();
    this.lanes.clear();
    this.begun.clear();
    this.sending.clear();
    this.wishes.value = new Map();
  }

  /** Items that are this tab's from now on: left by it before a reload, or by a tab that is gone. */
  private async adopt(left: (one: Kept) => boolean): Promise<void> {
    const { signal } = this.ended;
    const orphans = () => this.keeping.all().filter((one) => left(one) && !this.wishes.value.has(one.key));
    if (orphans().some(({ kind }) => !this.kinds.has(kind))) await this.bringKinds().catch(() => undefined);
    if (signal.aborted) return;
    const known = orphans().filter(({ kind }) => this.kinds.has(kind));
    for (const { order, begun, tab: _tab, touched: _touched, ...wanted } of known.sort(
      (a, b) => a.order - b.order,
    )) {
      this.orders.set(wanted.key, order);
      // kept by another version of this page, it may be of another shape: then the server is asked what there is
      const saved = this.kinds.get(wanted.kind)?.isSaved(wanted.saved) ? wanted.saved : null;
      if (begun) this.begun.set(wanted.key, begun);
      this.want({ ...wanted, saved });
    }
  }

  of<S, W, A>(kind: string): Wish<S, W, A>[] {
    return [...this.wishes.value.values()].filter((wish) => wish.kind === kind) as Wish<S, W, A>[];
  }

  get<S, W, A>(key: string): Wish<S, W, A> | undefined {
    return this.wishes.value.get(key) as Wish<S, W, A> | undefined;
  }

  /** What a thing is to become, kept at once and sent in its turn. */
  want<S, W, A>(wanted: Wanted<S, W, A>, { held = false } = {}): Wish<S, W, A> {
    const before = this.get<S, W, A>(wanted.key);
    if (before?.state === "failed") this.begun.delete(wanted.key);
    // what is on its way may have been stored since the caller looked: here the newer of both is known
    const saved = before && before.state !== "failed" ? before.saved : wanted.saved;
    const [problem, theirs] = before?.state === "conflict" ? [before.problem, before.theirs] : [null, null];
    const state = before?.state === "conflict" ? "conflict" : held ? "held" : "saving";
    const wish: Wish<S, W, A> = { ...wanted, saved, state, problem, theirs };
    this.put(wish);
    this.keep(wish);
    if (state === "saving") this.start(wish.lane);
    return wish;
  }

  /** Sends what was held, or tries again what was refused. */
  send(key: string): void {
    const wish = this.get(key);
    if (!wish || wish.state === "conflict") return;
    this.patch(key, { state: "saving", problem: null });
    this.start(wish.lane);
  }

  /** Lets go of what was wanted: the server's stays. */
  discard(key: string): void {
    const wish = this.get(key);
    if (wish) this.end(wish, "dropped");
  }

  /** Ends a conflict: theirs is taken, or mine is written on top of theirs. */
  resolve(key: string, choice: "mine" | "theirs"): void {
    const wish = this.get(key);
    if (wish?.state !== "conflict") return;
    if (choice === "theirs") this.end({ ...wish, saved: wish.theirs }, "dropped");
    else {
      this.patch(key, { saved: wish.theirs, theirs: null, problem: null, state: "saving" });
      this.start(wish.lane);
    }
  }

  theirs({ kind, theirs }: Wish): string {
    try {
      return this.kinds.get(kind)?.words(theirs) ?? "";
    } catch (error) {
      return explain(error);
    }
  }

  /** Resolves when it rests: stored (undefined), in conflict or refused. */
  async settled(key: string): Promise<Wish | undefined> {
    for (let wish = this.get(key); wish; wish = this.get(key)) {
      const lane = this.lanes.get(wish.lane);
      if (wish.state !== "saving" || !lane) return wish;
      await lane;
    }
    return undefined;
  }

  /**
   * For a page that shows its own errors: the wish once the server has it, or null where there is no connection and it is
   * kept. A refusal is thrown, and what was refused is let go; a conflict is thrown too, and stays to be resolved.
   */
  async store<S, W, A>(wanted: Wanted<S, W, A>): Promise<Wish<S, W, A> | null> {
    const { key, kind } = wanted;
    let stored: Wish<S, W, A> | null = null;
    const deaf = this.listen<S, W, A>(kind, (wish) => {
      if (wish.key === key && wish.state === "saved") stored = wish;
    });
    this.want(wanted);
    const lost = until(() => connection.value.lost);
    const wish = await Promise.race([this.settled(key), lost.happened]).finally(lost.stop);
    deaf();
    if (stored || !wish || wish.state === "saving") return stored;
    const refusal = this.refusals.get(key) ?? new ApiError(wish.problem ?? say("unsaved-otherwise"), 0);
    if (wish.state === "failed") this.discard(key);
    throw refusal;
  }

  private start(lane: string): void {
    if (this.lanes.has(lane)) return;
    const { signal } = this.ended;
    const run = this.run(lane, signal).finally(() => {
      if (this.lanes.get(lane) === run) this.lanes.delete(lane);
    });
    this.lanes.set(lane, run);
  }

  private async run(lane: string, signal: AbortSignal): Promise<void> {
    for (;;) {
      const next = [...this.wishes.value.values()].find(
        (wish) => wish.lane === lane && wish.state === "saving",
      );
      if (!next || signal.aborted) return;
      const stop = new AbortController();
      const ended = (): void => stop.abort();
      signal.addEventListener("abort", ended);
      this.sending.set(next.key, stop);
      try {
        await this.bring(next.key, stop.signal);
      } catch (error) {
        // a fault of this page in what the server answered must not hold up what waits behind it
        if (!stop.signal.aborted) this.patch(next.key, { state: "failed", problem: explain(error) });
      }
      signal.removeEventListener("abort", ended);
      if (this.sending.get(next.key) === stop) this.sending.delete(next.key);
    }
  }

  /** One write at a time until the server has what is wanted. */
  private async bring(key: string, signal: AbortSignal): Promise<void> {
    let wanted: unknown;
    for (let steps = 1; this.get(key)?.state === "saving" && !signal.aborted; steps += 1) {
      const wish = this.get(key) as Wish;
      if (wish.want !== wanted) steps = 1;
      wanted = wish.want;
      await this.step(wish, steps, signal);
    }
  }

  private async step(wish: Wish, steps: number, signal: AbortSignal): Promise<void> {
    const kind = this.kinds.get(wish.kind) as AnyKind;
    if (!this.begun.has(wish.key) && kind.done?.(wish)) return this.end(wish, "saved");
    const { idempotencyKey, want } = this.begin(wish);
    const sent = { ...wish, want };
    try {
      if (steps > MOST_STEPS) throw problemOf("unsaved-otherwise", {}, 0);
      const saved: unknown = await kind.send(sent, { signal, idempotencyKey });
      if (signal.aborted) return;
      if (saved === null ? !kind.done?.({ ...sent, saved }) : !kind.isSaved(saved))
        throw problemOf("problem-unreadable", {}, 0);
      this.arrived(kind, sent, saved);
    } catch (error) {
      if (!signal.aborted) await this.refused(kind, sent, error, signal);
    }
  }

  /** The write that was begun before, by another page maybe, or a new one; kept before it is sent. */
  private begin(wish: Wish): Begun {
    const before = this.begun.get(wish.key);
    // what was kept is a copy of what is wanted
    const same = before && JSON.stringify(before.want) === JSON.stringify(wish.want);
    const begun = before ?? { idempotencyKey: newKey(), want: wish.want };
    this.begun.set(wish.key, same ? { ...begun, want: wish.want } : begun);
    if (!before) this.keep(wish);
    return this.begun.get(wish.key) ?? begun;
  }

  /** What was sent is there; what was wanted meanwhile is sent next. */
  private arrived(kind: AnyKind, sent: Wish, saved: unknown): void {
    this.begun.delete(sent.key);
    const now = this.get(sent.key);
    if (!now) return;
    changeSave(() => ({ savedAt: new Date(), failed: false }));
    if (kind.once && now.want === sent.want) this.end({ ...now, saved }, "saved");
    else this.patch(now.key, { saved, want: kind.left ? kind.left(sent.want, now.want) : now.want });
  }

  /** It may be there already, or both changes may fit; else it rests until it is decided. */
  private async refused(kind: AnyKind, sent: Wish, error: unknown, signal: AbortSignal): Promise<void> {
    const refusal = error instanceof ApiError ? error : new ApiError(explain(error), 0);
    this.refusals.set(sent.key, refusal);
    const stored = isStoredAlready(refusal);
    const look = stored || refusal.status === 409;
    const theirs = look ? await readInstead(kind, sent, refusal, signal) : undefined;
    const now = this.get(sent.key);
    if (signal.aborted || !now) return;
    if (tellsWhetherStored(refusal)) this.begun.delete(sent.key);
    const known = theirs !== undefined && (theirs !== null || !stored);
    if (known && (stored || kind.done?.({ ...sent, saved: theirs }))) this.arrived(kind, sent, theirs);
    else if (stored) this.end(now, "dropped");
    else this.rest(kind, sent, now, theirs, explain(refusal));
  }

  private rest(kind: AnyKind, sent: Wish, now: Wish, theirs: unknown, problem: string): void {
    if (theirs === undefined || kind.version(theirs) === kind.version(sent.saved))
      this.patch(now.key, { state: "failed", problem });
    else if (theirs !== null && kind.fits?.(now, theirs)) this.patch(now.key, { saved: theirs, problem });
    else this.patch(now.key, { state: "conflict", problem, theirs });
  }

  private end(wish: Wish, state: "saved" | "dropped"): void {
    const left = new Map(this.wishes.value);
    left.delete(wish.key);
    this.orders.delete(wish.key);
    this.begun.delete(wish.key);
    this.refusals.delete(wish.key);
    this.wishes.value = left;
    this.keeping.forget(wish.key);
    if (state === "dropped") this.sending.get(wish.key)?.abort();
    changeSave(() => ({ failed: false })); // of what was refused on the way, nothing is left
    this.tell({ ...wish, state });
  }

  private patch(key: string, change: Partial<Wish>): void {
    const wish = this.get(key);
    if (!wish) return;
    const next = { ...wish, ...change };
    this.put(next);
    if ("saved" in change) this.keep(next);
  }

  private put(wish: Wish): void {
    this.wishes.value = new Map(this.wishes.value).set(wish.key, wish);
    this.tell(wish);
  }

  /** A page that cannot show a wish keeps nobody from sending it. */
  private tell(wish: Wish): void {
    for (const told of this.listeners.get(wish.kind) ?? []) {
      try {
        told(wish);
      } catch (error) {
        console.error(error);
      }
    }
  }

  private keep(wish: Wish): void {
    const { state: _state, problem: _problem, theirs: _theirs, ...wanted } = wish;
    if (!this.orders.has(wish.key)) this.orders.set(wish.key, Math.max(0, ...this.orders.values()) + 1);
    const begun = this.begun.get(wish.key) ?? null;
    this.keeping.keep({ ...wanted, begun, order: this.orders.get(wish.key) ?? 0 });
  }
}

/** Whether the server has looked: who is not let in, or not answered, learns nothing of a write before, and its key stays. */
function tellsWhetherStored({ status }: ApiError): boolean {
  return status >= 400 && status < 500 && ![401, 403, 429].includes(status);
}

export const outbox = new Outbox();
