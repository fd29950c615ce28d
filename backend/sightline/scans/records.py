"""Records of line-scan recordings: frozen, as `records` has them for videos."""

from dataclasses import dataclass
from datetime import datetime
from typing import TypedDict

from sightline.enums import (
    Category,
    Cause,
    JsonObject,
    Lighting,
    MeasurementStatus,
    OptionalStepState,
    ScanMethod,
    ScanSource,
    ScanState,
    ScanVehicleState,
    ScanVerdict,
    TimeAxis,
    VehicleOrigin,
)
from sightline.infra.audit.records import Who
from sightline.infra.jobs.records import Job
from sightline.linescan.parts import Rig
from sightline.measurements.records import ReviewState


@dataclass(frozen=True, slots=True)
class StripSource:
    """A strip that was uploaded: its file name, where its bytes are, and their hash."""

    name: str
    media_key: str
    sha256: str
    upload_id: int | None = None


@dataclass(frozen=True, slots=True)
class ColumnSource:
    """A video that the strips are cut from, along two pixel columns; the first is reached first."""

    recording_id: int
    column_1_px: int
    column_2_px: int


@dataclass(frozen=True, slots=True)
class StripFacts:
    """What the reading found: both tiled forms with their hashes, and what is to be said about them."""

    first_key: str
    second_key: str
    first_sha256: str
    second_sha256: str
    rows_px: int
    lines: int
    bits: int
    notes: list[str]


@dataclass(frozen=True, slots=True)
class ScanCounts:
    """Computed when asked, never stored; `older` were measured with other values of the rig.

    `heights`: standing heights of targets, and those among them that wait for a verdict.
    """

    vehicles: int = 0
    to_review: int = 0
    accepted: int = 0
    rejected: int = 0
    not_measurable: int = 0
    older: int = 0
    heights: int = 0
    heights_to_review: int = 0


@dataclass(frozen=True, slots=True)
class Scan:
    """A pair of strips. Facts are None until it is ready; `first` is the camera that is reached first."""

    id: int
    survey_id: int
    name: str
    state: ScanState
    error: str | None
    job: Job | None
    source: ScanSource
    recording_id: int | None
    column_1_px: int | None
    column_2_px: int | None
    first_name: str | None
    second_name: str | None
    first_source_key: str | None
    second_source_key: str | None
    first_source_sha256: str | None
    second_source_sha256: str | None
    time_axis: TimeAxis
    first_key: str | None
    second_key: str | None
    first_sha256: str | None
    second_sha256: str | None
    rows_px: int | None
    lines: int | None
    bits: int | None
    notes: list[str]
    rig: Rig
    lighting: Lighting | None
    counts: ScanCounts
    run: "ScanRun | None"
    version: int
    created_by: Who | None
    created_at: datetime
    updated_by: Who | None
    updated_at: datetime


class ScanChanges(TypedDict, total=False):
    """What people may change of a scan; keys left out stay as they are."""

    name: str
    lighting: Lighting | None
    baseline_m: float
    u_baseline_m: float
    line_rate_hz: float
    u_line_rate_ratio: float
    divergence_rad: float
    u_divergence_rad: float
    distance_m: float | None
    misalignment_px: float | None
    u_misalignment_px: float


@dataclass(frozen=True, slots=True)
class ScanRunValues:
    """What a run of the finder did: with which method and rig, how many it found and measured."""

    method: ScanMethod
    rig: JsonObject
    found: int
    measured: int
    summary: JsonObject
    warnings: list[str]
    code_version: str


@dataclass(frozen=True, slots=True)
class ScanRun:
    id: int
    scan_id: int
    job_id: int | None
    method: ScanMethod
    rig: JsonObject
    found: int
    measured: int
    summary: JsonObject
    warnings: list[str]
    code_version: str
    created_by: Who | None
    created_at: datetime


