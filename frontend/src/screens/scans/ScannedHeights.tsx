/** The heights clicked in the strips of a survey, target by target, and how many of them wait for a verdict. */
import { DataTable, Panel } from "../../components";
import { say, withUnit } from "../../core/messages";
import type { ScanStatistics, Target } from "../../core/types";
import { formatCount, heads, plainLength } from "../../core/units";
import { HEIGHT_WORDS } from "../../core/words";

export function ScannedHeights({ heights }: { heights: ScanStatistics["heights"] }) {
  const { length: unit } = heads();
  const waiting = heights.reduce((sum, one) => sum + one.to_review, 0);
  return (
    <Panel
      says="motion-heights"
      aside={
        waiting > 0 && <span class="muted small">{say("motion-heights-waiting", { count: waiting })}</span>
      }
    >
      <DataTable
        label={say("motion-heights")}
        class="table--dense"
        data-testid="scanned-heights"
        rows={heights}
        keyOf={(one) => one.target}
        columns={({ num, rowHead }) => [
          rowHead(say("motion-heights-target"), (one) => HEIGHT_WORDS[one.target as Target]),
          num("n", (one) => formatCount(one.n)),
          num(withUnit(say("motion-heights-mean"), unit), (one) => plainLength(one.mean_m, 3)),
          num(withUnit(say("motion-heights-sd"), unit), (one) => plainLength(one.sd_m, 3)),
          num(withUnit(say("motion-heights-median"), unit), (one) => plainLength(one.median_m, 3)),
          num(withUnit(say("motion-heights-u95"), unit), (one) => plainLength(one.U95_m, 3)),
          num(say("motion-heights-to-review"), (one) => formatCount(one.to_review)),
          num(say("motion-heights-rejected"), (one) => formatCount(one.rejected)),
        ]}
      />
    </Panel>
  );
}
