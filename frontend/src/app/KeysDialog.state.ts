import { signal } from "@preact/signals";

/** Whether the key map is shown; kept apart so that the dialog itself loads only when asked for. */
export const keysShown = signal(false);
