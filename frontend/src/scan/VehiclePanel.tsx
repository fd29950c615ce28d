/** The chosen vehicle: its numbers, what is known of it, profile, match, budget, history, and the verdict. */
import { Button, Loading, Notice, StateMark, TableScroll } from "../components";
import { hint } from "../keys";
import { CatalogueField } from "../measure/CatalogueField";
import { CommitField } from "../measure/CommitField";
import { canWork } from "../state/session";
import { formatMoment } from "../times";
import type { ScanMotion, ScanVehicle, ScanVehicleDetail } from "../types";
import { fixed, formatLength, formatSmall, lengthUnit, parseLength } from "../units";
import { MatchPictures } from "./MatchPictures";
import type { ScanModel } from "./model";
import { ProfileFigure } from "./ProfileFigure";
import { Verdict } from "./Verdict";
import { causeWords, formatAcceleration, formatMeasured, formatSeconds, formatSpeed, stateOf } from "./words";

export function VehiclePanel({ model }: { model: ScanModel }) {
  const vehicle = model.chosen.value;
  const detail = model.detail.value;
  if (!vehicle) {
    return (
      <aside class="scan__side scan__side--empty" aria-label="Vehicle">
        <p class="muted">
          Choose a vehicle in the list or in the picture{hint("passNext")}: its motion, the fit and the gaps
          come here.
        </p>
      </aside>
    );
  }
  const m = vehicle.measurement;
  return (
    <aside class="scan__side" aria-label="Vehicle" key={vehicle.id}>
      <header class="vehicle__head">
        <h2>
          {String(vehicle.number).padStart(2, "0")}{" "}
          <span class="muted">{[vehicle.make, vehicle.model].filter(Boolean).join(" ")}</span>
        </h2>
        <StateMark state={stateOf(vehicle)} />
      </header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, so the keyboard must reach it */}
      <div class="scan__body stack" role="group" aria-label="Motion and history" tabIndex={0}>
        {m && <Numbers m={m} vehicle={vehicle} />}
        {m && <Verdict model={model} m={m} />}
        {canWork.value && <Tools model={model} m={m} />}
        <Known model={model} vehicle={vehicle} />
        {detail ? (
          <>
            {m?.status === "ok" && <ProfileFigure detail={detail} />}
            <MatchPictures detail={detail} />
            {m?.status === "ok" && <Budget detail={detail} />}
            <History detail={detail} />
          </>
        ) : (
          <Loading what="the fit" />
        )}
      </div>
    </aside>
  );
}

function Numbers({ m, vehicle }: { m: ScanMotion; vehicle: ScanVehicle }) {
  const gap = vehicle.gap;
  return (
    <section aria-label="Motion">
      {m.status === "ok" ? (
        <p class="review__height" data-testid="scan-speed">
          {formatSpeed(m.speed_mps, m.U95_speed_mps, 2)}
        </p>
      ) : (
        <Notice kind="warning" title="Not measurable">
          {m.reason}
        </Notice>
      )}
      {m.warnings.map((one) => (
        <Notice key={one} kind="warning">
          {one}
        </Notice>
      ))}
      {m.older && (
        <Notice>
          Measured with other values of the rig than the recording has now; measure again to bring it up.
        </Notice>
      )}
      <dl class="facts small">
        {m.status === "ok" && (
          <>
            <dt>Length</dt>
            <dd data-testid="scan-length">{formatMeasured(m.length_m, m.U95_length_m)}</dd>
            <dt>Acceleration</dt>
            <dd>{formatAcceleration(m.acceleration_mps2, m.U95_acceleration_mps2)}</dd>
            <dt>Wheelbase</dt>
            <dd data-testid="scan-wheelbase">
              {m.wheelbase_m === null ? "not clicked" : formatMeasured(m.wheelbase_m, m.U95_wheelbase_m)}
            </dd>
          </>
        )}
        <dt>Time gap</dt>
        <dd>
          {gap?.time_gap_s == null ? (gap?.reason ?? "the first vehicle") : formatSeconds(gap.time_gap_s, 3)}
        </dd>
        {gap?.time_gap_s != null && (
          <>
            <dt>Distance gap</dt>
            <dd>
              {gap.distance_gap_m === null ? gap.reason : formatLength(gap.distance_gap_m, 2)}
              {gap.paper_distance_gap_m !== null && (
                <span class="muted"> (by mean speed {formatLength(gap.paper_distance_gap_m, 2)})</span>
              )}
            </dd>
            <dt>Headway</dt>
            <dd>{formatSeconds(gap.headway_s, 3)}</dd>
          </>
        )}
        <dt>By</dt>
        <dd>
          {causeWords(m)}
          {m.fit_error_percent !== null && <>; scatter of the blocks {fixed(m.fit_error_percent, 2)} %</>}
        </dd>
        {m.misalignment_px !== null && (
          <>
            <dt>Misalignment</dt>
            <dd>
              {fixed(m.misalignment_px, 2)} px
              {m.u_misalignment_px !== null && ` (u ${fixed(m.u_misalignment_px, 2)} px)`}
            </dd>
          </>
        )}
      </dl>
    </section>
  );
}

