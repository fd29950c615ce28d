/** The line camera's calibration: where the rod stood, its marks with their residuals, and what they give. */
import { Button, DataTable, Empty, Facts, IconButton, Notice, Notices } from "../../components";
import { CommitField, LengthField } from "../../components/CommitField";
import { say, sentenceOf, wordsOf } from "../../core/messages";
import type { RodMark } from "../../core/types";
import { fixed, formatHeight, formatLength, localNumber, parseLength, parseNumber } from "../../core/units";
import type { ScanModel } from "./model";

const DEGREE = Math.PI / 180;

export function RodPanel({ model }: { model: ScanModel }) {
  const { rod } = model;
  const { marks } = rod.values.value;
  const solved = rod.solved.value;
  return (
    <aside class="desk__side scan__side" aria-label={say("scan-rod-label")}>
      <header class="row row--far vehicle__head">
        <h2>{say("scan-rod-title")}</h2>
        <span class="grow" />
        <Button says="action-close" small kind="quiet" onClick={() => model.cancel()} />
      </header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, so the keyboard must reach it */}
      <div class="pad scan__body stack" role="group" aria-label={say("scan-rod-body")} tabIndex={0}>
        <NextMark model={model} />
        {marks.length === 0 ? (
          <Empty says="scan-rod-none-title" why="scan-rod-none" />
        ) : (
          <Marks model={model} marks={marks} residuals={solved?.residuals_px ?? []} />
        )}
        <Result model={model} />
        <Uncertainties model={model} />
      </div>
    </aside>
  );
}

type NextName = "distance_m" | "height_m" | "step_m";
type Check = (text: string) => string | null;

const positive: Check = (text) =>
  (parseLength(text) ?? 0) > 0 ? null : say("length-problem", { example: localNumber("2.70") });
const any: Check = (text) =>
  parseLength(text) === null ? say("length-problem", { example: localNumber("0.50") }) : null;
const NEXT_WORDS = wordsOf("scan-rod-", "distance_m", "height_m", "step_m");
const NEXT: readonly { name: NextName; check: Check }[] = [
  { name: "distance_m", check: positive },
  { name: "height_m", check: any },
  { name: "step_m", check: any },
];

function NextMark({ model }: { model: ScanModel }) {
  const { next } = model.rod;
  const put = (name: NextName, value: number | null): void => {
    if (value === null) return;
    // another distance begins at the foot
    next.value = { ...next.value, ...(name === "distance_m" ? { height_m: 0 } : {}), [name]: value };
  };
  return (
    <section aria-label={say("scan-rod-next")}>
      <div class="grid grid--3 grid--tight grid--low rod__fields">
        {NEXT.map(({ name, check }) => (
          <LengthField
            key={name}
            label={NEXT_WORDS[name]}
            metres={next.value[name]}
            check={check}
            onCommit={(metres) => put(name, metres)}
          />
        ))}
      </div>
      <p class="small muted">{say("scan-rod-next-note")}</p>
    </section>
  );
}

interface MarksProps {
  model: ScanModel;
  marks: readonly RodMark[];
  residuals: readonly number[];
}

function Marks({ model, marks, residuals }: MarksProps) {
  const largest = Math.max(...residuals.map(Math.abs), 0);
  return (
    <section aria-label={say("scan-rod-marks")}>
      <DataTable
        label={say("scan-rod-marks")}
        class="table--dense"
        data-testid="rod-marks"
        rows={marks}
        keyOf={(_, index) => index}
        columns={({ num, actions }) => [
          num(say("scan-rod-head-distance"), (mark) => formatLength(mark.distance_m, 3)),
          num(say("scan-rod-head-height"), (mark) => formatLength(mark.height_m, 3)),
          num(say("scan-rod-head-row"), (mark) => fixed(mark.row_px, 1)),
          num(say("scan-rod-head-residual"), (_, index) => {
            const residual = residuals[index];
            if (residual === undefined) return "–";
            const worst = Math.abs(residual) === largest && largest > 1;
            const words = say("value-px", { value: fixed(residual, 2) });
            return <span class={worst ? "rod__worst" : ""}>{words}</span>;
          }),
          actions(say("scan-rod-head-remove"), (_, index) => (
            <IconButton
              icon="trash"
              label={say("scan-rod-remove", { number: String(index + 1) })}
              onClick={() => model.rod.remove(index)}
            />
          )),
        ]}
      />
    </section>
  );
}

function Result({ model }: { model: ScanModel }) {
  const { rod } = model;
  const solved = rod.solved.value;
  const marks = rod.values.value.marks.length;
  return (
    <section class="stack" aria-label={say("scan-rod-result")} aria-live="polite">
      {solved?.status === "ok" && (
        <Facts
          small
          of={[
            [
              say("scan-rod-camera-height"),
              <strong data-testid="rod-camera-height">
                {formatHeight(solved.camera_height_m, solved.U95_camera_height_m)}
              </strong>,
            ],
            [say("scan-rod-residuals"), say("scan-rod-rms", { rms_px: fixed(solved.rms_px ?? 0, 2) })],
          ]}
        />
      )}
      {solved && solved.status !== "ok" && marks > 0 && <Notice>{sentenceOf(solved.reason)}</Notice>}
      <Notices of={solved?.warnings} kind="warning" />
      <div class="row row--wrap">
        <Button
          says="scan-rod-store"
          kind="primary"
          busy={model.busy.value}
          disabled={solved?.status !== "ok" || !rod.changed.value}
          onClick={() => void rod.store()}
        />
        {marks > 0 && <Button says="scan-rod-clear" onClick={() => rod.clear()} />}
        {rod.changed.value && model.heights.kept.pose.value && (
          <Button says="scan-rod-reset" kind="quiet" onClick={() => rod.reset()} />
        )}
      </div>
    </section>
  );
}

function Uncertainties({ model }: { model: ScanModel }) {
  const { rod } = model;
  const { sigma_px, u_distance_m, u_lean_rad } = rod.values.value;
  const atLeast = (least: number) => (text: string) => {
    const value = parseNumber(text);
    return value === null || value < least ? say("scan-rod-at-least", { least: String(least) }) : null;
  };
  return (
    <section class="grid grid--3 grid--tight grid--low rod__fields" aria-label={say("scan-rod-u")}>
      <CommitField
        says="scan-rod-u-row"
        value={String(sigma_px)}
        unit={say("unit-px")}
        check={atLeast(0.01)}
        onCommit={(text) => rod.change({ sigma_px: parseNumber(text) ?? sigma_px })}
      />
      <LengthField
        says="scan-rod-u-distance"
        metres={u_distance_m}
        check={(text) =>
          (parseLength(text) ?? -1) < 0 ? say("length-problem", { example: localNumber("0.005") }) : null
        }
        onCommit={(metres) => rod.change({ u_distance_m: metres ?? u_distance_m })}
      />
      <CommitField
        says="scan-rod-u-lean"
        value={String(Number((u_lean_rad / DEGREE).toFixed(3)))}
        unit="°"
        check={atLeast(0)}
        onCommit={(text) => rod.change({ u_lean_rad: (parseNumber(text) ?? 0) * DEGREE })}
      />
    </section>
  );
}
