/** What the page found, as signals: tables at once, then heights, chain and signature while somebody reads. */
import { signal } from "@preact/signals";
import type { Messages } from "#messages";
import { type AuditFiles, auditFiles, type Held, heldFiles, textOf } from "./blocks";
import { type Chain, type Signed, signed, walked } from "./chain";
import { type Row, rowsOf } from "./csv";
import { type Pose, poseOf } from "./documents";
import { checkedFolder, type FolderCheck } from "./folder";
import { type Again, computedAgain } from "./measured";
import type { Piece } from "./pieces";
import { type Part, partsOf, README } from "./readme";
import { sha256 } from "./sha256";
import { notVouched, posesNotVouched } from "./vouched";

export type TableName = Messages["opened-table"]["table"];

/** What the package says of itself for this page: sizes of its folders, figures, tables with their columns. */
interface About {
  /** the vehicles that figures and report are limited to, in words; null for the whole survey */
  readonly only: string | null;
  readonly made_with: string;
  readonly folders: readonly { folder: string; files: number; bytes: number }[];
  readonly figures: readonly { path: string; title: string; wide: boolean }[];
  /** tables that are too large for a page */
  readonly left_out: readonly string[];
  readonly tables: readonly { path: string; name: TableName; columns: Readonly<Record<string, string>> }[];
}

export interface Opened {
  readonly about: About;
  readonly held: ReadonlyMap<string, Held>;
  readonly rows: (name: string) => readonly Row[];
  /** what came out, and what was not covered */
  readonly conclusion: readonly Part[];
  readonly measurements: readonly Row[];
  readonly budget: ReadonlyMap<string, readonly Row[]>;
  readonly crops: ReadonlyMap<string, readonly Row[]>;
  /** measurements of vehicles that the package is not of */
  readonly outside: ReadonlySet<string>;
  readonly poses: ReadonlyMap<string, Pose>;
  readonly records: ReadonlyMap<string, unknown>;
}

export interface Audited {
  readonly chain: Chain;
  readonly signed: Signed;
  /** files carried by the page that are not those that the seal names */
  readonly notSealed: readonly string[];
  readonly sealed: number;
  readonly notVouched: readonly string[];
  readonly posesNotVouched: readonly string[];
  readonly beside: readonly Held[];
}

export const opened = signal<Opened | null>(null);
/** heights computed again, by measurement; grows */
export const again = signal<ReadonlyMap<string, Again>>(new Map());
export const audited = signal<Audited | "absent" | null>(null);
export const progress = signal<number>(0);
export const folder = signal<FolderCheck | "checking" | "unreadable" | null>(null);
export const failed = signal<string | null>(null);
export const done = signal(false);

/** Reads what the page carries and checks it, step by step. */
export async function open(): Promise<void> {
  try {
    const found = await read();
    opened.value = found;
    await computeAll(found);
    await auditAll(found, await auditFiles());
  } catch (error) {
    failed.value = String(error instanceof Error ? error.message : error);
  }
  done.value = true;
}

async function read(): Promise<Opened> {
  const held = await heldFiles();
  const tables = new Map<string, readonly Row[]>();
  const about = JSON.parse(document.getElementById("about")?.textContent ?? "{}") as About;
  const rows = (name: string) => {
    const path = about.tables.find((one) => one.name === name)?.path ?? "";
    const known = tables.get(path) ?? (held.has(path) ? rowsOf(textOf(held.get(path))) : []);
    tables.set(path, known);
    return known;
  };
  const poses = new Map<string, Pose>();
  const records = new Map<string, unknown>();
  for (const [path, one] of held) {
    const id = /^records\/pose-(\d+)\.json$/.exec(path)?.[1];
    if (id === undefined) continue;
    const record = JSON.parse(textOf(one)) as { document: unknown };
    records.set(id, record);
    poses.set(id, poseOf(record.document));
  }
  const measurements = rows("measurements");
  const crops = grouped(rows("crops"));
  return {
    about,
    held,
    rows,
    conclusion: held.has(README) ? partsOf(textOf(held.get(README))).slice(0, 2) : [],
    measurements,
    budget: grouped(rows("budget")),
    crops,
    outside: about.only === null ? new Set() : outside(measurements, crops, rows("exclusions")),
    poses,
    records,
  };
}

