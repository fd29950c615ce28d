/** The record of a vehicle: its model, what is known of it, how it was filmed; saved by itself. */
import { useMemo, useRef } from "preact/hooks";
import { choices, OptionalField } from "../../components";
import { CommitField, LengthField } from "../../components/CommitField";
import { TypingHold } from "../../components/typing";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import type { CatalogueRow, ModelSize, Vehicle } from "../../core/types";
import { CATEGORY_WORDS, DIRECTION_WORDS, DISCARDED_WORDS, LIGHTING_WORDS } from "../../core/words";
import { CatalogueField } from "../../parts/vehicles/CatalogueField";
import { ModelYears } from "../../parts/vehicles/ModelYears";
import { lacksClass } from "../../parts/vehicles/passes";
import { FIELD_WORDS } from "./fields";
import { fromCatalogue } from "./fromCatalogue";
import { KnownHeights } from "./KnownHeights";
import type { MeasureModel } from "./model";
import { noteModel, RecentModels } from "./RecentModels";
import { CannotFit, ModelChosen, useModelFits, WhichModel } from "./WhichModel";

export function VehicleRecord({ model, vehicle }: { model: MeasureModel; vehicle: Vehicle }) {
  const locked = !canWork.value;
  const draft = model.vehicles.drafts.value.get(vehicle.id);
  const hold = useMemo(
    () => ({ start: () => model.vehicles.hold(vehicle.id), end: () => model.vehicles.release(vehicle.id) }),
    [model, vehicle.id],
  );
  const fits = useModelFits(vehicle);
  const make = useRef<HTMLInputElement>(null);
  const take = (row: CatalogueRow, sizes?: readonly ModelSize[]): void => {
    noteModel(row);
    model.edit(fromCatalogue(row, vehicle, sizes), vehicle);
  };
  const takeLast = (row: CatalogueRow): void => {
    take(row);
    model.named(vehicle);
  };
  /** What the field of a fact is drawn with: one of several, words, a length. */
  const wired = (name: keyof typeof FIELD_WORDS) => ({ label: FIELD_WORDS[name], disabled: locked });
  const chosen = <F extends "category" | "lighting" | "direction" | "discarded">(name: F) => ({
    ...wired(name),
    value: vehicle[name],
    onInput: (value: Vehicle[F]) => model.edit({ [name]: value }),
  });
  const length = (name: "manufacturer_height_m" | "u_manufacturer_height_m") => ({
    metres: vehicle[name],
    disabled: locked,
    onCommit: (metres: number | null) => model.edit({ [name]: metres }),
  });
  const toMake = (): void => {
    make.current?.focus();
    make.current?.select();
  };
  return (
    <section class="facts-form" aria-label={say("measure-record")}>
      <h3>{say("measure-record")}</h3>
      {draft?.state === "failed" && (
        <p class="small" role="alert">
          {draft.problem}
        </p>
      )}
      <TypingHold.Provider value={hold}>
        <div class="grid grid--tight below facts-form__grid">
          <div class="across">
            <RecentModels locked={locked} onChoose={takeLast} toMake={toMake} />
          </div>
          <CatalogueField
            {...wired("make")}
            field={make}
            value={vehicle.make ?? ""}
            query={(text) => text}
            onChoose={(row) => take(row)}
            onCommit={(text) => model.edit({ make: text || null })}
          />
          <CatalogueField
            {...wired("model")}
            value={vehicle.model ?? ""}
            query={(text) => `${vehicle.make ?? ""} ${text}`.trim()}
            onChoose={(row) => take(row)}
            onCommit={(text) => model.edit({ model: text || null })}
          />
          <div class="across">
            <ModelChosen
              vehicle={vehicle}
              locked={locked}
              onSeen={() => model.edit({ model_chosen_by: "seen" })}
            />
            <CannotFit fits={fits.data} vehicle={vehicle} />
            <WhichModel found={fits} locked={locked} onChoose={take} />
          </div>
          <CommitField
            {...wired("year")}
            value={vehicle.year === null ? "" : String(vehicle.year)}
            numeric
            check={yearProblem}
            onCommit={(text) => model.edit({ year: text === "" ? null : Number(text) })}
          />
          <OptionalField
            {...chosen("category")}
            none="–"
            options={choices(CATEGORY_WORDS)}
            hint={lacksClass(vehicle) ? say("measure-class-missing") : undefined}
          />
          <div class="across">
            <ModelYears make={vehicle.make} model={vehicle.model} year={vehicle.year} />
          </div>
          <LengthField says="measure-makers-height" {...length("manufacturer_height_m")} />
          <LengthField says="measure-makers-height-u" {...length("u_manufacturer_height_m")} />
          <div class="across">
            <CommitField
              {...wired("height_source")}
              value={vehicle.height_source ?? ""}
              onCommit={(text) => model.edit({ height_source: text || null })}
            />
          </div>
          <div class="across">
            <KnownHeights vehicle={vehicle} locked={locked} edit={(changes) => model.edit(changes)} />
          </div>
          <OptionalField {...chosen("lighting")} none="–" options={choices(LIGHTING_WORDS)} />
          <OptionalField {...chosen("direction")} none="–" options={choices(DIRECTION_WORDS)} />
          <div class="across">
            <OptionalField
              {...chosen("discarded")}
              none={say(vehicle.in_sample ? "measure-in-sample" : "measure-out-of-sample")}
              options={choices(DISCARDED_WORDS)}
              hint={vehicle.measurements.length > 0 ? say("measure-discard-measured") : undefined}
              disabled={locked || (vehicle.measurements.length > 0 && !vehicle.discarded)}
            />
          </div>
          <div class="across">
            <CommitField
              {...wired("notes")}
              rows={2}
              value={vehicle.notes}
              onCommit={(notes) => model.edit({ notes })}
            />
          </div>
        </div>
      </TypingHold.Provider>
    </section>
  );
}

/** The server's limits: the first motor car, and next year's models, which are sold already. */
function yearProblem(text: string): string | null {
  const most = new Date().getFullYear() + 1;
  const year = /^\d{4}$/.test(text) ? Number(text) : 0;
  return text === "" || (year >= 1885 && year <= most)
    ? null
    : say("measure-year-problem", { most: String(most) });
}
