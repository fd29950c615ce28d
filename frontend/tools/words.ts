/** The words of the pages by rooms, cut out of the catalogue when the pages are built: a page fetches those it says.
 *
 * A room is a folder of `src/screens`, with what it imports of `parts` and `viewer`. What only its parts say that are
 * shown `late` is the room of its own that comes with them. What the app around the screens says, and what more than two
 * rooms say, is said "everywhere"; what no page says is the "server"'s, fetched where it has not said it itself.
 */
import { readdirSync, readFileSync } from "node:fs";
import { basename, dirname, join, posix } from "node:path";
import { fileURLToPath } from "node:url";
import { FluentResource } from "@fluent/bundle";
import { type Entry, FluentParser, FluentSerializer, Resource, Visitor } from "@fluent/syntax";
import type { Plugin } from "vite";

const HERE = dirname(fileURLToPath(import.meta.url));
const CATALOGUE = join(HERE, "../../backend/sightline/messages");
const PAGES = join(HERE, "../src");
const SOURCE = "en";
const [EVERYWHERE, SERVER] = ["everywhere", "server"] as const;
const LATE = "-late";
const MOST_ROOMS = 2;

/** `virtual:words`: each language's rooms and how their words are fetched; `virtual:words/<language>/<room>`: the words,
 *  their Fluent read already. Tests have all words everywhere. */
export function words(): Plugin {
  const name = "virtual:words";
  const languages = readdirSync(CATALOGUE)
    .filter((file) => file.endsWith(".ftl"))
    .map((file) => basename(file, ".ftl"));
  const cut = new Map<string, ReadonlyMap<string, string>>();
  const wordsOf = (language: string) => {
    const made = cut.get(language) ?? byRoom(language);
    cut.set(language, made);
    return made;
  };
  const loaders = (language: string) =>
    [...wordsOf(language).keys()]
      .filter((room) => language !== SOURCE || room !== EVERYWHERE) // which every page has
      .map((room) => `${JSON.stringify(room)}: () => import("${name}/${language}/${room}")`)
      .join(",");
  return {
    name: "words",
    resolveId: (id) => (id === name || id.startsWith(`${name}/`) ? `\0${id}` : null),
    load(id) {
      if (id === `\0${name}`)
        return `export default {${languages.map((one) => `${one}: {${loaders(one)}}`).join(",")}}`;
      if (!id.startsWith(`\0${name}/`)) return null;
      const [language = "", room = ""] = id.slice(name.length + 2).split("/");
      this.addWatchFile(join(CATALOGUE, `${language}.ftl`));
      return `export default ${JSON.stringify(read(wordsOf(language).get(room) ?? ""))}`;
    },
  };
}

/** Each message's pattern, as Fluent's bundle takes it. */
function read(source: string): Record<string, unknown> {
  return Object.fromEntries(new FluentResource(source).body.map(({ id, value }) => [id, value]));
}

/** What the file of a language's room is called: "words-fr-measure". */
export function wordsName(modules: readonly string[]): string | null {
  const [, language, room] = /^\0virtual:words\/(\w+)\/([\w-]+)$/.exec(modules[0] ?? "") ?? [];
  return room && modules.length === 1 ? `words-${language}-${room}` : null;
}

type Written = Entry & { id: { name: string } };

/** The Fluent source of each room, in a language. */
export function byRoom(language: string): ReadonlyMap<string, string> {
  const { body } = new FluentParser().parse(readFileSync(join(CATALOGUE, `${language}.ftl`), "utf8"));
  const entries = body.filter((one): one is Written => one.type === "Message" || one.type === "Term");
  const rooms = process.env.VITEST ? new Map<string, Set<string>>() : roomsOf(entries);
  const made = new Map<string, Entry[]>();
  for (const entry of entries) {
    const all = rooms.get(entry.id.name) ?? new Set([EVERYWHERE]);
    const said = [...all].filter((room) => !room.endsWith(LATE) || !all.has(room.slice(0, -LATE.length)));
    const everywhere = entry.type === "Term" || said.includes(EVERYWHERE) || said.length > MOST_ROOMS;
    for (const room of everywhere ? [EVERYWHERE] : said.length > 0 ? said : [SERVER]) made.set(room, [...(made.get(room) ?? []), entry]);
  }
  const serializer = new FluentSerializer();
  return new Map([...made].map(([room, own]) => [room, serializer.serialize(new Resource(own))]));
}

