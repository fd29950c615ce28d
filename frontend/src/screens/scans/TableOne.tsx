/** The vehicles in the layout of the paper's Table I, the printed table beside them. */
import { DataTable, Panel } from "../../components";
import { say, withUnit } from "../../core/messages";
import type { ScanStatistics } from "../../core/types";
import { fixed, heads, plainAcceleration, plainLength, plainSpeed, speedScale } from "../../core/units";
import { vehicleName } from "../../core/words";
import { SOURCE_WORDS } from "./referenceWords";

export function TableOne({ found }: { found: ScanStatistics }) {
  return (
    <Panel says="motion-paper-title">
      <div class="grid grid--fit scan-tables" style={{ "--least": "600px" }}>
        <Own found={found} />
        <Printed found={found} />
      </div>
      <p class="panel__note small muted">{say("paper-sizes")}</p>
    </Panel>
  );
}

const speedHead = () => withUnit(say("motion-head-speed"), heads().speed);
const accelerationHead = () => withUnit(say("motion-head-acceleration"), heads().acceleration);
const lengthHead = (of: "motion-head-size" | "motion-head-true") => withUnit(say(of), heads().length);

function Own({ found }: { found: ScanStatistics }) {
  return (
    <DataTable
      label={say("motion-paper-own")}
      data-testid="scan-table-own"
      rows={found.table}
      keyOf={(row) => row.vehicle_id}
      columns={({ col, num }) => [
        col(say("motion-head-vehicle"), (row) => vehicleName(row.number)),
        num(speedHead(), (row) => plainSpeed(row.speed_mps)),
        num(accelerationHead(), (row) => plainAcceleration(row.acceleration_mps2)),
        num(lengthHead("motion-head-size"), (row) => plainLength(row.length_m)),
        col(say("motion-head-reference"), (row) => speedsOf(row.references)),
        num(lengthHead("motion-head-true"), (row) => plainLength(row.true_length_m)),
        num(say("motion-head-fit-error"), (row) =>
          row.fit_error_percent === null ? "–" : fixed(row.fit_error_percent, 2),
        ),
      ]}
    />
  );
}

function speedsOf(references: ScanStatistics["table"][number]["references"]): string {
  return references
    .filter((one) => one.quantity === "speed")
    .map((one) => `${plainSpeed(one.value)} ${SOURCE_WORDS[one.source]}`)
    .join(", ");
}

function Printed({ found }: { found: ScanStatistics }) {
  return (
    <DataTable
      label={say("motion-paper-printed")}
      rows={found.paper}
      keyOf={(row) => row.car_id}
      columns={({ col, num }) => [
        col(say("motion-head-car"), (row) => row.car_id),
        num(speedHead(), (row) => plainSpeed(row.speed_kmh / speedScale("m")[0])),
        num(accelerationHead(), (row) => plainAcceleration(row.acceleration_mps2)),
        num(lengthHead("motion-head-size"), (row) => plainLength(row.size_m)),
        col(say("motion-head-counter"), (row) =>
          row.counter === "breaking" ? say("motion-counter-braking") : (row.counter ?? ""),
        ),
        num(lengthHead("motion-head-true"), (row) => plainLength(row.true_length_m)),
        num(say("motion-head-fit-error"), (row) => fixed(row.fit_error_percent, 2)),
      ]}
    />
  );
}
