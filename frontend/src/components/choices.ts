export interface Choice<T extends string> {
  value: T;
  label: string;
}

/** Out of words by name; all of them in their order, or those that are named. */
export function choices<T extends string>(
  words: Readonly<Record<T, string>>,
  names: readonly T[] = Object.keys(words) as T[],
): Choice<T>[] {
  return names.map((value) => ({ value, label: words[value] }));
}

export function named(things: readonly { id: number; name: string }[]): Choice<string>[] {
  return things.map(({ id, name }) => ({ value: String(id), label: name }));
}
