import { useState } from "preact/hooks";
import { Button, Loading, Notice, Problem, StateMark } from "../../components";
import { api } from "../../core/api";
import { useResource } from "../../core/resource";
import { formatMoment } from "../../core/times";
import type { Calibration, CameraDetail, CameraView } from "../../core/types";
import { fixed, plural } from "../../core/units";
import { Checks } from "./Checks";
import { CoverageMap } from "./CoverageMap";
import { angleOfView, coveredShare, type Figure, figuresOf, worstView } from "./lens";
import { ViewPicture } from "./ViewPicture";

interface Props {
  id: number;
  camera: CameraDetail;
  makeCurrent?: (id: number) => Promise<void>;
}

/** What a calibration came to: verdict, figures with uncertainties, where the picture was covered, which view fits worst. */
export function CalibrationPanel({ id, camera, makeCurrent }: Props) {
  const calibration = useResource(
    (signal) => api.ask("GET /calibrations/{calibration_id}", { calibration_id: id }, { signal }),
    [id],
  );
  if (!calibration.data) {
    return calibration.error ? (
      <Problem error={calibration.error} again={calibration.reload} />
    ) : (
      <div class="panel result-awaited">
        <Loading what="the calibration" />
      </div>
    );
  }
  const c = calibration.data;
  const inUse = camera.current_calibration_id === c.id;
  return (
    <section class="panel" aria-label="Calibration">
      <header class="panel__head">
        <div>
          <h2 class="row">
            <StateMark
              state={c.trusted ? "trusted" : "not_trusted"}
              word={c.trusted ? "This calibration can be trusted" : "This calibration is not to be trusted"}
            />
          </h2>
          <p class="muted small">
            {c.source === "import" ? "Imported" : c.source === "clip" ? "From a recording" : "From images"},{" "}
            {formatMoment(c.created_at)}
            {c.created_by && `, ${c.created_by.name}`}
          </p>
        </div>
        {inUse ? (
          <span class="badge badge--solid">in use</span>
        ) : (
          makeCurrent && <Button onClick={() => void makeCurrent(c.id)}>Use this one</Button>
        )}
      </header>
      <div class="panel__body stack">
        {c.summary && <p>{c.summary}</p>}
        {c.warnings.map((warning) => (
          <Notice kind="warning" key={warning}>
            {warning}
          </Notice>
        ))}
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

function Figures({ calibration }: { calibration: Calibration }) {
  const { document: lens, views } = calibration;
  const used = views.filter((view) => view.used).length;
  const figures = figuresOf(lens);
  const unknown = figures.every((figure) => figure.u === null);
  return (
    <div>
      <table class="table figures">
        <tbody>
          <tr>
            <th scope="row">residual (rms)</th>
            <td class="num">{lens.rms_px === null ? "not told" : `${lens.rms_px.toFixed(3)} px`}</td>
            <td class="muted">{views.length > 0 && `${used} of ${plural(views.length, "view")} used`}</td>
          </tr>
          <tr>
            <th scope="row">picture</th>
            <td class="num">
              {lens.width_px} × {lens.height_px}
            </td>
            <td class="muted">
              {lens.model === "fisheye" ? "fisheye" : "ordinary lens"}, about {angleOfView(lens).toFixed(0)}°
              across
            </td>
          </tr>
          {figures.map((figure) => (
            <FigureRow key={figure.name} figure={figure} />
          ))}
        </tbody>
      </table>
      {!unknown && <p class="small muted figures__note">± is one standard uncertainty (k = 1).</p>}
    </div>
  );
}

const MEANING: Record<string, string> = {
  fx: "focal length, across",
  fy: "focal length, down",
  cx: "optical centre, across",
  cy: "optical centre, down",
};

function FigureRow({ figure }: { figure: Figure }) {
  const digits =
    figure.u !== null && figure.u > 0
      ? Math.max(0, Math.min(6, 1 - Math.floor(Math.log10(figure.u))))
      : figure.digits;
  return (
    <tr>
      <th scope="row">{MEANING[figure.name] ?? `distortion ${figure.name}`}</th>
      <td class="num">
        {fixed(figure.value, digits)} {figure.unit}
      </td>
      <td class="muted nowrap">{figure.u !== null && `± ${figure.u.toFixed(digits)}`}</td>
    </tr>
  );
}

function Coverage({ calibration }: { calibration: Calibration }) {
  const { coverage, document: lens } = calibration;
  if (coverage.flat().every((count) => count === 0)) {
    return (
      <p class="muted">Which parts of the picture the boards covered is not known for this calibration.</p>
    );
  }
  return (
    <figure>
      <CoverageMap coverage={coverage} aspect={lens.width_px / lens.height_px} />
      <figcaption class="small muted">
        Where corners were seen: {(coveredShare(coverage) * 100).toFixed(0)} % of the picture.
      </figcaption>
      <Reshoot missing={calibration.reshoot} />
    </figure>
  );
}

/** Which pictures to take next, from the places and tilts that are missing. */
function Reshoot({ missing }: { missing: string[] }) {
  if (missing.length === 0) return <p class="small">Every part of the picture was covered well enough.</p>;
  return (
    <div class="reshoot small">
      <h3>What to shoot again</h3>
      <ul>
        {missing.map((sentence) => (
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
        <h3>Residual of each view</h3>
        <ol class="bars">
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
                  <span class="num">{view.rms_px?.toFixed(3)} px</span>
                </button>
              </li>
            ))}
        </ol>
        {leftOut.length > 0 && (
          <details class="left-out">
            <summary>{plural(leftOut.length, "view")} left out</summary>
            <dl>
              {leftOut.map((view) => (
                <div key={view.file}>
                  <dt>{view.file}</dt>
                  <dd class="muted">{view.reason ?? "no reason told"}</dd>
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
