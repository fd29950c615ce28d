/** Which strip is which, and how to ask again for tiles that did not come. */
import { say } from "../../core/messages";
import type { Tiles } from "./tiles";
import "./strips.css";

export function OverStrips({ tiles }: { tiles: Tiles }) {
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