function Tools({ model, m }: { model: ScanModel; m: ScanMotion | null }) {
  const wheels = model.mode.value === "wheels";
  return (
    <div class="row row--wrap">
      <Button small title={`Fill the window${hint("scanFit")}`} onClick={() => model.show("fit")}>
        Show
      </Button>
      {m?.status === "ok" && (
        <Button
          small
          pressed={wheels}
          title={`Click both hubs${hint("scanWheels")}`}
          onClick={() => model.start("wheels")}
        >
          {m.wheelbase_m === null ? "Click the wheels" : "Click the wheels again"}
        </Button>
      )}
      <Button
        small
        icon="trash"
        title={`Take the vehicle out${hint("remove")}`}
        onClick={() => void model.remove()}
      >
        Take out
      </Button>
    </div>
  );
}

function Known({ model, vehicle }: { model: ScanModel; vehicle: ScanVehicle }) {
  const disabled = !canWork.value;
  const unit = lengthUnit.value;
  const length = (value: number | null) =>
    value === null ? "" : fixed(unit === "ft" ? value / 0.3048 : value, 3);
  const wrong = (text: string) => (text === "" || (parseLength(text) ?? 0) > 0 ? null : "This is no length.");
  const put = (name: "true_length_m" | "true_wheelbase_m") => (text: string) =>
    void model.fillIn({ [name]: text.trim() === "" ? null : parseLength(text) });
  return (
    <section class="scan__known" aria-label="What is known of the vehicle">
      <CatalogueField
        label="Make"
        value={vehicle.make ?? ""}
        query={(text) => text}
        disabled={disabled}
        onChoose={(row) => void model.fillIn({ catalogue_id: row.id })}
        onCommit={(make) => void model.fillIn({ make: make || null })}
      />
      <CatalogueField
        label="Model"
        value={vehicle.model ?? ""}
        query={(text) => `${vehicle.make ?? ""} ${text}`}
        disabled={disabled}
        onChoose={(row) => void model.fillIn({ catalogue_id: row.id })}
        onCommit={(name) => void model.fillIn({ model: name || null })}
      />
      <CommitField
        label="True length"
        value={length(vehicle.true_length_m)}
        numeric
        unit={unit}
        disabled={disabled}
        check={wrong}
        hint={off(vehicle.length_error_m)}
        onCommit={put("true_length_m")}
      />
      <CommitField
        label="True wheelbase"
        value={length(vehicle.true_wheelbase_m)}
        numeric
        unit={unit}
        disabled={disabled}
        check={wrong}
        hint={off(vehicle.wheelbase_error_m)}
        onCommit={put("true_wheelbase_m")}
      />
    </section>
  );
}

function off(metres: number | null): string | undefined {
  if (metres === null) return undefined;
  return `measured ${metres < 0 ? "" : "+"}${formatSmall(metres)}`;
}

function Budget({ detail }: { detail: ScanVehicleDetail }) {
  const m = detail.vehicle.measurement;
  return (
    <section class="panel" aria-labelledby="scan-budget">
      <header class="panel__head">
        <h3 id="scan-budget">Where the uncertainty comes from</h3>
        <span class="muted small">standard uncertainties</span>
      </header>
      <TableScroll label="Budget">
        <table class="table table--dense">
          <thead>
            <tr>
              <th>source</th>
              <th class="num">speed</th>
              <th class="num">acceleration</th>
              <th class="num">length</th>
            </tr>
          </thead>
          <tbody>
            {detail.budget.map((one) => (
              <tr key={one.source}>
                <td>{one.source}</td>
                <td class="num">{formatSpeed(one.u_speed_mps, null, 3)}</td>
                <td class="num">{formatAcceleration(one.u_acceleration_mps2)}</td>
                <td class="num">{formatSmall(one.u_length_m)}</td>
              </tr>
            ))}
            {m && (
              <tr>
                <td>
                  <strong>together</strong>
                </td>
                <td class="num">{formatSpeed(m.u_speed_mps, null, 3)}</td>
                <td class="num">{formatAcceleration(m.u_acceleration_mps2)}</td>
                <td class="num">{formatSmall(m.u_length_m)}</td>
              </tr>
            )}
          </tbody>
        </table>
      </TableScroll>
    </section>
  );
}

function History({ detail }: { detail: ScanVehicleDetail }) {
  const reviews = new Map(detail.reviews.map((one) => [one.revision, one]));
  return (
    <details open={detail.history.length > 1}>
      <summary>History ({detail.history.length})</summary>
      <ul class="scan__history small">
        {[...detail.history].reverse().map((one) => {
          const verdict = reviews.get(one.revision);
          return (
            <li key={one.id}>
              <strong>{one.status === "ok" ? formatSpeed(one.speed_mps, null, 2) : "not measurable"}</strong>,{" "}
              {formatLength(one.length_m)} <span class="muted">{causeWords(one)}</span>
              <br />
              <span class="muted">
                {one.created_by?.name ?? "the search"}, {formatMoment(one.created_at)}
                {verdict && `; ${verdict.verdict} by ${verdict.reviewer?.name ?? "somebody"}`}
                {verdict?.reason && `: ${verdict.reason}`}
              </span>
            </li>
          );
        })}
      </ul>
    </details>
  );
}
