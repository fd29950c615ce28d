import { Check } from "../../components";
import { CommitField, LengthField } from "../../components/CommitField";
import { say } from "../../core/messages";
import type { KnownTarget, Vehicle } from "../../core/types";
import { TARGET_WORDS, TARGETS } from "../../core/words";
import { type Changes, FIELD_WORDS } from "./fields";

interface Props {
  vehicle: Vehicle;
  locked: boolean;
  edit(changes: Changes): void;
}

const KNOWN = TARGETS.filter((target): target is KnownTarget => target !== "roof");

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
      <div class="stack stack--tight known__rows">
        {KNOWN.map((target) => (
          <Known key={target} target={target} vehicle={vehicle} locked={locked} edit={edit} />
        ))}
      </div>
      <Check
        label={FIELD_WORDS.check_target}
        checked={vehicle.check_target}
        disabled={locked}
        onInput={(check_target) => edit({ check_target })}
      />
      <p class="field__hint">{say("measure-check-target-help")}</p>
      {empty && <p class="field__problem">{say("measure-check-target-empty")}</p>}
    </details>
  );
}

function Known({ target, vehicle, locked, edit }: Props & { target: KnownTarget }) {
  const height = `known_${target}_m` as const;
  const u = `u_known_${target}_m` as const;
  const source = `known_${target}_source` as const;
  return (
    <fieldset class="grid grid--3 grid--close grid--low" aria-label={FIELD_WORDS[height]}>
      <LengthField
        label={target === "other" ? say("measure-known-mark") : TARGET_WORDS[target]}
        metres={vehicle[height]}
        disabled={locked}
        onCommit={(metres) => edit({ [height]: metres })}
      />
      <LengthField
        says="measure-known-u"
        metres={vehicle[u]}
        disabled={locked}
        onCommit={(metres) => edit({ [u]: metres })}
      />
      <CommitField
        says="measure-known-source"
        value={vehicle[source] ?? ""}
        disabled={locked}
        onCommit={(text) => edit({ [source]: text || null })}
      />
    </fieldset>
  );
}
