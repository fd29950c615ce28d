/** The questions about the board, in the order of work, in words and with a drawing. */

import { Button, JobProgress, Notice, Segments, SelectField, TextField } from "../../components";
import { hint } from "../../core/commands";
import { canWork } from "../../core/session";
import { lengthText, lengthUnit, plural } from "../../core/units";
import { KindField, MarkerFields } from "../../parts/boards/MarkerFields";
import { BoardDrawing } from "./BoardDrawing";
import { U_BOW_M, U_TAPE_M } from "./form";
import type { PoseModel } from "./model";

export function PoseForm({ model }: { model: PoseModel }) {
  return (
    <form
      class="pose-form"
      onSubmit={(event) => {
        event.preventDefault();
        void model.run();
      }}
    >
      <LensQuestions model={model} />
      <BoardQuestions model={model} />
      <SpanQuestions model={model} />
      <HeightQuestions model={model} />
      <Run model={model} />
    </form>
  );
}

/** A problem is said once the person has tried, not while the form is being filled in. */
function shown(model: PoseModel, problem: string | null): string | null {
  return model.tried.value ? problem : null;
}

function LensQuestions({ model }: { model: PoseModel }) {
  const form = model.form.value;
  const problems = model.problems.value;
  const locked = !canWork.value;
  return (
    <fieldset disabled={locked}>
      <legend>Recording and lens</legend>
      <SelectField
        label="Recording"
        value={String(model.reel.recording.value?.id ?? "")}
        options={model.reel.recordings.value.map((one) => ({
          value: String(one.id),
          label: one.name,
          disabled: one.state !== "ready",
        }))}
        onChange={(id) => void model.openRecording(Number(id))}
      />
      <SelectField
        label="Calibration"
        value={String(form.calibrationId ?? "")}
        problem={shown(model, problems.calibration)}
        options={[
          ...(form.calibrationId === null ? [{ value: "", label: "none yet" }] : []),
          ...model.calibrations.value.map((one) => ({
            value: String(one.id),
            label: `${one.camera}, ${one.id}${one.current ? ", current" : ""}${one.trusted ? "" : ", not to be trusted"}`,
          })),
        ]}
        onChange={(id) => model.set({ calibrationId: id === "" ? null : Number(id) })}
      />
    </fieldset>
  );
}

function BoardQuestions({ model }: { model: PoseModel }) {
  const form = model.form.value;
  const problems = model.problems.value;
  const unit = lengthUnit.value;
  const locked = !canWork.value;
  return (
    <fieldset disabled={locked}>
      <legend>The board</legend>
      <KindField value={form} change={(part) => model.set(part)} disabled={locked} />
      <div class="pose-form__three">
        <TextField
          label="Inner corners across"
          numeric
          value={String(form.columns || "")}
          onInput={(text) => model.set({ columns: count(text) })}
        />
        <TextField
          label="and down"
          numeric
          value={String(form.rows || "")}
          onInput={(text) => model.set({ rows: count(text) })}
          problem={problems.board}
        />
        <TextField
          label="Square"
          numeric
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
        Inner corners are where four squares meet: a board of 10 by 7 squares has 9 by 6.{" "}
        {form.kind === "charuco" && "A road pose needs the whole board in sight."}
      </p>
    </fieldset>
  );
}

function SpanQuestions({ model }: { model: PoseModel }) {
  const form = model.form.value;
  const problems = model.problems.value;
  const locked = !canWork.value;
  return (
    <fieldset disabled={locked}>
      <legend>Frames in which it stands still</legend>
      <div class="row row--wrap">
        <Button
          small
          title={`The first frame${hint("passBegin")}`}
          onClick={() => model.mark("first")}
          disabled={locked}
        >
          Begins here
        </Button>
        <Button
          small
          title={`The last frame${hint("passEnd")}`}
          onClick={() => model.mark("last")}
          disabled={locked}
        >
          Ends here
        </Button>
        <span class="nowrap" data-testid="pose-span">
          {span(form.first, form.last)}
        </span>
      </div>
      {shown(model, problems.span) && <p class="field__problem">{problems.span}</p>}
    </fieldset>
  );
}

