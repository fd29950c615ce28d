/** Proposed points over the frame: dashed diamonds and the word, so that none is taken for a measurement. */
import { say } from "../../../core/messages";
import { TARGET_NOUNS } from "../../../core/words";
import { PointMark } from "../../../viewer/Overlay";
import type { FrameStage } from "../../../viewer/stage";
import type { Role } from "./placed";
import type { Proposals } from "./proposals";

function roleWords(role: Role): string {
  return role === "contact" ? say("measure-step-contact") : TARGET_NOUNS[role];
}

export function ProposalLayer({ proposals, stage }: { proposals: Proposals; stage: FrameStage }) {
  return (
    <g class="proposal" data-testid="proposals">
      {proposals.inHand().map((one) => (
        <g key={one.role} data-testid={`proposed-${one.role}`}>
          <PointMark
            stage={stage}
            at={one.at}
            kind={one.role === "contact" ? "contact" : "point"}
            proposed
            selected={proposals.selected.value === one.role}
            text={say("measure-proposed-mark", { what: roleWords(one.role) })}
          />
        </g>
      ))}
    </g>
  );
}
