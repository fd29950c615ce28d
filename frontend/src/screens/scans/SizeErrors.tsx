/** Lengths and wheelbases against what their makers say. */
import { DataTable, Panel } from "../../components";
import { say, sentenceOf, wordsOf } from "../../core/messages";
import type { ScanErrorGroup, ScanStatistics } from "../../core/types";
import { formatSmall } from "../../core/units";

const LENGTHS = wordsOf("motion-length-");
const WHEELBASES = wordsOf("motion-wheelbase-");
const COLUMNS = ["bias_m", "mae_m", "rmse_m", "sd_m"] as const;
const HEADS = wordsOf("motion-", "bias_m", "mae_m", "rmse_m", "sd_m");

export function SizeErrors({ found }: { found: ScanStatistics }) {
  return (
    <Panel says="motion-errors-title" note={say("motion-errors-note")}>
      <DataTable
        label={say("motion-errors-table")}
        class="table--dense"
        data-testid="scan-errors"
        rows={[...told(LENGTHS, found.length_errors), ...told(WHEELBASES, found.wheelbase_errors)]}
        keyOf={(_, index) => index}
        columns={({ col, num, across }) => [
          col(say("motion-errors-of"), (one) => one.word, "nowrap"),
          num(say("motion-errors-n"), (one) => one.n),
          ...across(
            ({ n, reason }) => (n === 0 ? (sentenceOf(reason) ?? say("motion-errors-none")) : undefined),
            undefined,
            ...COLUMNS.map((name) => num(HEADS[name], (one) => <Figure of={one.figures[name]} />)),
          ),
        ]}
      />
      <div class="stat-notes small" data-testid="scan-errors-note">
        {[found.length_ratio, found.wheelbase_ratio].map((one) => {
          const agrees = sentenceOf(one.agrees);
          return agrees && <p key={agrees}>{agrees}</p>;
        })}
        <p>{say("motion-errors-scatter")}</p>
      </div>
    </Panel>
  );
}

/** All of a size together, and the groups that say something else than it, by their words. */
function told(words: Readonly<Record<string, string>>, groups: readonly ScanErrorGroup[]) {
  const all = groups.find((one) => one.group === "overall")?.n ?? 0;
  const there = groups.filter(({ n, group }) => group === "overall" || (n > 0 && n < all));
  return there.map((one) => ({ ...one, word: words[one.group] ?? one.group }));
}

function Figure({ of }: { of: ScanErrorGroup["figures"][string] | undefined }) {
  const within = of?.ci95;
  return (
    <>
      {of?.value == null ? "–" : formatSmall(of.value)}
      {within && (
        <p class="small muted nowrap">
          {say("interval", { low: formatSmall(within.low), high: formatSmall(within.high) })}
        </p>
      )}
    </>
  );
}
