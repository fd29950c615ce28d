/** The picture for clicking again without seeing: only what this person has clicked just now is drawn. */
import { TARGET_WORDS } from "../core/words";
import type { BlindClicks } from "./blind";
import { FrameView } from "./FrameView";
import type { Player } from "./player";
import type { FrameStage } from "./stage";

interface Props {
  blind: BlindClicks;
  player: Player;
  stage: FrameStage;
}

export function BlindFrame({ blind, player, stage }: Props) {
  const wanted = blind.wanted.value;
  return (
    <FrameView
      player={player}
      stage={stage}
      describedBy="blind-hint"
      above={
        <p class="frame-hint" id="blind-hint" role="status" data-testid="blind-hint">
          {wanted && <strong>{TARGET_WORDS[wanted.target]}</strong>}
          <span>{stage.hint}</span>
        </p>
      }
    />
  );
}
