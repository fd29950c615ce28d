/** What was done and to what, as the audit trail says it; what has no word here yet is shown by its name. */
import { jobName } from "../../core/jobs";
import { say, wordsOf } from "../../core/messages";
import type { AuditEvent, NamedEvent, Verdict } from "../../core/types";
import { STATE_WORDS, vehicleName } from "../../core/words";

export const ENTITY_WORDS = wordsOf("audit-entity-");

const ACTION_WORDS = wordsOf("audit-action-");

export function actionWords({ action }: AuditEvent): string {
  return (ACTION_WORDS as Readonly<Record<string, string>>)[action] ?? action.replaceAll("_", " ");
}

/** "vehicle 09, roof", "rejected: vehicle 09, roof", "camera “left”": as people call it. */
export function subjectWords({ event, subject }: NamedEvent): string {
  const kind =
    (ENTITY_WORDS as Readonly<Record<string, string>>)[event.entity] ?? event.entity.replaceAll("_", " ");
  const { vehicle, target, name } = subject;
  if (vehicle !== null) {
    const named = { vehicle: vehicleName(vehicle) };
    const words = target
      ? say("audit-subject-target", { ...named, target })
      : say("audit-subject-vehicle", named);
    const verdict =
      event.entity === "review" ? (event.after as { verdict?: Verdict } | null)?.verdict : undefined;
    return verdict ? say("audit-subject-verdict", { verdict: STATE_WORDS[verdict], subject: words }) : words;
  }
  if (!name) return kind;
  return say("audit-subject-named", { entity: kind, name: event.entity === "job" ? jobName(name) : name });
}

/** The row of the database, for who looks into it. */
export function rowWords({ entity, entity_id }: AuditEvent): string | undefined {
  return entity_id === null ? undefined : `${entity}: ${say("audit-row", { id: String(entity_id) })}`;
}

/** Where it can be looked at; null where there is no page for it. */
export function pageOf({ event, subject }: NamedEvent): string | null {
  const { entity, entity_id, survey_id } = event;
  if (survey_id === null || entity_id === null) return null;
  const survey = `/surveys/${survey_id}`;
  if (entity === "review" || entity === "measurement")
    return subject.measurement_id ? `${survey}/review?measurement=${subject.measurement_id}` : null;
  const pages: Readonly<Record<string, string>> = {
    survey,
    vehicle: `${survey}/measure?vehicle=${entity_id}`,
    wheel_pair: `${survey}/checks?tab=traffic&vehicle=${subject.vehicle_id}`,
    camera: `${survey}/camera?camera=${entity_id}`,
    recording: `${survey}/measure?recording=${entity_id}`,
    scan: `${survey}/scan?scan=${entity_id}`,
    review_plan: `${survey}/review`,
    free_plan: `${survey}/repeats`,
    computing: `${survey}/checks?tab=again&computing=${entity_id}`,
    export: `${survey}/export`,
    lot: `${survey}/lots?lot=${entity_id}`,
    lot_decision: `${survey}/lots`,
  };
  return pages[entity] ?? null;
}
