/** What the traffic says of the pose, the vehicles with their headings, and the turn before it is accepted. */
import { Button, DataTable, Facts, named, num, SelectField, Table } from "../../components";
import { say, sentenceOf, sentencesOf } from "../../core/messages";
import { canWork } from "../../core/session";
import type { TurnedPose, Vehicle } from "../../core/types";
import { formatLength, formatSmall } from "../../core/units";
import { vehicleName } from "../../core/words";
import { formatDegrees, formatHeading } from "./angles";
import type { TrafficModel } from "./model";
import { TARGET_NAMES } from "./words";

export function TrafficSide({ model }: { model: TrafficModel }) {
  const preview = model.preview.value;
  return (
    <aside class="desk__side" aria-label={say("checks-direction")}>
      {model.reel.recordings.value.length > 1 && (
        <div class="stack stack--tight pad traffic__pose">
          <SelectField
            says="field-recording"
            hideLabel
            value={String(model.reel.recording.value?.id ?? "")}
            options={named(model.reel.recordings.value)}
            onInput={(id) => model.chooseRecording(Number(id))}
          />
        </div>
      )}
      {preview ? <Preview model={model} preview={preview} /> : <Verdict model={model} />}
      <Passes model={model} />
    </aside>
  );
}

function Verdict({ model }: { model: TrafficModel }) {
  const pose = model.pose.value;
  if (!pose) return null;
  return (
    <section class="stack stack--tight pad traffic__pose" aria-label={say("checks-verdict")}>
      <p class="traffic__verdict" data-testid="traffic-verdict">
        {sentencesOf(pose.verdict)}
      </p>
      {pose.mean_rad !== null && (
        <Facts
          small
          of={[
            [
              say("checks-mean"),
              say("value-u", { value: formatDegrees(pose.mean_rad), u: formatDegrees(pose.u_mean_rad) }),
            ],
            [say("checks-spread-of-vehicles"), formatDegrees(pose.spread_rad)],
            [
              say("checks-used-vehicles"),
              say("checks-used-of", { count: pose.used, all: pose.vehicles.length }),
            ],
          ]}
        />
      )}
      {pose.turned_from !== null && (
        <p class="small muted">
          {say("checks-turned-from", {
            turned: formatDegrees(pose.turned_by_rad),
            pose: String(pose.turned_from),
          })}
        </p>
      )}
      {canWork.value && (
        <div class="row row--wrap">
          {/* where the verdict says that none is needed, none is offered */}
          {pose.proposed && pose.mean_rad !== null && (
            <Button small kind="primary" onClick={() => void model.previewTurn()}>
              {say("checks-turn-by", { turn: formatDegrees(pose.mean_rad) })}
            </Button>
          )}
          {pose.turned_from !== null && (
            <Button
              says="checks-use-before"
              small
              busy={model.turning.value}
              onClick={() => void model.turnBack()}
            />
          )}
        </div>
      )}
    </section>
  );
}

function Preview({ model, preview }: { model: TrafficModel; preview: TurnedPose }) {
  const { changes } = preview;
  const nameOf = (id: number): string => {
    const vehicle = model.vehicles.value.find((one) => one.id === id);
    return vehicle ? vehicleName(vehicle.number) : "–";
  };
  return (
    <section
      class="stack stack--tight pad traffic__pose"
      aria-label={say("checks-turned-pose")}
      data-testid="turn-preview"
    >
      <h2>{say("checks-turned-by", { turn: formatDegrees(preview.turn_rad) })}</h2>
      <p class="small">{sentencesOf(preview.summary)}</p>
      <p class="small">
        {changes.count === 0
          ? say("checks-turn-no-heights")
          : say("checks-turn-heights", { count: changes.count, largest: formatSmall(changes.largest_m) })}
      </p>
      {changes.count > 0 && (
        <DataTable
          label={say("checks-differences")}
          scroll="traffic__changes"
          rows={changes.listed}
          keyOf={(one) => one.measurement_id}
          columns={({ col, num }) => [
            col(say("checks-vehicle"), (one) => nameOf(one.vehicle_id)),
            col(say("checks-target"), (one) => TARGET_NAMES[one.target]),
            num(say("checks-height"), (one) => formatLength(one.height_m)),
            num(say("checks-turned"), (one) => formatSmall(one.difference_m)),
          ]}
        />
      )}
      <div class="row">
        <Button
          says="checks-turn"
          small
          kind="primary"
          busy={model.turning.value}
          onClick={() => void model.turn()}
        />
        <Button
          says="action-cancel"
          small
          onClick={() => {
            model.preview.value = null;
          }}
        />
      </div>
    </section>
  );
}

function Passes({ model }: { model: TrafficModel }) {
  return (
    <Table
      class="heads-stay traffic__list"
      heads={[say("checks-vehicle"), num(say("checks-heading")), num(say("checks-apart"))]}
    >
      {model.passes.value.map((vehicle) => (
        <Row key={vehicle.id} model={model} vehicle={vehicle} />
      ))}
    </Table>
  );
}

function Row({ model, vehicle }: { model: TrafficModel; vehicle: Vehicle }) {
  const current = model.vehicleId.value === vehicle.id;
  const found = model.pose.value?.vehicles.find((one) => one.vehicle_id === vehicle.id);
  return (
    <tr aria-current={current ? "true" : undefined} data-testid={`heading-${vehicle.number}`}>
      <td>
        <button
          type="button"
          class="traffic__open"
          onClick={() => {
            model.open(vehicle);
            model.stage.focus();
          }}
        >
          <strong>{vehicleName(vehicle.number)}</strong>{" "}
          {[vehicle.make, vehicle.model].filter(Boolean).join(" ")}
        </button>
        {found?.source === "two_frames" && <div class="small muted">{say("checks-two-frames")}</div>}
        {found?.reason && <div class="small">{sentenceOf(found.reason)}</div>}
        {current && model.pair.value && canWork.value && (
          <Button
            says="checks-withdraw"
            small
            kind="quiet"
            icon="trash"
            onClick={() => void model.withdraw()}
          />
        )}
      </td>
      <td class="num">{found ? formatHeading(found.heading_rad, found.u_heading_rad) : "–"}</td>
      <td class="num">{found?.base_m != null ? formatLength(found.base_m, 2) : ""}</td>
    </tr>
  );
}
