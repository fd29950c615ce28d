/** Parts of the chosen vehicle's panel: what is known of it, the motion's budget, its revisions. */
import { num, Table } from "../../components";
import { CommitField } from "../../components/CommitField";
import { Said } from "../../components/Said";
import { say } from "../../core/messages";
import { canWork } from "../../core/session";
import { formatMoment } from "../../core/times";
import type { CatalogueRow, ScanMotion, ScanVehicle, ScanVehicleDetail } from "../../core/types";
import {
  formatAcceleration,
  formatLength,
  formatSmall,
  formatSpeed,
  lengthUnit,
  parseLength,
  plainLength,
} from "../../core/units";
import { budgetSource, STATE_WORDS } from "../../core/words";
import { CatalogueField } from "../../parts/vehicles/CatalogueField";
import type { ScanModel } from "./model";
import type { Facts } from "./wanted";
import { causeWords } from "./words";

export function Known({ model, vehicle }: { model: ScanModel; vehicle: ScanVehicle }) {
  const disabled = !canWork.value;
  const length = (value: number | null) => (value === null ? "" : plainLength(value, 3));
  const wrong = (text: string) =>
    text === "" || (parseLength(text) ?? 0) > 0 ? null : say("scan-known-problem");
  return (
    <section class="scan__known" aria-label={say("scan-known")}>
      <CatalogueField
        label={say("scan-known-make")}
        value={vehicle.make ?? ""}
        query={(text) => text}
        disabled={disabled}
        onChoose={(row) => void model.edits.fillIn(fromCatalogue(row))}
        onCommit={(make) => void model.edits.fillIn({ make: make || null })}
      />
      <CatalogueField
        label={say("scan-known-model")}
        value={vehicle.model ?? ""}
        query={(text) => `${vehicle.make ?? ""} ${text}`}
        disabled={disabled}
        onChoose={(row) => void model.edits.fillIn(fromCatalogue(row))}
        onCommit={(name) => void model.edits.fillIn({ model: name || null })}
      />
      {(["length", "wheelbase"] as const).map((name) => (
        <CommitField
          key={name}
          says={`scan-known-${name}`}
          value={length(vehicle[`true_${name}_m`])}
          unit={lengthUnit.value}
          disabled={disabled}
          check={wrong}
          hint={off(vehicle[`${name}_error_m`])}
          onCommit={(text) => void model.edits.fillIn({ [`true_${name}_m`]: parseLength(text) })}
        />
      ))}
    </section>
  );
}

function fromCatalogue({ make, model, category, length_m, wheelbase_m, source }: CatalogueRow): Facts {
  const facts_source = source || "catalogue";
  return { make, model, category, true_length_m: length_m, true_wheelbase_m: wheelbase_m, facts_source };
}

function off(metres: number | null): string | undefined {
  if (metres === null) return undefined;
  return say("scan-known-off", { difference: `${metres < 0 ? "" : "+"}${formatSmall(metres)}` });
}

export function Budget({ detail }: { detail: ScanVehicleDetail }) {
  const m = detail.vehicle.measurement;
  return (
    <section class="panel" aria-labelledby="scan-budget">
      <header class="panel__head">
        <h3 id="scan-budget">{say("budget-title")}</h3>
        <span class="muted small">{say("scan-budget-note")}</span>
      </header>
      <Table
        label={say("scan-budget")}
        class="table--dense"
        heads={[
          say("scan-budget-source"),
          num(say("scan-budget-speed")),
          num(say("scan-budget-acceleration")),
          num(say("scan-budget-length")),
        ]}
      >
        {detail.budget.map((one) => (
          <tr key={one.source}>
            <td>{budgetSource(one.source)}</td>
            <td class="num">{formatSpeed(one.u_speed_mps, null, 3)}</td>
            <td class="num">{formatAcceleration(one.u_acceleration_mps2, null, 3)}</td>
            <td class="num">{formatSmall(one.u_length_m)}</td>
          </tr>
        ))}
        {m && (
          <tr>
            <td>
              <strong>{say("budget-together")}</strong>
            </td>
            <td class="num">{formatSpeed(m.u_speed_mps, null, 3)}</td>
            <td class="num">{formatAcceleration(m.u_acceleration_mps2, null, 3)}</td>
            <td class="num">{formatSmall(m.u_length_m)}</td>
          </tr>
        )}
      </Table>
    </section>
  );
}

export function History({ detail }: { detail: ScanVehicleDetail }) {
  const reviews = new Map(detail.reviews.map((one) => [one.revision, one]));
  return (
    <details open={detail.history.length > 1}>
      <summary>{say("scan-history", { count: detail.history.length })}</summary>
      <ul class="scan__history small">
        {[...detail.history].reverse().map((one) => (
          <li key={one.id}>
            <Said
              what="scan-revision"
              values={{
                speed: one.status === "ok" ? formatSpeed(one.speed_mps, null, 2) : STATE_WORDS.not_measurable,
                length: formatLength(one.length_m),
                cause: causeWords(one),
              }}
            />
            <br />
            <span class="muted">{whoWords(one, reviews.get(one.revision))}</span>
          </li>
        ))}
      </ul>
    </details>
  );
}

/** Who made a revision and when, and the verdict on it. */
function whoWords(one: ScanMotion, review?: ScanVehicleDetail["reviews"][number]): string {
  const person = one.created_by?.name ?? say("scan-by-search");
  const time = formatMoment(one.created_at);
  if (!review) return say("scan-revision-who", { person, time });
  const { verdict, reason } = review;
  const reviewer = review.reviewer?.name ?? say("scan-by-somebody");
  if (!reason) return say("scan-revision-verdict", { person, time, verdict, reviewer });
  return say("scan-revision-verdict-why", { person, time, verdict, reviewer, reason });
}
