/** The chosen vehicle: its numbers, what is known of it, profile, match, budget, history, and the verdict. */
import { Button, Loading, Notice, StateMark } from "../../components";
import { Said } from "../../components/Said";
import { hint } from "../../core/commands";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import type { ScanMotion, ScanVehicle } from "../../core/types";
import { fixed, formatAcceleration, formatLength, formatSpeed } from "../../core/units";
import { vehicleName } from "../../core/words";
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
      <aside class="scan__side scan__side--empty" aria-label={say("scan-vehicle")}>
        <p class="muted">{say("scan-vehicle-none", { key: hint("passNext") })}</p>
      </aside>
    );
  }
  const m = vehicle.measurement;
  return (
    <aside class="scan__side" aria-label={say("scan-vehicle")} key={vehicle.id}>
      <header class="vehicle__head">
        <h2>
          {vehicleName(vehicle.number)}{" "}
          <span class="muted">{[vehicle.make, vehicle.model].filter(Boolean).join(" ")}</span>
        </h2>
        <StateMark state={stateOf(vehicle)} />
      </header>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, so the keyboard must reach it */}
      <div class="scan__body stack" role="group" aria-label={say("scan-vehicle-body")} tabIndex={0}>
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
          <Loading what={say("scan-fit-loading")} />
        )}
      </div>
    </aside>
  );
}

function Numbers({ m, vehicle }: { m: ScanMotion; vehicle: ScanVehicle }) {
  const gap = vehicle.gap;
  return (
    <section class="stack stack--tight" aria-label={say("scan-motion")}>
      {m.status === "ok" ? (
        <p class="vehicle__height" data-testid="scan-speed">
          {formatSpeed(m.speed_mps, m.U95_speed_mps, 2)}
        </p>
      ) : (
        <Notice kind="warning" title={say("scan-not-measurable")}>
          {m.reason}
        </Notice>
      )}
      {m.warnings.map((one) => (
        <Notice key={one} kind="warning">
          {one}
        </Notice>
      ))}
      {m.older && <Notice>{say("scan-older")}</Notice>}
      <dl class="facts small">
        {m.status === "ok" && (
          <>
            <dt>{say("scan-length")}</dt>
            <dd data-testid="scan-length">{formatMeasured(m.length_m, m.U95_length_m)}</dd>
            <dt>{say("scan-acceleration")}</dt>
            <dd>{formatAcceleration(m.acceleration_mps2, m.U95_acceleration_mps2)}</dd>
            <dt>{say("scan-wheelbase")}</dt>
            <dd data-testid="scan-wheelbase">
              {m.wheelbase_m === null
                ? say("scan-wheelbase-none")
                : formatMeasured(m.wheelbase_m, m.U95_wheelbase_m)}
            </dd>
          </>
        )}
        <dt>{say("scan-time-gap")}</dt>
        <dd>
          {gap?.time_gap_s == null
            ? (gap?.reason ?? say("scan-time-gap-first"))
            : formatSeconds(gap.time_gap_s, 3)}
        </dd>
        {gap?.time_gap_s != null && (
          <>
            <dt>{say("scan-distance-gap")}</dt>
            <dd>
              <DistanceGap gap={gap} />
            </dd>
            <dt>{say("scan-headway")}</dt>
            <dd>{formatSeconds(gap.headway_s, 3)}</dd>
          </>
        )}
        <dt>{say("scan-by")}</dt>
        <dd>
          {m.fit_error_percent === null
            ? causeWords(m)
            : say("scan-cause-scatter", { cause: causeWords(m), percent: fixed(m.fit_error_percent, 2) })}
        </dd>
        {m.misalignment_px !== null && (
          <>
            <dt>{say("scan-misalignment")}</dt>
            <dd>{misalignmentWords(m.misalignment_px, m.u_misalignment_px)}</dd>
          </>
        )}
      </dl>
    </section>
  );
}

function DistanceGap({ gap }: { gap: NonNullable<ScanVehicle["gap"]> }) {
  const words = gap.distance_gap_m === null ? gap.reason : formatLength(gap.distance_gap_m, 2);
  if (gap.paper_distance_gap_m === null) return <>{words}</>;
  return (
    <Said
      what="scan-distance-gap-paper"
      values={{ gap: words ?? "", paper_gap: formatLength(gap.paper_distance_gap_m, 2) }}
      parts={{ muted: (text) => <span class="muted">{text}</span> }}
    />
  );
}

function misalignmentWords(value: number, u: number | null): string {
  const value_px = fixed(value, 2);
  if (u === null) return say("value-px", { value: value_px });
  return say("scan-misalignment-u", { value_px, u_px: fixed(u, 2) });
}

function Tools({ model, m }: { model: ScanModel; m: ScanMotion | null }) {
  const wheels = model.mode.value === "wheels";
  return (
    <div class="row row--wrap">
      <Button small title={say("scan-show-title") + hint("scanFit")} onClick={() => model.show("fit")}>
        {say("scan-show")}
      </Button>
      {m?.status === "ok" && (
        <Button
          small
          pressed={wheels}
          title={say("scan-wheels-title") + hint("scanWheels")}
          onClick={() => model.start("wheels")}
        >
          {say(m.wheelbase_m === null ? "scan-wheels" : "scan-wheels-again")}
        </Button>
      )}
      {model.heights.pose.value && (
        <Button
          small
          pressed={model.mode.value === "height"}
          title={say("scan-heights-title") + hint("scanHeight")}
          onClick={() => model.heights.begin(null)}
        >
          {say("scan-heights-measure")}
        </Button>
      )}
      <Button
        small
        icon="trash"
        title={say("scan-take-out-title") + hint("remove")}
        onClick={() => void model.remove()}
      >
        {say("scan-take-out")}
      </Button>
    </div>
  );
}
