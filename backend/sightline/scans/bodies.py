"""Bodies of line-scan recordings: what comes in and what goes out. Metres, seconds; U95 = 1.96 u."""

from datetime import datetime
from typing import Annotated

from pydantic import Field
from pydantic.fields import FieldInfo

from sightline.enums import (
    Category,
    Cause,
    Lighting,
    MeasurementStatus,
    ScanMethod,
    ScanSource,
    ScanState,
    ScanVehicleState,
    ScanVerdict,
    TimeAxis,
    VehicleOrigin,
    Verdict,
)
from sightline.infra.audit.records import Who
from sightline.infra.web.bodies import Finite, Id, In, JobBody, Name, Out, Text
from sightline.infra.web.quantities import Word
from sightline.linescan import rig
from sightline.linescan.rig import Limits
from sightline.measurements.records import ReviewState

Version = Annotated[int, Field(ge=1, le=2**31 - 1, description="The version that you saw.")]
Line = Annotated[Finite, Field(ge=0, le=1e12, description="Line number, fractional.")]
Column = Annotated[int, Field(ge=0, le=2**16)]
LengthM = Annotated[Finite, Field(gt=0, le=100)]
ULengthM = Annotated[Finite, Field(ge=0, le=100)]


def _within(limits: Limits, description: str | None = None) -> FieldInfo:
    field: FieldInfo = Field(ge=limits.least, le=limits.most, description=description)
    return field


BaselineM = Annotated[Finite, _within(rig.BASELINE_M)]
UBaselineM = Annotated[Finite, _within(rig.U_BASELINE_M)]
LineRateHz = Annotated[Finite, _within(rig.LINE_RATE_HZ)]
Ratio = Annotated[Finite, _within(rig.U_LINE_RATE_RATIO, "Standard uncertainty over the value.")]
Angle = Annotated[Finite, _within(rig.DIVERGENCE_RAD)]
UAngle = Annotated[Finite, _within(rig.U_DIVERGENCE_RAD)]
DistanceM = Annotated[Finite, _within(rig.DISTANCE_M)]
Pixels = Annotated[Finite, _within(rig.MISALIGNMENT_PX)]
UPixels = Annotated[Finite, _within(rig.U_MISALIGNMENT_PX)]


class RigIn(In):
    """The rig as measured on the road; `u_` are standard uncertainties (k = 1)."""

    baseline_m: BaselineM
    line_rate_hz: LineRateHz
    u_baseline_m: UBaselineM = 0.0
    u_line_rate_ratio: Ratio = 0.0
    divergence_rad: Angle = 0.0
    u_divergence_rad: UAngle = 0.0
    distance_m: DistanceM | None = None
    misalignment_px: Pixels | None = Field(default=None, description="null: estimated from the traffic.")
    u_misalignment_px: UPixels = 0.0


class NewScan(RigIn):
    """Two strips that were uploaded with the purpose `strip`; the first is reached first."""

    name: Name | None = None
    first_upload: Id
    second_upload: Id
    time_axis: TimeAxis = "width"
    lighting: Lighting | None = None
    find: ScanMethod | None = Field(
        default="direct", description="Look for vehicles with this method once the strips are read."
    )


class NewScanFromVideo(In):
    """Two pixel columns of a video; its frame rate is the line rate."""

    name: Name | None = None
    recording_id: Id
    column_1_px: Column = Field(description="The column that a vehicle reaches first.")
    column_2_px: Column
    baseline_m: BaselineM = Field(description="Between the two columns on the vehicle's side plane.")
    u_baseline_m: UBaselineM = 0.0
    lighting: Lighting | None = None
    find: ScanMethod | None = "direct"


