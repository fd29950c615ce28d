"""What the storage room gives back: frozen records, one per word of the design.

Times are aware datetimes in UTC; lengths metres; points (x, y) pixels; JSON documents are plain lists and
dicts, never to be changed in place. Arrays are read-only.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any, Literal, TypedDict

import numpy as np
import numpy.typing as npt

Json = Any
JsonObject = dict[str, Any]
Point = tuple[float, float]

Role = Literal["admin", "operator", "reviewer", "viewer"]
Target = Literal["roof", "driver_eye", "taillight", "headlight", "other"]
Lighting = Literal["daytime", "low_light"]
Category = Literal["hatchback", "saloon", "estate", "suv", "van", "lorry", "other"]
RecordingState = Literal["ingesting", "ready", "failed"]
CalibrationSource = Literal["images", "clip", "import"]
JobState = Literal["queued", "running", "done", "failed", "cancelled"]
MeasurementStatus = Literal["ok", "not_measurable"]
Verdict = Literal["to_review", "accepted", "fixed", "rejected", "reopened"]
ReviewVerdict = Literal["accepted", "fixed", "rejected", "reopened"]
VehicleState = Literal["to_do", "partial", "measured", "rejected", "accepted"]
StepKey = Literal["camera", "recordings", "pose", "vehicles", "review", "results"]
StepState = Literal["done", "next", "waiting"]

REQUIRED_TARGETS: tuple[Target, ...] = ("roof", "driver_eye", "taillight")


@dataclass(frozen=True, slots=True)
class Who:
    """A person as others see them."""

    id: int
    name: str


@dataclass(frozen=True, slots=True)
class Person:
    """An account. `session_key` changes when every signed-in session of theirs must end."""

    id: int
    name: str
    email: str
    role: Role
    active: bool
    created_at: datetime
    last_seen_at: datetime | None
    has_password: bool
    session_key: int


@dataclass(frozen=True, slots=True)
class Inset:
    """How far a target lies behind the side plane, metres, and its standard uncertainty."""

    inset_m: float
    u_inset_m: float
    note: str = ""


@dataclass(frozen=True, slots=True)
class SurveyCounts:
    """Computed when asked, never stored."""

    recordings: int = 0
    vehicles: int = 0
    vehicles_measured: int = 0
    measurements: int = 0
    to_review: int = 0
    accepted: int = 0
    rejected: int = 0


@dataclass(frozen=True, slots=True)
class Step:
    """One step of a survey's work, and what to do next in it."""

    key: StepKey
    state: StepState
    summary: str


@dataclass(frozen=True, slots=True)
class Survey:
    id: int
    name: str
    site: str
    description: str
    is_demo: bool
    version: int
    created_at: datetime
    insets: Mapping[str, Inset]
    counts: SurveyCounts
    steps: tuple[Step, ...]


@dataclass(frozen=True, slots=True)
class CalibrationSummary:
    id: int
    camera_id: int
    created_at: datetime
    created_by: Who | None
    source: CalibrationSource
    trusted: bool
    summary: str


@dataclass(frozen=True, slots=True)
class Calibration:
    """A calibration with its camera.json `document`; never changed once written."""

    id: int
    camera_id: int
    created_at: datetime
    created_by: Who | None
    source: CalibrationSource
    trusted: bool
    summary: str
    document: JsonObject
    warnings: list[str]
    coverage: list[list[int]]
    views: list[JsonObject]
    recording_id: int | None


@dataclass(frozen=True, slots=True)
class CalibrationImage:
    id: int
    camera_id: int
    name: str
    media_key: str
    width_px: int
    height_px: int
    found: bool
    reason: str | None
    corners_px: list[list[float]]
    columns: int
    rows: int
    sharpness: float | None


@dataclass(frozen=True, slots=True)
class Camera:
    id: int
    survey_id: int
    name: str
    notes: str
    current_calibration_id: int | None
    images: int
    calibrations: tuple[CalibrationSummary, ...]


@dataclass(frozen=True, slots=True)
class Upload:
    """A file on its way in; `offset` bytes have arrived."""

    id: int
    survey_id: int
    filename: str
    size_bytes: int
    offset: int
    media_key: str
    created_at: datetime
    created_by: Who | None
    recording_id: int | None
    finished_at: datetime | None


