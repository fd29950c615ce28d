type WordsOfRooms = Readonly<Record<string, () => Promise<{ default: string }>>>;

declare module "virtual:words" {
  /** For each language its rooms, and how the words that are said in them are fetched. */
  const languages: Readonly<Record<string, WordsOfRooms>>;
  export default languages;
}

declare module "virtual:words/en/everywhere" {
  /** Fluent source of what the app around the screens says. */
  const words: string;
  export default words;
}
