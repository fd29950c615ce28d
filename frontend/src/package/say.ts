/** The sentences of this page: those of the catalogues whose keys begin with `opened-`, taken out when it is built. */
import catalogues from "virtual:opened-messages";
import {
  FluentBundle,
  type FluentFunction,
  FluentNumber,
  FluentResource,
  type FluentVariable,
} from "@fluent/bundle";
import type { Messages } from "#messages";
import { begin, language } from "./language";

export const LANGUAGES: readonly string[] = Object.keys(catalogues);

/** A number as the app writes counts: from 10,000 on thousands stand apart by a narrow space that does not break. */
class Count extends FluentNumber {
  override toString(scope: Parameters<FluentNumber["toString"]>[0]): string {
    if (!scope) return super.toString(scope);
    const format = scope.memoizeIntlObject(Intl.NumberFormat, { useGrouping: "min2", ...this.opts });
    const parts = format.formatToParts(this.value);
    return parts.map((part) => (part.type === "group" ? "\u202f" : part.value)).join("");
  }
}

const NUMBER: FluentFunction = ([number], options) => {
  const asked = Object.entries(options).map(([name, value]) => [name, value.valueOf()]);
  return new Count(Number(number), Object.fromEntries(asked));
};

const bundles = new Map(
  Object.entries(catalogues).map(([name, text]) => {
    const bundle = new FluentBundle(name, { useIsolating: false, functions: { NUMBER } });
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
  const given = Object.entries((values ?? {}) as Record<string, FluentVariable>);
  const counted = given.map(([name, value]) => [name, typeof value === "number" ? new Count(value) : value]);
  return bundle.formatPattern(pattern, Object.fromEntries(counted));
}

/** A word whose key is put together out of a table's cell; the cell as it is where there is none. */
export function sayCell(key: string, cell: string): string {
  const found = say(key as "opened-filter");
  return found === key ? cell : found;
}
