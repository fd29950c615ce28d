import { signal } from "@preact/signals";

/** What the top bar says about writes. `api.ts` keeps it; screens need do nothing. */
export interface SaveState {
  pending: number;
  /** of these, the ones waiting for the connection to come back */
  waiting: number;
  savedAt: Date | null;
  failed: boolean;
}

export const saveState = signal<SaveState>({ pending: 0, waiting: 0, savedAt: null, failed: false });

export function changeSave(change: (old: SaveState) => Partial<SaveState>): void {
  saveState.value = { ...saveState.value, ...change(saveState.value) };
}

window.addEventListener("beforeunload", (event) => {
  if (saveState.value.pending > 0) event.preventDefault();
});
