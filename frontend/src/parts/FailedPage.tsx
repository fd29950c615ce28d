/** In place of a page whose model could not be read: why, and reading it again. */
import type { ReadonlySignal } from "@preact/signals";
import { Problem } from "../components";

export function FailedPage({
  model,
}: {
  model: { problem: ReadonlySignal<unknown>; load(): Promise<void> };
}) {
  return (
    <div class="page">
      <Problem error={model.problem.value} again={() => void model.load()} />
    </div>
  );
}
