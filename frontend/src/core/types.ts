/** What the server sends and takes: the types of its own description (`make types`) by their names, and shorter names of
 *  some. Lengths in metres, times ISO 8601 UTC. */
import type { components } from "#schema";
import { wordsOf } from "./messages";

export type * from "#schema";

type Schemas = components["schemas"];

/** A point in the picture, pixels; (0, 0) is the centre of the top-left pixel. */
export type Px = [x: number, y: number];

export type Role = Schemas["PersonFacts"]["role"];
export type Target = Schemas["MeasurementBody"]["target"];
export type Verdict = Schemas["ReviewState"]["verdict"];
export type StepKey = Schemas["Step"]["key"];
export type Lighting = NonNullable<Schemas["VehicleBody"]["lighting"]>;
export type Direction = NonNullable<Schemas["VehicleBody"]["direction"]>;
export type DriverSide = NonNullable<Schemas["VehicleBody"]["driver_side"]>;
export type Category = NonNullable<Schemas["VehicleBody"]["category"]>;

export const ROLE_NAMES = wordsOf("role-", "viewer", "operator", "reviewer", "admin");

export type SurveyRole = Schemas["Member"]["role"];
export type Members = Schemas["MembersBody"];
export type Member = Members["members"][number];
/** What a person is in the survey that is open: a member's role, or that of the account. */
export type ActingRole = Survey["my_role"];
export const SURVEY_ROLE_NAMES = wordsOf("role-", "viewer", "operator", "reviewer", "manager");

export type Person = Schemas["PersonFacts"];
export type ApiToken = Schemas["ApiTokenFacts"];

export type Study = Schemas["StudyPage"]["study"];
export type StudyResult = NonNullable<Schemas["StudyPage"]["result"]>;

export type Survey = Schemas["SurveyBody"];
/** How traffic goes at a site and where the camera stands; null: nobody has said. */
export type Traffic = Survey["traffic"];
/** Where its site lies and what road it is; null: nobody has said. */
export type Place = Survey["place"];
export type Asked = Survey["asked"];
export type AskedTarget = Asked["daytime"][number];
/** What may be known of a vehicle beside the height of its roof. */
export type KnownTarget = keyof Vehicle extends infer K
  ? K extends `known_${infer T}_m`
    ? T
    : never
  : never;
export type NotVisible = NonNullable<Schemas["VehicleBody"]["roof_not_visible"]>;
/** What a survey makes of a class of vehicles: its set, and what the EU and FHWA call it. */
export type VehicleClass = Survey["classes"][number];
export type ClassSet = NonNullable<VehicleClass["class_set"]>;
export type Sampling = Survey["sampling"];
export type Quota = Sampling["quotas"][number];
export type ModelChosenBy = NonNullable<Schemas["VehicleBody"]["model_chosen_by"]>;
export type ModelSize = Schemas["MeasuredSize"]["size"];
export type Discarded = NonNullable<Schemas["VehicleBody"]["discarded"]>;
export type InsetName = keyof Survey["insets"];
export type InsetPlace = Schemas["InsetChoice"]["place"];

export type CameraView = Schemas["ViewBody"];
export type Calibration = Schemas["CalibrationBody"];
export type CalibrationImage = Schemas["CalibrationImageBody"];

export type Job = Schemas["JobBody"];
/** What was found of a camera that moved since its road pose. */
export type Drift = Schemas["DriftBody"];
export type DriftCheck = NonNullable<Drift["check"]>;
export type Made = Measurement["made"];
export type Recording = Schemas["RecordingBody"];
export type RecordingChange = Partial<Schemas["RecordingChange"]>;
export type UnfinishedUpload = Schemas["UploadBody"];

export type BoardFinding = Schemas["BoardView"];
export type AxisLines = Schemas["DrawnAxes"];
export type PoseSummary = Schemas["PoseSummaryBody"];
export type Pose = Schemas["PoseBody"];

export type AxesAnswer = Schemas["Ruler"];
export type BudgetEntry = Schemas["BudgetPart"];
export type HeightAnswer = Schemas["Answer"];
export type SecondFrameAnswer = Schemas["Proposal"];

export type Measurement = Schemas["MeasurementBody"];
export type Vehicle = Schemas["VehicleBody"];
export type CatalogueRow = Schemas["CatalogueEntry"];
export type ModelFits = Schemas["WhichModel"];
export type History = Schemas["HistoryBody"];
export type ReviewItem = Schemas["QueueItemBody"];

export type Comparison = Schemas["ComparisonBody"];
export type Repeats = Schemas["Findings"];
export type ProposedTarget = Schemas["OfProposedTarget"];
export type RepeatSpread = Schemas["Spread"];
export type PersonRepeats = Schemas["OfPerson"];
export type TargetRepeats = Schemas["OfTarget"];
export type RepeatDifference = Schemas["Difference"];
export type ToClickAgain = Schemas["Blind"];

export type Computings = Schemas["ComputingsBody"];

/** What the curves of a figure are drawn from; lengths in metres. */
export type Ecdf = Schemas["EcdfBody"];
export type Density = Schemas["DensityBody"];

export type Photograph = Schemas["PhotographBody"];
export type ExportPackage = Schemas["ExportBody"];
export type AuditCheck = Schemas["Verification"];

export type Scan = Schemas["ScanBody"];
export type ScanVehicle = Schemas["ScanVehicleBody"];
export type ScanMotion = Schemas["ScanMotionBody"];
export type ScanVehicleDetail = Schemas["ScanVehicleDetailBody"];
export type LinePose = Schemas["ShownLinePose"];
export type RodMark = Schemas["Mark"];
export type LineHeight = Schemas["ScanHeightBody"];
export type LineHeightAnswer = Schemas["HeightPreview"];
export type ScanMethod = NonNullable<Schemas["FindWanted"]["method"]>;
export type ScanStatistics = Schemas["ScanStatisticsBody"];
export type ScanReference = ScanVehicle["references"][number];
export type ReferenceQuantity = ScanReference["quantity"];
export type ReferenceSource = ScanReference["source"];
export type ScanSpread = Schemas["ScanSpreadBody"];
export type TrafficOfScans = Schemas["ScanFlows"];
export type TrafficInterval = Schemas["ShownInterval"];
export type TrafficFigure = Schemas["Figure"];
export type ScanErrorGroup = Schemas["ErrorFiguresBody"];
