import { TableScroll } from "../../components";
import { say } from "../../core/messages";
import { fixed, formatSpeed } from "../../core/units";
import type { Passing } from "./model";

/** Exposure, motion blur and frames of a pass, by speed. */
export function PassingTable({ passing }: { passing: readonly Passing[] }) {
  return (
    <section class="panel" aria-labelledby="plan-passing" data-testid="plan-passing">
      <div class="panel__head">
        <h2 id="plan-passing">{say("planning-passing-title")}</h2>
      </div>
      <TableScroll label={say("planning-passing-title")}>
        <table class="table">
          <thead>
            <tr>
              <th>{say("planning-passing-speed")}</th>
              <th class="num">{say("planning-passing-exposure")}</th>
              <th class="num">{say("planning-passing-blur")}</th>
              <th class="num">{say("planning-passing-frames-30")}</th>
              <th class="num">{say("planning-passing-frames-60")}</th>
            </tr>
          </thead>
          <tbody>
            {passing.map((one) => (
              <tr key={one.speed_mps}>
                <td>{formatSpeed(one.speed_mps, null, 0)}</td>
                <td class="num">{say("planning-passing-fraction", { part: String(one.shutter) })}</td>
                <td class="num">{say("planning-passing-px", { blur: fixed(one.blur_px, 1) })}</td>
                {one.frames.map((count, at) => (
                  <td key={at} class="num">
                    {count}
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </TableScroll>
      <p class="field__hint plan-note">{say("planning-passing-note")}</p>
    </section>
  );
}
