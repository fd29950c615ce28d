/** The sentences of this page: those of the catalogue whose keys begin with `opened-`, taken out when it is built. */

import text from "virtual:opened-messages";
import { FluentBundle, FluentResource, type FluentVariable } from "@fluent/bundle";
import type { Messages } from "#messages";

const bundle = new FluentBundle("en", { useIsolating: false });
bundle.addResource(new FluentResource(text));

type Key = Extract<keyof Messages, `opened-${string}`>;

export function say<K extends Key>(
  key: K,
  ...[values]: Messages[K] extends null ? [] : [values: Messages[K]]
): string {
  const pattern = bundle.getMessage(key)?.value;
  return pattern ? bundle.formatPattern(pattern, values as Record<string, FluentVariable> | undefined) : key;
}
