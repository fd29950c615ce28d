import { readdirSync, readFileSync } from "node:fs";
import { expect, it } from "vitest";

const SRC = `${import.meta.dirname}/..`;

it("every variable of the style that is read is written somewhere", () => {
  const files = readdirSync(SRC, { recursive: true }).map(String);
  const text = files
    .filter((name) => /\.(css|tsx?)$/.test(name) && !name.includes(".test."))
    .map((name) => readFileSync(`${SRC}/${name}`, "utf8"))
    .join("\n");
  const read = [...text.matchAll(/var\((--[\w-]+)/g)].map((found) => found[1] ?? "");
  const written = new Set([...text.matchAll(/"?(--[\w-]+)"?: /g)].map((found) => found[1]));
  expect([...new Set(read)].filter((name) => !written.has(name))).toEqual([]);
});
