/** The files of the package themselves, where a person chooses its folder or drops its ZIP: each held against the seal. */
import type { Held } from "./blocks";
import type { Seal } from "./chain";
import type { Piece } from "./pieces";
import { hex, sha256 } from "./sha256";

export interface FolderCheck {
  readonly files: number;
  readonly bytes: number;
  readonly changed: readonly string[];
  readonly missing: readonly string[];
  readonly strange: readonly string[];
}

const SUMS = "SHA256SUMS";
const AFTER = ["audit.csv", "audit.js", "checkpoint.json", SUMS];

/** Holds every file against the seal; `beside`: audit.csv and checkpoint.json as audit.js told them. */
export async function checkedFolder(
  pieces: readonly Piece[],
  seal: Seal,
  beside: readonly Held[],
  rest: (done: number) => Promise<void>,
): Promise<FolderCheck> {
  const sums = new Map<string, string>();
  let bytes = 0;
  for (const [n, piece] of pieces.entries()) {
    sums.set(piece.path, await sumOf(await piece.bytes()));
    bytes += piece.size;
    await rest(n / pieces.length);
  }
  const expected = new Map(
    Object.entries(seal.files).filter(([path]) => path !== "crops/" && path !== "audit.csv"),
  );
  for (const one of beside) expected.set(one.path, one.sha256);
  const crops = [...sums.keys()].filter((path) => path.startsWith("crops/"));
  const changed = [...expected]
    .filter(([path, sum]) => sums.has(path) && sums.get(path) !== sum)
    .map(([path]) => path);
  if (sha256(linesOf(sums, crops)) !== seal.files["crops/"]) changed.push("crops/");
  const listed = linesOf(
    sums,
    [...sums.keys()].filter((path) => path !== SUMS),
  );
  if (sums.get(SUMS) !== sha256(listed)) changed.push(SUMS);
  const known = new Set([...expected.keys(), ...crops, ...AFTER]);
  return {
    files: pieces.length,
    bytes,
    changed,
    missing: [...expected.keys(), ...AFTER].filter(
      (path, n, all) => !sums.has(path) && all.indexOf(path) === n,
    ),
    strange: [...sums.keys()].filter((path) => !known.has(path)),
  };
}

function linesOf(sums: ReadonlyMap<string, string>, paths: readonly string[]): string {
  return [...paths]
    .sort()
    .map((path) => `${sums.get(path)}  ${path}\n`)
    .join("");
}

async function sumOf(content: Uint8Array<ArrayBuffer>): Promise<string> {
  if (globalThis.crypto?.subtle) return hex(new Uint8Array(await crypto.subtle.digest("SHA-256", content)));
  return sha256(content);
}
