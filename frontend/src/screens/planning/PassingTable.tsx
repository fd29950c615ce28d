import { num, Panel, Table } from "../../components";
import { say } from "../../core/messages";
import { fixed, formatSpeed } from "../../core/units";
import type { Passing } from "./model";

/** Exposure, motion blur and frames of a pass, by speed. */
export function PassingTable({ passing }: { passing: readonly Passing[] }) {
  return (
    <Panel says="planning-passing-title" data-testid="plan-passing">
      <Table
        label={say("planning-passing-title")}
        heads={[
          say("planning-passing-speed"),
          num(say("planning-passing-exposure")),
          num(say("planning-passing-blur")),
          num(say("planning-passing-frames-30")),
          num(say("planning-passing-frames-60")),
        ]}
      >
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
      </Table>
      <p class="field__hint plan-note">{say("planning-passing-note")}</p>
    </Panel>
  );
}