class ChangedScan(In):
    """Any subset; what is left out stays. Results keep the values that they were made with."""

    version: Version
    name: Name | None = None
    lighting: Lighting | None = None
    baseline_m: BaselineM | None = None
    line_rate_hz: LineRateHz | None = None
    u_baseline_m: UBaselineM | None = None
    u_line_rate_ratio: Ratio | None = None
    divergence_rad: Angle | None = None
    u_divergence_rad: UAngle | None = None
    distance_m: DistanceM | None = None
    misalignment_px: Pixels | None = None
    u_misalignment_px: UPixels | None = None


class RigBody(Out):
    baseline_m: float
    line_rate_hz: float
    u_baseline_m: float
    u_line_rate_ratio: float
    divergence_rad: float
    u_divergence_rad: float
    distance_m: float | None
    misalignment_px: float | None
    u_misalignment_px: float


class ScanCountsBody(Out):
    vehicles: int
    to_review: int
    accepted: int
    rejected: int
    not_measurable: int
    older: int = Field(description="Measured with other values of the rig; find again brings them up.")
    heights: int = Field(description="Standing heights of targets.")
    heights_to_review: int


class ScanRunBody(Out):
    """One search for vehicles, and what it says of the recording."""

    id: int
    method: ScanMethod
    found: int
    measured: int
    warnings: list[str]
    misalignment_px: float | None
    u_misalignment_px: float | None
    misalignment_words: str | None
    code_version: str
    created_by: Who | None
    created_at: datetime


class LevelBody(Out):
    """A zoom level of the strips: so many lines, of which each stands for `step` lines of the recording."""

    level: int
    lines: int
    step: int
    tiles: int


class ScanBody(Out):
    """A pair of strips; tiles are at `/api/scans/{id}/tiles/{camera}/{level}/{index}`, time to the right."""

    id: int
    survey_id: int
    name: str
    state: ScanState
    error: str | None
    job: JobBody | None
    source: ScanSource
    recording_id: int | None
    column_1_px: int | None
    column_2_px: int | None
    first_name: str | None
    second_name: str | None
    time_axis: TimeAxis
    rows_px: int | None
    lines: int | None
    bits: int | None
    duration_s: float | None
    tile_lines: int
    tiles_version: str | None = Field(description="Put it into the tiles' address as ?v= .")
    levels: list[LevelBody]
    notes: list[str]
    rig: RigBody
    lighting: Lighting | None
    counts: ScanCountsBody
    run: ScanRunBody | None
    version: int
    created_by: Who | None
    created_at: datetime
    updated_by: Who | None
    updated_at: datetime


class SwapWanted(In):
    """The cameras exchanged: what was camera 2 is reached first."""

    version: Version


class FindWanted(In):
    method: ScanMethod = "direct"
    search: bool = Field(
        default=True, description="false: measure the known vehicles again, look for no others."
    )


class ScanMotionBody(Out):
    """One revision of a vehicle's motion: speed and acceleration are those when the front is at camera 1."""

    id: int
    revision: int
    cause: Cause
    placed_by_person: bool
    method: ScanMethod
    older: bool = Field(description="Made with other values of the rig than the scan has now.")
    front_line_1: float
    rear_line_1: float
    front_line_2: float
    rear_line_2: float
    time_s: float = Field(description="When the front is at camera 1, from the first line on.")
    speed_mps: float | None
    u_speed_mps: float | None
    U95_speed_mps: float | None
    acceleration_mps2: float | None
    u_acceleration_mps2: float | None
    U95_acceleration_mps2: float | None
    length_m: float | None
    u_length_m: float | None
    U95_length_m: float | None
    fit_error_percent: float | None
    misalignment_px: float | None
    u_misalignment_px: float | None
    gain: float | None
    front_wheel_line: float | None
    rear_wheel_line: float | None
    wheelbase_m: float | None
    u_wheelbase_m: float | None
    U95_wheelbase_m: float | None
    status: MeasurementStatus
    reason: str | None
    warnings: list[str]
    code_version: str
    created_by: Who | None
    created_at: datetime
    review: ReviewState
    mine: bool = Field(description="You placed its boundaries, so somebody else reviews it.")


