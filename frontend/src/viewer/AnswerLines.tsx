/** Axes and ladder through the contact in use, as the server answered them, or that they are awaited. */
import { say } from "../core/messages";
import { formatRung } from "../core/units";
import { linesShown } from "./display";
import type { Geometry } from "./geometry";
import { AxesLayer, LadderLayer, Word } from "./Overlay";
import type { FrameStage } from "./stage";

export function AnswerLines({ geometry, stage }: { geometry: Geometry; stage: FrameStage }) {
  const answer = geometry.axes.value;
  const awaited = geometry.awaited.value;
  if (!linesShown.value) return null;
  // lines of another contact would say something of this one
  if (awaited) {
    return (
      <g data-testid="axes-awaited">
        <Word stage={stage} at={awaited} text={say("measure-axes-awaited")} dx={18} dy={18} />
      </g>
    );
  }
  if (!answer?.axes) return null;
  const rungs = answer.ladder.map((rung) => ({ ...rung, words: formatRung(rung.height_m) }));
  return (
    <>
      <LadderLayer rungs={rungs} stage={stage} />
      <AxesLayer axes={answer.axes} stage={stage} />
    </>
  );
}
