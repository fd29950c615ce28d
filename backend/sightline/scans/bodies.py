"""Bodies of line-scan recordings: what comes in and what goes out. Metres, seconds; U95 = 1.96 u."""

from dataclasses import dataclass
from datetime import datetime
from typing import Annotated

from pydantic import Field
from pydantic.fields import FieldInfo

from sightline.enums import (
    Category,
    CutAlong,
    Lighting,
    LiveState,
    ScanDirection,
    ScanMethod,
    ScanVehicleState,
    ScanVerdict,
    TimeAxis,
    Verdict,
)
from sightline.infra.audit.records import Who
from sightline.infra.web.bodies import Finite, Id, In, JobBody, Name, Text
from sightline.infra.web.named import RecordingId, UploadId
from sightline.infra.web.quantities import Word
from sightline.linescan.parts import USUAL_SHADOW_SHARE, Entry, Gap
from sightline.linescan.rig import LIMITS
from sightline.measurements.records import ReviewState
from sightline.recordings.bodies import StartIn
from sightline.scans.records import FoundMotion, ScanReviewFacts, ScanRun, ScanVehicleFacts, StripPair
from sightline.scans.references.records import ShownReference

Version = Annotated[int, Field(ge=1, le=2**31 - 1, description="The version that you saw.")]
Line = Annotated[Finite, Field(ge=0, le=1e12, description="Line number, fractional.")]
Cut = Annotated[int, Field(ge=0, le=2**16)]
LengthM = Annotated[Finite, Field(gt=0, le=100)]
ULengthM = Annotated[Finite, Field(ge=0, le=100)]


def _within(name: str, description: str | None = None) -> FieldInfo:
    limits = LIMITS[name]
    field: FieldInfo = Field(ge=limits.least, le=limits.most, description=description)
    return field


BaselineM = Annotated[Finite, _within("baseline_m")]
UBaselineM = Annotated[Finite, _within("u_baseline_m")]
LineRateHz = Annotated[Finite, _within("line_rate_hz")]
Ratio = Annotated[Finite, _within("u_line_rate_ratio", "Standard uncertainty over the value.")]
Angle = Annotated[Finite, _within("divergence_rad")]
UAngle = Annotated[Finite, _within("u_divergence_rad")]
DistanceM = Annotated[Finite, _within("distance_m")]
Pixels = Annotated[Finite, _within("misalignment_px")]
UPixels = Annotated[Finite, _within("u_misalignment_px")]
_SHADOW = "Of the rows, from the bottom, in which no vehicle is looked for."
ShadowShare = Annotated[Finite, _within("shadow_share", _SHADOW)]
_TOGETHER = "Of the errors of baseline and divergence; 0 where these change without it."
Correlation = Annotated[Finite, _within("baseline_correlation", _TOGETHER)]
_AWAY = "Of a vehicle's distance, its place in the lane included."
UDistanceM = Annotated[Finite, _within("u_distance_m", _AWAY)]
LaneName = Annotated[str, Field(min_length=1, max_length=40)]
TyresPx = Annotated[Finite, Field(ge=0, le=2**16)]


class RigLaneIn(In):
    """A lane of the rig: its vehicles' distance, and by what they are known to be its own."""

    name: LaneName
    distance_m: DistanceM
    u_distance_m: UDistanceM = 0.0
    direction: ScanDirection | None = Field(default=None, description="Of its traffic; null: either.")
    tyres_from_px: TyresPx | None = Field(
        default=None, description="Tyres meet the road between this row of strip 1 (from the top) and"
    )
    tyres_to_px: TyresPx | None = Field(default=None, description="this one; both null: any row.")
    shadow_share: ShadowShare | None = Field(default=None, description="null: the rig's.")


Lanes = Annotated[
    list[RigLaneIn],
    Field(max_length=8, description="Where vehicles drive at several distances; none: all at distance_m."),
]


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
    shadow_share: ShadowShare = USUAL_SHADOW_SHARE
    baseline_correlation: Correlation = 0.0
    u_distance_m: UDistanceM = 0.0
    lanes: Lanes = Field(default_factory=list)


class NewScan(RigIn):
    """Two strips that were uploaded with the purpose `strip`; the first is reached first."""

    name: Name | None = None
    first_upload: UploadId
    second_upload: UploadId
    time_axis: TimeAxis = "width"
    lighting: Lighting | None = None
    find: ScanMethod | None = Field(
        default="direct", description="Look for vehicles with this method once the strips are read."
    )


class NewScanFromVideo(In):
    """Two pixel columns or rows of a video; its frame rate is the line rate."""

    name: Name | None = None
    recording_id: RecordingId
    cut_along: CutAlong = Field(
        default="columns",
        description="Columns: traffic runs to the left or right. Rows: it runs up or down, the camera is "
        "mounted turned, and the vehicles' roofs point to the left or to the right of the picture.",
    )
    cut_1_px: Cut = Field(description="The column or row that a vehicle reaches first.")
    cut_2_px: Cut
    baseline_m: BaselineM = Field(description="Between the two cuts on the vehicle's side plane.")
    u_baseline_m: UBaselineM = 0.0
    lighting: Lighting | None = None
    find: ScanMethod | None = "direct"


class ScanStartIn(StartIn):
    """When line 0 was taken, as clocks of the place showed it, and how well that is known."""

    u_s: Finite = Field(description="Standard uncertainty (k = 1), seconds: more than 0, at most an hour.")


