/** The language that a page is read in: that of its package or evidence file, until somebody chooses another. */
import { signal } from "@preact/signals";

export const language = signal("en");

/** The language of what a page carries, and its sentences in each, by their English. */
interface Spoken {
  readonly language?: string;
  readonly said?: Readonly<Record<string, Readonly<Record<string, string>>>>;
}

function spoken(): Spoken {
  try {
    const carried = document.querySelector("#about, #evidence");
    return JSON.parse(carried?.textContent ?? "{}") as Spoken;
  } catch {
    return {}; // the page says elsewhere that it cannot read what it carries
  }
}

const about = spoken();

export function speak(name: string): void {
  language.value = name;
  document.documentElement.lang = name;
}

/** Speaks that of what the page carries, if it is one of these. */
export function begin(known: readonly string[]): void {
  speak(known.find((name) => name === about.language) ?? "en");
}

/** A sentence of what the page carries, in the language that is spoken. */
export function told(text: string): string {
  return about.said?.[language.value]?.[text] ?? text;
}

/** A number that was written with a decimal point, as the language writes it. */
export function decimal(text: string): string {
  const parts = new Intl.NumberFormat(language.value).formatToParts(0.5);
  return text.replace(".", parts.find((part) => part.type === "decimal")?.value ?? ".");
}
