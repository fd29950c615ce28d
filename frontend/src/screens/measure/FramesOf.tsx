/** The frames of a measurement, and what a further one gains. */
import { Button, Facts, IconButton } from "../../components";
import { explain } from "../../core/api";
import { hint } from "../../core/commands";
import { say, sentenceOf } from "../../core/messages";
import { type Resource, useResource } from "../../core/resource";
import { canWork } from "../../core/session";
import { formatHeight, formatSmall } from "../../core/units";
import { askHeight, askSecondFrame, heightOrReason } from "../../viewer/geometry";
import { framesOf } from "../../viewer/values";
import type { MeasureModel } from "./model";
import type { Entry } from "./records";

/** To go to and to take away, and what one more would gain. */
export function Frames({ model, entry }: { model: MeasureModel; entry: Entry }) {
  const frames = framesOf(entry.values);
  return (
    <div class="frames-of" data-testid="frames-of">
      {frames.length > 1 && (
        <>
          <ul class="frames-of__list">
            {frames.map(({ frame }, i) => (
              <li key={frame}>
                <Button
                  small
                  kind="quiet"
                  pressed={model.seenFrame.value === frame}
                  onClick={() => {
                    model.reel.player.value?.go(frame);
                    model.points.select({ key: entry.key, role: "point" });
                    model.stage.focus();
                  }}
                >
                  {say("measure-frame", { frame: String(frame) })}
                </Button>
                <span class="grow muted small">{i === 0 ? say("measure-frame-first") : ""}</span>
                {canWork.value && (
                  <IconButton
                    icon="trash"
                    label={say("measure-frame-remove", { frame: String(frame) })}
                    title={say("measure-frame-remove-this")}
                    onClick={() => model.second.remove(entry.key, frame)}
                  />
                )}
              </li>
            ))}
          </ul>
          <AgainstOne model={model} entry={entry} />
        </>
      )}
      {canWork.value && entry.state === "saved" && <GainButton model={model} entry={entry} />}
    </div>
  );
}

/** Of a measurement, asked again when its points are others; an answer that comes late is not for them. */
function useAnswer<Answer>(
  model: MeasureModel,
  { saved }: Entry,
  ask: (recordingId: number) => Promise<Answer>,
): Resource<Answer | null> {
  const recordingId = model.reel.player.value?.recordingId;
  return useResource(
    async () => (recordingId === undefined ? null : ask(recordingId)),
    [saved?.id, saved?.revision],
  );
}

/** What the first frame alone would give, beside what all give together. */
function AgainstOne({ model, entry }: { model: MeasureModel; entry: Entry }) {
  const { data: answer } = useAnswer(model, entry, (recordingId) =>
    askHeight({ recordingId, vehicleId: entry.vehicleId, ...entry.values }),
  );
  if (!answer?.single) return null;
  return (
    <Facts
      small
      of={[
        [say("measure-one-frame"), formatHeight(answer.single.height_m, answer.single.U95_height_m)],
        [say("measure-all-frames", { count: answer.frames }), heightOrReason(answer)],
      ]}
    />
  );
}

/** "Second frame gains: 18 → 7 mm", and the way there. */
function GainButton({ model, entry }: { model: MeasureModel; entry: Entry }) {
  const { data: answer, error } = useAnswer(model, entry, (recordingId) =>
    askSecondFrame(recordingId, entry.vehicleId, entry.values),
  );
  const which = entry.values.more.length === 0 ? "second" : "another";
  if (error) return <p class="small muted">{explain(error)}</p>;
  if (!answer) return <p class="small muted">{say("measure-gain-looking", { which })}</p>;
  if (!answer.ok) return <p class="small muted">{answer.reason && sentenceOf(answer.reason)}</p>;
  return (
    <div data-testid="second-frame-gain">
      <Button
        small
        title={say("measure-gain-go", { frame: String(answer.frame) }) + hint("secondFrame")}
        onClick={() => void model.second.start(entry.key)}
      >
        {say("measure-gain", {
          which,
          U95_now: formatSmall(answer.U95_now_m),
          U95_then: formatSmall(answer.U95_then_m),
        })}
      </Button>
    </div>
  );
}
