"""The closed lists of words that records use, and a few short names for types."""

from typing import Any, Literal

Json = Any
JsonObject = dict[str, Any]
Point = tuple[float, float]

Role = Literal["admin", "operator", "reviewer", "viewer"]
Target = Literal["roof", "driver_eye", "taillight", "headlight", "other"]
Lighting = Literal["daytime", "low_light"]
Category = Literal["hatchback", "saloon", "estate", "suv", "van", "lorry", "other"]
RecordingState = Literal["ingesting", "ready", "failed"]
UploadPurpose = Literal["video", "strip"]
CalibrationSource = Literal["images", "clip", "import"]
JobState = Literal["queued", "running", "done", "failed", "cancelled"]
MeasurementStatus = Literal["ok", "not_measurable"]
Verdict = Literal["to_review", "accepted", "fixed", "rejected", "reopened"]
ReviewVerdict = Literal["accepted", "fixed", "rejected", "reopened"]
VehicleOrigin = Literal["person", "found"]
Direction = Literal["right", "left"]
VehicleState = Literal["to_do", "partial", "measured", "rejected", "accepted"]
StepKey = Literal["camera", "recordings", "pose", "vehicles", "review", "results"]
StepState = Literal["done", "next", "waiting"]
ScanState = Literal["reading", "ready", "failed"]
ScanSource = Literal["strips", "video"]
ScanMethod = Literal["direct", "paper"]
TimeAxis = Literal["width", "height"]
Cause = Literal["found", "added", "boundaries", "wheels", "again"]
ScanVerdict = Literal["accepted", "rejected", "reopened"]
ScanVehicleState = Literal["to_review", "accepted", "rejected", "not_measurable"]

REQUIRED_TARGETS: tuple[Target, ...] = ("roof", "driver_eye", "taillight")
