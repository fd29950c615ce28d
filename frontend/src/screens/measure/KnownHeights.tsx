/** Heights of the eye, the lamps and a mark that were known before, and whether the record is a check target. */
import { CommitField } from "../../components/CommitField";
import { say } from "../../core/messages";
import type { KnownTarget, Vehicle } from "../../core/types";
import { lengthProblem, lengthText, lengthUnit, parseLength } from "../../core/units";
import { TARGET_WORDS } from "../../core/words";
import { type Changes, FIELD_WORDS } from "./fields";

interface Props {
  vehicle: Vehicle;
  locked: boolean;
  edit(changes: Changes): void;
}

const KNOWN: readonly KnownTarget[] = ["driver_eye", "taillight", "headlight", "other"];

export function KnownHeights({ vehicle, locked, edit }: Props) {
  const count = KNOWN.filter((target) => vehicle[`known_${target}_m`] !== null).length;
  const empty = vehicle.check_target && count === 0 && vehicle.manufacturer_height_m === null;
  return (
    <details class="known" open={vehicle.check_target || undefined} data-testid="known-heights">
      <summary>
        {say("measure-known-title")}{" "}
        {count > 0 && <span class="small muted">{say("measure-known-some", { count })}</span>}
      </summary>
      <p class="field__hint">{say("measure-known-help")}</p>
      <div class="known__rows">
        {KNOWN.map((target) => (
          <Known key={target} target={target} vehicle={vehicle} locked={locked} edit={edit} />
        ))}
      </div>
      <label>
        <input
          type="checkbox"
          checked={vehicle.check_target}
          disabled={locked}
          onChange={(event) => edit({ check_target: event.currentTarget.checked })}
        />{" "}
        {FIELD_WORDS.check_target}
      </label>
      <p class="field__hint">{say("measure-check-target-help")}</p>
      {empty && <p class="field__problem">{say("measure-check-target-empty")}</p>}
    </details>
  );
}

function Known({ target, vehicle, locked, edit }: Props & { target: KnownTarget }) {
  const unit = lengthUnit.value;
  const height = `known_${target}_m` as const;
  const u = `u_known_${target}_m` as const;
  const source = `known_${target}_source` as const;
  const length = { numeric: true, unit, disabled: locked } as const;
  return (
    <fieldset class="known__row" aria-label={FIELD_WORDS[height]}>
      <CommitField
        {...length}
        label={target === "other" ? say("measure-known-mark") : TARGET_WORDS[target]}
        value={lengthText(vehicle[height], unit)}
        check={(text) => lengthProblem(text, { empty: true })}
        onCommit={(text) => edit({ [height]: parseLength(text) })}
      />
      <CommitField
        {...length}
        label={say("measure-known-u")}
        value={lengthText(vehicle[u], unit)}
        check={(text) => lengthProblem(text, { empty: true })}
        onCommit={(text) => edit({ [u]: parseLength(text) })}
      />
      <CommitField
        label={say("measure-known-source")}
        value={vehicle[source] ?? ""}
        disabled={locked}
        onCommit={(text) => edit({ [source]: text || null })}
      />
    </fieldset>
  );
}
