/** The catalogue of messages: every sentence that a person reads, in the language that is chosen.
 *
 * The sentences are in `backend/sightline/messages/<language>.ftl` (Project Fluent), which the server reads too.
 * Keys and the values that a sentence takes are type-checked: `npm run types` makes `#messages` out of en.ftl.
 */
import words from "virtual:words";
import english from "virtual:words/en/everywhere";
import { FluentBundle, type FluentFunction, FluentNumber, type FluentVariable } from "@fluent/bundle";
import { computed, signal } from "@preact/signals";
import type { Messages } from "#messages";
import { stored } from "./stored";

const SOURCE = "en";
/** Thousands stand apart from 10,000 on, in every language, by a narrow space that does not break. */
export const APART = { useGrouping: "min2" } as const;
const NARROW = "\u202f";
/** The rooms of words beside those of the screens: see `tools/words.ts`. */
const EVERYWHERE = "everywhere";
const OF_SERVER = "server";
const LATE = "-late";

export const LANGUAGES: readonly string[] = [SOURCE, ...Object.keys(words).filter((name) => name !== SOURCE)];

export type MessageKey = keyof Messages;
export type PlainKey = { [K in MessageKey]: Messages[K] extends null ? K : never }[MessageKey];
type Values<K extends MessageKey> = Messages[K] extends null ? [] : [values: Messages[K]];

const chosen = stored<string>("language", "", (v) => typeof v === "string");
/** The keys of the English sentences, as they stand there. */
const KEYS = new Set<string>();
class Written extends FluentNumber {
  override toString(scope: Parameters<FluentNumber["toString"]>[0]): string {
    return scope
      ? writeNumber(scope.memoizeIntlObject(Intl.NumberFormat, this.opts), this.value)
      : super.toString(scope);
  }
}

let writeSmall = (metres: number, _digits?: number): string => `${metres * 1000} mm`;
/** Whether lengths are shown as the server writes them in its sentences: metric. */
let metric = (): boolean => true;
/** `{ SMALL($error_m) }` in a sentence: metres as a small length in the unit that is shown. */
const SMALL: FluentFunction = ([metres], { digits }) =>
  writeSmall(numberOf(metres), digits === undefined ? undefined : numberOf(digits));
/** `{ NUMBER($all) }` in a sentence: its thousands stand apart, whoever said the number. */
const NUMBER: FluentFunction = ([number], options) => {
  if (!(number instanceof FluentNumber)) return number ?? "";
  const asked = Object.entries(options).map(([name, value]) => [name, value.valueOf()]);
  return new Written(number.valueOf(), { ...number.opts, ...APART, ...Object.fromEntries(asked) });
};
const source = bundleOf(SOURCE);
addWords(source, english);
/** Whose words are wanted, and those that each language has. */
const rooms = new Set([EVERYWHERE]);
const known = new Map([[source, new Set([EVERYWHERE])]]);
/** What is spoken; behind it English, for what it lacks. */
const bundles = signal<readonly FluentBundle[]>([source]);

/** How times and numbers are written: the language's own way, British for English. */
export const region = computed(() => (language.value === SOURCE ? "en-GB" : language.value));

export const language = computed(() => bundles.value[0]?.locales[0] ?? SOURCE);

/** The language that was chosen here, else the first of the browser's that there is, else English. */
export function preferredLanguage(wishes: readonly string[] = navigator.languages): string {
  for (const wish of [chosen.value, ...wishes]) {
    const found = [wish, wish.split("-")[0]].find((one) => one && LANGUAGES.includes(one));
    if (found) return found;
  }
  return SOURCE;
}

export async function learn(...wanted: readonly string[]): Promise<void> {
  for (const room of wanted) rooms.add(room);
  const news = await Promise.all(bundles.value.map(complete));
  if (news.some(Boolean)) bundles.value = [...bundles.value];
}

/** Loads the words of those parts of the screens that are shown later than the rest. */
export function learnLate(): Promise<void> {
  return learn(...[...rooms].map((room) => (room.endsWith(LATE) ? room : room + LATE)));
}

