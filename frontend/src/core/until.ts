import { effect } from "@preact/signals";

/** Resolves once something holds of signals; `stop` ends the watch. */
export function until(happens: () => boolean): { happened: Promise<undefined>; stop: () => void } {
  let stop = (): void => {};
  const happened = new Promise<undefined>((resolve) => {
    stop = effect(() => {
      if (happens()) resolve(undefined);
    });
  });
  return { happened, stop };
}
