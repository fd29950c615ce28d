import { type Said, sentenceOf } from "../../core/messages";

/** The whole stored row, for who verifies a package; the other names tell it in short. */
const ROW = "row";

type Fields = Record<string, unknown> | null;

/** What differs between the two states of a record, field by field; null stands for "was not there". */
export function changesOf(before: Fields, after: Fields) {
  const names = [...new Set([...Object.keys(before ?? {}), ...Object.keys(after ?? {})])];
  return names
    .filter((name) => name !== ROW)
    .map((name) => ({ name, before: shown(before?.[name]), after: shown(after?.[name]) }))
    .filter((change) => change.before !== change.after);
}

function shown(value: unknown): string | null {
  if (value === undefined || value === null) return null;
  if (typeof value === "string") return value === "" ? null : value;
  const said = [value].flat();
  if (said.length > 0 && said.every(isSaid)) return said.map(sentenceOf).join(" ");
  const text = JSON.stringify(value);
  return text.length > 400 ? `${text.slice(0, 400)}…` : text;
}

function isSaid(value: unknown): value is Said {
  return typeof value === "object" && value !== null && "code" in value && "values" in value;
}
