import { Button, Facts, IconButton } from "../../components";
import { LengthField } from "../../components/CommitField";
import { explain } from "../../core/api";
import { hint } from "../../core/commands";
import { say, sentenceOf } from "../../core/messages";
import { type Resource, useResource } from "../../core/resource";
import { canWork } from "../../core/session";
import { fixed, formatHeight, formatLength, formatSmall, lengthProblem } from "../../core/units";
import { Budget } from "../../parts/vehicles/Budget";
import { Revisions } from "../../parts/vehicles/Revisions";
import { askHeight, askSecondFrame, heightOrReason } from "../../viewer/geometry";
import type { Inset } from "../../viewer/values";
import { framesOf } from "../../viewer/values";
import type { MeasureModel } from "./model";
import type { Entry } from "./records";

export function MeasurementDetail({ model, entry }: { model: MeasureModel; entry: Entry }) {
  const source = entry.preview ?? entry.saved;
  return (
    <div class="stack stack--near height-detail">
      <Frames model={model} entry={entry} />
      {canWork.value && entry.state === "saved" && (
        <Button
          says="measure-whole-follow"
          small
          title={say("measure-whole-go") + hint("followPass")}
          onClick={() => void model.whole.start(entry.key)}
        />
      )}
      <InsetEditor model={model} entry={entry} />
      {source && source.budget.length > 0 && <Budget entries={source.budget} total_m={source.u_height_m} />}
      <Facts
        small
        of={[
          [say("stage-frame"), entry.values.frame],
          [say("measure-contact"), pixels(entry.values.contact)],
          [say("measure-point"), pixels(entry.values.point)],
          entry.saved && [say("measure-points-set"), say("measure-made", { made: entry.saved.made })],
          entry.saved && [say("measure-distance"), formatLength(entry.saved.distance_m, 2)],
          entry.saved && [say("measure-lateral"), formatLength(entry.saved.y_m, 2)],
          entry.saved && [say("measure-along"), formatLength(entry.saved.x_m, 2)],
          entry.saved && [say("measure-without-inset"), formatLength(entry.saved.uncorrected_height_m)],
        ]}
      />
      {entry.saved && <Revisions id={entry.saved.id} revision={entry.saved.revision} />}
      {canWork.value && (
        <Button says="measure-withdraw" small icon="trash" onClick={() => model.points.withdraw(entry.key)} />
      )}
    </div>
  );
}

function pixels(point: readonly number[]): string {
  return say("measure-px", { across_px: fixed(point[0] ?? 0, 1), down_px: fixed(point[1] ?? 0, 1) });
}

/** How far the target lies behind the side plane: an estimate, with its own uncertainty. */
function InsetEditor({ model, entry }: { model: MeasureModel; entry: Entry }) {
  const usual = model.insets.usual(entry.values.target);
  const now: Inset | null = entry.values.inset ?? usual;
  if (!now) return null;
  const set = (change: Partial<Inset>): void => model.points.setInset(entry.key, { ...now, ...change });
  const check = (text: string) => lengthProblem(text, { empty: false });
  const own = usual && (usual.inset_m !== now.inset_m || usual.u_inset_m !== now.u_inset_m);
  return (
    <div>
      <p class="small">
        <strong>{say("measure-inset")}</strong> <span class="badge">{say("measure-estimate")}</span>{" "}
        <span class="muted">
          {say(
            entry.values.more.length > 0 || entry.values.follow
              ? "measure-inset-solved"
              : "measure-inset-what",
          )}
        </span>
      </p>
      <div class="grid grid--close height-detail__inset">
        {(["inset_m", "u_inset_m"] as const).map((name) => (
          <LengthField
            key={name}
            says={name === "inset_m" ? "measure-inset" : "measure-inset-u"}
            disabled={!canWork.value}
            metres={now[name]}
            check={check}
            onCommit={(metres) => set({ [name]: metres ?? now[name] })}
          />
        ))}
      </div>
      {own && usual && canWork.value && (
        <Button
          small
          kind="quiet"
          onClick={() => set({ inset_m: usual.inset_m, u_inset_m: usual.u_inset_m })}
        >
          {say("measure-inset-as-survey", {
            inset: formatLength(usual.inset_m, 2),
            u_inset: formatLength(usual.u_inset_m, 2),
          })}
        </Button>
      )}
    </div>
  );
}

/** To go to and to take away, and what one more would gain. */
function Frames({ model, entry }: { model: MeasureModel; entry: Entry }) {
  const frames = framesOf(entry.values);
  return (
    <div class="stack stack--tight frames-of" data-testid="frames-of">
      {frames.length > 1 && (
        <>
          <ul class="stack stack--dense">
            {frames.map(({ frame }, i) => (
              <li key={frame} class="row">
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
