/** The vehicles in the order in which they passed, with the gaps between them. */
import { useSignalEffect } from "@preact/signals";
import { useRef } from "preact/hooks";
import { StateMark, TableScroll } from "../../components";
import type { ScanVehicle } from "../../core/types";
import { fixed, heads, plainAcceleration, plainLength, plainSpeed } from "../../core/units";
import type { ScanModel } from "./model";
import { stateOf } from "./words";

export function VehicleTable({ model }: { model: ScanModel }) {
  const units = heads();
  const box = useRef<HTMLTableSectionElement>(null);
  useSignalEffect(() => {
    const id = model.chosenId.value;
    requestAnimationFrame(() =>
      box.current?.querySelector(`[data-vehicle="${id}"]`)?.scrollIntoView({ block: "nearest" }),
    );
  });
  const vehicles = model.vehicles.value;
  return (
    <TableScroll label="Vehicles" class="scan__table">
      <table class="table table--dense">
        <thead>
          <tr>
            <th>no.</th>
            <th class="num">time (s)</th>
            <th class="num">speed ({units.speed})</th>
            <th class="num">acc. ({units.acceleration})</th>
            <th class="num">length ({units.length})</th>
            <th class="num">gap (s)</th>
            <th class="num">gap ({units.length})</th>
            <th class="num">headway (s)</th>
            <th>state</th>
          </tr>
        </thead>
        <tbody ref={box}>
          {vehicles.map((vehicle) => (
            <Row key={vehicle.id} vehicle={vehicle} model={model} />
          ))}
        </tbody>
      </table>
    </TableScroll>
  );
}

function Row({ vehicle, model }: { vehicle: ScanVehicle; model: ScanModel }) {
  const here = model.chosenId.value === vehicle.id;
  const m = vehicle.measurement;
  const gap = vehicle.gap;
  return (
    <tr
      data-vehicle={vehicle.id}
      data-testid={`scan-vehicle-${vehicle.number}`}
      class={here ? "scan__row scan__row--chosen" : "scan__row"}
      onClick={() => model.choose(vehicle.id)}
    >
      <td>
        <button type="button" class="scan__pick" aria-pressed={here} onClick={() => model.choose(vehicle.id)}>
          {String(vehicle.number).padStart(2, "0")}
          <span class="visually-hidden"> choose</span>
        </button>
      </td>
      <td class="num">{m ? fixed(m.time_s, 2) : "–"}</td>
      <td class="num">
        <strong>{plainSpeed(m?.speed_mps ?? null)}</strong>
      </td>
      <td class="num">{plainAcceleration(m?.acceleration_mps2 ?? null)}</td>
      <td class="num">{plainLength(m?.length_m ?? null)}</td>
      <td class="num" title={gap?.reason ?? undefined}>
        {gap?.time_gap_s == null ? "–" : fixed(gap.time_gap_s, 2)}
      </td>
      <td class="num" title={gap?.reason ?? undefined}>
        {plainLength(gap?.distance_gap_m ?? null, 1)}
      </td>
      <td class="num">{gap?.headway_s == null ? "–" : fixed(gap.headway_s, 2)}</td>
      <td>
        <StateMark state={stateOf(vehicle)} />
      </td>
    </tr>
  );
}
