import { useState } from "preact/hooks";
import { Button, DataTable, Loading, Notices, Problem, StateMark } from "../../components";
import { say, sentenceOf, wordsOf } from "../../core/messages";
import { useAsked } from "../../core/resource";
import { formatMoment } from "../../core/times";
import type { Calibration, CameraDetail, CameraView } from "../../core/types";
import { fixed, formatAway, formatLength } from "../../core/units";
import { CoverageMap } from "./CoverageMap";
import { apart, boardInWords, halvesInWords, heldOutInWords, px } from "./checks";
import { angleOfView, coveredShare, type Figure, figuresOf, worstView } from "./lens";
import { ViewPicture } from "./ViewPicture";

interface Props {
  id: number;
  camera: CameraDetail;
  makeCurrent?: (id: number) => Promise<unknown>;
}

/** What a calibration came to: verdict, figures with uncertainties, where the picture was covered, which view fits worst. */
export function CalibrationPanel({ id, camera, makeCurrent }: Props) {
  const calibration = useAsked("GET /calibrations/{calibration_id}", { calibration_id: id });
  if (!calibration.data) {
    return calibration.error ? (
      <Problem error={calibration.error} again={calibration.reload} />
    ) : (
      <div class="panel result-awaited">
        <Loading what={say("camera-loading-calibration")} />
      </div>
    );
  }
  const c = calibration.data;
  const inUse = camera.current_calibration_id === c.id;
  return (
    <section class="panel" aria-label={say("field-calibration")}>
      <header class="row row--apart row--far panel__head">
        <div>
          <h2 class="row">
            <StateMark
              state={c.trusted ? "trusted" : "not_trusted"}
              word={say(c.trusted ? "camera-trusted" : "camera-not-trusted")}
            />
          </h2>
          <p class="muted small">{madeWords(c)}</p>
        </div>
        <div class="row">
          <Button
            says="camera-download"
            small
            icon="download"
            href={`/api/calibrations/${c.id}/camera.json`}
            download
          />
          {inUse ? (
            <span class="badge badge--solid">{say("in-use")}</span>
          ) : (
            makeCurrent && <Button says="camera-use" onClick={() => void makeCurrent(c.id)} />
          )}
        </div>
      </header>
      <div class="panel__body stack">
        <p>{sentenceOf(c.summary)}</p>
        <Notices of={c.warnings} kind="warning" />
        <div class="result">
          <Figures calibration={c} />
          <Coverage calibration={c} />
        </div>
        <Checks calibration={c} />
        {c.views.length > 0 && <Views calibration={c} camera={camera} />}
      </div>
    </section>
  );
}

function madeWords({ source, created_at, created_by }: Calibration): string {
  const time = formatMoment(created_at);
  return created_by
    ? say("camera-made-by", { source, time, person: created_by.name })
    : say("camera-made", { source, time });
}

function Figures({ calibration }: { calibration: Calibration }) {
  const { document: lens, views } = calibration;
  const used = views.filter((view) => view.used).length;
  const figures = figuresOf(lens);
  const unknown = figures.every((figure) => figure.u === null);
  return (
    <div>
      <table class="table table--dense figures">
        <tbody>
          <tr>
            <th scope="row">{say("camera-residual")}</th>
            <td class="num">{lens.rms_px === null ? say("camera-not-told") : px(lens.rms_px)}</td>
            <td class="muted">
              {views.length > 0 && say("camera-views-used", { used, count: views.length })}
            </td>
          </tr>
          <tr>
            <th scope="row">{say("camera-picture")}</th>
            <td class="num">
              {lens.width_px} × {lens.height_px}
            </td>
            <td class="muted">
              {say("camera-across", { model: lens.model, angle: fixed(angleOfView(lens), 0) })}
            </td>
          </tr>
          {figures.map((figure) => (
            <FigureRow key={figure.name} figure={figure} />
          ))}
        </tbody>
      </table>
      {!unknown && <p class="small muted below">{say("camera-u-note")}</p>}
    </div>
  );
}

const MEANING: Partial<Record<string, string>> = wordsOf("camera-", "fx", "fy", "cx", "cy");

function FigureRow({ figure }: { figure: Figure }) {
  const digits =
    figure.u !== null && figure.u > 0
      ? Math.max(0, Math.min(6, 1 - Math.floor(Math.log10(figure.u))))
      : figure.digits;
  const value = fixed(figure.value, digits);
  return (
    <tr>
      <th scope="row">{MEANING[figure.name] ?? say("camera-distortion", { name: figure.name })}</th>
      <td class="num">{figure.unit === "px" ? say("value-px", { value }) : value}</td>
      <td class="muted nowrap">{figure.u !== null && say("camera-u", { u: fixed(figure.u, digits) })}</td>
    </tr>
  );
}

