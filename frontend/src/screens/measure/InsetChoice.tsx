/** What only a look at the vehicle can tell: where the driver sits, which spot of the roof was clicked. */
import { choices, Segments } from "../../components";
import { linkTo, Said } from "../../components/Said";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import { survey } from "../../core/survey";
import type { DriverSide, Target, Vehicle } from "../../core/types";
import { formatLength } from "../../core/units";
import { INSET_PLACE_WORDS, SIDE_WORDS } from "../../core/words";
import { classIsMissing, insetChoices } from "../../parts/vehicles/insets";
import type { MeasureModel } from "./model";
import type { Entry } from "./records";

interface Props {
  model: MeasureModel;
  target: Target;
  entry: Entry | null;
}

export function InsetChoice({ model, target, entry }: Props) {
  const vehicle = model.vehicle.value;
  if (target === "driver_eye" && vehicle) return <DriverSideChoice model={model} vehicle={vehicle} />;
  return target === "roof" ? <RoofChoice model={model} target={target} entry={entry} /> : null;
}

/** Beside the eye, always: near or far, and what it follows from. One click says it of this vehicle. */
function DriverSideChoice({ model, vehicle }: { model: MeasureModel; vehicle: Vehicle }) {
  const side = vehicle.driver_side ?? vehicle.side;
  const silent = survey.value?.traffic.steering_side ? "undirected" : "unknown";
  const from = vehicle.driver_side ? "said" : (vehicle.side_from ?? silent);
  const values = {
    direction: vehicle.direction ?? "right",
    steering: survey.value?.traffic.steering_side ?? "left",
  };
  return (
    <div class="inset-choice" data-testid="inset-choice-driver_eye" data-side={side ?? "unknown"}>
      <span class="small">{say("measure-inset-side")}</span>
      {canWork.value ? (
        <Segments
          says="measure-inset-side"
          value={side ?? ""}
          options={choices<string>(SIDE_WORDS)}
          onInput={(picked) => model.insets.chooseSide(picked as DriverSide)}
        />
      ) : (
        <span class="small">{side ? SIDE_WORDS[side] : say("measure-side-unknown")}</span>
      )}
      <span class="small muted">
        <Said
          what="measure-side-from"
          values={{ from, ...values }}
          parts={linkTo(`/surveys/${model.surveyId}/settings`)}
        />
      </span>
      {from === "said" && canWork.value && (
        <button type="button" class="link small" onClick={() => model.insets.chooseSide(null)}>
          {say("measure-side-as-survey")}
        </button>
      )}
    </div>
  );
}

function RoofChoice({ model, target, entry }: Props) {
  const category = model.vehicle.value?.category ?? null;
  const offered = insetChoices(survey.value, target, category);
  const asked = model.flow.value.target === target;
  if (offered.length < 2 || !asked || !canWork.value) return null;
  const now = model.insetOf(target) ?? entry?.values.inset ?? model.insets.usual(target);
  const value = offered.findIndex(
    (choice) => choice.inset_m === now?.inset_m && choice.u_inset_m === now?.u_inset_m,
  );
  return (
    <div class="inset-choice" data-testid={`inset-choice-${target}`}>
      <span class="small">{say("measure-inset-roof")}</span>
      <Segments
        says="measure-inset-roof"
        value={String(value)}
        options={offered.map((choice, i) => ({ value: String(i), label: INSET_PLACE_WORDS[choice.place] }))}
        onInput={(picked) => {
          const choice = offered[Number(picked)];
          if (choice) model.insets.choose(target, { inset_m: choice.inset_m, u_inset_m: choice.u_inset_m });
        }}
      />
      <span class="small muted">
        {say("measure-inset-now", {
          inset: formatLength(now?.inset_m ?? null, 2),
          u_inset: formatLength(now?.u_inset_m ?? null, 2),
        })}{" "}
        {classIsMissing(target, category) && say("measure-inset-needs-class")}
      </span>
    </div>
  );
}
