/** The cut of the catalogue into rooms: whatever a screen says is among its words. */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { expect, it, vi } from "vitest";
import { byRoom } from "../../tools/words.ts";

vi.stubEnv("VITEST", "");
const src = `${import.meta.dirname}/../`;
const english = byRoom("en");
const everywhere = keysOf("everywhere");

function keysOf(room: string): ReadonlySet<string> {
  return new Set([...(english.get(room) ?? "").matchAll(/^([a-zA-Z][\w-]*) =/gm)].map(([, key = ""]) => key));
}

it.each(readdirSync(`${src}screens`))("%s has the words it says", (room) => {
  const own = new Set([...keysOf(room), ...keysOf(`${room}-late`)]);
  const folder = `${src}screens/${room}`;
  const all = readdirSync(folder, { recursive: true, encoding: "utf8" });
  const files = all.filter((file) => /\.tsx?$/.test(file) && !file.includes(".test."));
  const texts = files.map((file) => readFileSync(`${folder}/${file}`, "utf8"));
  const parts = texts.flatMap((text) => [...text.matchAll(/"(?:\.\.\/)+((?:parts|viewer)\/[\w/]+)"/g)]);
  const shared = parts.flatMap(([, path]) => [`${src}${path}.tsx`, `${src}${path}.ts`]).filter(existsSync);
  const every = [...texts, ...shared.map((file) => readFileSync(file, "utf8"))];
  const said = every.flatMap((text) =>
    [...text.matchAll(/(?:\bsay\(|<Said\s+what=|\bsays=)"([\w-]+)"/g)].map(([, key = ""]) => key),
  );
  expect(said.length).toBeGreaterThan(2);
  expect(said.filter((key) => !own.has(key) && !everywhere.has(key))).toEqual([]);
});

it("keeps apart what a screen says only after an action, and nothing that it shows before", () => {
  const [first, late] = [keysOf("measure"), keysOf("measure-late")];
  for (const key of ["measure-conflict-kept", "measure-whole-keep"]) expect(late).toContain(key);
  for (const key of ["measure-passes", "measure-second-looking", "which-model-title", "measure-span-first"])
    expect(first).toContain(key);
  expect([...late].filter((key) => first.has(key))).toEqual([]);
});

it("has what the app around the screens says everywhere, and little else", () => {
  for (const key of ["app-name", "page-measure", "action-cancel", "problem-page"])
    expect(everywhere).toContain(key);
  expect(everywhere).not.toContain("scans-passes-head-u_line");
  expect(english.get("everywhere")?.length).toBeLessThan(150_000);
});

it("cuts each language alike", () => {
  expect([...byRoom("fr").keys()].sort()).toEqual([...english.keys()].sort());
});