function HeightQuestions({ model }: { model: PoseModel }) {
  const form = model.form.value;
  const problems = model.problems.value;
  const unit = lengthUnit.value;
  const locked = !canWork.value;
  return (
    <fieldset disabled={locked}>
      <legend>How high it stands</legend>
      <Segments
        label="Reference row"
        value={form.reference}
        options={[
          { value: "bottom", label: "lowest row of corners" },
          { value: "top", label: "uppermost row" },
        ]}
        onChange={(reference) => model.set({ reference })}
        disabled={locked}
      />
      <BoardDrawing
        reference={form.reference}
        columns={form.columns}
        rows={form.rows}
        markers={form.kind === "charuco"}
      />
      <TextField
        label={`From the road up to the ${form.reference === "top" ? "uppermost" : "lowest"} row of inner corners`}
        numeric
        unit={unit}
        value={form.referenceHeight}
        onInput={(referenceHeight) => model.set({ referenceHeight })}
        problem={shown(model, problems.referenceHeight)}
      />
      <SurenessQuestions model={model} />
    </fieldset>
  );
}

function SurenessQuestions({ model }: { model: PoseModel }) {
  const form = model.form.value;
  const problems = model.problems.value;
  const unit = lengthUnit.value;
  return (
    <details>
      <summary>How sure these are</summary>
      <div class="pose-form__two">
        <TextField
          label="± of the tape"
          numeric
          unit={unit}
          value={form.uReferenceHeight}
          onInput={(uReferenceHeight) => model.set({ uReferenceHeight })}
          placeholder={lengthText(U_TAPE_M)}
        />
        <TextField
          label="± of the lean"
          numeric
          unit="°"
          value={form.uLean}
          onInput={(uLean) => model.set({ uLean })}
          problem={problems.uncertainty}
        />
        <TextField
          label="± of a square"
          numeric
          unit={unit}
          value={form.uSquare}
          onInput={(uSquare) => model.set({ uSquare })}
          placeholder="0.1 %"
        />
        <TextField
          label="± of the bow"
          numeric
          unit={unit}
          value={form.uBow}
          onInput={(uBow) => model.set({ uBow })}
          placeholder={lengthText(U_BOW_M)}
        />
      </div>
      <p class="field__hint">
        Standard uncertainties, all estimates until you measure them: 3 mm is a steel tape read with care on
        asphalt; 0.3° is a board set with a good spirit level, towards the camera and sideways alike; a print
        is true to 0.1 % of a square; the middle of a stiff board is out of plane by 0.5 mm. Each goes into
        every height's budget under its own name.
      </p>
    </details>
  );
}

function Run({ model }: { model: PoseModel }) {
  const locked = !canWork.value;
  const again = model.reel.recording.value?.pose_id != null && model.pose.value !== null;
  return (
    <footer class="pose-form__foot">
      {model.job.value?.state === "failed" && <Notice kind="problem">{model.job.value.error}</Notice>}
      {model.job.value?.state === "cancelled" && <Notice>Stopped; nothing was changed.</Notice>}
      {model.running.value && model.job.value ? (
        <JobProgress job={model.job.value} onCancel={() => model.cancel()} />
      ) : (
        <span data-testid="pose-run">
          <Button kind={again ? "plain" : "primary"} type="submit" disabled={locked}>
            {again ? "Find the road pose again" : "Find the road pose"}
          </Button>
        </span>
      )}
      {locked && <p class="small muted">You may look; an operator finds the pose.</p>}
    </footer>
  );
}

function count(text: string): number {
  const value = Number.parseInt(text, 10);
  return Number.isFinite(value) ? Math.min(Math.max(value, 0), 60) : 0;
}

function span(first: number | null, last: number | null): string {
  if (first === null) return "not marked yet";
  if (last === null) return `from ${first}, end not marked`;
  return `${first} to ${last}, ${plural(last - first + 1, "frame")}`;
}
