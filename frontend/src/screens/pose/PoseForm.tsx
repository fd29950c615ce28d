/** The questions about the board, in the order of work, in words and with a drawing. */
import type { ComponentChildren } from "preact";
import { Button, choices, JobProgress, Notice, Segments, SelectField, TextField } from "../../components";
import { hint } from "../../core/commands";
import { fieldsOf, sent } from "../../core/form";
import { type PlainKey, say, sentenceOf, wordsOf } from "../../core/messages";
import { canWork } from "../../core/session";
import { fixed, lengthUnit, smallScale, smallText } from "../../core/units";
import { KindField, MarkerFields } from "../../parts/boards/MarkerFields";
import { BoardDrawing } from "./BoardDrawing";
import { U_BOW_M, U_TAPE_M } from "./form";
import type { PoseModel } from "./model";

export function PoseForm({ model }: { model: PoseModel }) {
  return (
    <form class="pose-form" onSubmit={sent(() => model.run())}>
      <LensQuestions model={model} />
      <BoardQuestions model={model} />
      <SpanQuestions model={model} />
      <HeightQuestions model={model} />
      <Run model={model} />
    </form>
  );
}

/** Some of the questions under their name; who may only look answers none. */
function Questions({ says, children }: { says: PlainKey; children: ComponentChildren }) {
  return (
    <fieldset disabled={!canWork.value}>
      <legend>{say(says)}</legend>
      {children}
    </fieldset>
  );
}

/** A problem is said once the person has tried, not while the form is being filled in. */
function shown(model: PoseModel, problem: string | null): string | null {
  return model.tried.value ? problem : null;
}

function LensQuestions({ model }: { model: PoseModel }) {
  const form = model.form.value;
  const problems = model.problems.value;
  return (
    <Questions says="pose-lens">
      <SelectField
        says="field-recording"
        value={String(model.reel.recording.value?.id ?? "")}
        options={model.reel.recordings.value.map((one) => ({
          value: String(one.id),
          label: one.name,
          disabled: one.state !== "ready",
        }))}
        onInput={(id) => void model.openRecording(Number(id))}
      />
      <SelectField
        says="field-calibration"
        value={String(form.calibrationId ?? "")}
        problem={shown(model, problems.calibration)}
        options={[
          ...(form.calibrationId === null ? [{ value: "", label: say("pose-calibration-none") }] : []),
          ...model.calibrations.value.map((one) => ({
            value: String(one.id),
            label: say("pose-calibration", {
              state: standing(one),
              camera: one.camera,
              calibration: String(one.id),
            }),
          })),
        ]}
        onInput={(id) => model.set({ calibrationId: id === "" ? null : Number(id) })}
      />
    </Questions>
  );
}

function standing({ current, trusted }: { current: boolean; trusted: boolean }) {
  if (current) return trusted ? "current" : "current_not_trusted";
  return trusted ? "other" : "not_trusted";
}

function BoardQuestions({ model }: { model: PoseModel }) {
  const form = model.form.value;
  const problems = model.problems.value;
  const [, unit] = smallScale();
  return (
    <Questions says="pose-board">
      <KindField value={form} change={(part) => model.set(part)} />
      <div class="pose-form__three">
        <TextField
          says="pose-columns"
          numeric
          value={String(form.columns || "")}
          onInput={(text) => model.set({ columns: count(text) })}
        />
        <TextField
          says="pose-rows"
          numeric
          value={String(form.rows || "")}
          onInput={(text) => model.set({ rows: count(text) })}
          problem={problems.board}
        />
        <TextField
          says="pose-square"
          unit={unit}
          value={form.square}
          onInput={(square) => model.set({ square })}
          problem={shown(model, problems.square)}
        />
      </div>
      <MarkerFields
        value={form}
        unit={unit}
        problem={shown(model, problems.marker)}
        change={(part) => model.set(part)}
      />
      <p class="field__hint">
        {say("pose-corners-hint")} {form.kind === "charuco" && say("pose-charuco-hint")}
      </p>
    </Questions>
  );
}