/** Loads a language and speaks it; until it is here the app speaks as before. */
export async function speak(name: string): Promise<void> {
  const other = name === SOURCE || !words[name] ? [] : [bundleOf(name)];
  const next = [...other, source];
  await Promise.all(next.map(complete));
  bundles.value = next;
  document.documentElement.lang = language.value;
}

export async function chooseLanguage(name: string): Promise<void> {
  rooms.add(OF_SERVER); // what the server has said already, it said in the language before
  await speak(name);
  chosen.value = name;
}

/** A sentence of the catalogue. Read in a render it follows the language. */
export function say<K extends MessageKey>(key: K, ...[values]: Values<K>): string {
  return sentence(key, values as Record<string, FluentVariable> | undefined);
}

/** What a column or an axis is called, with its unit: "Speed (km/h)". */
export const withUnit = (name: string, unit: string): string => say("with-unit", { name, unit });

export function sayInEach(key: PlainKey): string[] {
  const patterns = bundles.value.map((bundle) => [bundle, bundle.getMessage(key)?.value] as const);
  return patterns.flatMap(([bundle, pattern]) => (pattern ? [bundle.formatPattern(pattern)] : []));
}

type NamesAfter<P extends string, K = PlainKey> = K extends `${P}${infer N}` ? N : never;

/** Words looked up by a name, each said when it is read: `wordsOf("target-noun-").roof` says "target-noun-roof". They are
 *  all whose keys begin so, or those that are named; where keys have no beginning in common, `{ roof: "target-roof" }`. */
export function wordsOf<P extends string>(beginning: P): Readonly<Record<NamesAfter<P>, string>>;
export function wordsOf<P extends string, N extends NamesAfter<P>>(
  beginning: P,
  ...names: N[]
): Readonly<Record<N, string>>;
export function wordsOf<N extends string>(keys: Record<N, PlainKey>): Readonly<Record<N, string>>;
export function wordsOf(of: string | Readonly<Record<string, string>>, ...named: string[]) {
  const keys = typeof of === "object" ? of : Object.fromEntries(named.map((name) => [name, of + name]));
  const open = typeof of === "string" && named.length === 0 ? of : null;
  const names = () =>
    open === null
      ? Object.keys(keys)
      : [...KEYS].filter((key) => key.startsWith(open)).map((key) => key.slice(open.length));
  const word = (name: string | symbol) => {
    if (typeof name === "symbol") return undefined;
    const key = open === null ? keys[name] : open + name;
    return key !== undefined && KEYS.has(key) ? sentence(key) : undefined;
  };
  return new Proxy<Record<string, string>>(
    {},
    {
      get: (_, name) => word(name),
      has: (_, name) => word(name) !== undefined,
      ownKeys: names,
      getOwnPropertyDescriptor: (_, name) => ({ enumerable: true, configurable: true, value: word(name) }),
    },
  );
}

/** "F, → or Home" */
export function anyOf(words: readonly string[]): string {
  return new Intl.ListFormat(region.value, { type: "disjunction" }).format(words);
}

/** "10, 25 and 90" */
export function allOf(words: readonly string[]): string {
  return new Intl.ListFormat(region.value, { type: "conjunction" }).format(words);
}

/** "Roof; driver’s eye": what stands apart in a row. */
export function apart(words: readonly string[]): string {
  const [first = "", ...others] = words;
  return others.reduce((before, second) => say("words-apart", { first: before, second }), first);
}

/** A number as `format` has it, with the space that sets thousands apart. */
export function writeNumber(format: Intl.NumberFormat, value: number): string {
  const parts = format.formatToParts(value);
  return parts.map((part) => (part.type === "group" ? NARROW : part.value)).join("");
}

/** `say` where key and values were checked before. */
export function sentence(key: string, values?: Record<string, FluentVariable>): string {
  for (const bundle of bundles.value) {
    const pattern = bundle.getMessage(key)?.value;
    if (!pattern) continue;
    const errors: Error[] = [];
    const text = bundle.formatPattern(pattern, values && written(values), errors);
    if (errors.length > 0) console.error(`${key}: ${errors.join("; ")}`);
    return unbroken(text);
  }
  return key;
}

