/**
 * One stack for everything that can be taken back on the measure page: points, measurements, vehicle facts.
 * Steps run strictly one after the other, so Ctrl+Z held down cannot overtake the server.
 */
import { computed, signal } from "@preact/signals";

export interface Step {
  /** What was done, as it reads after "Undo: ". */
  readonly label: string;
  undo(): Promise<void> | void;
  redo(): Promise<void> | void;
}

const MAX_STEPS = 200;

export class UndoStack {
  private readonly done = signal<readonly Step[]>([]);
  private readonly undone = signal<readonly Step[]>([]);
  private running: Promise<void> = Promise.resolve();

  readonly undoLabel = computed(() => this.done.value.at(-1)?.label ?? null);
  readonly redoLabel = computed(() => this.undone.value.at(-1)?.label ?? null);

  /** Note a step that has just been done; what was undone before can no longer be redone. */
  push(step: Step): void {
    this.done.value = [...this.done.value, step].slice(-MAX_STEPS);
    this.undone.value = [];
  }

  undo(): Promise<void> {
    return this.move(this.done, this.undone, (step) => step.undo());
  }

  redo(): Promise<void> {
    return this.move(this.undone, this.done, (step) => step.redo());
  }

  /** Work that must see what the steps before it stored: it waits for an undo that is still under way. */
  inTurn(work: () => Promise<void>): Promise<void> {
    const turn = this.running.then(work);
    this.running = turn.catch(() => {});
    return turn;
  }

  /** A step that fails stays where it was; the caller hears why. */
  private move(
    from: { value: readonly Step[] },
    to: { value: readonly Step[] },
    run: (step: Step) => Promise<void> | void,
  ): Promise<void> {
    return this.inTurn(async () => {
      const step = from.value.at(-1);
      if (!step) return;
      await run(step);
      from.value = from.value.filter((other) => other !== step);
      to.value = [...to.value, step];
    });
  }
}
