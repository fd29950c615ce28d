/** Lengths and wheelbases against what their makers say. */
import { TableScroll } from "../../components";
import type { ScanErrorGroup, ScanStatistics } from "../../core/types";
import { formatSmall } from "../../core/units";

const GROUPS: Record<string, string> = { daytime: "Daytime", low_light: "Low light", overall: "Overall" };
const COLUMNS = [
  ["bias_m", "bias"],
  ["mae_m", "MAE"],
  ["rmse_m", "RMSE"],
  ["sd_m", "SD"],
] as const;

export function SizeErrors({ found }: { found: ScanStatistics }) {
  return (
    <section class="panel" aria-labelledby="scan-errors">
      <header class="panel__head">
        <h2 id="scan-errors">Measured minus the maker’s value</h2>
        <span class="muted small">with 95 % intervals</span>
      </header>
      <TableScroll label="Errors of lengths and wheelbases">
        <table class="table" data-testid="scan-errors">
          <thead>
            <tr>
              <th>of</th>
              <th class="num">n</th>
              {COLUMNS.map(([, head]) => (
                <th key={head} class="num">
                  {head}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            <Rows what="Length" groups={found.length_errors} />
            <Rows what="Wheelbase" groups={found.wheelbase_errors} />
          </tbody>
        </table>
      </TableScroll>
    </section>
  );
}

function Rows({ what, groups }: { what: string; groups: readonly ScanErrorGroup[] }) {
  const told = groups.filter((one) => one.n > 0 || one.group === "overall");
  return (
    <>
      {told.map((group) => (
        <tr key={group.group}>
          <td>
            {what}, {(GROUPS[group.group] ?? group.group).toLowerCase()}
          </td>
          <td class="num">{group.n}</td>
          {group.n === 0 ? (
            <td colSpan={COLUMNS.length} class="small muted">
              {group.reason ?? "No vehicle has a known size."}
            </td>
          ) : (
            COLUMNS.map(([key]) => <Cell key={key} group={group} name={key} />)
          )}
        </tr>
      ))}
    </>
  );
}

function Cell({ group, name }: { group: ScanErrorGroup; name: string }) {
  const figure = group.figures[name];
  const within = figure?.ci95;
  return (
    <td class="num">
      {figure?.value == null ? "–" : formatSmall(figure.value)}
      {within && (
        <p class="small muted nowrap">
          {formatSmall(within.low)} to {formatSmall(within.high)}
        </p>
      )}
    </td>
  );
}
