/** What the server sends and takes, as its HTTP description says it. Lengths in metres, points in pixels, times ISO 8601 UTC. */

export type Role = "viewer" | "operator" | "reviewer" | "admin";
export type Px = [x: number, y: number];
export type Target = "roof" | "driver_eye" | "taillight" | "headlight" | "other";
export type Lighting = "daytime" | "low_light";
export type Category = "hatchback" | "saloon" | "estate" | "suv" | "van" | "lorry" | "other";

export interface Person {
  id: number;
  name: string;
  email: string;
  role: Role;
  active: boolean;
  created_at: string;
  last_seen_at: string | null;
  has_password: boolean;
}

export interface Me {
  person: Person;
  version: string;
  needs_password: boolean;
  demo_survey_id: number | null;
}

export interface NamedPerson {
  id: number;
  name: string;
}

export interface Inset {
  inset_m: number;
  u_inset_m: number;
  note: string;
}

export type StepKey = "camera" | "recordings" | "pose" | "vehicles" | "review" | "results";

export interface Step {
  key: StepKey;
  state: "done" | "next" | "waiting";
  summary: string;
}

export interface Survey {
  id: number;
  name: string;
  site: string;
  description: string;
  is_demo: boolean;
  version: number;
  created_at: string;
  insets: Record<Target, Inset>;
  counts: {
    recordings: number;
    vehicles: number;
    vehicles_measured: number;
    measurements: number;
    to_review: number;
    accepted: number;
    rejected: number;
  };
  steps: Step[];
}

export interface CameraView {
  file: string;
  image_id?: number | null;
  frame?: number | null;
  used: boolean;
  reason: string | null;
  rms_px: number | null;
  corners_px?: Px[];
  residuals_px?: Px[];
}

export interface CameraDocument {
  format: "sightline-camera-1";
  name: string;
  width_px: number;
  height_px: number;
  model: "brown" | "fisheye";
  fx_px: number;
  fy_px: number;
  cx_px: number;
  cy_px: number;
  distortion: number[];
  rms_px: number | null;
  parameters: string[];
  covariance: number[][] | null;
  views: CameraView[];
}

export interface CalibrationSummary {
  id: number;
  created_at: string;
  created_by: NamedPerson | null;
  source: "images" | "clip" | "import";
  trusted: boolean;
  summary: string;
}

export interface Calibration extends CalibrationSummary {
  camera_id: number;
  document: CameraDocument;
  warnings: string[];
  /** 12 rows of 16 columns: how many corners fell into each part of the picture. */
  coverage: number[][];
  views: CameraView[];
}

export interface CalibrationImage {
  id: number;
  name: string;
  width_px: number;
  height_px: number;
  found: boolean;
  reason: string | null;
  /** row by row */
  corners_px: Px[];
  columns: number;
  rows: number;
  sharpness: number | null;
  url: string;
}

export interface Camera {
  id: number;
  survey_id: number;
  name: string;
  notes: string;
  current_calibration_id: number | null;
  images: number;
  calibrations: CalibrationSummary[];
}

export interface CameraDetail extends Omit<Camera, "images"> {
  images: CalibrationImage[];
}

export type JobState = "queued" | "running" | "done" | "failed" | "cancelled";

export interface Job {
  id: number;
  kind: string;
  state: JobState;
  progress: number;
  message: string;
  error: string | null;
  result: Record<string, number> | null;
  survey_id: number | null;
  recording_id: number | null;
  created_at: string;
  finished_at: string | null;
}

export interface Recording {
  id: number;
  survey_id: number;
  name: string;
  state: "ingesting" | "ready" | "failed";
  error: string | null;
  job: Job | null;
  sha256: string | null;
  size_bytes: number;
  width_px: number | null;
  height_px: number | null;
  frame_count: number | null;
  duration_s: number | null;
  codec: string | null;
  container: string | null;
  vfr: boolean;
  notes: string[];
  camera_id: number | null;
  pose_id: number | null;
  lighting: Lighting | null;
  lighting_proposed: Lighting | null;
  created_at: string;
  thumbs: { frame: number; url: string }[];
}

export interface FrameTable {
  first: number;
  pts: number[];
  time_s: number[];
  crc: number[];
  key: boolean[];
}

export interface BoardFinding {
  found: boolean;
  reason: string | null;
  columns: number;
  rows: number;
  corners_px: Px[];
  outline_px: Px[];
  order_note: string;
}

