/** What the server sends and takes. Names come from its description (`schema.d.ts`, made by `npm run types`); here they get the
 *  short names that the screens use, and pairs of numbers become points. Lengths in metres, times ISO 8601 UTC. */
import type { components } from "#schema";

type Schemas = components["schemas"];

/** A point in the picture, pixels; (0, 0) is the centre of the top-left pixel. */
export type Px = [x: number, y: number];

type With<T, Changed> = Omit<T, keyof Changed> & Changed;

export type Role = Schemas["PersonBody"]["role"];
export type Target = Schemas["MeasurementBody"]["target"];
export type Verdict = Schemas["ReviewBody"]["verdict"];
export type StepKey = Schemas["StepBody"]["key"];
export type Lighting = NonNullable<Schemas["VehicleBody"]["lighting"]>;
export type Category = NonNullable<Schemas["VehicleBody"]["category"]>;

export const ROLE_NAMES: Record<Role, string> = {
  viewer: "Viewer",
  operator: "Operator",
  reviewer: "Reviewer",
  admin: "Administrator",
};

export type Person = Schemas["PersonBody"];
export type Me = Schemas["Me"];

export type Inset = Schemas["InsetBody"];
export type Step = Schemas["StepBody"];
export type Survey = Schemas["SurveyBody"];

/** `camera.json` of the contract; the description leaves it open. */
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
}

export type CameraView = With<Schemas["ViewBody"], { corners_px: Px[]; residuals_px: Px[] }>;
export type Calibration = With<Schemas["CalibrationBody"], { document: CameraDocument; views: CameraView[] }>;
export type CalibrationImage = With<Schemas["CalibrationImageBody"], { corners_px: Px[] }>;
export type Camera = Schemas["CameraBody"];
export type CameraDetail = With<Schemas["CameraDetail"], { images: CalibrationImage[] }>;

export type Job = With<Schemas["JobBody"], { result: Record<string, number> | null }>;
/** What was found of a camera that moved since its road pose. */
export type Drift = Schemas["DriftBody"];
export type DriftCheck = NonNullable<Drift["check"]>;
export type ContactProposal = With<Schemas["ContactProposalBody"], { contact: Px | null; outline: Px[] }>;
export type Recording = With<Schemas["RecordingBody"], { job: Job | null }>;
export type FrameTable = Schemas["FrameRows"];
export type ReadyFrames = Schemas["ReadyFrames"];
export type UnfinishedUpload = Schemas["UploadBody"];

export type BoardFinding = With<Schemas["BoardBody"], { corners_px: Px[]; outline_px: Px[] }>;
export interface AxisLines {
  longitudinal: Px[];
  vertical: Px[];
  transversal: Px[];
  origin_px: Px;
}
export type PoseSummary = Schemas["PoseSummaryBody"];
export interface PoseOverlay {
  grid: Px[][];
  iso_heights: { height_m: number; points: Px[] }[];
  axes: AxisLines | null;
  corners_px: Px[];
}
export type Pose = With<Schemas["PoseBody"], { overlay: PoseOverlay }>;

export type AxesAnswer = With<
  Schemas["AxesAnswer"],
  { axes: AxisLines | null; ladder: { height_m: number; points: Px[]; label: boolean }[] }
>;
export type BudgetEntry = Schemas["BudgetEntryBody"];
export type HeightAnswer = Schemas["HeightAnswer"];
/** The second frame proposed: where both points are expected and what it gains. */
export type SecondFrameAnswer = Schemas["SecondFrameAnswer"];

export type Measurement = With<Schemas["MeasurementBody"], { contact: Px; point: Px; budget: BudgetEntry[] }>;
export type Vehicle = With<Schemas["VehicleBody"], { measurements: Measurement[] }>;
export type VehicleFields = Pick<
  Vehicle,
  | "first_frame"
  | "best_frame"
  | "last_frame"
  | "make"
  | "model"
  | "year"
  | "category"
  | "manufacturer_height_m"
  | "u_manufacturer_height_m"
  | "height_source"
  | "lighting"
  | "notes"
>;
export type CatalogueRow = Schemas["EntryBody"];
export type History = With<Schemas["HistoryBody"], { revisions: Measurement[] }>;
export type ReviewItem = With<Schemas["QueueItemBody"], { measurement: Measurement }>;

export type Comparison = With<Schemas["ComparisonBody"], { repeat: Measurement }>;
export type Repeats = Schemas["FindingsBody"];
export type RepeatSpread = Schemas["SpreadBody"];
export type PersonRepeats = Schemas["OfPersonBody"];
export type TargetRepeats = Schemas["OfTargetBody"];
export type RepeatDifference = Schemas["DifferenceBody"];
export type ToClickAgain = Schemas["BlindBody"];

export type Photograph = Schemas["PhotographBody"];
export type ExportPackage = Schemas["ExportBody"];
export type AuditEvent = Schemas["AuditEventBody"];
export type AuditCheck = Schemas["VerificationBody"];

export type Scan = With<Schemas["ScanBody"], { job: Job | null }>;
export type ScanVehicle = Schemas["ScanVehicleBody"];
export type ScanMotion = Schemas["ScanMotionBody"];
export type ScanVehicleDetail = Schemas["ScanVehicleDetailBody"];
export type LinePose = Schemas["LinePoseBody"];
export type LinePoses = Schemas["LinePosesBody"];
export type RodMark = Schemas["RodMarkBody"];
export type SolvedRod = Schemas["SolvedRodBody"];
export type LineHeight = Schemas["LineHeightBody"];
export type LineHeightAnswer = Schemas["LineHeightAnswer"];
export type StripUpload = Schemas["StripUploadBody"];
export type ScanMethod = NonNullable<Schemas["FindWanted"]["method"]>;
export type ScanStatistics = Schemas["ScanStatisticsBody"];
export type ScanSpread = Schemas["ScanSpreadBody"];
export type ScanErrorGroup = Schemas["ScanErrorGroupBody"];