@dataclass(frozen=True, slots=True)
class Job:
    """A piece of long work; the job table owns the truth about it."""

    id: int
    kind: str
    state: JobState
    payload: JsonObject
    progress: float
    message: str
    error: str | None
    result: JsonObject | None
    survey_id: int | None
    recording_id: int | None
    created_by: int | None
    created_at: datetime
    started_at: datetime | None
    finished_at: datetime | None
    attempts: int
    worker: str | None
    lease_until: datetime | None
    cancel_requested: bool


@dataclass(frozen=True, slots=True)
class Facts:
    """What the ingest found out about a video."""

    width_px: int
    height_px: int
    duration_s: float
    codec: str
    container: str
    vfr: bool
    notes: list[str] = field(default_factory=list)
    report: JsonObject = field(default_factory=dict)
    thumbs: list[int] = field(default_factory=list)
    lighting_proposed: Lighting | None = None


@dataclass(frozen=True, slots=True)
class Recording:
    """A video. Facts are None until it is ready; `thumbs` are the frame numbers that have a thumbnail."""

    id: int
    survey_id: int
    name: str
    state: RecordingState
    error: str | None
    job: Job | None
    media_key: str
    sha256: str
    size_bytes: int
    width_px: int | None
    height_px: int | None
    frame_count: int | None
    duration_s: float | None
    codec: str | None
    container: str | None
    vfr: bool
    notes: list[str]
    report: JsonObject
    thumbs: list[int]
    camera_id: int | None
    pose_id: int | None
    lighting: Lighting | None
    lighting_proposed: Lighting | None
    created_at: datetime


class RecordingChanges(TypedDict, total=False):
    """What people may change of a recording; keys left out stay as they are."""

    name: str
    camera_id: int | None
    pose_id: int | None
    lighting: Lighting | None


@dataclass(frozen=True, slots=True)
class Frame:
    n: int
    pts: int
    time_s: float
    key: bool
    crc32: int


@dataclass(frozen=True, eq=False, slots=True)
class FrameTable:
    """Frames `first .. first + len - 1` of a recording, as read-only arrays of equal length."""

    first: int
    pts: npt.NDArray[np.int64]
    time_s: npt.NDArray[np.float64]
    key: npt.NDArray[np.bool_]
    crc32: npt.NDArray[np.uint32]

    def __len__(self) -> int:
        return len(self.pts)


@dataclass(frozen=True, slots=True)
class PoseSummary:
    id: int
    survey_id: int
    recording_id: int
    calibration_id: int
    created_at: datetime
    created_by: Who | None
    first_frame: int
    last_frame: int
    rms_px: float | None
    distance_m: float | None
    summary: str


@dataclass(frozen=True, slots=True)
class Pose:
    """A road pose with its pose.json `document`; never changed once written."""

    id: int
    survey_id: int
    recording_id: int
    calibration_id: int
    created_at: datetime
    created_by: Who | None
    first_frame: int
    last_frame: int
    rms_px: float | None
    distance_m: float | None
    summary: str
    document: JsonObject
    warnings: list[str]
    expected: list[JsonObject]
    overlay: JsonObject


@dataclass(frozen=True, slots=True)
class CatalogueRow:
    """One model as it comes in; lengths in metres, None where unknown."""

    make: str
    model: str
    year_from: int | None = None
    year_to: int | None = None
    category: Category | None = None
    height_m: float | None = None
    length_m: float | None = None
    width_m: float | None = None
    wheelbase_m: float | None = None
    source: str = ""


@dataclass(frozen=True, slots=True)
class CatalogueEntry:
    id: int
    make: str
    model: str
    year_from: int | None
    year_to: int | None
    category: Category | None
    height_m: float | None
    length_m: float | None
    width_m: float | None
    wheelbase_m: float | None
    source: str


@dataclass(frozen=True, slots=True)
class CatalogueImport:
    added: int
    updated: int