function SpanQuestions({ model }: { model: PoseModel }) {
  const form = model.form.value;
  const problems = model.problems.value;
  return (
    <Questions says="pose-still">
      <div class="row row--wrap">
        <Button
          says="pose-begins"
          small
          title={say("pose-begins-title") + hint("passBegin")}
          onClick={() => model.mark("first")}
        />
        <Button
          says="pose-ends"
          small
          title={say("pose-ends-title") + hint("passEnd")}
          onClick={() => model.mark("last")}
        />
        <span class="nowrap" data-testid="pose-span">
          {span(form.first, form.last)}
        </span>
      </div>
      {model.offered.value && (
        <p class="row small" data-testid="pose-span-offer">
          <span class="grow">
            {say("pose-span-offer", {
              first_frame: String(model.offered.value.first_frame),
              last_frame: String(model.offered.value.last_frame),
            })}
          </span>
          <Button says="pose-span-take" small onClick={() => model.takeOffered()} />
        </p>
      )}
      {shown(model, problems.span) && <p class="field__problem">{problems.span}</p>}
    </Questions>
  );
}

function HeightQuestions({ model }: { model: PoseModel }) {
  const form = model.form.value;
  const problems = model.problems.value;
  const unit = lengthUnit.value;
  const field = fieldsOf(form, (part) => model.set(part));
  return (
    <Questions says="pose-height">
      <Segments
        says="pose-reference"
        {...field("reference")}
        options={choices(wordsOf("pose-reference-", "bottom", "top"))}
      />
      <BoardDrawing
        reference={form.reference}
        columns={form.columns}
        rows={form.rows}
        markers={form.kind === "charuco"}
      />
      <TextField
        label={say("pose-reference-height", { reference: form.reference })}
        unit={unit}
        {...field("referenceHeight")}
        hint={say("pose-reference-height-hint")}
        problem={shown(model, problems.referenceHeight)}
      />
      <SurenessQuestions model={model} />
    </Questions>
  );
}

function SurenessQuestions({ model }: { model: PoseModel }) {
  const form = model.form.value;
  const problems = model.problems.value;
  const [, unit] = smallScale();
  const field = fieldsOf(form, (part) => model.set(part));
  return (
    <details>
      <summary>{say("pose-sure")}</summary>
      <div class="grid grid--close below">
        <TextField
          says="pose-u-tape"
          unit={unit}
          {...field("uReferenceHeight")}
          placeholder={smallText(U_TAPE_M)}
        />
        <TextField says="pose-u-lean" unit="°" {...field("uLean")} problem={problems.uncertainty} />
        <TextField
          says="pose-u-square"
          unit={unit}
          {...field("uSquare")}
          placeholder={say("percent", { percent: fixed(0.1, 1) })}
        />
        <TextField says="pose-u-bow" unit={unit} {...field("uBow")} placeholder={smallText(U_BOW_M)} />
      </div>
      <p class="field__hint">{say("pose-u-hint")}</p>
    </details>
  );
}

function Run({ model }: { model: PoseModel }) {
  const locked = !canWork.value;
  const again = model.reel.recording.value?.pose_id != null && model.pose.value !== null;
  return (
    <footer class="stack stack--tight pose-form__foot">
      {model.job.value?.state === "failed" && (
        <Notice kind="problem">{sentenceOf(model.job.value.error)}</Notice>
      )}
      {model.job.value?.state === "cancelled" && <Notice>{say("pose-stopped")}</Notice>}
      {model.running.value && model.job.value ? (
        <JobProgress job={model.job.value} onCancel={() => model.cancel()} />
      ) : (
        <span data-testid="pose-run">
          <Button
            says={again ? "pose-find-again" : "pose-find"}
            kind={again ? "plain" : "primary"}
            type="submit"
            disabled={locked}
          />
        </span>
      )}
      {locked && <p class="small muted">{say("pose-look-only")}</p>}
    </footer>
  );
}

function count(text: string): number {
  const value = Number.parseInt(text, 10);
  return Number.isFinite(value) ? Math.min(Math.max(value, 0), 60) : 0;
}

function span(first: number | null, last: number | null): string {
  if (first === null) return say("pose-not-marked");
  const first_frame = String(first);
  if (last === null) return say("pose-end-not-marked", { first_frame });
  return say("pose-marked", { first_frame, last_frame: String(last), count: last - first + 1 });
}
