/** Axes and ladder through the contact in use, as the server answered them. */
import type { AxesAnswer } from "../core/types";
import { formatLength } from "../core/units";
import { linesShown } from "./display";
import { AxesLayer, LadderLayer } from "./Overlay";
import type { FrameStage } from "./stage";

export function AnswerLines({ answer, stage }: { answer: AxesAnswer | null; stage: FrameStage }) {
  if (!linesShown.value || !answer?.axes) return null;
  const rungs = answer.ladder.map((rung) => ({ ...rung, words: formatLength(rung.height_m, 1) }));
  return (
    <>
      <LadderLayer rungs={rungs} stage={stage} />
      <AxesLayer axes={answer.axes} stage={stage} />
    </>
  );
}
