/** The heights clicked in the strips of a survey, target by target, and how many of them wait for a verdict. */
import { TableScroll } from "../../components";
import { say } from "../../core/messages";
import type { ScanStatistics, Target } from "../../core/types";
import { formatCount, heads, plainLength } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";

export function ScannedHeights({ heights }: { heights: ScanStatistics["heights"] }) {
  const { length: unit } = heads();
  const waiting = heights.reduce((sum, one) => sum + one.to_review, 0);
  return (
    <section class="panel" aria-labelledby="scanned-heights">
      <header class="panel__head">
        <h2 id="scanned-heights">{say("scan-heights")}</h2>
        {waiting > 0 && <span class="muted small">{say("motion-heights-waiting", { count: waiting })}</span>}
      </header>
      <TableScroll label={say("scan-heights")}>
        <table class="table table--dense" data-testid="scanned-heights">
          <thead>
            <tr>
              <th>{say("motion-heights-target")}</th>
              <th class="num">n</th>
              <th class="num">{say("with-unit", { name: say("motion-heights-mean"), unit })}</th>
              <th class="num">{say("with-unit", { name: say("motion-heights-sd"), unit })}</th>
              <th class="num">{say("with-unit", { name: say("motion-heights-median"), unit })}</th>
              <th class="num">{say("with-unit", { name: say("motion-heights-u95"), unit })}</th>
              <th class="num">{say("motion-heights-to-review")}</th>
              <th class="num">{say("motion-heights-rejected")}</th>
            </tr>
          </thead>
          <tbody>
            {heights.map((one) => (
              <tr key={one.target}>
                <th scope="row">{TARGET_WORDS[one.target as Target]}</th>
                <td class="num">{formatCount(one.n)}</td>
                <td class="num">{plainLength(one.mean_m, 3)}</td>
                <td class="num">{plainLength(one.sd_m, 3)}</td>
                <td class="num">{plainLength(one.median_m, 3)}</td>
                <td class="num">{plainLength(one.U95_m, 3)}</td>
                <td class="num">{formatCount(one.to_review)}</td>
                <td class="num">{formatCount(one.rejected)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
    </section>
  );
}
