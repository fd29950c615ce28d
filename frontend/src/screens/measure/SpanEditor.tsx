/** The pass's frames, first, last and best: typed, or taken from the frame that is seen. */
import { Button } from "../../components";
import { CommitField } from "../../components/CommitField";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import type { Vehicle } from "../../core/types";
import type { MeasureModel } from "./model";
import { type SpanEnd, spanProblem } from "./span";
import "./span.css";

const ENDS = [
  { end: "first_frame", label: "measure-span-first", take: "measure-span-first-here" },
  { end: "best_frame", label: "measure-span-best", take: "measure-span-best-here" },
  { end: "last_frame", label: "measure-span-last", take: "measure-span-last-here" },
] as const satisfies { end: SpanEnd; label: string; take: string }[];

export function SpanEditor({ model, vehicle }: { model: MeasureModel; vehicle: Vehicle }) {
  const here = model.seenFrame.value;
  const sameRecording = model.reel.player.value?.recordingId === vehicle.recording_id;
  return (
    <section class="facts-form span-editor" aria-label={say("measure-span")}>
      <h3>{say("measure-span")}</h3>
      <div class="grid grid--3 grid--close below span-editor__ends">
        {ENDS.map(({ end, label, take }) => {
          const problem = spanProblem(vehicle, end, String(here));
          const why = sameRecording ? problem : say("measure-span-elsewhere");
          return (
            <div key={end}>
              <CommitField
                says={label}
                value={vehicle[end] === null ? "" : String(vehicle[end])}
                numeric
                disabled={!canWork.value}
                check={(text) => spanProblem(vehicle, end, text)}
                onCommit={(text) => model.edit({ [end]: text === "" ? null : Number(text) })}
              />
              {canWork.value && (
                <Button
                  says={take}
                  small
                  disabled={here < 0 || why !== null || vehicle[end] === here}
                  title={why ?? say("measure-frame", { frame: String(here) })}
                  onClick={() => model.edit({ [end]: here })}
                />
              )}
            </div>
          );
        })}
      </div>
    </section>
  );
}
