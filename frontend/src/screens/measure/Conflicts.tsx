/** Somebody else changed the same thing: who, what, and the choice of theirs or mine. Nothing is lost before it is made. */
import { useSignal } from "@preact/signals";
import { Button, Segments } from "../../components";
import { say } from "../../core/messages";
import { outbox } from "../../core/outbox";
import { formatHeight } from "../../core/units";
import { STATE_WORDS } from "../../core/words";
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
      aria-label={say("measure-conflict")}
      data-testid="vehicle-conflict"
    >
      <p>{whoOnly(draft.problem)}</p>
      <p class="small muted">{say("measure-conflict-kept")}</p>
      {draft.disputed.map((field) => (
        <div key={field} class="conflict__field">
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
            onChange={(side) => {
              choice.value = new Map(choice.value).set(field, side);
            }}
          />
        </div>
      ))}
      <Button small kind="primary" onClick={settle}>
        {say("measure-conflict-save")}
      </Button>
    </section>
  );
}

export function MeasurementConflict({ entry }: { entry: Entry }) {
  const theirs = entry.theirs;
  if (!theirs) return null;
  const words = theirs.withdrawn ? STATE_WORDS.withdrawn : formatHeight(theirs.height_m, theirs.U95_height_m);
  return (
    <div class="conflict" role="alert" data-testid="measurement-conflict">
      <p>{whoOnly(entry.problem)}</p>
      <p class="small">
        {say("measure-conflict-both", {
          person: theirs.created_by?.name ?? say("measure-conflict-somebody"),
          theirs: words,
          mine: entry.values.withdrawn ? STATE_WORDS.withdrawn : heightWords(entry),
        })}
      </p>
      <div class="row">
        <Button small onClick={() => outbox.resolve(entry.key, "theirs")}>
          {say("unsaved-take")}
        </Button>
        <Button small onClick={() => outbox.resolve(entry.key, "mine")}>
          {say("unsaved-keep")}
        </Button>
      </div>
    </div>
  );
}

/** Who and when, without the advice to do it again: here nothing has to be done again. */
function whoOnly(problem: string | null): string {
  return `${(problem ?? "").split(";")[0]?.replace(/\.$/, "")}.`;
}