export interface PoseSummary {
  id: number;
  recording_id: number;
  calibration_id: number;
  created_at: string;
  first_frame: number;
  last_frame: number;
  rms_px: number;
  distance_m: number | null;
  summary: string;
}

export interface PoseOverlay {
  grid: Px[][];
  iso_heights: { height_m: number; points: Px[] }[];
  axes: AxisLines;
  corners_px: Px[];
}

export interface AxisLines {
  longitudinal: Px[];
  vertical: Px[];
  transversal: Px[];
  origin_px: Px;
}

export interface Pose extends PoseSummary {
  document: Record<string, unknown>;
  warnings: string[];
  expected: { distance_m: number; u_height_m: number | null; U95_height_m: number | null }[];
  overlay: PoseOverlay;
}

export interface AxesAnswer {
  ok: boolean;
  reason: string | null;
  axes: AxisLines | null;
  ladder: { height_m: number; points: Px[]; label: boolean }[];
  x_m: number | null;
  y_m: number | null;
  distance_m: number | null;
}

export interface BudgetEntry {
  source: string;
  u_m: number;
}

export interface HeightAnswer {
  status: "ok" | "not_measurable";
  reason: string | null;
  height_m: number | null;
  u_height_m: number | null;
  U95_height_m: number | null;
  uncorrected_height_m: number | null;
  inset_m: number;
  u_inset_m: number;
  x_m: number | null;
  y_m: number | null;
  distance_m: number | null;
  budget: BudgetEntry[];
  flags: string[];
}

export type Verdict = "to_review" | "accepted" | "fixed" | "rejected" | "reopened";

export interface Measurement {
  id: number;
  revision: number;
  revision_id: number;
  vehicle_id: number;
  recording_id: number;
  target: Target;
  frame: number;
  pts: number;
  time_s: number;
  frame_crc: number;
  contact: Px;
  point: Px;
  sigma_px: number;
  pose_id: number;
  calibration_id: number;
  inset_m: number;
  u_inset_m: number;
  height_m: number | null;
  uncorrected_height_m: number | null;
  u_height_m: number | null;
  U95_height_m: number | null;
  distance_m: number | null;
  status: "ok" | "not_measurable";
  reason: string | null;
  flags: string[];
  budget: BudgetEntry[];
  code_version: string;
  created_by: NamedPerson;
  created_at: string;
  withdrawn: boolean;
  review: { verdict: Verdict; reason: string | null; reviewer: NamedPerson | null; at: string | null };
}

export interface VehicleFields {
  make: string | null;
  model: string | null;
  year: number | null;
  category: Category | null;
  manufacturer_height_m: number | null;
  u_manufacturer_height_m: number | null;
  height_source: string | null;
  lighting: Lighting | null;
  notes: string;
}

export interface Vehicle extends VehicleFields {
  id: number;
  survey_id: number;
  recording_id: number;
  number: number;
  first_frame: number;
  last_frame: number;
  best_frame: number | null;
  version: number;
  state: "to_do" | "partial" | "measured" | "rejected" | "accepted";
  measurements: Measurement[];
}

export interface CatalogueRow {
  id: number;
  make: string;
  model: string;
  year_from: number | null;
  year_to: number | null;
  category: Category | null;
  height_m: number | null;
  length_m: number | null;
  width_m: number | null;
  wheelbase_m: number | null;
  source: string;
}

export interface History {
  revisions: Measurement[];
  reviews: {
    id: number;
    revision: number;
    verdict: Verdict;
    reason: string | null;
    reviewer: NamedPerson | null;
    at: string;
  }[];
}

export interface ReviewItem {
  measurement: Measurement;
  vehicle: Omit<Vehicle, "measurements">;
  mine: boolean;
}

export interface ExportPackage {
  id: number;
  created_at: string;
  created_by: NamedPerson | null;
  size_bytes: number;
  sha256: string;
  url: string;
}

export interface AuditEvent {
  id: number;
  at: string;
  actor: NamedPerson | null;
  action: string;
  entity: string;
  entity_id: number | string;
  survey_id: number | null;
  before: Record<string, unknown> | null;
  after: Record<string, unknown> | null;
  hash: string;
  previous_hash: string | null;
}

export interface AuditCheck {
  ok: boolean;
  checked: number;
  head_hash: string | null;
  problem: string | null;
}

export interface UnfinishedUpload {
  id: number | string;
  filename: string;
  size_bytes: number;
  offset_bytes: number;
  created_at: string;
}
