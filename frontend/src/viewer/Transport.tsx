import { useLayoutEffect, useRef } from "preact/hooks";
import { Button, IconButton } from "../components";
import { type ActionId, commandName, hint } from "../core/commands";
import { say } from "../core/messages";
import { formatFrameTime } from "../core/times";
import type { Player } from "./player";
import type { FrameStage } from "./stage";

export function Transport({ player, stage }: { player: Player; stage: FrameStage }) {
  const box = useRef<HTMLInputElement>(null);
  const typed = useRef(false);
  const frame = player.frame.value;
  const time = player.timeOf(frame);
  const count = player.count.value;
  const playWords = say(player.playing.value ? "transport-stop" : "transport-play");
  const go = (): void => {
    const wanted = Number.parseInt(box.current?.value ?? "", 10);
    if (Number.isFinite(wanted)) player.go(wanted);
    if (box.current) box.current.value = String(player.frame.value);
  };
  // of the layout, so that its key serves as soon as it is seen
  useLayoutEffect(() => {
    stage.frameBox = box.current;
    return () => {
      stage.frameBox = null;
    };
  }, [stage]);
  // A frame that arrives while the box has the focus keeps its text selected, and never mixes with typed digits.
  useLayoutEffect(() => {
    const input = box.current;
    const focused = document.activeElement === input;
    if (!input || (focused && typed.current)) return;
    input.value = String(frame);
    if (focused) input.select();
  }, [frame]);
  return (
    <div class="row row--wrap row--near transport">
      <Step action="framePreviousTen" text="−10" onClick={() => player.step(-10)} />
      <Step action="framePrevious" text="−1" onClick={() => player.step(-1)} />
      <IconButton
        icon={player.playing.value ? "pause" : "play"}
        label={playWords}
        title={playWords + hint("play")}
        onClick={() => player.toggle()}
      />
      <Step action="frameNext" text="+1" onClick={() => player.step(1)} />
      <Step action="frameNextTen" text="+10" onClick={() => player.step(10)} />
      <label class="transport__frame">
        <span class="small muted">{say("transport-frame")}</span>
        <input
          ref={box}
          class="input input--num"
          data-testid="frame-box"
          inputMode="numeric"
          defaultValue={frame}
          title={commandName("frameGo") + hint("frameGo")}
          onFocus={(event) => {
            typed.current = false;
            event.currentTarget.select();
          }}
          onInput={() => {
            typed.current = true;
          }}
          onBlur={go}
          onKeyDown={(event) => {
            if (event.key !== "Enter" && event.key !== "Escape") return;
            if (event.key === "Escape" && box.current) box.current.value = String(frame);
            go();
            event.stopPropagation();
            stage.focus();
          }}
        />
        <span class="small muted nowrap transport__of">
          {count === null ? "" : say("transport-of", { last_frame: String(count - 1) })}
        </span>
      </label>
      <span class="transport__time nowrap">{time === null ? "" : formatFrameTime(time)}</span>
      {player.vfr.value && (
        <span class="badge" title={say("transport-vfr-title")}>
          {say("vfr")}
        </span>
      )}
    </div>
  );
}

function Step(props: { action: ActionId; text: string; onClick(): void }) {
  const label = commandName(props.action);
  return (
    <Button small kind="quiet" title={label + hint(props.action)} onClick={props.onClick}>
      <span aria-hidden="true">{props.text}</span>
      <span class="visually-hidden">{label}</span>
    </Button>
  );
}
