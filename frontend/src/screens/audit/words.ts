/** What was done and to what, as the audit trail says it; what has no word here yet is shown by its name. */
import { jobName } from "../../core/jobs";
import { say, wordsOf } from "../../core/messages";
import type { AuditEvent, NamedEvent, Verdict } from "../../core/types";
import { STATE_WORDS, vehicleName } from "../../core/words";

export const ENTITY_WORDS = wordsOf({
  survey: "audit-entity-survey",
  survey_member: "audit-entity-survey_member",
  camera: "audit-entity-camera",
  calibration_image: "audit-entity-calibration_image",
  calibration: "audit-entity-calibration",
  recording: "audit-entity-recording",
  upload: "audit-entity-upload",
  pose: "audit-entity-pose",
  photograph: "audit-entity-photograph",
  catalogue: "audit-entity-catalogue",
  vehicle: "audit-entity-vehicle",
  proposals: "audit-entity-proposals",
  measurement: "audit-entity-measurement",
  computing: "audit-entity-computing",
  lot: "audit-entity-lot",
  lot_decision: "audit-entity-lot_decision",
  review: "audit-entity-review",
  review_plan: "audit-entity-review_plan",
  free_plan: "audit-entity-free_plan",
  wheel_pair: "audit-entity-wheel_pair",
  click_sigma: "audit-entity-click_sigma",
  standards: "audit-entity-standards",
  scan: "audit-entity-scan",
  scan_run: "audit-entity-scan_run",
  scan_vehicle: "audit-entity-scan_vehicle",
  scan_measurement: "audit-entity-scan_measurement",
  scan_review: "audit-entity-scan_review",
  scan_reference: "audit-entity-scan_reference",
  line_pose: "audit-entity-line_pose",
  rig_calibration: "audit-entity-rig_calibration",
  line_height: "audit-entity-line_height",
  line_height_review: "audit-entity-line_height_review",
  export: "audit-entity-export",
  evidence: "audit-entity-evidence",
  study: "audit-entity-study",
  study_result: "audit-entity-study_result",
  study_member: "audit-entity-study_member",
  package: "audit-entity-package",
  checkpoint: "audit-entity-checkpoint",
  signing_key: "audit-entity-signing_key",
  person: "audit-entity-person",
  sign_in_link: "audit-entity-sign_in_link",
  api_token: "audit-entity-api_token",
  job: "audit-entity-job",
});

const ACTION_WORDS = wordsOf({
  calibrate: "audit-action-calibrate",
  cancel: "audit-action-cancel",
  cancelled: "audit-action-cancelled",
  compute_again: "audit-action-compute_again",
  accepted: "audit-action-accepted",
  dissolved: "audit-action-dissolved",
  draw: "audit-action-draw",
  full_inspection: "audit-action-full_inspection",
  taken_back: "audit-action-taken_back",
  check_drift: "audit-action-check_drift",
  choose: "audit-action-choose",
  choose_calibration: "audit-action-choose_calibration",
  create: "audit-action-create",
  decide_drift: "audit-action-decide_drift",
  delete: "audit-action-delete",
  detect: "audit-action-detect",
  done: "audit-action-done",
  failed: "audit-action-failed",
  finish: "audit-action-finish",
  fix: "audit-action-fix",
  import: "audit-action-import",
  ingest: "audit-action-ingest",
  ingest_failed: "audit-action-ingest_failed",
  order: "audit-action-order",
  propose: "audit-action-propose",
  read: "audit-action-read",
  recorded: "audit-action-recorded",
  reading_failed: "audit-action-reading_failed",
  release: "audit-action-release",
  requeue: "audit-action-requeue",
  request: "audit-action-request",
  restart_ingest: "audit-action-restart_ingest",
  restart_reading: "audit-action-restart_reading",
  restore: "audit-action-restore",
  retire: "audit-action-retire",
  review: "audit-action-review",
  revise: "audit-action-revise",
  revoke: "audit-action-revoke",
  run: "audit-action-run",
  seal: "audit-action-seal",
  set_password: "audit-action-set_password",
  sign: "audit-action-sign",
  sign_out: "audit-action-sign_out",
  swap_cameras: "audit-action-swap_cameras",
  take: "audit-action-take",
  take_back_drift_decision: "audit-action-take_back_drift_decision",
  undo: "audit-action-undo",
  update: "audit-action-update",
  use: "audit-action-use",
  withdraw: "audit-action-withdraw",
});

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
