/** Each file of tests has a window of its own. Before its tests it is given what browsers have and happy-dom lacks, and
 *  loses its way to the network, which what a test leaves running must not ask either. */
import { DecompressionStream } from "node:stream/web";
import { vi } from "vitest";

Object.assign(window, {
  DecompressionStream,
  fetch: () => Promise.reject(new TypeError("Tests ask no network.")),
});

// a busy machine is slow, not wrong: only what never comes fails
const waitFor = vi.waitFor;
vi.waitFor = (wanted, options) =>
  waitFor(wanted, { timeout: 60_000, ...(typeof options === "number" ? { timeout: options } : options) });
