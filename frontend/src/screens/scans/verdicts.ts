/** Verdicts on motions and heights of line scans, as values that can be put back. */
import type { Ledger } from "../../core/history";
import type { LineHeight } from "../../core/types";
import type { Verdict } from "./kinds";

interface Judged {
  readonly review: LineHeight["review"];
  /** What the outbox keeps for it. */
  readonly kept: Verdict | undefined;
}

/** The verdict that stands on the newest revision of each key; what waits is written as reopened. */
export function verdictLedger<K>(
  judged: (key: K) => Judged | null,
  write: Ledger<K, Verdict>["write"],
  nameOf?: (key: K) => unknown,
): Ledger<K, Verdict> {
  return {
    ...(nameOf ? { nameOf } : {}),
    read(key) {
      const { review, kept } = judged(key) ?? {};
      if (kept) return kept;
      if (review?.verdict !== "accepted" && review?.verdict !== "rejected")
        return { verdict: "reopened", reason: null };
      return { verdict: review.verdict, reason: review.reason ?? null };
    },
    write,
  };
}
