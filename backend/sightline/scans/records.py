"""Records of line-scan recordings: frozen, as `records` has them for videos."""

from collections.abc import Mapping
from dataclasses import dataclass, fields
from datetime import datetime
from typing import Annotated, Any, Generic, TypeVar

from pydantic import Field

from sightline.enums import (
    AxlesBy,
    Category,
    Cause,
    CutAlong,
    JsonObject,
    LaneBy,
    Lighting,
    MeasurementStatus,
    OptionalStepState,
    ScanDirection,
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
from sightline.messages.said import Said
from sightline.scans.clock import CLOCK, ScanClock, clock_of

Values = TypeVar("Values")


@dataclass(frozen=True, slots=True)
class StoredRevision(Generic[Values]):
    """One calibration of something of a scan; the newest revision counts."""

    id: int
    survey_id: int
    scan_id: int
    revision: int
    values: Values
    created_by: Who | None
    created_at: datetime


@dataclass(frozen=True, slots=True)
class StripSource:
    """A strip that was uploaded: its file name, where its bytes are, and their hash."""

    name: str
    media_key: str
    sha256: str
    upload_id: int | None = None


@dataclass(frozen=True, slots=True)
class LiveSource:
    """Live lines, which become strips when the stream ends."""


@dataclass(frozen=True, slots=True)
class CutSource:
    """A video that the strips are cut from, along two pixel columns or rows; the first is reached first."""

    recording_id: int
    cut_along: CutAlong
    cut_1_px: int
    cut_2_px: int


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
    notes: list[Said]


@dataclass(frozen=True, slots=True)
class ScanCounts:
    """The vehicles of a scan by state; computed when asked, never stored."""

    vehicles: int = 0
    to_review: int = 0
    accepted: int = 0
    rejected: int = 0
    not_measurable: int = 0
    older: Annotated[
        int, Field(description="Measured with other values of the rig; find again brings them up.")
    ] = 0
    heights: Annotated[int, Field(description="Standing heights of targets.")] = 0
    heights_to_review: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class StripPair:
    """What is said of a pair of strips in an answer too. Facts are None until it is ready."""

    id: int
    survey_id: int
    name: str
    state: ScanState
    error: Said | None
    source: ScanSource
    recording_id: int | None
    cut_along: CutAlong | None
    cut_1_px: int | None
    cut_2_px: int | None
    first_name: str | None
    second_name: str | None
    time_axis: TimeAxis
    rows_px: int | None
    lines: int | None
    bits: int | None
    notes: list[Said]
    rig: Rig
    lighting: Lighting | None
    heard_at: Annotated[
        datetime | None, Field(description="When its live stream was last heard; null: not live.")
    ]
    start_proposed: Annotated[
        datetime | None,
        Field(description="When the video that it was cut from began; for a person to confirm."),
    ]
    started_at: Annotated[datetime | None, Field(description="When line 0 was taken, as a person confirmed.")]
    time_zone: str | None
    u_start_s: Annotated[float | None, Field(description="Standard uncertainty of started_at (k = 1).")]
    counts: ScanCounts
    version: int
    created_by: Who | None
    created_at: datetime
    updated_by: Who | None
    updated_at: datetime


@dataclass(frozen=True, slots=True, kw_only=True)
class Scan(StripPair):
    """A pair of strips; `first` is the camera that is reached first."""

    job: Job | None
    first_source_key: str | None
    second_source_key: str | None
    first_source_sha256: str | None
    second_source_sha256: str | None
    first_key: str | None
    second_key: str | None
    first_sha256: str | None
    second_sha256: str | None
    run: "ScanRun | None"

    @property
    def clock(self) -> ScanClock | None:
        """Its clock; None while nobody has confirmed the start."""
        return clock_of({name: getattr(self, name) for name in CLOCK})


#: What people change of a scan or of a vehicle of it, by name; what is left out stays as it is.
Changes = Mapping[str, Any]


@dataclass(frozen=True, slots=True, kw_only=True)
class RunSummary:
    """What the traffic says of the cameras, of so many `vehicles`."""

    misalignment_px: float | None = None
    u_misalignment_px: float | None = None
    misalignment_words: Said | None = None
    vehicles: int = 0
    gain: float | None = None
    u_gain: float | None = None


@dataclass(frozen=True, slots=True)
class ScanRunValues:
    """What a run of the finder did: with which method and rig, how many it found and measured."""

    method: ScanMethod
    rig: Annotated[JsonObject, Field(exclude=True)]
    found: int
    measured: int
    summary: RunSummary
    warnings: list[Said]
    code_version: str


@dataclass(frozen=True, slots=True)
class ScanRun(ScanRunValues):
    """One search for vehicles, and what it says of the recording."""

    id: int
    scan_id: int
    job_id: int | None
    created_by: Who | None
    created_at: datetime


@dataclass(frozen=True, slots=True, kw_only=True)
class FoundMotion:
    """Boundaries of a vehicle and its motion; speed and acceleration as the front is at camera 1."""

    cause: Cause
    method: ScanMethod
    direction: Annotated[
        ScanDirection,
        Field(
            description="Which camera it reached first; speed and gaps are those at camera 1 all the same."
        ),
    ]
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
    front_wheel_line: float | None
    rear_wheel_line: float | None
    wheelbase_m: float | None
    u_wheelbase_m: float | None
    axle_lines: Annotated[
        list[float] | None, Field(description="Of strip 1, at each wheel's hub; null: not looked for.")
    ]
    axles_by: AxlesBy | None
    lane: Annotated[
        str | None, Field(description="Of the rig's lanes; none where it is not known, or the rig has none.")
    ]
    lane_by: LaneBy | None
    tyres_px: Annotated[
        float | None,
        Field(
            description="Row of strip 1 at which its tyres meet the road, if the lane was assigned by it; "
            "none where it was not looked for."
        ),
    ]
    status: MeasurementStatus
    reason: Said | None
    warnings: list[Said]
    code_version: str


@dataclass(frozen=True, slots=True, kw_only=True)
class ScanValues(FoundMotion):
    """The content of one revision: boundaries, the rig they were measured with, and the motion.

    `placed_by`: who placed the boundaries or wheels that stand in it, None where the machine found them.
    `budget`: {source, u_speed_mps, u_acceleration_mps2, u_length_m} each. `profile`: columns line_1,
    speed_mps, fitted_mps, used of equal length. `u_boundaries_m`: what the doubt about found boundaries
    brings to the length's u.
    """

    placed_by: int | None
    run_id: int | None
    rig: JsonObject
    correlation: float | None
    u_boundaries_m: float
    budget: list[JsonObject]
    profile: JsonObject | None

    @property
    def axles(self) -> int | None:
        """How many axles it has; None where no wheel is known."""
        return len(self.axle_lines) if self.axle_lines else None


# What made a revision and by whom, and what follows from the rest.
_NOT_CONTENT = ("cause", "placed_by", "run_id", "budget", "profile", "code_version")


def same_motion(then: ScanValues, now: ScanValues) -> bool:
    """Whether one has the very boundaries, wheels, rig and numbers of another, whoever made it."""
    names = [one.name for one in fields(ScanValues) if one.name not in _NOT_CONTENT]
    return all(getattr(then, name) == getattr(now, name) for name in names)


@dataclass(frozen=True, slots=True)
class ScanMeasurement:
    """One revision of a vehicle's motion. `values.profile` is None in lists, where nobody draws it.

    `verdict_of_id`: the earlier revision whose verdict holds for it too; `judged_id`: the one that its
    verdict was given on.
    """

    id: int
    survey_id: int
    scan_id: int
    vehicle_id: int
    revision: int
    values: ScanValues
    created_by: Who | None
    created_at: datetime
    review: ReviewState
    verdict_of_id: int | None = None
    judged_id: int | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class KnownOfScanned:
    """What people fill in about a scanned vehicle; `true_` lengths are the manufacturer's."""

    make: str | None
    model: str | None
    year: int | None
    category: Category | None
    true_length_m: float | None
    u_true_length_m: float | None
    true_wheelbase_m: float | None
    u_true_wheelbase_m: float | None
    facts_source: str | None
    run_of: Annotated[str | None, Field(description="Name of the car of which this is one run of several.")]
    lighting: Lighting | None
    notes: str


@dataclass(frozen=True, slots=True, kw_only=True)
class ScanVehicleFacts(KnownOfScanned):
    """A vehicle of a scan and what is known of it."""

    id: int
    scan_id: int
    number: int
    origin: VehicleOrigin
    version: int
    updated_by: Who | None
    updated_at: datetime
    deleted: bool


@dataclass(frozen=True, slots=True, kw_only=True)
class ScanVehicle(ScanVehicleFacts):
    """A vehicle of a scan with its current measurement."""

    survey_id: int
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
class ScanReviewFacts:
    """A verdict given on a revision."""

    revision: int
    verdict: ScanVerdict
    reason: str | None
    reviewer: Who | None
    at: datetime


@dataclass(frozen=True, slots=True)
class ScanReview(ScanReviewFacts):
    """One as it is stored."""

    id: int
    measurement_id: int
    vehicle_id: int


@dataclass(frozen=True, slots=True)
class ScanProgress:
    """The line scans of a survey: vehicles and heights by what was done with them, and what to do next."""

    state: OptionalStepState
    summary: list[Said]
    scans: int = 0
    ready: int = 0
    vehicles: int = 0
    to_review: int = 0
    accepted: int = 0
    rejected: int = 0
    not_measurable: int = 0
    heights: int = 0
    heights_to_review: int = 0
    heights_accepted: int = 0
    heights_rejected: int = 0
