/** Undo and redo of a page with a history of its own: their keys, and their buttons in the top bar. */
import { hint } from "../core/commands";
import type { History } from "../core/history";
import { say } from "../core/messages";
import { toast, toastProblem } from "../core/toasts";
import { useTopTools } from "../core/topbar";
import { type ButtonCommand, CommandButton } from "./CommandButton";

export interface HistoryOptions {
  /** Takes back what is in hand and not stored yet; answers false where nothing is. */
  back?(): boolean;
  /** Whether something is in hand. */
  inHand?(): boolean;
  /** What is under way ends first, so that it is a step of its own. */
  settle?(): void;
}

export interface HistoryCommands {
  readonly undo: ButtonCommand;
  readonly redo: ButtonCommand;
}

export function historyCommands(history: History, options: HistoryOptions = {}): HistoryCommands {
  return {
    undo: {
      id: "undo",
      icon: "undo",
      run: () => {
        options.settle?.();
        if (!options.back?.()) void history.undo().then(tell("undo-done"), toastProblem);
      },
      enabled: () => history.undoLabel.value !== null || options.inHand?.() === true,
    },
    redo: {
      id: "redo",
      icon: "redo",
      run: () => {
        options.settle?.();
        void history.redo().then(tell("redo-done"), toastProblem);
      },
      enabled: () => history.redoLabel.value !== null,
    },
  };
}

/** Said in words too: what changed may be small, or the view another one now. */
function tell(words: "undo-done" | "redo-done"): (step: string | null) => void {
  return (step) => {
    if (step !== null) toast(say(words, { step }), { about: "undo" });
  };
}

export function useUndoTools(history: History, { undo, redo }: HistoryCommands): void {
  const { undoLabel, redoLabel } = history;
  useTopTools(
    () => (
      <>
        <span data-testid="undo">
          <CommandButton command={undo} small={false} title={undoTitle(undoLabel.value) + hint("undo")} />
        </span>
        <span data-testid="redo">
          <CommandButton command={redo} small={false} title={redoTitle(redoLabel.value) + hint("redo")} />
        </span>
      </>
    ),
    [history, undoLabel.value, redoLabel.value],
  );
}

function undoTitle(step: string | null): string {
  return step ? say("undo-step", { step }) : say("undo-nothing");
}

function redoTitle(step: string | null): string {
  return step ? say("redo-step", { step }) : say("redo-nothing");
}
