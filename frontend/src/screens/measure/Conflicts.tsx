/** Somebody else changed the same thing: who, what, and the choice of theirs or mine. Nothing is lost before it is made. */
import { useSignal } from "@preact/signals";
import { Button, Facts, Segments } from "../../components";
import { say } from "../../core/messages";
import { outbox } from "../../core/outbox";
import { useResource } from "../../core/resource";
import { formatMoment } from "../../core/times";
import type { HeightAnswer } from "../../core/types";
import { heightWords, STATE_WORDS } from "../../core/words";
import { askHeight } from "../../viewer/geometry";
import { FIELD_WORDS, type Field } from "./fields";
import { showFact } from "./kinds";
import type { MeasureModel } from "./model";
import type { Entry } from "./records";

export function VehicleConflict({ model, id }: { model: MeasureModel; id: number }) {
  const draft = model.vehicles.drafts.value.get(id);
  const choice = useSignal<ReadonlyMap<Field, "mine" | "theirs">>(new Map());
  if (draft?.state !== "conflict" || !draft.theirs) return null;
  const theirs = draft.theirs;
  const chosen = (field: Field): "mine" | "theirs" => choice.value.get(field) ?? "mine";
  const settle = (): void => {
    void model.vehicles.settle(id, new Map(draft.disputed.map((field) => [field, chosen(field)])));
  };
  return (
    <section
      class="stack stack--tight conflict"
      role="alertdialog"
      aria-label={say("measure-conflict")}
      data-testid="vehicle-conflict"
    >
      <p>
        {say("measure-conflict-changed", {
          person: theirs.updated_by?.name ?? say("measure-conflict-somebody"),
          when: formatMoment(theirs.updated_at),
        })}
      </p>
      <p class="small muted">{say("measure-conflict-kept")}</p>
      {draft.disputed.map((field) => (
        <div key={field} class="stack stack--dense">
          <strong class="small">{FIELD_WORDS[field]}</strong>
          <Segments
            label={FIELD_WORDS[field]}
            value={chosen(field)}
            options={[
              {
                value: "mine",
                label: say("measure-conflict-mine", { value: showFact(field, draft.changes[field]) }),
              },
              {
                value: "theirs",
                label: say("measure-conflict-theirs", { value: showFact(field, theirs[field]) }),
              },
            ]}
            onInput={(side) => {
              choice.value = new Map(choice.value).set(field, side);
            }}
          />
        </div>
      ))}
      <Button says="measure-conflict-save" small kind="primary" onClick={settle} />
    </section>
  );
}

export function MeasurementConflict({ model, entry }: { model: MeasureModel; entry: Entry }) {
  const { theirs, values } = entry;
  const mine = useMine(model, entry);
  if (!theirs) return null;
  const told = {
    person: theirs.created_by?.name ?? say("measure-conflict-somebody"),
    when: formatMoment(theirs.created_at),
  };
  return (
    <div class="stack stack--tight conflict" role="alert" data-testid="measurement-conflict">
      <p>{say(theirs.withdrawn ? "measure-conflict-withdrawn" : "measure-conflict-measured", told)}</p>
      <Facts
        of={[
          [say("measure-conflict-height-theirs"), heightWords(theirs)],
          [say("measure-conflict-height-mine"), mine],
        ]}
      />
      <div class="row row--wrap">
        <Button
          says="measure-conflict-keep-theirs"
          small
          onClick={() => outbox.resolve(entry.key, "theirs")}
        />
        <Button
          says={values.withdrawn ? "measure-conflict-withdraw" : "measure-conflict-save-mine"}
          small
          onClick={() => outbox.resolve(entry.key, "mine")}
        />
      </div>
    </div>
  );
}

/** The height of one's own clicks, asked for where the page does not know it any more, as after a reload. */
function useMine(model: MeasureModel, { key, values, vehicleId, preview }: Entry): string {
  const recordingId = model.vehicles.get(vehicleId)?.recording_id;
  const known = preview !== null || values.withdrawn || recordingId === undefined;
  const answer = useResource<HeightAnswer | null>(
    async () => (known ? preview : askHeight({ ...values, recordingId, vehicleId })),
    [key, values, preview],
  );
  if (values.withdrawn) return STATE_WORDS.withdrawn;
  const height = preview ?? answer.data;
  return height ? heightWords(height) : (outbox.get(key)?.mine ?? "…");
}
