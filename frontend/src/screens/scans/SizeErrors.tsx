/** Lengths and wheelbases against what their makers say. */
import { num, Panel, Table } from "../../components";
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
      <Table
        label={say("motion-errors-table")}
        data-testid="scan-errors"
        heads={[
          say("motion-errors-of"),
          num(say("motion-errors-n")),
          ...COLUMNS.map((name) => num(HEADS[name])),
        ]}
      >
        <Rows words={LENGTHS} groups={found.length_errors} />
        <Rows words={WHEELBASES} groups={found.wheelbase_errors} />
      </Table>
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

interface RowsProps {
  words: Readonly<Record<string, string>>;
  groups: readonly ScanErrorGroup[];
}

function Rows({ words, groups }: RowsProps) {
  const told = groups.filter((one) => one.n > 0 || one.group === "overall");
  return (
    <>
      {told.map((group) => (
        <tr key={group.group}>
          <td>{words[group.group] ?? group.group}</td>
          <td class="num">{group.n}</td>
          {group.n === 0 ? (
            <td colSpan={COLUMNS.length} class="small muted">
              {sentenceOf(group.reason) ?? say("motion-errors-none")}
            </td>
          ) : (
            COLUMNS.map((name) => <Cell key={name} group={group} name={name} />)
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
          {say("interval", { low: formatSmall(within.low), high: formatSmall(within.high) })}
        </p>
      )}
    </td>
  );
}
