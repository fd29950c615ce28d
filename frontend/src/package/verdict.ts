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

/** Heights: those computed again, those that differ, those that were not. */
export function ofHeights(again: ReadonlyMap<string, Again>): Check {
  const all = [...again];
  const wrong = all.filter(([, one]) => one.differs.length > 0).map(([id]) => id);
  const refused = all.filter(([, one]) => one.refused !== null).length;
  const off = Math.max(0, ...all.map(([, one]) => Math.abs(one.off_m ?? 0)));
  const name = "heights";
  if (wrong.length > 0) {
    return {
      name,
      state: "wrong",
      words: say("opened-heights-differ", { count: wrong.length, named: named(wrong) }),
    };
  }
  const words = say("opened-heights-agree", { count: all.length - refused, off_um: off * 1e6 });
  return refused === 0
    ? { name, state: "fine", words }
    : { name, state: "open", words: `${words} ${say("opened-heights-refused", { count: refused })}` };
}

export function ofChain(audited: Audited | "absent"): Check[] {
  if (audited === "absent") return [{ name: "chain", state: "open", words: say("opened-chain-absent") }];
  const { chain } = audited;
  const whole: Check =
    chain.broken === null
      ? { name: "chain", state: "fine", words: say("opened-chain-whole", { count: chain.events }) }
      : {
          name: "chain",
          state: "wrong",
          words: say("opened-chain-broken", { number: String(chain.broken) }),
        };
  return [whole, ofSeal(audited), ofRows(audited), ofPoses(audited), ofSignature(audited)];
}

function ofSeal({ chain, notSealed, sealed }: Audited): Check {
  const name = "seal";
  if (chain.seal === null) return { name, state: "wrong", words: say("opened-seal-none") };
  if (!chain.seal.holds) return { name, state: "wrong", words: say("opened-seal-chain") };
  return notSealed.length > 0
    ? { name, state: "wrong", words: say("opened-seal-wrong", { named: named(notSealed) }) }
    : { name, state: "fine", words: say("opened-seal-holds", { count: sealed }) };
}

function ofRows({ notVouched }: Audited): Check {
  return notVouched.length > 0
    ? {
        name: "rows",
        state: "wrong",
        words: say("opened-rows-differ", { count: notVouched.length, named: named(notVouched) }),
      }
    : { name: "rows", state: "fine", words: say("opened-rows-agree") };
}

function ofPoses({ posesNotVouched }: Audited): Check {
  return posesNotVouched.length > 0
    ? { name: "poses", state: "wrong", words: say("opened-poses-differ", { named: named(posesNotVouched) }) }
    : { name: "poses", state: "fine", words: say("opened-poses-agree") };
}

function ofSignature({ signed: { state, key, at } }: Audited): Check {
  const name = "signature";
  if (state === "wrong") return { name, state: "wrong", words: say("opened-signature-wrong") };
  if (state === "unknown") return { name, state: "open", words: say("opened-signature-unknown") };
  return {
    name,
    state: "fine",
    words: say("opened-signature-holds", { at: at.slice(0, 10), key: key.slice(0, 16) }),
  };
}

export function ofFolder(check: FolderCheck | "unreadable"): Check {
  const name = "folder";
  if (check === "unreadable") return { name, state: "open", words: say("opened-folder-unreadable") };
  const { changed, missing, strange } = check;
  if (changed.length > 0)
    return { name, state: "wrong", words: say("opened-folder-changed", { named: named(changed) }) };
  if (missing.length > 0)
    return { name, state: "wrong", words: say("opened-folder-missing", { named: named(missing) }) };
  if (strange.length > 0)
    return { name, state: "wrong", words: say("opened-folder-strange", { named: named(strange) }) };
  return {
    name,
    state: "fine",
    words: say("opened-folder-fine", { count: check.files, mb: check.bytes / 1e6 }),
  };
}
