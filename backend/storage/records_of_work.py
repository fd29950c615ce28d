"""Records of vehicles, measurements, reviews, jobs, exports and the audit chain (see `records`)."""

from dataclasses import dataclass
from datetime import datetime
from typing import TypedDict

from backend.storage.words import (
    Category,
    Direction,
    JobState,
    JsonObject,
    Lighting,
    MeasurementStatus,
    Point,
    ReviewVerdict,
    Target,
    VehicleOrigin,
    VehicleState,
    Verdict,
)


@dataclass(frozen=True, slots=True)
class Who:
    """A person as others see them."""

    id: int
    name: str


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
    scan_id: int | None = None


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
    origin: VehicleOrigin
    direction: Direction | None
    detection: JsonObject | None


@dataclass(frozen=True, slots=True)
class FurtherFrame:
    """The same two points, clicked on another frame of the pass."""

    frame: int
    pts: int
    time_s: float
    frame_crc: int
    contact: Point
    point: Point


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
    more_frames: tuple[FurtherFrame, ...] = ()
    solved_inset_m: float | None = None
    u_solved_inset_m: float | None = None


@dataclass(frozen=True, slots=True)
class ReviewState:
    """The verdict on a revision; `to_review` while nobody has looked."""

    verdict: Verdict
    reason: str | None = None
    reviewer: Who | None = None
    at: datetime | None = None


@dataclass(frozen=True, slots=True)
class Measurement:
    """One revision of a measurement (`id` is the series); lists and lookups give the current one.

    `repeat_of`: the measurement that this one repeats, which then stands in no list and counts for no result.
    """

    id: int
    revision: int
    revision_id: int
    survey_id: int
    vehicle_id: int
    recording_id: int
    repeat_of: int | None
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
    more_frames: tuple[FurtherFrame, ...]
    solved_inset_m: float | None
    u_solved_inset_m: float | None
    created_by: Who | None
    created_at: datetime
    withdrawn: bool
    review: ReviewState
    #: Derived when read, never stored: the camera had moved on this frame.
    drift_flag: str | None = None

    @property
    def all_flags(self) -> list[str]:
        """What was stored, and what was found out since about the camera."""
        return self.flags if self.drift_flag is None else [*self.flags, self.drift_flag]


@dataclass(frozen=True, slots=True)
class WheelPair:
    """Both tyre contacts of a vehicle on one frame; `pose_id` is the recording's pose in force."""

    id: int
    vehicle_id: int
    vehicle_number: int
    recording_id: int
    frame: int
    pts: int
    time_s: float
    frame_crc: int
    first: Point
    second: Point
    withdrawn: bool
    pose_id: int | None
    created_by: Who | None
    created_at: datetime


@dataclass(frozen=True, slots=True)
class ClickSigma:
    """A person's own click sigma in a survey, from `pairs` repeats; None: the usual one."""

    id: int
    survey_id: int
    person: Who | None
    sigma_px: float | None
    pairs: int
    created_by: Who | None
    created_at: datetime


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
    origin: VehicleOrigin
    direction: Direction | None
    detection: JsonObject | None
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
    content_sha256: str


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
