/** The pass's frames, first, last and best: typed, or taken from the frame that is seen. */
import { Button } from "../../components";
import { CommitField } from "../../components/CommitField";
import { canWork } from "../../core/session";
import type { Vehicle } from "../../core/types";
import type { MeasureModel } from "./model";
import { type SpanEnd, spanProblem } from "./span";
import "./span.css";

const ENDS: readonly { end: SpanEnd; label: string; take: string }[] = [
  { end: "first_frame", label: "First", take: "Begin here" },
  { end: "best_frame", label: "Best", take: "Best here" },
  { end: "last_frame", label: "Last", take: "End here" },
];

export function SpanEditor({ model, vehicle }: { model: MeasureModel; vehicle: Vehicle }) {
  const here = model.seenFrame.value;
  const sameRecording = model.reel.player.value?.recordingId === vehicle.recording_id;
  return (
    <section class="facts-form span-editor" aria-label="Frames of the pass">
      <h3>Frames of the pass</h3>
      <div class="span-editor__ends">
        {ENDS.map(({ end, label, take }) => {
          const problem = spanProblem(vehicle, end, String(here));
          const why = sameRecording ? problem : "Another recording is open.";
          return (
            <div key={end}>
              <CommitField
                label={label}
                value={vehicle[end] === null ? "" : String(vehicle[end])}
                numeric
                disabled={!canWork.value}
                check={(text) => spanProblem(vehicle, end, text)}
                onCommit={(text) => model.edit({ [end]: text === "" ? null : Number(text) })}
              />
              {canWork.value && (
                <Button
                  small
                  disabled={here < 0 || why !== null || vehicle[end] === here}
                  title={why ?? `Frame ${here}`}
                  onClick={() => model.edit({ [end]: here })}
                >
                  {take}
                </Button>
              )}
            </div>
          );
        })}
      </div>
    </section>
  );
}
