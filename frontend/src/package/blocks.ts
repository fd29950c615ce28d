/** The files of the package that the page carries, and the audit chain that lies beside it as a script: a page that is
 *  opened from a folder may not read its neighbours, but it may run them. */
import { sha256 } from "./sha256";

export interface Held {
  readonly path: string;
  readonly bytes: Uint8Array;
  readonly sha256: string;
}

declare global {
  /** What audit.js fills: audit.csv and checkpoint.json, packed as the page's own files are. */
  var sightlineAudit: Readonly<Record<string, string>> | undefined;
}

const decoder = new TextDecoder("utf-8", { fatal: true, ignoreBOM: true });

export async function heldFiles(): Promise<Map<string, Held>> {
  const found = new Map<string, Held>();
  for (const block of document.querySelectorAll<HTMLScriptElement>("script[data-path]")) {
    const path = block.dataset.path ?? "";
    found.set(path, await unpacked(path, block.textContent ?? ""));
    block.remove(); // half of the page's memory
  }
  return found;
}

export interface AuditFiles {
  readonly audit: Held;
  readonly checkpoint: Held;
}

/** audit.csv and checkpoint.json from audit.js, null where that is not beside the page. */
export async function auditFiles(): Promise<AuditFiles | null> {
  const packed = globalThis.sightlineAudit;
  const [audit, checkpoint] = [packed?.["audit.csv"], packed?.["checkpoint.json"]];
  if (audit === undefined || checkpoint === undefined) return null;
  return {
    audit: await unpacked("audit.csv", audit),
    checkpoint: await unpacked("checkpoint.json", checkpoint),
  };
}

export function textOf(held: Held | undefined): string {
  return held ? decoder.decode(held.bytes) : "";
}

/** Base64 of raw DEFLATE (RFC 1951). */
async function unpacked(path: string, packed: string): Promise<Held> {
  const letters = atob(packed.trim());
  const bytes = new Uint8Array(letters.length);
  for (let n = 0; n < letters.length; n++) bytes[n] = letters.charCodeAt(n);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  const content = new Uint8Array(await new Response(stream).arrayBuffer());
  return { path, bytes: content, sha256: sha256(content) };
}
