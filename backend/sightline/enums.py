"""The closed lists of words that records use, and a few short names for types."""

from typing import Any, Literal

JsonObject = dict[str, Any]
FollowedPoint = Literal["contact", "second_contact", "target"]
Point = tuple[float, float]

Role = Literal["admin", "operator", "reviewer", "viewer"]
SurveyRole = Literal["manager", "operator", "reviewer", "viewer"]
ActingRole = Literal["admin", "manager", "operator", "reviewer", "viewer"]
# What an API token may be for. read: every question; upload: bring in recordings and find passes; measure:
# the rest of what an operator does; review: verdicts and lots; export: packages and results of studies
Scope = Literal["read", "upload", "measure", "review", "export"]
Target = Literal["roof", "driver_eye", "taillight", "headlight", "other"]
Hand = Literal["right", "left"]
CameraPlace = Literal["verge", "median"]
DriverSide = Literal["near", "far"]
SideBasis = Literal["said", "direction", "place"]
InsetSource = Literal["usual", "own"]
# clicked: by hand, the contact perhaps a proposed one where no target was proposed; confirmed: both as
# Sightline proposed them, accepted by a person; moved: begun from proposed points (contact or target), at
# least one of the two put by a person
MadeAsSaid = Literal["clicked", "confirmed", "moved"]
Made = Literal[MadeAsSaid, "snapped"]
ProposalKept = Literal["shown", "withheld"]
# what the demonstration shows of a vehicle: accepted, a roof that the reviewer fixed, a contact
# of a taillight that slipped and was rejected, or waiting for a verdict
DemoFate = Literal["accepted", "fixed", "slipped", "waits"]
GoalVerdict = Literal["met", "missed", "undecided"]
# what an operator tells apart by looking at a vehicle: which spot of the roof, which side the driver
InsetPlace = Literal["near_edge", "crown", "near", "far"]
InsetName = Literal[
    "roof",
    "roof_van",
    "roof_box",
    "roof_unknown",
    "driver_eye_near",
    "driver_eye_far",
    "taillight",
    "headlight",
    "other",
]
Lighting = Literal["daytime", "low_light"]
StreetLighting = Literal["on", "off"]
StreetLamps = Literal["present", "none"]
LightingGroup = Literal[Lighting, "unknown"]
Category = Literal[
    "hatchback",
    "saloon",
    "estate",
    "suv",
    "multi_purpose",
    "pickup",
    "van",
    "lorry",
    "tractor_unit",
    "bus",
    "recreational_vehicle",
    "trailer",
    "motorcycle",
    "other",
]
ClassSet = Literal["passenger_cars", "light_trucks", "heavy"]
EuClass = Literal["L", "M1", "M2", "M3", "N1", "N2", "N3", "O1", "O2", "O3", "O4", "T"]
RecordingState = Literal["ingesting", "ready", "failed"]
UploadPurpose = Literal["video", "strip"]
BoardKind = Literal["checkerboard", "charuco"]
BoardSide = Literal["top", "bottom"]
PatternSide = Literal["left", "right", "above", "below"]
LensModel = Literal["brown", "fisheye"]
CalibrationSource = Literal["images", "clip", "import"]
Display = Literal["plain", "bright"]
DriftState = Literal["still", "moved", "unknown"]
LogFormat = Literal["plain", "json"]
EndedState = Literal["done", "failed", "cancelled"]
JobState = Literal["queued", "running", EndedState]
MeasurementStatus = Literal["ok", "not_measurable"]
AcceptedVerdict = Literal["accepted", "fixed"]  # of heights that count
ReviewVerdict = Literal[AcceptedVerdict, "rejected", "reopened"]
Verdict = Literal["to_review", ReviewVerdict]
ComputingKind = Literal["asked", "sides", "adjustment", "undo"]
ComputingCause = Literal["pose", "inset", "side", "program"]
DoubtKind = Literal["above_roof", "below_lamp", "outside_class", "far_from_maker"]
ReviewSign = Literal["large_u", "unusual", "far_from_maker", "new_operator"]
LotGrouping = Literal["target", "lighting", "operator", "day"]
LotChoice = Literal["accepted", "full_inspection", "dissolved", "taken_back"]
LotState = Literal["open", LotChoice]
LotRole = Literal["sample", "rest", "left"]
LotLeaving = Literal["measured_again", "withdrawn", "vehicle_deleted", "verdict_of_its_own"]
VerdictBasis = Literal["individual", "lot"]
QueueState = Literal["to_review", AcceptedVerdict, "rejected", "all"]
TravelSource = Literal["followed", "measured", "assumed"]
InsetMethod = Literal["known_heights", "trend", "two_frames"]
DirectionSource = Literal["tyres", "two_frames"]
VehicleOrigin = Literal["person", "found"]
Direction = Literal["right", "left"]
VehicleState = Literal[
    "to_do", "partial", "measured", "not_visible", "rejected", "accepted", "out_of_sample", "discarded"
]
AskedTarget = Literal["roof", "driver_eye", "taillight", "headlight"]
# How its model was found where sizes told it. size: taken from the models that fit what was measured; seen:
# then recognised on the vehicle itself
ModelChosenBy = Literal["size", "seen"]
# What may be known of a vehicle beside the height of its roof, that the maker states
KnownTarget = Literal["driver_eye", "taillight", "headlight", "other"]
SamplingMethod = Literal["every", "nth", "share"]
Discarded = Literal["no_vehicle", "twice", "cut_off", "stopped", "other"]
PassEnd = Literal["measured", "not_visible", "open", "out_of_sample", "discarded"]
ResponseLighting = Literal["all", Lighting, "unknown"]
ResponseSet = Literal["all", ClassSet, "none"]
ProposedTarget = Literal["roof", "taillight", "headlight", "driver_eye"]
ProposedPoint = Literal["contact_rear", "contact_front", ProposedTarget]
WheelEnd = Literal["rear", "front"]
NotVisible = Literal["hidden", "glare", "too_dark", "outside", "own_body", "no_driver"]
StepKey = Literal["camera", "recordings", "pose", "vehicles", "review", "results"]
StepState = Literal["done", "next", "begun", "waiting"]
OptionalStepState = Literal["none", "open", "done"]
ScanState = Literal["live", "reading", "ready", "failed"]
ScanSource = Literal["strips", "video", "live"]
# silent: not heard for seconds; stopped: for so long that its process is gone, though it never ended
LiveState = Literal["running", "silent", "stopped", "ended"]
ScanMethod = Literal["direct", "paper"]
# which of the two cameras of a rig a vehicle reaches first
ScanDirection = Literal["camera_1_first", "camera_2_first"]
# who found the wheels that a vehicle's axles are counted by
AxlesBy = Literal["machine", "person"]
LaneBy = Literal["machine", "person"]
TimeAxis = Literal["width", "height"]
# frames per second at which a road is filmed: what a person may state
FILMED_HZ = (1.0, 2000.0)
# Why the times of a video are not those of filming.
ClockDoubt = Literal["slow_motion", "impossible_rate", "no_rate"]
# of a video: columns for traffic to the left or right; rows for traffic up or down, roofs to one side
CutAlong = Literal["columns", "rows_left_up", "rows_right_up"]
#: How a pass of a staff or a board tells of the baseline at its distance.
RigPassKind = Literal["positions", "speed", "board"]
Cause = Literal["found", "added", "boundaries", "wheels", "lane", "back", "again"]
ScanVerdict = Literal["accepted", "rejected", "reopened"]
ScanVehicleState = Literal["to_review", "accepted", "rejected", "not_measurable"]
ScanPoseStatus = Literal["ok", "not_solvable"]
LineClicksStatus = Literal[MeasurementStatus, "contact"]
KnownLength = Literal["length", "wheelbase"]
# What a scanned vehicle has of a measurement by something else, and by what: the car's own speedometer
# (counter), a radar or laser gun, GPS, loops in the road, a tape
ReferenceQuantity = Literal["speed", KnownLength]
ReferenceSource = Literal["counter", "radar", "laser", "gps", "loop", "tape", "other"]
ReferenceChange = Literal["new", "replaces", "same", "ambiguous", "refused"]
RunsVerdict = Literal["agree", "too_far_apart", "too_alike", "too_few"]
MatchPicture = Literal["first", "second", "difference"]
#: What of a line-scanned vehicle is held against a limit, on which side it must keep, and the answer.
JudgedQuantity = Literal["speed", "time_gap", "distance_gap"]
ExposureHint = Literal["dark", "wide", "tall"]
PlannedQuantity = Literal["length", JudgedQuantity]
LimitSide = Literal["upper", "lower"]
Conformity = Literal["conforming", "not_conforming", "undecided"]
StatisticsTarget = Literal["driver_eye", "taillight", "headlight", "roof"]
StatisticsState = Literal["accepted", "to_review", "rejected", "all"]
StandardHeight = Literal["eye_car", "eye_truck", "object_stopping", "object_passing", "headlight", "vehicle"]
EyeRule = Literal["eye_car", "eye_truck"]
Rounding = Literal["cm", "none"]
ErrorGrouping = Literal["all", "lighting", "category"]
Correction = Literal["inset", "shift", "none", "regression", "deconvolution"]
ComparisonVerdict = Literal["higher", "lower", "not_told_apart"]
RuleHeights = Literal["cars", "trucks", "all"]  # whose a rule is read on; all: no class is known
RuleVerdict = Literal["lower", "higher", "alike", "unknown"]
IntervalPart = Literal["sampling", "sites", "shared_errors", "random_error", "known_heights"]
LengthUnit = Literal["m", "ft"]
ModelSize = Literal["height", "length", "width", "wheelbase", "taillight", "headlight"]
SizeUnit = Literal["m", "cm", "mm", "ft", "in"]
CatalogueChange = Literal["new", "update", "same", "conflict", "duplicate", "refused"]
OnConflict = Literal["keep", "replace"]
SightKind = Literal[
    "stopping",
    "decision_a",
    "decision_b",
    "decision_c",
    "decision_d",
    "decision_e",
    "passing",
    "intersection_left",
    "intersection_right",
]
SightCase = Literal["standard", "survey", "mix"]
SightClasses = Literal["class", "chosen", "eyes", "objects", "all"]
CrestVerdict = Literal["alike", "shorter", "longer", "unknown"]
CurveCase = Literal["S < L", "S > L", "none"]
Manoeuvre = Literal["A", "B", "C", "D", "E"]
Crossing = Literal["left_from_stop", "right_from_stop", "crossing", "left_from_major"]

