/** The files of a package however they came: of a chosen or dropped folder, or within a ZIP. */
import { type Entry, entriesOf } from "./zip";

export type Piece = Entry;

export function ofChosen(chosen: readonly File[]): Piece[] {
  return chosen.map((file) => pieceOf(file, belowTop(file.webkitRelativePath) || file.name));
}

/** The files of one ZIP, or of a folder, that somebody dropped. Throws where a ZIP cannot be read. */
export async function ofDropped(items: DataTransfer): Promise<Piece[]> {
  const entries = [...items.items].map((one) => one.webkitGetAsEntry?.() ?? null);
  const [file] = items.files;
  const folder = entries.find((one): one is FileSystemDirectoryEntry => one?.isDirectory === true);
  if (folder !== undefined) return filesBelow(folder, "");
  return file === undefined ? [] : ofZip(file);
}

/** The files of a ZIP, with or without a folder around them all. Throws where it cannot be read. */
export async function ofZip(zip: Blob): Promise<Piece[]> {
  const found = await entriesOf(zip);
  if (found.some((one) => one.path === "audit.csv")) return found;
  const top = found[0]?.path.split("/")[0];
  const within = found.every((one) => one.path.startsWith(`${top}/`));
  return within ? found.map((one) => ({ ...one, path: belowTop(one.path) })) : found;
}

function belowTop(path: string): string {
  return path.split("/").slice(1).join("/");
}

function pieceOf(file: File, path: string): Piece {
  return { path, size: file.size, bytes: async () => new Uint8Array(await file.arrayBuffer()) };
}

async function filesBelow(folder: FileSystemDirectoryEntry, above: string): Promise<Piece[]> {
  const found: Piece[] = [];
  for (const one of await entriesIn(folder)) {
    const path = above + one.name;
    if (one.isDirectory) found.push(...(await filesBelow(one as FileSystemDirectoryEntry, `${path}/`)));
    else found.push(pieceOf(await fileOf(one as FileSystemFileEntry), path));
  }
  return found;
}

async function entriesIn(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const found: FileSystemEntry[] = [];
  for (;;) {
    // a browser tells a hundred at a time, and none at the end
    const more = await new Promise<FileSystemEntry[]>((tell, fail) => reader.readEntries(tell, fail));
    if (more.length === 0) return found;
    found.push(...more);
  }
}

function fileOf(entry: FileSystemFileEntry): Promise<File> {
  return new Promise((tell, fail) => entry.file(tell, fail));
}
