/** The models of the catalogue that fit what was measured: a key goes to the list, a digit or Enter takes a row and
 *  returns to the frame. And the word where the model filled in cannot fit. */
import { useEffect, useRef, useState } from "preact/hooks";
import { Problem } from "../../components";
import { api } from "../../core/api";
import { hint, useCommands } from "../../core/commands";
import { say, wordsOf } from "../../core/messages";
import { type Resource, useResource } from "../../core/resource";
import type { CatalogueRow, FittingModel, ModelFits, Vehicle } from "../../core/types";
import { formatSmall } from "../../core/units";
import { yearsOf } from "../../parts/vehicles/ModelYears";

const SIZE_WORDS = wordsOf({
  height: "which-model-height",
  length: "which-model-length",
  width: "which-model-width",
  wheelbase: "which-model-wheelbase",
  taillight: "which-model-taillight",
  headlight: "which-model-headlight",
});

/** Asked again whenever the record or a height of it was stored. */
export function useModelFits(vehicle: Vehicle): Resource<ModelFits> {
  const made = vehicle.measurements.map((one) => one.revision_id).join();
  return useResource<ModelFits>(
    (signal) => api.ask("GET /vehicles/{vehicle_id}/which-model", { vehicle_id: vehicle.id }, { signal }),
    [vehicle.id, vehicle.version, made],
    { keep: true },
  );
}

/** "roof +12 mm, wheelbase −40 mm": measured minus catalogue. */
function differencesOf(fit: FittingModel): string {
  return fit.differences
    .map(({ size, difference_m }) => {
      const sign = difference_m < 0 ? "−" : "+";
      return `${SIZE_WORDS[size]} ${sign}${formatSmall(Math.abs(difference_m))}`;
    })
    .join(", ");
}

function chance(p: number): string {
  return p < 0.0001 ? "< 0.0001" : p.toPrecision(1);
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
            limit: String(fits.limit_p),
          })
        : null}
    </p>
  );
}

interface Props {
  found: Resource<ModelFits>;
  locked: boolean;
  onChoose(row: CatalogueRow): void;
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
    onChoose(row.entry);
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
      <h4>
        {say("which-model-title")}
        <span class="muted small">{hint("whichModel")}</span>
      </h4>
      {found.error !== null && <Problem error={found.error} again={() => void found.reload()} />}
      {found.data?.reason && <p class="small muted">{found.data.reason}</p>}
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
                <span class="which-model__why small muted">
                  {differencesOf(row)}
                  {row.cannot && ` · ${say("which-model-row-cannot", { p: chance(row.p) })}`}
                </span>
              </span>
            </div>
          ))}
        </div>
      )}
    </section>
  );
}