# What a new survey asks for: eyes by day, when drivers can be seen; lamps in low light, when they are lit.
USUALLY_ASKED: dict[Lighting, tuple[AskedTarget, ...]] = {
    "daytime": ("roof", "driver_eye"),
    "low_light": ("roof", "taillight"),
}
#: The databases that an installation can have.
DatabaseKind = Literal["sqlite", "postgresql"]
#: Where a key in a backup comes from: a file that is in it, a setting that is not, nowhere yet.
KeyFrom = Literal["file", "environment", "none"]
# what an audit event is about, and what was done
AuditEntity = Literal[
    "survey",
    "survey_member",
    "camera",
    "calibration_image",
    "calibration",
    "recording",
    "upload",
    "pose",
    "photograph",
    "catalogue",
    "vehicle",
    "measurement",
    "proposals",
    "review",
    "computing",
    "review_plan",
    "free_plan",
    "wheel_pair",
    "click_sigma",
    "standards",
    "scan",
    "scan_run",
    "lot",
    "lot_decision",
    "scan_vehicle",
    "scan_measurement",
    "scan_review",
    "scan_reference",
    "line_pose",
    "rig_calibration",
    "export",
    "evidence",
    "study",
    "study_result",
    "study_member",
    "package",
    "checkpoint",
    "signing_key",
    "person",
    "sign_in_link",
    "api_token",
    "job",
]
AuditAction = Literal[
    "accepted",
    "calibrate",
    "cancel",
    "cancelled",
    "check_drift",
    "choose",
    "choose_calibration",
    "compute_again",
    "create",
    "decide_drift",
    "delete",
    "detect",
    "dissolved",
    "done",
    "draw",
    "failed",
    "finish",
    "fix",
    "full_inspection",
    "import",
    "ingest",
    "ingest_failed",
    "order",
    "propose",
    "read",
    "reading_failed",
    "recorded",
    "release",
    "request",
    "requeue",
    "restart_ingest",
    "restart_reading",
    "restore",
    "retire",
    "review",
    "revise",
    "revoke",
    "run",
    "seal",
    "set_password",
    "sign",
    "sign_out",
    "swap_cameras",
    "take",
    "take_back_drift_decision",
    "taken_back",
    "undo",
    "update",
    "use",
    "withdraw",
]
