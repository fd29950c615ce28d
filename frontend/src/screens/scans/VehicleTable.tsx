/** The vehicles in the order in which they passed, with the gaps between them. */
import { StateMark, TableScroll } from "../../components";
import { useRowsIn } from "../../components/oneTabStop";
import { Said } from "../../components/Said";
import { say, sentenceOf, withUnit } from "../../core/messages";
import { formatPlaceClock, formatPlaceMoment } from "../../core/times";
import type { ScanVehicle } from "../../core/types";
import { fixed, formatSeconds, heads, plainAcceleration, plainLength, plainSpeed } from "../../core/units";
import { vehicleName } from "../../core/words";
import { OtherWay } from "../../parts/OtherWay";
import type { ScanModel } from "./model";
import { stateOf } from "./words";

export function VehicleTable({ model }: { model: ScanModel }) {
  const units = heads();
  const box = useRowsIn<HTMLTableSectionElement>(".scan__pick", "data-vehicle", model.chosenId);
  const vehicles = model.vehicles.value;
  const clock = model.scan.value?.started_at != null;
  const lanes = (model.scan.value?.rig.lanes.length ?? 0) > 0;
  return (
    <TableScroll label={say("scan-vehicles")} class="scan__table">
      <table class="table table--dense">
        <thead>
          <tr>
            <th>{say("scan-head-number")}</th>
            <th class="num">{clock ? say("scan-head-clock") : withUnit(say("scan-head-time"), "s")}</th>
            <th class="num">{withUnit(say("scan-head-speed"), units.speed)}</th>
            <th class="num">{withUnit(say("scan-head-acceleration"), units.acceleration)}</th>
            <th class="num">{withUnit(say("scan-head-length"), units.length)}</th>
            <th class="num">{withUnit(say("scan-head-gap"), "s")}</th>
            <th class="num">{withUnit(say("scan-head-distance-gap"), units.length)}</th>
            {/* there is room for one of the two; the headway stands in the panel */}
            {lanes ? (
              <th>{say("scan-lane")}</th>
            ) : (
              <th class="num">{withUnit(say("scan-head-headway"), "s")}</th>
            )}
            <th>{say("scan-head-state")}</th>
          </tr>
        </thead>
        <tbody ref={box}>
          {vehicles.map((vehicle) => (
            <Row key={vehicle.id} vehicle={vehicle} model={model} lanes={lanes} />
          ))}
        </tbody>
      </table>
    </TableScroll>
  );
}

function since(m: ScanVehicle["measurement"]): string {
  return m ? fixed(m.time_s, 2) : "–";
}

function timeTitle({ filmed_at, measurement }: ScanVehicle): string | undefined {
  if (!filmed_at || !measurement) return undefined;
  const time = formatPlaceMoment(filmed_at);
  return say("scan-time-title", { time, since: formatSeconds(measurement.time_s) });
}

function Row({ vehicle, model, lanes }: { vehicle: ScanVehicle; model: ScanModel; lanes: boolean }) {
  const here = model.chosenId.value === vehicle.id;
  const m = vehicle.measurement;
  const gap = vehicle.gap;
  const waiting = model.heights.kept.waitingOf(vehicle.id);
  return (
    <tr
      data-vehicle={vehicle.id}
      data-testid={`scan-vehicle-${vehicle.number}`}
      class="scan__row"
      aria-current={here}
      onClick={() => model.choose(vehicle.id)}
    >
      <td>
        <button type="button" class="scan__pick" aria-pressed={here} onClick={() => model.choose(vehicle.id)}>
          <Said
            what="scan-choose-vehicle"
            values={{ vehicle: vehicleName(vehicle.number) }}
            parts={{ hidden: (text) => <span class="visually-hidden">{text}</span> }}
          />
        </button>
      </td>
      <td class="num" title={timeTitle(vehicle)}>
        {vehicle.filmed_at ? formatPlaceClock(vehicle.filmed_at) : since(m)}
      </td>
      <td class="num nowrap">
        {m?.direction === "camera_2_first" && <OtherWay />}
        <strong>{plainSpeed(m?.speed_mps ?? null)}</strong>
      </td>
      <td class="num">{plainAcceleration(m?.acceleration_mps2 ?? null)}</td>
      <td class="num">{plainLength(m?.length_m ?? null)}</td>
      <td class="num" title={sentenceOf(gap?.reason) ?? undefined}>
        {gap?.time_gap_s == null ? "–" : fixed(gap.time_gap_s, 2)}
      </td>
      <td class="num" title={sentenceOf(gap?.reason) ?? undefined}>
        {plainLength(gap?.distance_gap_m ?? null, 1)}
      </td>
      {lanes ? (
        <td>{m?.lane ?? "–"}</td>
      ) : (
        <td class="num">{gap?.headway_s == null ? "–" : fixed(gap.headway_s, 2)}</td>
      )}
      <td class="nowrap">
        <StateMark state={stateOf(vehicle)} />
        {waiting > 0 && (
          <p class="small">
            <StateMark state="to_review" word={say("scan-heights-waiting", { count: waiting })} />
          </p>
        )}
      </td>
    </tr>
  );
}
