/** A proposal over the frame: dashed, a diamond, and the word; nothing is stored until a person clicks. */
import { say, sentenceOf } from "../../../core/messages";
import { InImage, PointMark } from "../../../viewer/Overlay";
import type { FrameStage } from "../../../viewer/stage";
import type { Assist } from "./assist";

export function AssistLayer({ assist, stage }: { assist: Assist; stage: FrameStage }) {
  const answer = assist.answer.value;
  const at = assist.at.value;
  if (!answer || !at) return null;
  const wheel = answer.outline.map(([u, v], i) => `${i === 0 ? "M" : "L"}${u} ${v}`).join("");
  return (
    <g class="proposal" data-testid="contact-proposal">
      <InImage stage={stage}>
        <path class="proposal__wheel" d={wheel} />
      </InImage>
      <PointMark stage={stage} at={at} kind="contact" proposed text={sentenceOf(answer.words)} />
    </g>
  );
}

/** What the assistant says in words: that it looks, why it refuses, or how to take the proposal. */
export function AssistNote({ assist }: { assist: Assist }) {
  const answer = assist.answer.value;
  const words = assist.waiting.value
    ? say("measure-proposal-looking")
    : (assist.problem.value ??
      (answer
        ? answer.contact
          ? say("measure-proposal-take", { proposal: sentenceOf(answer.words) })
          : sentenceOf(answer.words)
        : null));
  if (!words) return null;
  const drawn = answer?.contact != null;
  return (
    <p
      class={drawn ? "visually-hidden" : "frame-note frame-note--below"}
      role="status"
      data-testid="assist-note"
    >
      {words}
    </p>
  );
}
