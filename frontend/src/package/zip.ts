/** The files of a ZIP as its central directory tells them (PKWARE APPNOTE 6.3, 4.3), each read when it is asked for: a
 *  package may be larger than memory, and a browser has no reader of its own. */

export interface Entry {
  readonly path: string;
  readonly size: number;
  readonly bytes: () => Promise<Uint8Array<ArrayBuffer>>;
}

const LOCAL = 0x04034b50;
const CENTRAL = 0x02014b50;
const END = 0x06054b50;
const END_64 = 0x06064b50;
const LOCATOR_64 = 0x07064b50;
const END_BYTES = 22;
const LOCATOR_BYTES = 20;
const CENTRAL_BYTES = 46;
const LOCAL_BYTES = 30;
const MOST_COMMENT = 65_535;
const MOST_DIRECTORY = 512e6;
const FULL_32 = 0xffffffff;
const ENCRYPTED = 1;
const STORED = 0;
const DEFLATED = 8;

/** Every file, in the directory's order. Throws where this is no ZIP, a part of one, or names a file twice. */
export async function entriesOf(zip: Blob): Promise<Entry[]> {
  const { at, bytes, count } = await directoryOf(zip);
  const directory = await viewOf(zip, at, bytes);
  const found = new Map<string, Entry>();
  let next = 0;
  for (let n = 0; n < count; n++) {
    const one = centralAt(directory, next);
    next += one.length;
    if (one.path.endsWith("/")) continue;
    if (found.has(one.path)) throw new Error(one.path);
    found.set(one.path, { path: one.path, size: one.size, bytes: () => contentOf(zip, one) });
  }
  return [...found.values()];
}

interface Directory {
  readonly at: number;
  readonly bytes: number;
  readonly count: number;
}

async function directoryOf(zip: Blob): Promise<Directory> {
  const from = Math.max(zip.size - END_BYTES - MOST_COMMENT, 0);
  const tail = await viewOf(zip, from, zip.size - from);
  for (let at = tail.byteLength - END_BYTES; at >= 0; at--) {
    if (tail.getUint32(at, true) !== END) continue;
    const found = {
      count: tail.getUint16(at + 10, true),
      bytes: tail.getUint32(at + 12, true),
      at: tail.getUint32(at + 16, true),
    };
    const larger = await directoryOf64(zip, from + at);
    return within(zip, larger ?? found);
  }
  throw new Error("no end");
}

/** What stands before the end of a ZIP of more than 4 GB or 65,535 files, null in others. */
async function directoryOf64(zip: Blob, end: number): Promise<Directory | null> {
  if (end < LOCATOR_BYTES) return null;
  const locator = await viewOf(zip, end - LOCATOR_BYTES, LOCATOR_BYTES);
  if (locator.getUint32(0, true) !== LOCATOR_64) return null;
  const told = await viewOf(zip, numberAt(locator, 8), 56);
  if (told.getUint32(0, true) !== END_64) throw new Error("no end");
  return { count: numberAt(told, 32), bytes: numberAt(told, 40), at: numberAt(told, 48) };
}

function within(zip: Blob, found: Directory): Directory {
  if (found.at + found.bytes > zip.size || found.bytes > MOST_DIRECTORY) throw new Error("cut off");
  return found;
}

type Central = ReturnType<typeof centralAt>;

function centralAt(directory: DataView<ArrayBuffer>, at: number) {
  if (directory.getUint32(at, true) !== CENTRAL) throw new Error("no entry");
  if (directory.getUint16(at + 8, true) & ENCRYPTED) throw new Error("encrypted");
  const name = directory.getUint16(at + 28, true);
  const extra = directory.getUint16(at + 30, true);
  const comment = directory.getUint16(at + 32, true);
  const start = at + CENTRAL_BYTES;
  const path = new TextDecoder().decode(new Uint8Array(directory.buffer, start, name));
  const told = [24, 20, 42].map((offset) => directory.getUint32(at + offset, true));
  const [size = 0, packed = 0, place = 0] = with64(directory, start + name, extra, told);
  return {
    path,
    size,
    packed,
    at: place,
    method: directory.getUint16(at + 10, true),
    length: CENTRAL_BYTES + name + extra + comment,
  };
}

/** Size, packed size and place: those that have no room in 32 bits stand in the extra field 1, in this order. */
function with64(directory: DataView, start: number, bytes: number, told: readonly number[]): number[] {
  let at = start;
  while (at + 4 <= start + bytes && directory.getUint16(at, true) !== 1)
    at += 4 + directory.getUint16(at + 2, true);
  let next = at + 4;
  return told.map((value) => {
    if (value !== FULL_32) return value;
    if (next + 8 > start + bytes) throw new Error("no size");
    next += 8;
    return numberAt(directory, next - 8);
  });
}

async function contentOf(zip: Blob, one: Central): Promise<Uint8Array<ArrayBuffer>> {
  const local = await viewOf(zip, one.at, LOCAL_BYTES);
  if (local.getUint32(0, true) !== LOCAL) throw new Error(one.path);
  const from = one.at + LOCAL_BYTES + local.getUint16(26, true) + local.getUint16(28, true);
  const packed = zip.slice(from, from + one.packed);
  if (packed.size !== one.packed) throw new Error(one.path);
  if (one.method === STORED) return new Uint8Array(await packed.arrayBuffer());
  if (one.method !== DEFLATED) throw new Error(one.path);
  return exactly(packed.stream().pipeThrough(new DecompressionStream("deflate-raw")), one);
}

/** As many bytes as the directory told, for a file of a few bytes may unpack to more than a memory holds. */
async function exactly(stream: ReadableStream<Uint8Array>, one: Central): Promise<Uint8Array<ArrayBuffer>> {
  const content = new Uint8Array(one.size);
  const reader = stream.getReader();
  let filled = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    if (filled + value.length > one.size) {
      await reader.cancel();
      throw new Error(one.path);
    }
    content.set(value, filled);
    filled += value.length;
  }
  if (filled !== one.size) throw new Error(one.path);
  return content;
}

async function viewOf(zip: Blob, at: number, bytes: number): Promise<DataView<ArrayBuffer>> {
  if (at < 0 || at + bytes > zip.size) throw new Error("cut off");
  return new DataView(await zip.slice(at, at + bytes).arrayBuffer());
}

function numberAt(view: DataView, at: number): number {
  return Number(view.getBigUint64(at, true));
}
