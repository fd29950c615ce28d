/** How pictures are shown: as they are, or brightened by the server. For the eye only; clicks and measurements are the same. */
import type { Signal } from "@preact/signals";
import { stored } from "../core/stored";

export const bright = stored<boolean>("bright", false, (value) => typeof value === "boolean");

/** Whether the lines of the road's axes are drawn over the picture. */
export const linesShown = stored<boolean>("lines", true);

export function set(switched: Signal<boolean>, on: boolean): void {
  switched.value = on;
}

export function toggle(switched: Signal<boolean>): void {
  switched.value = !switched.value;
}

export function toggleBright(): void {
  toggle(bright);
}

export function displayQuery(isBright: boolean): string {
  return isBright ? "display=bright" : "";
}
