/** Each message's pattern by its key, as Fluent's bundle takes it. */
type Words = Readonly<Record<string, import("@fluent/bundle").Message["value"]>>;
type WordsOfRooms = Readonly<Record<string, () => Promise<{ default: Words }>>>;

declare module "virtual:words" {
  /** For each language its rooms, and how the words that are said in them are fetched. */
  const languages: Readonly<Record<string, WordsOfRooms>>;
  export default languages;
}

declare module "virtual:words/en/everywhere" {
  /** What the app around the screens says. */
  const words: Words;
  export default words;
}
