import { signal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect } from "preact/hooks";

export const topTools = signal<ComponentChildren>(null);

/** Puts controls of a screen (undo, redo) into the top bar while it is shown; draw them again when `deps` change. */
export function useTopTools(draw: () => ComponentChildren, deps: readonly unknown[]): void {
  useEffect(() => {
    topTools.value = draw();
  }, deps);
  useEffect(
    () => () => {
      topTools.value = null;
    },
    [],
  );
}
