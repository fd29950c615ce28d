import { Panel } from "../../components";
import { say } from "../../core/messages";
import { Differences } from "../../parts/figures/Differences";
import type { Comparison } from "./model";

/** Where what counts is of two surveys or years: whether they differ by more than noise. */
export function ComparisonSection({ compared }: { compared: Comparison }) {
  const title = say("statistics-compared-title", {
    first: compared.first.name,
    second: compared.second.name,
  });
  return (
    <Panel label={title} data-testid="comparison">
      {compared.figures.length === 0 ? (
        <p class="stat-notes small">{say("statistics-compared-none")}</p>
      ) : (
        <Differences
          label={title}
          rows={compared.figures.map((one) => ({ ...one, low_m: one.U95_low_m, high_m: one.U95_high_m }))}
        />
      )}
      <p class="stat-notes small">{say("statistics-compared-note")}</p>
    </Panel>
  );
}