class GapBody(Out):
    """From the rear of the vehicle before to this front, at camera 1; numbers are null where unknown."""

    time_gap_s: float | None
    u_time_gap_s: float | None
    distance_gap_m: float | None = Field(description="By the leader's own fitted motion.")
    u_distance_gap_m: float | None
    headway_s: float | None = Field(description="From front to front at camera 1.")
    paper_distance_gap_m: float | None = Field(description="The paper's: time gap times the mean speed.")
    reason: str | None


class ScanVehicleBody(Out):
    """A vehicle of a scan with its current measurement; errors are measured minus the maker's value."""

    id: int
    scan_id: int
    number: int
    origin: VehicleOrigin
    state: ScanVehicleState
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
    deleted: bool
    updated_by: Who | None
    updated_at: datetime
    measurement: ScanMotionBody | None
    gap: GapBody | None = Field(description="null: the first vehicle.")
    length_error_m: float | None
    wheelbase_error_m: float | None


class ScanBudgetEntryBody(Out):
    source: str
    u_speed_mps: float
    u_acceleration_mps2: float
    u_length_m: float


class ProfileBody(Out):
    """Columns of equal length, one entry a block; residual = speed - fit; not `used`: left out of it."""

    line_1: list[float]
    time_s: list[float] = Field(description="From the front's reaching camera 1.")
    speed_mps: list[float]
    fitted_mps: list[float]
    residual_mps: list[float]
    used: list[bool]


class ScanReviewBody(Out):
    revision: int
    verdict: ScanVerdict
    reason: str | None
    reviewer: Who | None
    at: datetime


class MatchBody(Out):
    """Where the pictures of the match lie: pixel (x, y) is line `first_line + step x`, row y, of strip 1."""

    first_line: int
    lines: int
    step: int
    rows_px: int
    first_url: str
    second_url: str
    difference_url: str


class ScanVehicleDetailBody(Out):
    vehicle: ScanVehicleBody
    profile: ProfileBody | None
    budget: list[ScanBudgetEntryBody]
    match: MatchBody | None
    history: list[ScanMotionBody]
    reviews: list[ScanReviewBody]


class BoundariesIn(In):
    """Where front and rear cross each camera."""

    front_line_1: Line
    rear_line_1: Line
    front_line_2: Line
    rear_line_2: Line
    version: Version
    method: ScanMethod | None = Field(default=None, description="null: the method of the result before.")


class NewScanVehicle(In):
    """A vehicle by hand. Without the lines of camera 2 they are looked for."""

    front_line_1: Line
    rear_line_1: Line
    front_line_2: Line | None = None
    rear_line_2: Line | None = None
    method: ScanMethod = "direct"


class WheelsIn(In):
    """Lines in strip 1 of the middles of the front and rear wheel; null takes them away."""

    front_wheel_line: Line | None
    rear_wheel_line: Line | None
    version: Version


class ScanFacts(In):
    """What is known of the vehicle; left out stays, null clears. `catalogue_id` fills in the rest."""

    version: Version
    catalogue_id: Id | None = None
    make: Annotated[str, Field(max_length=100)] | None = None
    model: Word | None = None
    year: Annotated[int, Field(ge=1880, le=2200)] | None = None
    category: Category | None = None
    true_length_m: LengthM | None = None
    u_true_length_m: ULengthM | None = None
    true_wheelbase_m: LengthM | None = None
    u_true_wheelbase_m: ULengthM | None = None
    facts_source: Text | None = None
    lighting: Lighting | None = None
    notes: Text | None = None


class NewScanReview(In):
    verdict: ScanVerdict
    reason: Text | None = None
    seen: Verdict | None = Field(
        default=None, description="The verdict that you saw; another one is a conflict. null: not compared."
    )


class StripUploadBody(Out):
    """A strip that arrived and waits for its scan."""

    id: int
    filename: str
    size_bytes: int
    created_at: datetime
