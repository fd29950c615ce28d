/** Somebody else changed the same thing: who, what, and the choice of theirs or mine. Nothing is lost before it is made. */
import { useSignal } from "@preact/signals";
import { Button, Segments } from "../../components";
import { outbox } from "../../core/outbox";
import { formatHeight } from "../../core/units";
import { FIELD_WORDS, type Field } from "./fields";
import { showFact } from "./kinds";
import type { MeasureModel } from "./model";
import type { Entry } from "./records";
import { heightWords } from "./words";

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
      class="conflict"
      role="alertdialog"
      aria-label="Changed by somebody else"
      data-testid="vehicle-conflict"
    >
      <p>{whoOnly(draft.problem)}</p>
      <p class="small muted">Both versions are kept until you choose.</p>
      {draft.disputed.map((field) => (
        <div key={field} class="conflict__field">
          <strong class="small">{FIELD_WORDS[field]}</strong>
          <Segments
            label={FIELD_WORDS[field]}
            value={chosen(field)}
            options={[
              { value: "mine", label: `mine: ${showFact(field, draft.changes[field])}` },
              { value: "theirs", label: `theirs: ${showFact(field, theirs[field])}` },
            ]}
            onChange={(side) => {
              choice.value = new Map(choice.value).set(field, side);
            }}
          />
        </div>
      ))}
      <Button small kind="primary" onClick={settle}>
        Save this
      </Button>
    </section>
  );
}

export function MeasurementConflict({ entry }: { entry: Entry }) {
  const theirs = entry.theirs;
  if (!theirs) return null;
  const words = theirs.withdrawn ? "withdrawn" : formatHeight(theirs.height_m, theirs.U95_height_m);
  return (
    <div class="conflict" role="alert" data-testid="measurement-conflict">
      <p>{whoOnly(entry.problem)}</p>
      <p class="small">
        Theirs ({theirs.created_by?.name ?? "somebody"}): {words}. Yours:{" "}
        {entry.values.withdrawn ? "withdrawn" : heightWords(entry)}.
      </p>
      <div class="row">
        <Button small onClick={() => outbox.resolve(entry.key, "theirs")}>
          Take theirs
        </Button>
        <Button small onClick={() => outbox.resolve(entry.key, "mine")}>
          Keep mine
        </Button>
      </div>
    </div>
  );
}

/** Who and when, without the advice to do it again: here nothing has to be done again. */
function whoOnly(problem: string | null): string {
  return `${(problem ?? "").split(";")[0]?.replace(/\.$/, "")}.`;
}
