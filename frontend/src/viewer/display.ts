/** How pictures are shown: as they are, or brightened by the server. For the eye only; clicks and measurements are the same. */
import { stored } from "../core/stored";

export const bright = stored<boolean>("bright", false, (value) => typeof value === "boolean");

/** Whether the lines of the road's axes are drawn over the picture. */
export const linesShown = stored<boolean>("lines", true);

export const BRIGHT_WORDS = "display only: brightened";

export function toggleBright(): void {
  bright.value = !bright.value;
}

/** What is added to the address of a still or a crop. */
export function displayQuery(isBright: boolean): string {
  return isBright ? "display=bright" : "";
}