@dataclass(frozen=True, slots=True)
class ScanValues:
    """The content of one revision: boundaries, the rig they were measured with, and the motion.

    `cause`: what made it. `placed_by`: who placed the boundaries or wheels that stand in it, None where the
    machine found them. `budget`: {source, u_speed_mps, u_acceleration_mps2, u_length_m} each. `profile`:
    columns line_1, speed_mps, fitted_mps, used of equal length.
    """

    cause: Cause
    placed_by: int | None
    run_id: int | None
    method: ScanMethod
    rig: JsonObject
    front_line_1: float
    rear_line_1: float
    front_line_2: float
    rear_line_2: float
    speed_mps: float | None
    u_speed_mps: float | None
    acceleration_mps2: float | None
    u_acceleration_mps2: float | None
    length_m: float | None
    u_length_m: float | None
    fit_error_percent: float | None
    misalignment_px: float | None
    u_misalignment_px: float | None
    gain: float | None
    correlation: float | None
    front_wheel_line: float | None
    rear_wheel_line: float | None
    wheelbase_m: float | None
    u_wheelbase_m: float | None
    status: MeasurementStatus
    reason: str | None
    budget: list[JsonObject]
    profile: JsonObject | None
    warnings: list[str]
    code_version: str


@dataclass(frozen=True, slots=True)
class ScanMeasurement:
    """One revision of a vehicle's motion. `values.profile` is None in lists, where nobody draws it."""

    id: int
    survey_id: int
    scan_id: int
    vehicle_id: int
    revision: int
    values: ScanValues
    created_by: Who | None
    created_at: datetime
    review: ReviewState


class ScanVehicleChanges(TypedDict, total=False):
    """What people fill in about a scanned vehicle; keys left out stay as they are."""

    make: str | None
    model: str | None
    year: int | None
    category: Category | None
    true_length_m: float | None
    u_true_length_m: float | None
    true_wheelbase_m: float | None
    u_true_wheelbase_m: float | None
    facts_source: str | None
    lighting: Lighting | None
    notes: str


@dataclass(frozen=True, slots=True)
class ScanVehicle:
    """A vehicle of a scan with its current measurement; `true_` lengths are the manufacturer's."""

    id: int
    survey_id: int
    scan_id: int
    number: int
    origin: VehicleOrigin
    make: str | None
    model: str | None
    year: int | None
    category: Category | None
    true_length_m: float | None
    u_true_length_m: float | None
    true_wheelbase_m: float | None
    u_true_wheelbase_m: float | None
    facts_source: str | None
    lighting: Lighting | None
    notes: str
    version: int
    updated_by: Who | None
    updated_at: datetime
    deleted: bool
    measurement: ScanMeasurement | None

    @property
    def state(self) -> ScanVehicleState:
        """What is to be done with it, from its current measurement and the verdict on that."""
        if self.measurement is None:
            return state_of(None, None)
        return state_of(self.measurement.values.status, self.measurement.review.verdict)


def state_of(status: str | None, verdict: str | None) -> ScanVehicleState:
    """The state of a vehicle by its measurement's status (None: not measured) and the verdict on it."""
    if verdict in ("accepted", "rejected"):
        return "accepted" if verdict == "accepted" else "rejected"
    return "to_review" if status == "ok" else "not_measurable"


@dataclass(frozen=True, slots=True)
class ScanReview:
    """One verdict given on a revision."""

    id: int
    measurement_id: int
    vehicle_id: int
    revision: int
    verdict: ScanVerdict
    reason: str | None
    reviewer: Who | None
    at: datetime


@dataclass(frozen=True, slots=True)
class ScanProgress:
    """The line scans of a survey: vehicles and heights by what was done with them, and what to do next."""

    state: OptionalStepState
    summary: str
    scans: int = 0
    ready: int = 0
    vehicles: int = 0
    to_review: int = 0
    accepted: int = 0
    rejected: int = 0
    not_measurable: int = 0
    heights: int = 0
    heights_to_review: int = 0
