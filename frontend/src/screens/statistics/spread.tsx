/** The spread of groups of vehicles: how many, their mean, SD and percentiles. */
import { DataTable } from "../../components";
import { say } from "../../core/messages";
import { formatCount, lengthScale } from "../../core/units";
import { percent, scaled } from "../../parts/figures/numbers";
import type { Group } from "./model";

interface SpreadRow extends Pick<Group, "n" | "mean_m" | "sd_m" | "percentiles"> {
  key: string;
  word: string;
  /** A part of the row above it. */
  within?: boolean;
}

interface Props {
  label: string;
  head?: string;
  rows: readonly SpreadRow[];
  percents: readonly number[];
  decimals: number;
}

export function SpreadTable({ label, head = label, rows, percents, decimals }: Props) {
  const [factor, unit] = lengthScale();
  const shown = (value_m: number | null | undefined) => scaled(value_m ?? null, factor, decimals);
  return (
    <DataTable
      label={label}
      rows={rows}
      keyOf={(one) => one.key}
      columns={({ num, rowHead }) => [
        rowHead(head, ({ word, within }) => (within ? <span class="muted stat-within">{word}</span> : word)),
        num("n", (one) => formatCount(one.n)),
        num(say("statistics-groups-mean", { unit }), (one) => shown(one.mean_m)),
        num(say("statistics-groups-sd", { unit }), (one) => shown(one.sd_m)),
        ...percents.map((wanted) =>
          num(percent(wanted / 100, 0), (one) =>
            shown(one.percentiles.find((p) => p.percent === wanted)?.value),
          ),
        ),
      ]}
    />
  );
}