/** What a page says are counts: identifiers it says as texts. */
function written(values: Record<string, FluentVariable>): Record<string, FluentVariable> {
  const each = Object.entries(values).map(([name, value]) => [
    name,
    typeof value === "number" ? new Written(value, APART) : value,
  ]);
  return Object.fromEntries(each);
}

const BEFORE_UNIT = / (?=(?:%|(?:px|[µmck]?m|[µm]?s|km\/h|m\/s²?|mph|mrad|Hz|ppm|[kMGT]?[Bo])(?!\p{L})))/u;
const IN_A_FIGURE = new RegExp(`(?<=\\d)${BEFORE_UNIT.source}|(?<=\\bu) (?== )|(?<=\\bu =) |(?<=±) `, "gu");

/** A number stays in the line of its unit, and of what it is the uncertainty. */
function unbroken(text: string): string {
  return text.replace(IN_A_FIGURE, "\u00a0");
}

/** What the server says: a key of the catalogue and the values of its sentence, which may be said things themselves. */
export interface Said {
  code: string;
  values: Record<string, string | number | Said>;
  /** The sentence that the server made of it; an event of the audit trail has none. */
  message?: string;
}

/** A reason or a flag of the server, in the language spoken and the unit shown. */
export function sentenceOf(said: Said): string;
export function sentenceOf(said: Said | null | undefined): string | null;
export function sentenceOf(said: Said | null | undefined): string | null {
  return said ? (sayCode(said) ?? unbroken(said.message ?? said.code)) : null;
}

export function sentencesOf(each: readonly Said[]): string {
  return each.map(sentenceOf).join(" ");
}

const MOST_DIGITS = 15;

/** A sentence of the server in the language spoken, or null where this program has none of that name: what the server
 *  said itself needs no words here, unless lengths are to be in feet. Numbers are frames and identifiers more often than
 *  counts, so only the thousands of what the sentence asks for with NUMBER stand apart. */
export function sayCode({ code, values, message }: Said): string | null {
  if (!bundles.value.some((one) => one.hasMessage(code))) {
    const isSaid = message !== undefined && metric();
    if (!isSaid && !rooms.has(OF_SERVER)) learn(OF_SERVER).catch(() => undefined);
    return null;
  }
  const given = Object.entries(values).map(([name, value]) => [
    name,
    typeof value === "number"
      ? new Written(value, { useGrouping: false, maximumFractionDigits: MOST_DIGITS })
      : typeof value === "object"
        ? sentenceOf(value)
        : value,
  ]);
  return sentence(code, Object.fromEntries(given));
}

/** Fetches the words that a language lacks, those of screens asked for meanwhile included; tells whether there were any. */
async function complete(bundle: FluentBundle): Promise<boolean> {
  const has = known.get(bundle) ?? new Set();
  known.set(bundle, has);
  const missing = [...rooms].filter((room) => !has.has(room));
  if (missing.length === 0) return false;
  const fetched = missing.map(async (room) => {
    const own = await words[bundle.locales[0] ?? SOURCE]?.[room]?.();
    if (own) addWords(bundle, own.default);
    has.add(room);
  });
  await Promise.all(fetched);
  await complete(bundle);
  return true;
}

/** How sentences write small lengths, told by the room that knows the unit. */
export function writeSmallLengths(
  write: (metres: number, digits?: number) => string,
  isMetric: () => boolean,
): void {
  writeSmall = write;
  metric = isMetric;
}

function bundleOf(name: string): FluentBundle {
  return new FluentBundle(name, { useIsolating: false, functions: { NUMBER, SMALL } });
}

function numberOf(value: unknown): number {
  return Number(value instanceof FluentNumber ? value.value : value);
}

function addWords(bundle: FluentBundle, own: typeof english): void {
  const body = Object.entries(own).map(([id, value]) => ({ id, value, attributes: {} }));
  if (bundle.locales[0] === SOURCE) for (const { id } of body) KEYS.add(id);
  const errors = bundle.addResource({ body }, { allowOverrides: true });
  if (errors.length > 0) console.error(...errors);
}