class ChangedScan(In):
    """Any subset; what is left out stays. Results keep the values that they were made with."""

    version: Version
    name: Name | None = None
    lighting: Lighting | None = None
    start: Annotated[ScanStartIn | None, Field(description="Null: nobody has confirmed it.")] = None
    baseline_m: BaselineM | None = None
    line_rate_hz: LineRateHz | None = None
    u_baseline_m: UBaselineM | None = None
    u_line_rate_ratio: Ratio | None = None
    divergence_rad: Angle | None = None
    u_divergence_rad: UAngle | None = None
    distance_m: DistanceM | None = None
    misalignment_px: Pixels | None = None
    u_misalignment_px: UPixels | None = None
    shadow_share: ShadowShare | None = None
    baseline_correlation: Correlation | None = None
    u_distance_m: UDistanceM | None = None
    lanes: Lanes | None = None


@dataclass(frozen=True, slots=True)
class LevelBody:
    """A zoom level of the strips: so many lines, of which each stands for `step` lines of the recording."""

    level: int
    lines: int
    step: int
    tiles: int


@dataclass(frozen=True, slots=True, kw_only=True)
class ScanBody(StripPair):
    """A pair of strips; tiles are at `/api/scans/{id}/tiles/{camera}/{level}/{index}`, time to the right."""

    job: JobBody | None
    duration_s: float | None
    tile_lines: int
    tiles_version: Annotated[str | None, Field(description="Put it into the tiles' address as ?v= .")]
    levels: list[LevelBody]
    stream_state: Annotated[
        LiveState | None, Field(description="Of a live one; stopped: it never ended, nor goes on.")
    ]
    started_local: Annotated[
        str | None, Field(description="`started_at` by the clocks of `time_zone`, ISO 8601 with offset.")
    ]
    run: ScanRun | None


class SwapWanted(In):
    """The cameras exchanged: what was camera 2 is reached first."""

    version: Version


class FindWanted(In):
    method: ScanMethod = "direct"
    search: bool = Field(
        default=True, description="false: measure the known vehicles again, look for no others."
    )


@dataclass(frozen=True, slots=True, kw_only=True)
class ScanMotionBody(FoundMotion):
    """One revision of a vehicle's motion: speed and acceleration are those when the front is at camera 1."""

    id: int
    revision: int
    placed_by_person: bool
    older: Annotated[bool, Field(description="Made with other values of the rig than the scan has now.")]
    time_s: Annotated[float, Field(description="When the front is at camera 1, from the first line on.")]
    U95_speed_mps: float | None
    U95_acceleration_mps2: float | None
    U95_length_m: float | None
    U95_wheelbase_m: float | None
    created_by: Who | None
    created_at: datetime
    review: ReviewState
    mine: Annotated[bool, Field(description="You placed its boundaries, so somebody else reviews it.")]


@dataclass(frozen=True, slots=True, kw_only=True)
class ScanVehicleBody(ScanVehicleFacts):
    """A vehicle of a scan with its current measurement; errors are measured minus the maker's value."""

    state: ScanVehicleState
    measurement: ScanMotionBody | None
    filmed_at: Annotated[
        str | None,
        Field(description="When its front reached camera 1, ISO 8601 with offset; null without a start."),
    ]
    u_filmed_at_s: Annotated[
        float | None, Field(description="Of that (k = 1); null without a measured motion.")
    ]
    U95_filmed_at_s: float | None
    gap: Annotated[Gap | None, Field(description="null: the first vehicle.")]
    length_error_m: float | None
    wheelbase_error_m: float | None
    references: Annotated[
        list[ShownReference], Field(description="What something else measured of it, beside ours.")
    ]


@dataclass(frozen=True, slots=True)
class ProfileBody:
    """Columns of equal length, one entry a block; residual = speed - fit; not `used`: left out of it."""

    line_1: list[float]
    time_s: Annotated[list[float], Field(description="From the front's reaching camera 1.")]
    speed_mps: list[float]
    fitted_mps: list[float]
    residual_mps: list[float]
    used: list[bool]


@dataclass(frozen=True, slots=True)
class MatchBody:
    """Where the pictures of the match lie: pixel (x, y) is line `first_line + step x`, row y, of strip 1."""

    first_line: int
    lines: int
    step: int
    rows_px: int
    first_url: str
    second_url: str
    difference_url: str


@dataclass(frozen=True, slots=True)
class ScanVehicleDetailBody:
    vehicle: ScanVehicleBody
    profile: ProfileBody | None
    budget: list[Entry]
    match: MatchBody | None
    history: list[ScanMotionBody]
    reviews: list[ScanReviewFacts]


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


class AxlesIn(In):
    """Lines in strip 1 of all wheels' hubs; null: as the program finds them."""

    axle_lines: Annotated[list[Line], Field(max_length=20)] | None
    version: Version


class LaneIn(In):
    """The lane that it drove in, one of the rig's; null: as the program tells it."""

    lane: LaneName | None
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
    run_of: Annotated[str, Field(max_length=100)] | None = None
    lighting: Lighting | None = None
    notes: Text | None = None


class NewScanReview(In):
    verdict: ScanVerdict
    reason: Text | None = None
    seen: Verdict | None = Field(
        default=None, description="The verdict that you saw; another one is a conflict. null: not compared."
    )


@dataclass(frozen=True, slots=True)
class StripUploadBody:
    """A strip that arrived and waits for its scan."""

    id: int
    filename: str
    size_bytes: int
    created_at: datetime
