/** Undo and redo in the top bar, for a page with a stack of its own. */

import { hint } from "../core/commands";
import { useTopTools } from "../core/topbar";
import type { UndoStack } from "../core/undo";
import { Button } from "./index";

export function useUndoTools(stack: UndoStack, back: () => void, again: () => void): void {
  const { undoLabel, redoLabel } = stack;
  useTopTools(
    () => (
      <>
        <span data-testid="undo">
          <Button
            kind="quiet"
            icon="undo"
            label="Undo"
            title={
              undoLabel.value ? `Undo: ${undoLabel.value}${hint("undo")}` : `Nothing to undo${hint("undo")}`
            }
            disabled={undoLabel.value === null}
            onClick={back}
          />
        </span>
        <span data-testid="redo">
          <Button
            kind="quiet"
            icon="redo"
            label="Redo"
            title={
              redoLabel.value ? `Redo: ${redoLabel.value}${hint("redo")}` : `Nothing to redo${hint("redo")}`
            }
            disabled={redoLabel.value === null}
            onClick={again}
          />
        </span>
      </>
    ),
    [stack, undoLabel.value, redoLabel.value],
  );
}
