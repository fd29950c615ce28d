import { say } from "../../core/messages";
import type { BudgetEntry } from "../../core/types";
import { formatSmall } from "../../core/units";
import { budgetSource } from "../../core/words";
import "./vehicle.css";

/** Each source of uncertainty with its share; bars show squared contributions, which is how they add. */
export function Budget({ entries, total_m }: { entries: readonly BudgetEntry[]; total_m: number | null }) {
  const squares = entries.reduce((sum, one) => sum + one.u_m ** 2, 0);
  return (
    <table class="budget small">
      <caption class="small">
        <strong>{say("budget-title")}</strong> <span class="muted">{say("budget-note")}</span>
      </caption>
      <tbody>
        {entries.map((one) => (
          <tr key={one.source}>
            <th scope="row">{budgetSource(one.source)}</th>
            <td class="budget__share" aria-hidden="true">
              <span style={{ width: `${squares > 0 ? (100 * one.u_m ** 2) / squares : 0}%` }} />
            </td>
            <td class="num">{formatSmall(one.u_m)}</td>
          </tr>
        ))}
        <tr class="budget__sum">
          <th scope="row">{say("budget-together")}</th>
          <td aria-hidden="true" />
          <td class="num">{formatSmall(total_m)}</td>
        </tr>
      </tbody>
    </table>
  );
}