/** Of a limited package: what exclusions.csv calls not selected, and what was not pictured though others were (those
 *  have another reason there first). */
function outside(
  measurements: readonly Row[],
  crops: ReadonlyMap<string, readonly Row[]>,
  exclusions: readonly Row[],
): ReadonlySet<string> {
  const unpictured = (row: Row) =>
    crops.size > 0 && row["withdrawn"] !== "true" && !crops.has(row["id"] ?? "");
  return new Set([
    ...exclusions.filter((row) => row["state"] === "not_selected").map((row) => row["measurement_id"] ?? ""),
    ...measurements.filter(unpictured).map((row) => row["id"] ?? ""),
  ]);
}

function grouped(rows: readonly Row[]): Map<string, Row[]> {
  const found = new Map<string, Row[]>();
  for (const row of rows) {
    const id = row["measurement_id"] ?? "";
    const list = found.get(id);
    if (list) list.push(row);
    else found.set(id, [row]);
  }
  return found;
}

async function computeAll(found: Opened): Promise<void> {
  const results = new Map<string, Again>();
  const breathe = breathing();
  for (const row of found.measurements) {
    const parts = (found.budget.get(row["id"] ?? "") ?? []).map((part) => Number(part["u_m"]));
    results.set(row["id"] ?? "", computedAgain(row, found.poses.get(row["pose_id"] ?? ""), parts));
    await breathe(results.size / found.measurements.length);
  }
  again.value = results;
}

async function auditAll(found: Opened, beside: AuditFiles | null): Promise<void> {
  if (beside === null) {
    audited.value = "absent";
    return;
  }
  const chain = await walked(beside.audit, breathing());
  const sealed = chain.seal?.files ?? {};
  audited.value = {
    chain,
    signed: await signed(beside.checkpoint, chain),
    notSealed: [...found.held.values()]
      .filter((one) => sealed[one.path] !== one.sha256)
      .map((one) => one.path),
    sealed: found.held.size,
    notVouched: notVouched(found.measurements, chain),
    posesNotVouched: posesNotVouched(found.records, chain),
    beside: [beside.audit, beside.checkpoint],
  };
}

/** Holds the files of a folder or ZIP against the seal; without audit.js beside the page the chain comes from there. */
export async function checkPieces(read: () => Promise<readonly Piece[]>): Promise<void> {
  if (audited.value === null || folder.value === "checking") return;
  folder.value = "checking";
  try {
    folder.value = await checked(await read());
  } catch {
    folder.value = "unreadable";
  }
}

async function checked(pieces: readonly Piece[]): Promise<FolderCheck | "unreadable" | null> {
  if (pieces.length === 0) return null;
  if (audited.value === "absent" && opened.value !== null)
    await auditAll(opened.value, await auditAmong(pieces));
  const known = audited.value;
  if (known === null || known === "absent" || known.chain.seal === null) return "unreadable";
  return checkedFolder(pieces, known.chain.seal, known.beside, breathing());
}

const MOST_AUDIT = 128e6; // bytes: what audit.js too holds at most

async function auditAmong(pieces: readonly Piece[]): Promise<AuditFiles | null> {
  const [audit, checkpoint] = ["audit.csv", "checkpoint.json"].map((path) =>
    pieces.find((one) => one.path === path && one.size <= MOST_AUDIT),
  );
  if (audit === undefined || checkpoint === undefined) return null;
  return { audit: await heldOf(audit), checkpoint: await heldOf(checkpoint) };
}

async function heldOf(piece: Piece): Promise<Held> {
  const bytes = await piece.bytes();
  return { path: piece.path, bytes, sha256: sha256(bytes) };
}

const BREATH_MS = 16;

/** Lets the browser draw now and then, and tells how far things are. */
function breathing(): (fraction: number) => Promise<void> {
  let last = performance.now();
  return async (fraction) => {
    if (performance.now() - last < BREATH_MS) return;
    progress.value = fraction;
    await new Promise((go) => setTimeout(go));
    last = performance.now();
  };
}
