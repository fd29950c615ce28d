/** The frame of a recording on its stage: the picture, what the tools draw, the loupe, and whether it is still on its way. */
import { useSignalEffect } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { say } from "../core/messages";
import { bright } from "./display";
import { Loupe } from "./Loupe";
import { Picture } from "./Picture";
import type { Player } from "./player";
import type { FrameStage } from "./stage";
import type { Viewport } from "./viewport";
import "./timeline.css";
import "./notes.css";

export interface FrameViewProps {
  player: Player;
  stage: FrameStage;
  children?: ComponentChildren;
  /** Plain elements above everything, placed by the caller. */
  above?: ComponentChildren;
  describedBy?: string;
}

export function FrameView({ player, stage, children, above, describedBy }: FrameViewProps) {
  useSignalEffect(() => {
    const shown = player.shown.value;
    const facts = player.recording.value;
    if (shown) stage.setImage(shown.picture);
    else if (player.preview.value && facts?.width_px && facts.height_px)
      stage.setImage({ width: facts.width_px, height: facts.height_px });
  });
  return (
    <Picture
      stage={stage}
      class="frame-view"
      testId="frame-view"
      what={say("viewer-what")}
      label={say("viewer-frame-label", { frame: String(player.frame.value) })}
      describedBy={describedBy}
      blocked={() => player.preview.value !== null}
      subject={() => player.shown.value?.frame}
      draw={(canvas, view) =>
        draw(canvas, (player.shown.value ?? player.preview.value)?.picture ?? null, view)
      }
      above={
        <>
          {above}
          {bright.value && (
            <p class="stage-note frame-display" data-testid="display-only">
              {say("viewer-bright")}
            </p>
          )}
          <Loupe player={player} stage={stage} />
          <FrameState player={player} />
        </>
      }
    >
      {children}
    </Picture>
  );
}

function FrameState({ player }: { player: Player }) {
  const problem = player.problem.value;
  if (problem) {
    return (
      <div class="frame-problem" role="alert">
        <p>{problem}</p>
        <button type="button" class="btn" onClick={() => player.retry()}>
          {say("action-try-again")}
        </button>
      </div>
    );
  }
  const waiting = player.loading.value;
  const frame = String(player.frame.value);
  const preview = player.preview.value;
  if (preview)
    return (
      <div class="row frame-loading frame-loading--on" role="status" data-testid="stand-in">
        <span class="spinner" /> {say("viewer-stand-in", { thumbnail: String(preview.frame), frame })}
      </div>
    );
  return (
    <div class={`row frame-loading${waiting ? " frame-loading--on" : ""}`} aria-hidden={!waiting}>
      <span class="spinner" /> {say("viewer-frame", { frame })}
    </div>
  );
}

function draw(canvas: HTMLCanvasElement, picture: ImageBitmap | null, view: Viewport): void {
  const { screen, image, left, top, scale } = view;
  // where the picture lies, for who reads the page from outside, as the browser tests do
  canvas.dataset["picture"] = `${left} ${top} ${scale}`;
  const ratio = window.devicePixelRatio || 1;
  const width = Math.round(screen.width * ratio);
  const height = Math.round(screen.height * ratio);
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  const context = canvas.getContext("2d");
  if (!context) return;
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, width, height);
  if (!picture || picture.width === 0) return;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  // single pixels are what is clicked on: past 3x show them as they are
  context.imageSmoothingEnabled = scale < 3;
  context.imageSmoothingQuality = "high";
  context.drawImage(picture, left, top, image.width * scale, image.height * scale);
}
