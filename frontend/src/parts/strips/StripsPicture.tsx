/** Both strips on one time axis: drag to pan, wheel to zoom the time, with Shift the height. */
import type { ComponentChildren } from "preact";
import { say } from "../../core/messages";
import { Picture } from "../../viewer/Picture";
import type { StripStage } from "./stage";
import type { Tiles } from "./tiles";
import type { StripsView } from "./view";
import "./strips.css";

interface StripsProps {
  stage: StripStage;
  tiles: Tiles;
  draw: (canvas: HTMLCanvasElement, view: StripsView) => void;
  fit: () => void;
  children?: ComponentChildren;
}

export function StripsPicture({ stage, tiles, draw, fit, children }: StripsProps) {
  return (
    <Picture
      stage={stage}
      class="strips"
      testId="strips"
      what={say("scan-strips")}
      label={say("scan-strips-label")}
      panByDrag
      draw={draw}
      onDblClick={fit}
      above={
        <>
          <OverStrips tiles={tiles} />
          {children}
        </>
      }
    />
  );
}

/** Which strip is which, and how to ask again for tiles that did not come. */
function OverStrips({ tiles }: { tiles: Tiles }) {
  return (
    <>
      <span class="strips__name">{say("scan-camera-1")}</span>
      <span class="strips__name strips__name--second">{say("scan-camera-2")}</span>
      {tiles.failed.value && (
        <div class="strips__problem" role="alert">
          {say("scan-strips-missing")}{" "}
          <button type="button" class="btn btn--small" onClick={() => tiles.retry()}>
            {say("action-try-again")}
          </button>
        </div>
      )}
    </>
  );
}
