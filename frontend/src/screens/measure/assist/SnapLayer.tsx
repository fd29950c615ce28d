/** From where a contact was clicked to the tyre that it went to, with how far off that may be and how to go back. */
import { keyMap, showChord } from "../../../core/commands";
import { say } from "../../../core/messages";
import { fixed } from "../../../core/units";
import type { FrameStage } from "../../../viewer/stage";
import type { Snapping } from "./snapping";

export function SnapLayer({ snapping, stage }: { snapping: Snapping; stage: FrameStage }) {
  const shown = snapping.shown();
  if (!shown || shown.expected_px === null) return null;
  const view = stage.view.value;
  const [x0, y0] = view.toScreen(shown.from);
  const [x1, y1] = view.toScreen(shown.to);
  const left = x1 > view.screen.width / 2;
  const values = { expected_px: fixed(shown.expected_px, 1), key: showChord(keyMap.value.undo[0] ?? "") };
  return (
    <g class="snap" data-testid="snap">
      {["point-mark__halo", "point-mark__line"].map((kind) => (
        <g key={kind} class={kind}>
          <line x1={x0} y1={y0} x2={x1} y2={y1} />
          <circle cx={x0} cy={y0} r={4} />
        </g>
      ))}
      <text class="overlay-word" x={x1 + (left ? -15 : 15)} y={y1 + 38} text-anchor={left ? "end" : "start"}>
        {say("measure-snapped", values)}
      </text>
    </g>
  );
}
