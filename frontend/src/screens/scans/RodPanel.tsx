/** The line camera's calibration: where the rod stood, its marks with their residuals, and what they give. */
import { Button, Empty, Notice, TableScroll } from "../../components";
import { CommitField } from "../../components/CommitField";
import type { RodMark } from "../../core/types";
import {
  fixed,
  formatHeight,
  formatLength,
  lengthText,
  lengthUnit,
  parseLength,
  parseNumber,
} from "../../core/units";
import type { ScanModel } from "./model";

const DEGREE = Math.PI / 180;

export function RodPanel({ model }: { model: ScanModel }) {
  const { rod } = model;
  const { marks } = rod.values.value;
  const solved = rod.solved.value;
  return (
    <aside class="scan__side" aria-label="Calibration of the height">
      <header class="vehicle__head">
        <h2>Calibrate the height</h2>
        <span class="grow" />
        <Button small kind="quiet" onClick={() => model.cancel()}>
          Close
        </Button>
      </header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, so the keyboard must reach it */}
      <div class="scan__body stack" role="group" aria-label="Marks of the rod" tabIndex={0}>
        <NextMark model={model} />
        {marks.length === 0 ? (
          <Empty title="No marks yet">
            <p>
              Enter how far the rod stood from camera 1, then click its marks from the foot up. Do the same
              where it stood at another distance.
            </p>
          </Empty>
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

const positive: Check = (text) => ((parseLength(text) ?? 0) > 0 ? null : "A length, such as 2.70.");
const any: Check = (text) => (parseLength(text) === null ? "A length, such as 0.50." : null);
const NEXT: readonly { name: NextName; label: string; check: Check }[] = [
  { name: "distance_m", label: "Rod's distance", check: positive },
  { name: "height_m", label: "Mark's height", check: any },
  { name: "step_m", label: "Then higher by", check: any },
];

function NextMark({ model }: { model: ScanModel }) {
  const { next } = model.rod;
  const unit = lengthUnit.value;
  const put = (name: NextName) => (text: string) => {
    const value = parseLength(text);
    if (value === null) return;
    // another distance begins at the foot
    next.value = { ...next.value, ...(name === "distance_m" ? { height_m: 0 } : {}), [name]: value };
  };
  return (
    <section aria-label="Next mark">
      <div class="rod__fields">
        {NEXT.map(({ name, label, check }) => (
          <CommitField
            key={name}
            label={label}
            value={lengthText(next.value[name])}
            numeric
            unit={unit}
            check={check}
            onCommit={put(name)}
          />
        ))}
      </div>
      <p class="small muted">
        Distances run level from the camera's centre. A checkerboard held upright will do as well: “higher by”
        is then the size of its squares.
      </p>
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
    <section aria-label="Marks">
      <TableScroll label="Marks">
        <table class="table table--dense" data-testid="rod-marks">
          <thead>
            <tr>
              <th class="num">distance</th>
              <th class="num">height</th>
              <th class="num">row</th>
              <th class="num">residual</th>
              <th aria-label="remove" />
            </tr>
          </thead>
          <tbody>
            {marks.map((mark, index) => {
              const residual = residuals[index];
              const worst = residual !== undefined && Math.abs(residual) === largest && largest > 1;
              return (
                <tr key={index}>
                  <td class="num">{formatLength(mark.distance_m, 3)}</td>
                  <td class="num">{formatLength(mark.height_m, 3)}</td>
                  <td class="num">{fixed(mark.row_px, 1)}</td>
                  <td class="num">
                    {residual === undefined ? (
                      "–"
                    ) : (
                      <span class={worst ? "rod__worst" : ""}>{fixed(residual, 2)} px</span>
                    )}
                  </td>
                  <td>
                    <Button
                      small
                      kind="quiet"
                      icon="trash"
                      label={`Remove mark ${index + 1}`}
                      onClick={() => model.rod.remove(index)}
                    />
                  </td>
                </tr>
              );
            })}
          </tbody>
        </table>
      </TableScroll>
    </section>
  );
}

function Result({ model }: { model: ScanModel }) {
  const { rod } = model;
  const solved = rod.solved.value;
  const marks = rod.values.value.marks.length;
  return (
    <section class="stack" aria-label="What the marks give" aria-live="polite">
      {solved?.status === "ok" && (
        <dl class="facts small">
          <dt>Camera's height</dt>
          <dd>
            <strong data-testid="rod-camera-height">
              {formatHeight(solved.camera_height_m, solved.U95_camera_height_m)}
            </strong>
          </dd>
          <dt>Residuals</dt>
          <dd>{fixed(solved.rms_px ?? 0, 2)} px rms</dd>
        </dl>
      )}
      {solved && solved.status !== "ok" && marks > 0 && <Notice>{solved.reason}</Notice>}
      {solved?.warnings.map((one) => (
        <Notice key={one} kind="warning">
          {one}
        </Notice>
      ))}
      <div class="row row--wrap">
        <Button
          kind="primary"
          busy={model.busy.value}
          disabled={solved?.status !== "ok" || !rod.changed.value}
          onClick={() => void rod.store()}
        >
          Store the calibration
        </Button>
        {marks > 0 && <Button onClick={() => rod.clear()}>Remove all marks</Button>}
        {rod.changed.value && model.heights.pose.value && (
          <Button kind="quiet" onClick={() => rod.reset()}>
            Back to what is stored
          </Button>
        )}
      </div>
    </section>
  );
}

function Uncertainties({ model }: { model: ScanModel }) {
  const { rod } = model;
  const unit = lengthUnit.value;
  const { sigma_px, u_distance_m, u_lean_rad } = rod.values.value;
  const atLeast = (least: number) => (text: string) => {
    const value = parseNumber(text);
    return value === null || value < least ? `A number from ${least}, please.` : null;
  };
  return (
    <section class="rod__fields" aria-label="Standard uncertainties">
      <CommitField
        label="u of a mark's row"
        value={String(sigma_px)}
        numeric
        unit="px"
        check={atLeast(0.01)}
        onCommit={(text) => rod.change({ sigma_px: parseNumber(text) ?? sigma_px })}
      />
      <CommitField
        label="u of a distance"
        value={lengthText(u_distance_m)}
        numeric
        unit={unit}
        check={(text) => ((parseLength(text) ?? -1) < 0 ? "A length, such as 0.005." : null)}
        onCommit={(text) => rod.change({ u_distance_m: parseLength(text) ?? u_distance_m })}
      />
      <CommitField
        label="u of the rod's lean"
        value={String(Number((u_lean_rad / DEGREE).toFixed(3)))}
        numeric
        unit="°"
        check={atLeast(0)}
        onCommit={(text) => rod.change({ u_lean_rad: (parseNumber(text) ?? 0) * DEGREE })}
      />
    </section>
  );
}
