/** The columns of a spread: how many vehicles, their mean, SD and percentiles. */
import { num } from "../../components";
import { say } from "../../core/messages";
import { formatCount, lengthScale } from "../../core/units";
import { NONE, percent, scaled } from "../../parts/figures/numbers";
import type { Group } from "./model";

export function spreadHeads(percents: readonly number[]) {
  const unit = lengthScale()[1];
  return [
    num("n"),
    num(say("statistics-groups-mean", { unit })),
    num(say("statistics-groups-sd", { unit })),
    ...percents.map((one) => num(percent(one / 100, 0))),
  ];
}

interface CellsProps {
  of: Pick<Group, "n" | "mean_m" | "sd_m" | "percentiles">;
  percents: readonly number[];
  decimals: number;
}

export function SpreadCells({ of, percents, decimals }: CellsProps) {
  const factor = lengthScale()[0];
  const at = (wanted: number) => of.percentiles.find((p) => p.percent === wanted)?.value ?? null;
  return (
    <>
      <td class="num">{formatCount(of.n)}</td>
      <td class="num">{scaled(of.mean_m, factor, decimals)}</td>
      <td class="num">{of.sd_m === null ? NONE : scaled(of.sd_m, factor, decimals)}</td>
      {percents.map((wanted) => (
        <td key={wanted} class="num">
          {scaled(at(wanted), factor, decimals)}
        </td>
      ))}
    </>
  );
}
