/** A list that is worked through, of things or of what is to be said of them: the one beside, and the next that waits. */
type Listed = { readonly id: number } | { readonly measurement: { readonly id: number } };

const idOf = (one: Listed) => ("id" in one ? one.id : one.measurement.id);

/** The one after (or before) `id`; from none the first (or the last). One that is not listed stands before the list. */
export function beside<T extends Listed>(list: readonly T[], id: number | null, step: 1 | -1): T | undefined {
  const at = list.findIndex((one) => idOf(one) === id);
  return id === null && step === -1 ? list.at(-1) : list[at + step];
}

/** The next that waits: from the one after `id` on, and round to the one before it. */
export function nextThat<T extends Listed>(
  list: readonly T[],
  id: number | null,
  waits: (one: T) => boolean,
): T | undefined {
  const on = list.findIndex((one) => idOf(one) === id) + 1;
  return [...list.slice(on), ...list.slice(0, on)].find((one) => idOf(one) !== id && waits(one));
}
