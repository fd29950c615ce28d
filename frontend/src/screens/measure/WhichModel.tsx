/** The models of the catalogue that can be the vehicle, ranked by its lengths: a key goes to the list, a digit or Enter takes a row and
 *  returns to the frame. And the word where the model filled in cannot fit. */
import { useEffect, useRef, useState } from "preact/hooks";
import { Button, Problem } from "../../components";
import { hint, useCommands } from "../../core/commands";
import { allOf, say, sentenceOf } from "../../core/messages";
import { type Resource, useAsked } from "../../core/resource";
import type { CatalogueRow, FittingModel, ModelFits, ModelSize, Vehicle } from "../../core/types";
import { formatSmall, localNumber } from "../../core/units";
import { yearsOf } from "../../parts/vehicles/ModelYears";
import { SIZE_WORDS, sizesWords } from "./sizes";

/** Asked again whenever the record or a height of it was stored. */
export function useModelFits(vehicle: Vehicle): Resource<ModelFits> {
  const made = vehicle.measurements.map((one) => one.revision_id).join();
  return useAsked(
    "GET /vehicles/{vehicle_id}/which-model",
    { vehicle_id: vehicle.id },
    { keep: true, also: [vehicle.version, made] },
  );
}

/** "roof +12 mm, wheelbase −40 mm": measured minus catalogue. */
function differencesOf(fit: FittingModel, sizes?: readonly ModelSize[]): string {
  return fit.differences
    .filter(({ size }) => sizes?.includes(size) ?? true)
    .map(({ size, difference_m }) => {
      const sign = difference_m < 0 ? "−" : "+";
      return `${SIZE_WORDS[size]} ${sign}${formatSmall(Math.abs(difference_m))}`;
    })
    .join(", ");
}

function chance(p: number): string {
  return p < 0.0001 ? `< ${localNumber("0.0001")}` : localNumber(p.toPrecision(1));
}

/** Where the row filled in cannot be this vehicle. */
export function CannotFit({ fits, vehicle }: { fits: ModelFits | null; vehicle: Vehicle }) {
  const chosen = fits?.chosen;
  const same = chosen?.entry.make === vehicle.make && chosen?.entry.model === vehicle.model;
  return (
    <p class="field__hint" role="status" data-testid="cannot-fit">
      {chosen?.cannot && same && fits
        ? say("which-model-cannot", {
            model: `${chosen.entry.make} ${chosen.entry.model}`,
            differences: differencesOf(chosen),
            p: chance(chosen.p),
            limit: localNumber(String(fits.limit_p)),
          })
        : null}
    </p>
  );
}

/** That the model was chosen by its sizes, and the act that makes it a reference: it was seen on the vehicle. */
export function ModelChosen({ vehicle, locked, onSeen }: ChosenProps) {
  const { model_chosen_by: by, model_sizes: sizes } = vehicle;
  if (by === null) return null;
  const words = sizesWords(sizes ?? "");
  return (
    <div class="field__hint model-chosen" data-testid="model-chosen">
      <p>{say(by === "size" ? "model-chosen-by-size" : "model-chosen-seen", { sizes: words })}</p>
      {by === "size" && <Button says="model-chosen-see" small disabled={locked} onClick={onSeen} />}
    </div>
  );
}

interface ChosenProps {
  vehicle: Vehicle;
  locked: boolean;
  onSeen(): void;
}

/** By what the list ranks, and how many stand in it no more. */
function rankWords({ ranked_by, fit, fitting, cannot_fit }: ModelFits): string {
  const by = ranked_by.map((size) => SIZE_WORDS[size]);
  const ranked = by.length > 0 ? say("which-model-ranked", { sizes: allOf(by) }) : say("which-model-by-name");
  const shown = fit > fitting.length ? say("which-model-shown", { shown: fitting.length, count: fit }) : "";
  const gone = cannot_fit > 0 ? say("which-model-left-out", { count: cannot_fit }) : "";
  return [ranked, shown, gone].filter(Boolean).join(" ");
}

interface Props {
  found: Resource<ModelFits>;
  locked: boolean;
  onChoose(row: CatalogueRow, sizes: readonly ModelSize[]): void;
}

export function WhichModel({ found, locked, onChoose }: Props) {
  const box = useRef<HTMLDivElement>(null);
  const [active, setActive] = useState(0);
  const rows = found.data?.fitting ?? [];
  useEffect(() => setActive(0), [found.data]);
  const enter = (): boolean => {
    box.current?.focus();
    return rows.length > 0;
  };
  useCommands([{ id: "whichModel", run: enter, enabled: () => !locked }]);
  const choose = (index: number): boolean => {
    const row = rows[index];
    if (!row || locked) return false;
    onChoose(
      row.entry,
      row.differences.map(({ size }) => size),
    );
    box.current?.blur();
    return true;
  };
  const turn = (by: 1 | -1): void => setActive((active + by + rows.length) % rows.length);
  const keys: Record<string, () => unknown> = {
    ArrowDown: () => turn(1),
    ArrowUp: () => turn(-1),
    Enter: () => choose(active),
    Escape: () => box.current?.blur(),
  };
  const onKeyDown = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const act = keys[event.key] ?? (/^[1-5]$/.test(event.key) ? () => choose(Number(event.key) - 1) : null);
    if (!act || act() === false) return;
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <section class="which-model" aria-label={say("which-model-title")}>
      <h4 class="row row--base">
        {say("which-model-title")}
        <span class="muted small">{hint("whichModel")}</span>
      </h4>
      {found.error !== null && <Problem error={found.error} again={() => void found.reload()} />}
      {found.data?.reason && <p class="small muted">{sentenceOf(found.data.reason)}</p>}
      {found.data && rows.length > 0 && (
        <p class="small muted" data-testid="which-model-rank">
          {rankWords(found.data)}
        </p>
      )}
      {rows.length > 0 && (
        <div
          ref={box}
          class="which-model__list"
          role="listbox"
          tabIndex={0}
          aria-label={say("which-model-title")}
          aria-activedescendant={`which-model-${active}`}
          onKeyDown={onKeyDown}
        >
          {rows.map((row, i) => (
            // biome-ignore lint/a11y/useKeyWithClickEvents: the list holds the focus and its keys
            // biome-ignore lint/a11y/useFocusableInteractive: aria-activedescendant points here
            <div
              key={row.entry.id}
              id={`which-model-${i}`}
              role="option"
              class="which-model__row"
              aria-selected={i === active}
              onClick={() => choose(i)}
            >
              <kbd>{i + 1}</kbd>
              <span>
                <strong>{row.entry.make}</strong> {row.entry.model}{" "}
                <span class="muted">{yearsOf(row.entry)}</span>
                <span class="which-model__why small muted">{differencesOf(row, found.data?.ranked_by)}</span>
              </span>
            </div>
          ))}
        </div>
      )}
    </section>
  );
}
