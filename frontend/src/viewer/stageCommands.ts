/** The one table of what keys and buttons do on a picture. Screens add their own before it. */
import type { ButtonCommand } from "../components/CommandButton";
import type { ActionId } from "../core/commands";
import { bright, linesShown, set, toggle, toggleBright } from "./display";
import type { Player } from "./player";
import type { FrameStage, PictureStage } from "./stage";
import type { View } from "./view";

const STEPS_PX = { "": 1, Far: 10, Fine: 0.1 } as const;
const WAYS = { Left: [-1, 0], Right: [1, 0], Up: [0, -1], Down: [0, 1] } as const;

/** Nudges, the cursor, Enter, Esc and zoom: of every picture. */
export function pictureCommands<P, V extends View<P, V>>(stage: PictureStage<P, V>): ButtonCommand[] {
  const nudges = Object.entries(WAYS).flatMap(([way, [dx, dy]]) =>
    Object.entries(STEPS_PX).map(
      ([size, px]): ButtonCommand => ({
        id: `nudge${way}${size}` as ActionId,
        run: () => stage.nudge(dx * px, dy * px),
      }),
    ),
  );
  return [
    ...nudges,
    { id: "cursor", run: () => stage.keyboard.toggle(), pressed: () => stage.cursor.value !== null },
    { id: "place", run: () => stage.confirm() },
    { id: "cancel", run: () => stage.cancel() },
    { id: "zoomIn", run: () => stage.zoom(1.25) },
    { id: "zoomOut", run: () => stage.zoom(0.8) },
    fitCommand(stage),
  ];
}

export function fitCommand(stage: { fit(): void }): ButtonCommand {
  return { id: "zoomFit", run: () => stage.fit() };
}

export function loupeSwitch(stage: FrameStage): ButtonCommand {
  return { id: "loupeToggle", run: () => toggle(stage.loupe), pressed: () => stage.loupe.value };
}

export const linesSwitch: ButtonCommand = {
  id: "linesToggle",
  run: () => toggle(linesShown),
  pressed: () => linesShown.value,
};

export const brightSwitch: ButtonCommand = {
  id: "brightToggle",
  run: toggleBright,
  pressed: () => bright.value,
};

/** Those of every picture, of its loupe and its lines, and of the frames of the player that is open. */
export function frameCommands(stage: FrameStage, player: Player | null): ButtonCommand[] {
  return [
    ...pictureCommands(stage),
    { id: "loupe", held: true, run: (down) => set(stage.loupe, down) },
    loupeSwitch(stage),
    linesSwitch,
    brightSwitch,
    ...(player ? playerCommands(player, stage) : []),
  ];
}

/** Play waits for Space to come up again: until then it may be a pan. */
function playerCommands(player: Player, stage: FrameStage): ButtonCommand[] {
  return [
    { id: "frameNext", run: () => player.step(1) },
    { id: "framePrevious", run: () => player.step(-1) },
    { id: "frameNextTen", run: () => player.step(10) },
    { id: "framePreviousTen", run: () => player.step(-10) },
    { id: "secondNext", run: () => player.stepSeconds(1) },
    { id: "secondPrevious", run: () => player.stepSeconds(-1) },
    { id: "frameFirst", run: () => player.step(Number.NEGATIVE_INFINITY) },
    {
      id: "frameLast",
      run: () => player.step(Number.POSITIVE_INFINITY),
      enabled: () => player.count.value !== null,
    },
    { id: "frameGo", run: () => stage.frameBox?.focus() },
    {
      id: "play",
      held: true,
      run: (down) => {
        if (!down && !stage.panned) player.toggle();
        if (down) stage.panned = false;
      },
    },
  ];
}