function Coverage({ calibration }: { calibration: Calibration }) {
  const { coverage, document: lens } = calibration;
  if (coverage.flat().every((count) => count === 0)) {
    return <p class="muted">{say("camera-coverage-unknown")}</p>;
  }
  return (
    <figure>
      <CoverageMap coverage={coverage} aspect={lens.width_px / lens.height_px} />
      <figcaption class="small muted below">
        {say("camera-coverage", { percent: fixed(coveredShare(coverage) * 100, 0) })}
      </figcaption>
      <Reshoot missing={calibration.reshoot} />
    </figure>
  );
}

/** Which pictures to take next, from the places and tilts that are missing. */
function Reshoot({ missing }: { missing: Calibration["reshoot"] }) {
  if (missing.length === 0) return <p class="small">{say("camera-covered")}</p>;
  return (
    <div class="reshoot small">
      <h3>{say("camera-reshoot")}</h3>
      <ul>
        {missing.map(sentenceOf).map((sentence) => (
          <li key={sentence}>{sentence}</li>
        ))}
      </ul>
    </div>
  );
}

/** Where the view's picture is: an image of the camera, or a frame of the recording; null if neither is known. */
function pictureOf(view: CameraView, calibration: Calibration, camera: CameraDetail): string | null {
  const image = camera.images.find((one) => one.id === view.image_id);
  if (image) return image.url;
  const { recording_id } = calibration;
  return recording_id !== null && view.frame !== null
    ? `/api/recordings/${recording_id}/frames/${view.frame}.jpg`
    : null;
}

function Views({ calibration, camera }: { calibration: Calibration; camera: CameraDetail }) {
  const worst = worstView(calibration.views);
  const [picked, setPicked] = useState<CameraView | null>(null);
  const shown = picked ?? worst;
  const most = Math.max(...calibration.views.map((view) => view.rms_px ?? 0), 1e-9);
  const leftOut = calibration.views.filter((view) => !view.used);
  return (
    <div class="views">
      <div>
        <h3>{say("camera-residuals")}</h3>
        <ol class="below tall bars">
          {calibration.views
            .filter((view) => view.used)
            .map((view) => (
              <li key={view.file}>
                <button
                  type="button"
                  class="bar"
                  aria-pressed={view === shown}
                  onClick={() => setPicked(view)}
                >
                  <span class="clip bar__name" title={view.file}>
                    {view.file}
                  </span>
                  <span class="bar__track" aria-hidden="true">
                    <span style={{ width: `${((view.rms_px ?? 0) / most) * 100}%` }} />
                  </span>
                  <span class="num">{px(view.rms_px)}</span>
                </button>
              </li>
            ))}
        </ol>
        {leftOut.length > 0 && (
          <details class="left-out small">
            <summary>{say("camera-left-out", { count: leftOut.length })}</summary>
            <dl>
              {leftOut.map((view) => (
                <div key={view.file}>
                  <dt>{view.file}</dt>
                  <dd class="muted">{sentenceOf(view.reason) ?? say("camera-no-reason")}</dd>
                </div>
              ))}
            </dl>
          </details>
        )}
      </div>
      {shown?.corners_px && shown.corners_px.length > 0 && (
        <ViewPicture
          view={shown}
          worst={shown === worst}
          lens={calibration.document}
          picture={pictureOf(shown, calibration, camera)}
        />
      )}
    </div>
  );
}

/** What speaks for or against a calibration: two halves calibrated separately, and how flat the board was. */
function Checks({ calibration }: { calibration: Calibration }) {
  const { cross_validation: halves, board_shape: shape } = calibration;
  if (!halves && !shape) return null;
  return (
    <section class="lens-checks" aria-label={say("camera-checks")}>
      {halves && (
        <div>
          <h3>{say("camera-halves")}</h3>
          <p>{halvesInWords(halves)}</p>
          {halves.held_out_rms_px !== null && <p>{heldOutInWords(halves)}</p>}
          {halves.height_differences.length > 0 && (
            <>
              <DataTable
                class="lens-checks__table"
                rows={halves.height_differences}
                keyOf={(d) => d.distance_m}
                columns={({ col, num }) => [
                  col(say("camera-vehicle-at"), (d) => formatAway(d.distance_m)),
                  num(say("camera-heights-differ"), (d) =>
                    d.difference_m === null ? say("camera-not-in-picture") : apart(d.difference_m),
                  ),
                  num(say("camera-expected"), (d) => apart(d.expected_m ?? null), "muted"),
                ]}
              />
              <p class="small muted">
                {say("camera-halves-note", {
                  eye: formatLength(1.16, 2),
                  camera: formatLength(1.5, 1),
                  board: formatAway(3),
                })}
              </p>
            </>
          )}
        </div>
      )}
      {shape && (
        <div>
          <h3>{say("camera-flatness")}</h3>
          <p>{boardInWords(shape)}</p>
        </div>
      )}
    </section>
  );
}
