/**
 * What can be taken back, as change sets: the values of the keys that a step touched, before and after it.
 * A step that leaves every value as it was is no step. Steps run strictly one after the other, so that Ctrl+Z held down
 * cannot overtake the server.
 */
import { computed, signal } from "@preact/signals";
import { ApiError } from "./api";
import { sameValue } from "./same";

/** Values by key that can be put back: wanted clicks of a measurement, boundaries of a vehicle, whether a pass is there. */
export interface Ledger<K, V> {
  read(key: K): V;
  /** `left`: where a step is taken back or done again, what it left there before. */
  write(key: K, value: V, left?: V): Promise<void> | void;
  /** Two keys that stand for the same value; the key itself unless said otherwise. */
  nameOf?(key: K): unknown;
}

export interface Step {
  /** What was done, as it reads after "Undo: ". */
  readonly label: string;
  /** Brings into view what it was done on; see `History`. */
  show?(): Promise<void> | void;
  undo(): Promise<void> | void;
  redo(): Promise<void> | void;
}

/** What a step left is no more: it can never be taken, and leaves the list so that those before it can. */
export class StepOvertaken extends ApiError {
  constructor(message: string) {
    super(message, 409);
  }
}

interface Touched {
  readonly ledger: unknown;
  readonly name: unknown;
  unchanged(): boolean;
  back(): Promise<void> | void;
  /** Notes the value that is there now, for `again`. */
  close(): void;
  again(): Promise<void> | void;
}

/** The values that one step touches. Ends with `keep`, which makes it a step, unless nothing is other than before. */
export class ChangeSet {
  private readonly touched: Touched[] = [];

  constructor(
    private readonly label: string,
    private readonly push: (step: Step) => void,
  ) {}

  /** Notes a value before it is changed by other means; the first note counts. */
  touch<K, V>(ledger: Ledger<K, V>, key: K): void {
    const name = ledger.nameOf?.(key) ?? key;
    if (this.touched.some((other) => other.ledger === ledger && other.name === name)) return;
    const before = ledger.read(key);
    let after: V | undefined;
    this.touched.push({
      ledger,
      name,
      unchanged: () => sameValue(before, ledger.read(key)),
      back: () => ledger.write(key, before, after),
      close: () => {
        after = ledger.read(key);
      },
      again: () => ledger.write(key, after as V, before),
    });
  }

  write<K, V>(ledger: Ledger<K, V>, key: K, value: V): Promise<void> | void {
    this.touch(ledger, key);
    return ledger.write(key, value);
  }

  /** Answers whether it became a step. */
  keep(): boolean {
    const changed = this.touched.filter((one) => !one.unchanged());
    if (changed.length === 0) return false;
    for (const one of changed) one.close();
    this.push({
      label: this.label,
      undo: () => inOrder(changed.toReversed().map((one) => one.back)),
      redo: () => inOrder(changed.map((one) => one.again)),
    });
    return true;
  }

  drop(): Promise<void> | void {
    return inOrder(this.touched.toReversed().map((one) => one.back));
  }
}

const MAX_STEPS = 200;

export class History {
  private readonly done = signal<readonly Step[]>([]);
  private readonly undone = signal<readonly Step[]>([]);
  private running: Promise<void> = Promise.resolve();

  /**
   * @param place asked when a step begins: how to bring what is open then back into view. Undo and redo go there first, so
   *   that nothing is changed out of sight.
   */
  constructor(private readonly place: () => () => Promise<void> | void = () => () => {}) {}

  readonly undoLabel = computed(() => this.done.value.at(-1)?.label ?? null);
  readonly redoLabel = computed(() => this.undone.value.at(-1)?.label ?? null);

  /** A change set that its owner keeps or drops: a drag, a run of nudges. */
  begin(label: string): ChangeSet {
    const show = this.place();
    return new ChangeSet(label, (step) => this.push({ show, ...step }));
  }

  /** Does something as one step. Work that fails leaves no step. */
  run(label: string, work: (changes: ChangeSet) => Promise<void> | void): Promise<void> | void {
    const changes = this.begin(label);
    const under = work(changes);
    if (under instanceof Promise) return under.then(() => void changes.keep());
    changes.keep();
  }

  /** Note a step that is not a change of values; what was undone before can no longer be redone. */
  push(step: Step): void {
    this.done.value = [...this.done.value, { show: this.place(), ...step }].slice(-MAX_STEPS);
    this.undone.value = [];
  }

  /** Answers the label of what was undone; null where there was nothing. */
  undo(): Promise<string | null> {
    return this.move(this.done, this.undone, (step) => step.undo());
  }

  redo(): Promise<string | null> {
    return this.move(this.undone, this.done, (step) => step.redo());
  }

  /** Work that must see what the steps before it stored: it waits for an undo that is still under way. */
  inTurn<T>(work: () => Promise<T> | T): Promise<T> {
    const turn = this.running.then(work);
    this.running = turn.then(
      () => {},
      () => {},
    );
    return turn;
  }

  /** A step that fails stays where it was, unless it was overtaken; the caller hears why. */
  private move(
    from: { value: readonly Step[] },
    to: { value: readonly Step[] },
    run: (step: Step) => Promise<void> | void,
  ): Promise<string | null> {
    return this.inTurn(async () => {
      const step = from.value.at(-1);
      if (!step) return null;
      const drop = () => {
        from.value = from.value.filter((other) => other !== step);
      };
      try {
        await step.show?.();
        await run(step);
      } catch (error) {
        if (error instanceof StepOvertaken) drop();
        throw error;
      }
      drop();
      to.value = [...to.value, step];
      return step.label;
    });
  }
}

/** One after the other; at once as long as nothing has to be waited for. */
function inOrder(works: readonly (() => Promise<void> | void)[]): Promise<void> | void {
  for (const [at, work] of works.entries()) {
    const under = work();
    if (under instanceof Promise) return under.then(() => inOrder(works.slice(at + 1)));
  }
}
