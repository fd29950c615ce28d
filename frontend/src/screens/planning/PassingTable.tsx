import { DataTable, Panel } from "../../components";
import { say } from "../../core/messages";
import type { Passing } from "../../core/types";
import { fixed, formatSpeed } from "../../core/units";

export function PassingTable({ passing }: { passing: readonly Passing[] }) {
  return (
    <Panel says="planning-passing-title" data-testid="plan-passing">
      <DataTable
        label={say("planning-passing-title")}
        rows={passing}
        keyOf={(one) => one.speed_mps}
        columns={({ col, num }) => [
          col(say("planning-passing-speed"), (one) => formatSpeed(one.speed_mps, null, 0)),
          num(say("planning-passing-exposure"), (one) =>
            say("planning-passing-fraction", { part: String(one.shutter) }),
          ),
          num(say("planning-passing-blur"), (one) =>
            say("planning-passing-px", { blur: fixed(one.blur_px, 1) }),
          ),
          num(say("planning-passing-frames-30"), (one) => one.frames[0]),
          num(say("planning-passing-frames-60"), (one) => one.frames[1]),
        ]}
      />
      <p class="field__hint panel__note">{say("planning-passing-note")}</p>
    </Panel>
  );
}