/** In which rooms each message is said, those that it is said within included. */
function roomsOf(entries: readonly Written[]): Map<string, Set<string>> {
  const keys = entries.map((entry) => entry.id.name);
  const within = new Map(entries.map((entry) => [entry.id.name, referredTo(entry)]));
  const rooms = new Map<string, Set<string>>(keys.map((key) => [key, new Set()]));
  const put = (key: string, room: string): void => {
    if (!rooms.has(key) || rooms.get(key)?.has(room)) return;
    rooms.get(key)?.add(room);
    for (const one of within.get(key) ?? []) put(one, room);
  };
  const together: string[][] = [];
  const files = sources();
  const roomsOfFile = roomsOfModules(files);
  for (const [file, text] of files) {
    const { said, lists } = keysIn(text, keys);
    for (const room of roomsOfFile.get(file) ?? []) for (const key of said) put(key, room);
    together.push(...lists);
  }
  // a list that is read as a whole keeps its order, so it stays together
  for (const list of together) {
    const all = new Set(list.flatMap((key) => [...(rooms.get(key) ?? [])]));
    for (const room of all) for (const key of list) put(key, room);
  }
  return rooms;
}

function roomOf(file: string): string {
  return /^screens\/(\w+)/.exec(file)?.[1] ?? EVERYWHERE;
}

/** The pages' modules by their path below src. */
function sources(): ReadonlyMap<string, string> {
  const all = readdirSync(PAGES, { recursive: true, encoding: "utf8" }).map((file) => file.replaceAll("\\", "/"));
  const own = all.filter((file) => /\.tsx?$/.test(file) && !/\.test\.|^(testing|package)\//.test(file));
  return new Map(own.map((file) => [file, readFileSync(join(PAGES, file), "utf8")]));
}

/** Which rooms' code each module is in: what the app around the screens imports is everywhere, and so is what nobody does. */
function roomsOfModules(files: ReadonlyMap<string, string>): ReadonlyMap<string, ReadonlySet<string>> {
  const found = new Map<string, Set<string>>([...files.keys()].map((file) => [file, new Set()]));
  const imported = (file: string, imports: RegExp): string[] =>
    [...(files.get(file) ?? "").matchAll(imports)].flatMap(([, to = ""]) => {
      const path = posix.join(posix.dirname(file), to);
      return [`${path}.ts`, `${path}.tsx`, `${path}/index.ts`].find((one) => files.has(one)) ?? [];
    });
  const visit = (file: string, room: string): void => {
    const rooms = found.get(file);
    if (!rooms || rooms.has(room) || rooms.has(EVERYWHERE)) return;
    rooms.add(room);
    for (const module of imported(file, FIRST)) visit(module, room);
    if (room === EVERYWHERE) return;
    for (const module of imported(file, SOON)) visit(module, room);
    for (const module of imported(file, SHOWN_LATE)) visit(module, room.endsWith(LATE) ? room : room + LATE);
  };
  for (const file of files.keys()) if (/^(app|core|components|main)\b/.test(file)) visit(file, EVERYWHERE);
  for (const file of files.keys())
    for (const module of file.startsWith("app/") ? imported(file, ANY_LATER) : [])
      if (module.startsWith("screens/")) visit(module, roomOf(module));
  for (const [file, rooms] of found) if (rooms.has(EVERYWHERE) || rooms.size === 0) found.set(file, new Set([EVERYWHERE]));
  return found;
}

const FIRST = /^(?:import|export)\s+(?!type\b)(?:[^;"]*?from\s+)?"(\.[^"]+)";/gm;
const ANY_LATER = /\bimport\("(\.[^"]+)"\)/g;
const SHOWN_LATE = new RegExp(`\\blate\\(.*${ANY_LATER.source}`, "g");
/** What a page imports for itself, after what it is opened for. */
const SOON = new RegExp(`^(?!.*\\blate\\().*${ANY_LATER.source}`, "gm");

function referredTo(entry: Entry): string[] {
  const within = new Within();
  within.visit(entry);
  return within.keys;
}

/** The keys that a file names, those that it puts together, and the lists that it reads by their beginning. */
function keysIn(text: string, keys: readonly string[]): { said: Set<string>; lists: string[][] } {
  const said = new Set([...text.matchAll(/["'`]([a-z][\w-]*)["'`]/gi)].map(([, key = ""]) => key));
  for (const [, first = "", last = ""] of text.matchAll(/`([a-z][\w-]*-)\$\{[^}]*\}([\w-]*)`/gi))
    for (const key of keys) if (key.startsWith(first) && key.endsWith(last)) said.add(key);
  const lists: string[][] = [];
  for (const [, first = "", named = ""] of text.matchAll(/wordsOf\(\s*"([\w-]+-)"((?:,\s*"[\w-]+")*)/g)) {
    const list = named
      ? [...named.matchAll(/"([\w-]+)"/g)].map(([, name]) => first + name)
      : keys.filter((key) => key.startsWith(first));
    for (const key of list) said.add(key);
    if (!named) lists.push(list);
  }
  return { said, lists };
}

class Within extends Visitor {
  keys: string[] = [];
  visitMessageReference(node: { id: { name: string } }) {
    this.keys.push(node.id.name);
  }
}
