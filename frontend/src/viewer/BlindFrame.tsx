/** The picture for clicking again without seeing: only what this person has clicked just now is drawn. */
import { TARGET_HINTS, TARGET_WORDS } from "../core/words";
import type { BlindClicks } from "./blind";
import { linesShown } from "./display";
import { FrameView } from "./FrameView";
import type { Geometry } from "./geometry";
import { AxesLayer, KeyboardCursor, PointMark } from "./Overlay";
import type { Player } from "./player";
import type { Stage } from "./stage";

interface Props {
  blind: BlindClicks;
  player: Player;
  stage: Stage;
  geometry: Geometry;
}

export function BlindFrame({ blind, player, stage, geometry }: Props) {
  const wanted = blind.wanted.value;
  const contact = blind.contact.value;
  const shown = player.shown.value?.frame ?? null;
  const here = wanted !== null && shown === wanted.frame;
  const axes = geometry.axes.value?.axes;
  return (
    <FrameView
      player={player}
      stage={stage}
      label={`Frame ${player.frame.value}`}
      describedBy="blind-hint"
      placing={here && !blind.busy.value}
      onPlace={(point) => {
        blind.cursor.value = null;
        void blind.place(point, shown);
      }}
      above={
        <p class="frame-hint" id="blind-hint" role="status" data-testid="blind-hint">
          {wanted && <strong>{TARGET_WORDS[wanted.target]}</strong>}
          <span>{wanted && words(wanted.frame, here, contact === null, TARGET_HINTS[wanted.target])}</span>
        </p>
      }
    >
      {here && contact && (
        <>
          {linesShown.value && axes && <AxesLayer axes={axes} stage={stage} />}
          <PointMark stage={stage} at={contact} kind="contact" selected />
        </>
      )}
      {blind.cursor.value && <KeyboardCursor stage={stage} at={blind.cursor.value} />}
    </FrameView>
  );
}

function words(frame: number, here: boolean, first: boolean, target: string): string {
  if (!here) return `Another frame than the one to click on; that is ${frame}.`;
  return first ? "click where the tyre meets the road" : `click ${target}`;
}
