/** A list that is worked through, of things or of what is to be said of them: the one beside, and the next that waits. */
type Listed = { readonly id: number } | { readonly measurement: { readonly id: number } };

const idOf = (one: Listed) => ("id" in one ? one.id : one.measurement.id);

/** The one after (or before) `id`; from none, or one that is not listed, the first (or the last). */
export function beside<T extends Listed>(list: readonly T[], id: number | null, step: 1 | -1): T | undefined {
  const at = list.findIndex((one) => idOf(one) === id);
  if (at < 0) return step === 1 ? list[0] : list.at(-1);
  return list[at + step];
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
