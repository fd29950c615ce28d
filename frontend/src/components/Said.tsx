/** A sentence of the catalogue with marked parts: `<strong>`, `<em>`, `<kbd>`, `<code>`, `<sub>`, `<muted>`, and those
 * that a screen gives a meaning, such as `<link>`. The sentence stays whole, so that a translator can move its parts. */
import type { FluentVariable } from "@fluent/bundle";
import type { ComponentChildren } from "preact";
import type { Messages, Parts } from "#messages";
import { type MessageKey, sentence } from "../core/messages";

type Part = (text: string) => ComponentChildren;
/** What a screen must give a meaning. */
type Marked<K> = K extends keyof Parts ? Exclude<Parts[K], "muted"> : never;
type Given<K extends MessageKey> = (Messages[K] extends null ? { values?: never } : { values: Messages[K] }) &
  ([Marked<K>] extends [never] ? { parts?: { muted: Part } } : { parts: Record<Marked<K>, Part> });

const USUAL: Record<string, Part> = {
  strong: (text) => <strong>{text}</strong>,
  em: (text) => <em>{text}</em>,
  kbd: (text) => <kbd>{text}</kbd>,
  code: (text) => <code>{text}</code>,
  sub: (text) => <sub>{text}</sub>,
  muted: (text) => <span class="muted">{text}</span>,
};

export function linkTo(href: string): { link: Part } {
  return { link: (text) => <a href={href}>{text}</a> };
}

/** Stands for "<" in what people typed, which marks nothing. */
const LESS = "\uE000";

export function Said<K extends MessageKey>({ what, values, parts }: { what: K } & Given<K>) {
  const text = sentence(what, values ? withoutMarks(values) : undefined);
  return <>{pieces(text, { ...USUAL, ...(parts as Record<string, Part> | undefined) })}</>;
}

function withoutMarks(values: object): Record<string, FluentVariable> {
  const shown = Object.entries(values).map(([name, value]) => [
    name,
    typeof value === "string" ? value.replaceAll("<", LESS) : value,
  ]);
  return Object.fromEntries(shown);
}

/** The text with its marked parts put in place; a mark that nobody gave a meaning is shown as its text. */
function pieces(text: string, parts: Record<string, Part>): ComponentChildren[] {
  return text.split(/(<[a-z][a-z0-9]*>[^<]*<\/[a-z][a-z0-9]*>)/).map((piece) => {
    const [, name = "", inner = ""] = /^<([a-z][a-z0-9]*)>([^<]*)<\/\1>$/.exec(piece) ?? [];
    const plain = (name ? inner : piece).replaceAll(LESS, "<");
    return parts[name]?.(plain) ?? plain;
  });
}
