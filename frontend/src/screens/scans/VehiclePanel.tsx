/** The chosen vehicle: its numbers, what is known of it, profile, match, budget, history, and the verdict. */
import { Button, Loading, Notice, StateMark } from "../../components";
import { hint } from "../../core/commands";
import { canWork } from "../../core/session";
import type { ScanMotion, ScanVehicle } from "../../core/types";
import { fixed, formatAcceleration, formatLength, formatSpeed } from "../../core/units";
import { HeightList } from "./HeightList";
import { MatchPictures } from "./MatchPictures";
import type { ScanModel } from "./model";
import { ProfileFigure } from "./ProfileFigure";
import { Budget, History, Known } from "./VehicleParts";
import { Verdict } from "./Verdict";
import { causeWords, formatMeasured, formatSeconds, stateOf } from "./words";

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
        <HeightList model={model} />
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
    <section class="stack stack--tight" aria-label="Motion">
      {m.status === "ok" ? (
        <p class="vehicle__height" data-testid="scan-speed">
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
      {model.heights.pose.value && (
        <Button
          small
          pressed={model.mode.value === "height"}
          title={`Click a tyre's contact, then roof, eye and lamp${hint("scanHeight")}`}
          onClick={() => model.heights.begin(null)}
        >
          Measure heights
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
