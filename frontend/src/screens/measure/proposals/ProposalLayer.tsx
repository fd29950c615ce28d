/** Proposed points over the frame: dashed diamonds and the word, so that none is taken for a measurement. */
import { say } from "../../../core/messages";
import { TARGET_NOUNS } from "../../../core/words";
import type { FrameStage } from "../../../viewer/stage";
import type { InHand, Role } from "./placed";
import type { Proposals } from "./proposals";

const DIAMOND = "M0 -10L10 0L0 10L-10 0Z";

function roleWords(role: Role): string {
  return role === "contact" ? say("measure-step-contact") : TARGET_NOUNS[role];
}

export function ProposalLayer({ proposals, stage }: { proposals: Proposals; stage: FrameStage }) {
  return (
    <g class="proposal" data-testid="proposals">
      {proposals.inHand().map((one) => (
        <Mark key={one.role} one={one} selected={proposals.selected.value === one.role} stage={stage} />
      ))}
    </g>
  );
}

function Mark({ one, selected, stage }: { one: InHand; selected: boolean; stage: FrameStage }) {
  const [x, y] = stage.view.value.toScreen(one.at);
  return (
    <g
      transform={`translate(${x} ${y})`}
      class={`point-mark${selected ? " point-mark--selected" : ""}`}
      data-testid={`proposed-${one.role}`}
    >
      <path class="point-mark__halo" d={DIAMOND} />
      <path class="point-mark__line" d={DIAMOND} />
      <text class="overlay-word overlay-word--strong" x={15} y={one.role === "contact" ? 20 : -8}>
        {say("measure-proposed-mark", { what: roleWords(one.role) })}
      </text>
    </g>
  );
}