class VehicleChanges(TypedDict, total=False):
    """The fields of a vehicle record that people fill in; keys left out stay as they are."""

    first_frame: int
    last_frame: int
    best_frame: int | None
    make: str | None
    model: str | None
    year: int | None
    category: Category | None
    manufacturer_height_m: float | None
    u_manufacturer_height_m: float | None
    height_source: str | None
    lighting: Lighting | None
    notes: str


@dataclass(frozen=True, slots=True)
class MeasurementValues:
    """The content of one revision: what was clicked, on what, and the height computed from it."""

    target: Target
    frame: int
    pts: int
    time_s: float
    frame_crc: int
    contact: Point
    point: Point
    sigma_px: float
    pose_id: int
    calibration_id: int
    inset_m: float
    u_inset_m: float
    height_m: float | None
    uncorrected_height_m: float | None
    u_height_m: float | None
    U95_height_m: float | None
    distance_m: float | None
    status: MeasurementStatus
    reason: str | None
    flags: list[str]
    budget: list[JsonObject]
    code_version: str


@dataclass(frozen=True, slots=True)
class ReviewState:
    """The verdict on a revision; `to_review` while nobody has looked."""

    verdict: Verdict
    reason: str | None = None
    reviewer: Who | None = None
    at: datetime | None = None


@dataclass(frozen=True, slots=True)
class Measurement:
    """One revision of a measurement (`id` is the series); lists and lookups give the current one."""

    id: int
    revision: int
    revision_id: int
    survey_id: int
    vehicle_id: int
    recording_id: int
    target: Target
    frame: int
    pts: int
    time_s: float
    frame_crc: int
    contact: Point
    point: Point
    sigma_px: float
    pose_id: int
    calibration_id: int
    inset_m: float
    u_inset_m: float
    height_m: float | None
    uncorrected_height_m: float | None
    u_height_m: float | None
    U95_height_m: float | None
    distance_m: float | None
    status: MeasurementStatus
    reason: str | None
    flags: list[str]
    budget: list[JsonObject]
    code_version: str
    created_by: Who | None
    created_at: datetime
    withdrawn: bool
    review: ReviewState


@dataclass(frozen=True, slots=True)
class Review:
    """One verdict given; `revision` is the one that was looked at."""

    id: int
    measurement_id: int
    revision: int
    result_revision: int
    verdict: ReviewVerdict
    reason: str | None
    reviewer: Who | None
    at: datetime


@dataclass(frozen=True, slots=True)
class MeasurementHistory:
    """Everything ever said about one measurement, oldest first."""

    revisions: tuple[Measurement, ...]
    reviews: tuple[Review, ...]


@dataclass(frozen=True, slots=True)
class Vehicle:
    id: int
    survey_id: int
    recording_id: int
    number: int
    first_frame: int
    last_frame: int
    best_frame: int | None
    make: str | None
    model: str | None
    year: int | None
    category: Category | None
    manufacturer_height_m: float | None
    u_manufacturer_height_m: float | None
    height_source: str | None
    lighting: Lighting | None
    notes: str
    version: int
    updated_by: Who | None
    updated_at: datetime
    deleted: bool
    state: VehicleState
    measurements: tuple[Measurement, ...]


@dataclass(frozen=True, slots=True)
class QueueItem:
    """A measurement waiting for a reviewer; `mine` when the asker made this revision."""

    measurement: Measurement
    vehicle: Vehicle
    mine: bool


@dataclass(frozen=True, slots=True)
class Export:
    id: int
    survey_id: int
    created_at: datetime
    created_by: Who | None
    media_key: str
    size_bytes: int
    sha256: str
    audit_count: int
    audit_head: str


@dataclass(frozen=True, slots=True)
class AuditEvent:
    id: int
    at: datetime
    actor: Who | None
    action: str
    entity: str
    entity_id: int | None
    survey_id: int | None
    before: JsonObject | None
    after: JsonObject | None
    hash: str
    previous_hash: str


@dataclass(frozen=True, slots=True)
class AuditHead:
    """How many events the chain has and the hash of the last; kept outside, it proves nothing was cut off."""

    count: int
    hash: str


@dataclass(frozen=True, slots=True)
class Verification:
    """The answer of an audit check; `problem` is one sentence, None when all is well."""

    ok: bool
    checked: int
    head_hash: str
    problem: str | None
