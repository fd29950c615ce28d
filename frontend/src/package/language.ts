/** The language that a page is read in: that of the package's report, until somebody chooses another. */

import { signal } from "@preact/signals";

export const language = signal("en");

/** Sentences and names of the tables in the language of the package, by their English. */
interface Spoken {
  readonly language?: string;
  readonly said?: Readonly<Record<string, string>>;
}

function spoken(): Spoken {
  try {
    return JSON.parse(document.getElementById("about")?.textContent ?? "{}") as Spoken;
  } catch {
    return {}; // the page says elsewhere that it cannot read its package
  }
}

const about = spoken();

/** Speaks a language from now on. */
export function speak(name: string): void {
  language.value = name;
  document.documentElement.lang = name;
}

/** Speaks that of the package, if there is one of these. */
export function begin(known: readonly string[]): void {
  speak(known.find((name) => name === about.language) ?? "en");
}

/** A sentence of a table, in the language of the package if that is spoken. */
export function told(text: string): string {
  return (language.value === about.language && about.said?.[text]) || text;
}

/** A number that was written with a decimal point, as the language writes it. */
export function decimal(text: string): string {
  const parts = new Intl.NumberFormat(language.value).formatToParts(0.5);
  return text.replace(".", parts.find((part) => part.type === "decimal")?.value ?? ".");
}
