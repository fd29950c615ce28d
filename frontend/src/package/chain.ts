/** The audit chain: every event's hash and link, what it says of measurements and poses, its seal, its signature. */
import type { Held } from "./blocks";
import { textOf } from "./blocks";
import { canonical, type Json } from "./canonical";
import { type Row, rowsOf } from "./csv";
import { digest, fromHex, hex, sha256 } from "./sha256";

type Values = Readonly<Record<string, Json>>;

export interface Chain {
  readonly events: number;
  readonly head: string;
  /** the number of the first event that is not the one that was hashed, or that does not follow the one before */
  readonly broken: number | null;
  /** the newest row of each measurement, as its event tells it */
  readonly measurements: ReadonlyMap<string, Values>;
  /** the hash of each pose's content */
  readonly poses: ReadonlyMap<string, string>;
  readonly seal: Seal | null;
}

export interface Seal {
  readonly as_of: number;
  readonly files: Readonly<Record<string, string>>;
  /** whether the lines before the seal are those that it names */
  readonly holds: boolean;
}

const GENESIS = "0".repeat(64);
const encoder = new TextEncoder();

/** Walks the chain; `rest` lets the page breathe. */
export async function walked(audit: Held, rest: (done: number) => Promise<void>): Promise<Chain> {
  const rows = rowsOf(textOf(audit));
  const measurements = new Map<string, Values>();
  const poses = new Map<string, string>();
  let before = GENESIS;
  let broken: number | null = null;
  for (const [n, row] of rows.entries()) {
    if (!follows(row, n + 1, before) && broken === null) broken = n + 1;
    before = row["hash"] ?? "";
    if (!gathered(row, measurements, poses) && broken === null) broken = n + 1;
    if (n % 64 === 63) await rest(n / rows.length);
  }
  return { events: rows.length, head: before, broken, measurements, poses, seal: sealOf(audit, rows) };
}

function follows(row: Row, number: number, before: string): boolean {
  const values: Record<string, Json> = { number, chain: `survey/${row["survey_id"]}` };
  for (const name of ["at", "action", "entity", "before", "after"]) values[name] = row[name] || null;
  for (const name of ["actor_id", "entity_id", "survey_id"])
    values[name] = row[name] ? Number(row[name]) : null;
  const content = sha256(canonical(values));
  return (
    row["number"] === String(number) &&
    row["previous_hash"] === before &&
    row["content_sha256"] === content &&
    row["hash"] === sha256(before + content)
  );
}

function gathered(event: Row, measurements: Map<string, Values>, poses: Map<string, string>): boolean {
  if (!event["after"] || (event["entity"] !== "measurement" && event["entity"] !== "pose")) return true;
  const after = JSON.parse(event["after"]) as Values;
  if (event["entity"] === "pose") {
    if (after["content_sha256"]) poses.set(event["entity_id"] ?? "", String(after["content_sha256"]));
    return true;
  }
  const row = after["row"] as Values;
  measurements.set(event["entity_id"] ?? "", row);
  return sha256(canonical(row)) === after["content_sha256"];
}

function sealOf(audit: Held, rows: readonly Row[]): Seal | null {
  const last = rows.at(-1);
  if (last?.["entity"] !== "package" || last["action"] !== "seal") return null;
  const { as_of, files } = JSON.parse(last["after"] ?? "{}") as {
    as_of: number;
    files: Record<string, string>;
  };
  const start = audit.bytes.lastIndexOf(10, audit.bytes.length - 2) + 1;
  return { as_of, files, holds: files["audit.csv"] === sha256(audit.bytes.subarray(0, start)) };
}

export interface Signed {
  readonly key: string;
  readonly at: string;
  /** `unknown`: this browser cannot check Ed25519 */
  readonly state: "holds" | "wrong" | "unknown";
}

interface Checkpoint extends Record<string, Json> {
  at: string;
  key: string;
  root: string;
  signature: string;
  chains: number;
  place: number;
  path: string[];
  leaf: { chain: string; count: number; hash: string };
  keys: Handing[];
}

/** How a key followed from the one before, which signed it; the first signed itself. */
export type Handing = { key: string; after: string | null; signature: string };

/** Whether the installation's key signed the end of this chain, and each key was handed on by the one before. */
export async function signed(checkpoint: Held, chain: Chain): Promise<Signed> {
  const told = JSON.parse(textOf(checkpoint)) as Checkpoint;
  const { key, at } = told;
  const { leaf } = told;
  const ends = leaf.count === chain.events && leaf.hash === chain.head && rootOf(told) === told.root;
  if (!ends) return { key, at, state: "wrong" };
  try {
    const names = ["format", "at", "chains", "root", "key"];
    const own = await holds(told, names, told.key, told.signature);
    return { key, at, state: own && (await handedOn(told.keys, key)) ? "holds" : "wrong" };
  } catch {
    return { key, at, state: "unknown" };
  }
}

/** Whether each key was signed by the one before, and the last is this one. Throws where the browser has no Ed25519. */
export async function handedOn(keys: readonly Handing[], last: string): Promise<boolean> {
  const each = keys.map((one, n) => {
    const before = keys[n - 1]?.key ?? null;
    const by = before ?? one.key;
    return one.after === before && holds(one, ["format", "at", "key", "after"], by, one.signature);
  });
  return (await Promise.all(each)).every((one) => one) && keys.at(-1)?.key === last;
}

/** Whether a key signed these parts of a statement. Throws where the browser has no Ed25519. */
export async function holds(
  told: Values,
  names: readonly string[],
  key: string,
  signature: string,
): Promise<boolean> {
  const statement = Object.fromEntries(names.map((name) => [name, told[name] ?? null]));
  const held = await crypto.subtle.importKey("raw", fromHex(key), "Ed25519", false, ["verify"]);
  return crypto.subtle.verify("Ed25519", held, fromHex(signature), encoder.encode(canonical(statement)));
}

/** The root that the leaf and its path give (RFC 9162, 2.1.3.2); null where the path has another length. */
function rootOf({ leaf, place, chains, path }: Checkpoint): string | null {
  let node = digest(Uint8Array.from([0, ...encoder.encode(canonical(leaf))]));
  let [at, last] = [place, chains - 1];
  if (!(place >= 0 && place < chains)) return null;
  for (const step of path) {
    if (last === 0) return null;
    const beside = fromHex(step);
    if (at % 2 === 1 || at === last) {
      node = digest(Uint8Array.from([1, ...beside, ...node]));
      while (at % 2 === 0 && at > 0) [at, last] = [at >> 1, last >> 1];
    } else {
      node = digest(Uint8Array.from([1, ...node, ...beside]));
    }
    [at, last] = [at >> 1, last >> 1];
  }
  return last === 0 ? hex(node) : null;
}
