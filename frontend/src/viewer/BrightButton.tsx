/** Brightens the picture for the eye; the label on the picture says so. */
import { Button } from "../components";
import { hint } from "../core/commands";
import { bright, toggleBright } from "./display";

export function BrightButton() {
  return (
    <Button
      small
      kind="quiet"
      pressed={bright.value}
      title={`Brighten the picture, for display only${hint("brightToggle")}; measuring is not touched`}
      onClick={toggleBright}
    >
      Bright
    </Button>
  );
}
