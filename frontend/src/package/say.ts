/** The sentences of this page: those of the catalogues whose keys begin with `opened-`, taken out when it is built. */
import catalogues from "virtual:opened-messages";
import { FluentBundle, FluentResource, type FluentVariable } from "@fluent/bundle";
import type { Messages } from "#messages";
import { begin, language } from "./language";

export const LANGUAGES: readonly string[] = Object.keys(catalogues);

const bundles = new Map(
  Object.entries(catalogues).map(([name, text]) => {
    const bundle = new FluentBundle(name, { useIsolating: false });
    bundle.addResource(new FluentResource(text));
    return [name, bundle];
  }),
);
begin(LANGUAGES);

type Key = Extract<keyof Messages, `opened-${string}`>;

/** A sentence in the language that is spoken; read in a render it follows that. */
export function say<K extends Key>(
  key: K,
  ...[values]: Messages[K] extends null ? [] : [values: Messages[K]]
): string {
  const bundle = bundles.get(language.value);
  const pattern = bundle?.getMessage(key)?.value;
  if (!bundle || !pattern) return key;
  return bundle.formatPattern(pattern, values as Record<string, FluentVariable> | undefined);
}

/** A word whose key is put together out of a table's cell; the cell as it is where there is none. */
export function sayCell(key: string, cell: string): string {
  const found = say(key as "opened-filter");
  return found === key ? cell : found;
}
