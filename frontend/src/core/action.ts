/** Something that a person sets going: whether it is still under way, and what went wrong. */
import { useState } from "preact/hooks";

/** `after`: done behind every one, also where it failed: what the page shows is read again. */
export function useAction(after?: () => Promise<unknown>) {
  const [busy, setBusy] = useState(false);
  const [problem, setProblem] = useState<unknown>(null);
  /** Does the work and keeps what it throws as the problem; tells whether it went well. */
  const run = async (work: () => Promise<unknown>) => {
    setBusy(true);
    setProblem(null);
    try {
      await work();
      return true;
    } catch (error) {
      setProblem(error);
      return false;
    } finally {
      setBusy(false);
      await after?.();
    }
  };
  return { busy, problem, setProblem, run };
}
