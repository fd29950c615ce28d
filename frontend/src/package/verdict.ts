/** What the page says in the end: each check with its state and sentence. */
import type { FolderCheck } from "./folder";
import type { Again } from "./measured";
import type { Audited } from "./opened";
import { say } from "./say";

export interface Check {
  readonly name: string;
  readonly state: "fine" | "wrong" | "open";
  readonly words: string;
}

const MOST_NAMED = 5;
const named = (names: readonly string[]) =>
  names.slice(0, MOST_NAMED).join(", ") + (names.length > MOST_NAMED ? " …" : "");

export function check(name: string, fine: boolean, words: string): Check {
  return { name, state: fine ? "fine" : "wrong", words };
}

export function leftOpen(name: string, words: string): Check {
  return { name, state: "open", words };
}

/** Heights: those computed again, those that differ, those that were not. */
export function ofHeights(again: ReadonlyMap<string, Again>): Check {
  const all = [...again];
  const wrong = all.filter(([, one]) => one.differs.length > 0).map(([id]) => id);
  const refused = all.filter(([, one]) => one.refused !== null).length;
  const off = Math.max(0, ...all.map(([, one]) => Math.abs(one.off_m ?? 0)));
  const name = "heights";
  if (wrong.length > 0)
    return check(name, false, say("opened-heights-differ", { count: wrong.length, named: named(wrong) }));
  const words = say("opened-heights-agree", { count: all.length - refused, off_um: off * 1e6 });
  return refused === 0
    ? check(name, true, words)
    : leftOpen(name, `${words} ${say("opened-heights-refused", { count: refused })}`);
}

export function ofChain(audited: Audited | "absent"): Check[] {
  if (audited === "absent") return [leftOpen("chain", say("opened-chain-absent"))];
  const { broken, events: count } = audited.chain;
  const words =
    broken === null
      ? say("opened-chain-whole", { count })
      : say("opened-chain-broken", { number: String(broken) });
  const whole = check("chain", broken === null, words);
  return [whole, ofSeal(audited), ofRows(audited), ofPoses(audited), ofSignature(audited)];
}

function ofSeal({ chain, notSealed, sealed }: Audited): Check {
  const name = "seal";
  if (chain.seal === null) return check(name, false, say("opened-seal-none"));
  if (!chain.seal.holds) return check(name, false, say("opened-seal-chain"));
  return notSealed.length > 0
    ? check(name, false, say("opened-seal-wrong", { named: named(notSealed) }))
    : check(name, true, say("opened-seal-holds", { count: sealed }));
}

function ofRows({ notVouched }: Audited): Check {
  const count = notVouched.length;
  return count > 0
    ? check("rows", false, say("opened-rows-differ", { count, named: named(notVouched) }))
    : check("rows", true, say("opened-rows-agree"));
}

function ofPoses({ posesNotVouched }: Audited): Check {
  return posesNotVouched.length > 0
    ? check("poses", false, say("opened-poses-differ", { named: named(posesNotVouched) }))
    : check("poses", true, say("opened-poses-agree"));
}

function ofSignature({ signed: { state, key, at } }: Audited): Check {
  const name = "signature";
  if (state === "wrong") return check(name, false, say("opened-signature-wrong"));
  if (state === "unknown") return leftOpen(name, say("opened-signature-unknown"));
  return check(name, true, say("opened-signature-holds", { at: at.slice(0, 10), key: key.slice(0, 16) }));
}

export function ofFolder(found: FolderCheck | "unreadable"): Check {
  const name = "folder";
  if (found === "unreadable") return leftOpen(name, say("opened-folder-unreadable"));
  const { changed, missing, strange, files: count, bytes } = found;
  if (changed.length > 0) return check(name, false, say("opened-folder-changed", { named: named(changed) }));
  if (missing.length > 0) return check(name, false, say("opened-folder-missing", { named: named(missing) }));
  if (strange.length > 0) return check(name, false, say("opened-folder-strange", { named: named(strange) }));
  return check(name, true, say("opened-folder-fine", { count, mb: bytes / 1e6 }));
}
