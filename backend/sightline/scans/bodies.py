"""Bodies of line-scan recordings: what comes in and what goes out. Metres, seconds; U95 = 1.96 u."""

from dataclasses import dataclass
from datetime import datetime
from typing import Annotated

from pydantic import Field
from pydantic.fields import FieldInfo

from sightline.enums import (
    CutAlong,
    Lighting,
    LiveState,
    ScanDirection,
    ScanMethod,
    ScanVehicleState,
    ScanVerdict,
    TimeAxis,
)
from sightline.infra.audit.records import Who
from sightline.infra.web.bodies import Finite, Id, In, JobBody, Name, Text, of_record
from sightline.infra.web.named import RecordingId, UploadId
from sightline.infra.web.quantities import Word
from sightline.linescan.parts import Entry, Gap, Lane, Rig
from sightline.linescan.rig import LIMITS
from sightline.measurements.bodies import VerdictIn
from sightline.measurements.records import ReviewState
from sightline.recordings.bodies import StartIn
from sightline.scans.records import (
    FoundMotion,
    KnownOfScanned,
    ScanReviewFacts,
    ScanRun,
    ScanVehicleFacts,
    StripPair,
)
from sightline.scans.references.records import ShownReference

Version = Annotated[int, Field(ge=1, le=2**31 - 1, description="The version that you saw.")]
Line = Annotated[Finite, Field(ge=0, le=1e12, description="Line number, fractional.")]
Cut = Annotated[int, Field(ge=0, le=2**16)]


def _within(name: str, description: str | None = None) -> FieldInfo:
    limits = LIMITS[name]
    field: FieldInfo = Field(ge=limits.least, le=limits.most, description=description)
    return field


BaselineM = Annotated[Finite, _within("baseline_m")]
UBaselineM = Annotated[Finite, _within("u_baseline_m")]
DistanceM = Annotated[Finite, _within("distance_m")]
_AWAY = "Of a vehicle's distance, its place in the lane included."
UDistanceM = Annotated[Finite, _within("u_distance_m", _AWAY)]
LaneName = Annotated[str, Field(min_length=1, max_length=40)]
_SHADOW = "Of the rows, from the bottom, in which no vehicle is looked for"
_SAID = {
    "u_line_rate_ratio": "Standard uncertainty over the value.",
    "misalignment_px": "null: estimated from the traffic.",
    "shadow_share": f"{_SHADOW}.",
    "baseline_correlation": "Of the errors of baseline and divergence; 0 where these change without it.",
    "u_distance_m": _AWAY,
}
_OF_RIG = {name: Annotated[Finite, _within(name, _SAID.get(name))] for name in LIMITS}
_OF_LANE = {
    "name": LaneName,
    "direction": Annotated[ScanDirection, Field(description="Of its traffic; null: either.")],
    "tyres_*": Annotated[
        Finite,
        Field(ge=0, le=2**16, description="Tyres meet the road between these rows of strip 1; null: any."),
    ],
    **_OF_RIG,
    "shadow_share": Annotated[Finite, _within("shadow_share", f"{_SHADOW}; null: the rig's.")],
}


@of_record(Lane, given=_OF_LANE)
class RigLaneIn(In):
    """A lane of the rig: its vehicles' distance, and by what they are known to be its own."""


Lanes = Annotated[
    list[RigLaneIn],
    Field(max_length=8, description="Where vehicles drive at several distances; none: all at distance_m."),
]


@of_record(Rig, given=_OF_RIG)
class RigIn(In):
    """The rig as measured on the road; `u_` are standard uncertainties (k = 1)."""

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


@of_record(Rig, given=_OF_RIG, optional=True)
class ChangedScan(In):
    """Any subset; what is left out stays. Results keep the values that they were made with."""

    version: Version
    name: Name | None = None
    lighting: Lighting | None = None
    start: Annotated[ScanStartIn | None, Field(description="Null: nobody has confirmed it.")] = None
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


@dataclass(frozen=True, kw_only=True)
class GapBody(Gap):
    """The gap before a vehicle. U95 = 1.96 u."""

    U95_time_gap_s: float | None
    U95_distance_gap_m: float | None


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
    gap: Annotated[GapBody | None, Field(description="null: the first vehicle.")]
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


_GIVEN = {
    "make": Annotated[str, Field(max_length=100)],
    "model": Word,
    "year": Annotated[int, Field(ge=1880, le=2200)],
    "u_*_m": Annotated[Finite, Field(ge=0, le=100)],
    "*_m": Annotated[Finite, Field(gt=0, le=100)],
    "run_of": Annotated[str, Field(max_length=100)],
    "facts_source": Text,
    "notes": Text,
}


@of_record(KnownOfScanned, given=_GIVEN, optional=True)
class ScanFacts(In):
    """What is known of the vehicle; left out stays, null clears. `catalogue_id` fills in the rest."""

    version: Version
    catalogue_id: Id | None = None


class NewScanReview(VerdictIn):
    verdict: ScanVerdict


@dataclass(frozen=True, slots=True)
class StripUploadBody:
    """A strip that arrived and waits for its scan."""

    id: int
    filename: str
    size_bytes: int
    sha256: str
    created_at: datetime
