/** The vehicles in the layout of the paper's Table I, the printed table beside them. */
import { Panel, TableScroll } from "../../components";
import { say } from "../../core/messages";
import type { ScanStatistics } from "../../core/types";
import { fixed, heads, plainAcceleration, plainLength, plainSpeed, speedScale } from "../../core/units";
import { vehicleName } from "../../core/words";
import { SOURCE_WORDS } from "./referenceWords";

export function TableOne({ found }: { found: ScanStatistics }) {
  return (
    <Panel title={say("motion-paper-title")}>
      <div class="scan-tables">
        <Own found={found} />
        <Printed found={found} />
      </div>
      <p class="small muted scan-traffic__note">{found.paper_note}</p>
    </Panel>
  );
}

function Head({ first, counter }: { first: string; counter: string }) {
  const units = heads();
  return (
    <thead>
      <tr>
        <th>{first}</th>
        <th class="num">{say("with-unit", { name: say("motion-head-speed"), unit: units.speed })}</th>
        <th class="num">
          {say("with-unit", { name: say("motion-head-acceleration"), unit: units.acceleration })}
        </th>
        <th class="num">{say("with-unit", { name: say("motion-head-size"), unit: units.length })}</th>
        <th>{counter}</th>
        <th class="num">{say("with-unit", { name: say("motion-head-true"), unit: units.length })}</th>
        <th class="num">{say("motion-head-fit-error")}</th>
      </tr>
    </thead>
  );
}

function Own({ found }: { found: ScanStatistics }) {
  return (
    <TableScroll label={say("motion-paper-own")}>
      <table class="table" data-testid="scan-table-own">
        <Head first={say("motion-head-vehicle")} counter={say("motion-head-reference")} />
        <tbody>
          {found.table.map((row) => (
            <tr key={row.vehicle_id}>
              <td>{vehicleName(row.number)}</td>
              <td class="num">{plainSpeed(row.speed_mps)}</td>
              <td class="num">{plainAcceleration(row.acceleration_mps2)}</td>
              <td class="num">{plainLength(row.length_m)}</td>
              <td>{speedsOf(row.references)}</td>
              <td class="num">{plainLength(row.true_length_m)}</td>
              <td class="num">{row.fit_error_percent === null ? "–" : fixed(row.fit_error_percent, 2)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </TableScroll>
  );
}

/** "70.2 radar, 72.0 counter" */
function speedsOf(references: ScanStatistics["table"][number]["references"]): string {
  return references
    .filter((one) => one.quantity === "speed")
    .map((one) => `${plainSpeed(one.value)} ${SOURCE_WORDS[one.source]}`)
    .join(", ");
}

function Printed({ found }: { found: ScanStatistics }) {
  return (
    <TableScroll label={say("motion-paper-printed")}>
      <table class="table">
        <Head first={say("motion-head-car")} counter={say("motion-head-counter")} />
        <tbody>
          {found.paper.map((row) => (
            <tr key={row.car_id}>
              <td>{row.car_id}</td>
              <td class="num">{plainSpeed(row.speed_kmh / speedScale("m")[0])}</td>
              <td class="num">{plainAcceleration(row.acceleration_mps2)}</td>
              <td class="num">{plainLength(row.size_m)}</td>
              <td>{row.counter ?? ""}</td>
              <td class="num">{plainLength(row.true_length_m)}</td>
              <td class="num">{fixed(row.fit_error_percent, 2)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </TableScroll>
  );
}
