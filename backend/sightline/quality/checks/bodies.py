"""Bodies of the checks: insets from the survey itself, and the direction of travel against a road pose."""

from datetime import datetime
from typing import Annotated

from pydantic import Field

from sightline.enums import DirectionSource, InsetMethod, Target
from sightline.infra.web.bodies import Finite, FrameNumber, In, Out, Point, WhoBody
from sightline.poses.bodies import PoseOverlay
from sightline.surveys.bodies import InsetBody

# Half a turn is more than any board was ever set up askew.
TurnRad = Annotated[Finite, Field(ge=-1.6, le=1.6, description="The mean that was shown, radians.")]


class VehicleNameBody(Out):
    id: int
    number: int


class EstimateBody(Out):
    """One way to an inset: a figure with its uncertainty, or the reason why there is none."""

    method: InsetMethod
    reason: str | None
    inset_m: float | None
    u_inset_m: float | None
    spread_m: float | None = Field(description="Standard deviation between vehicles, where it is known.")
    vehicles: int
    caution: str | None = Field(description="Why it should not be used; null where it can be.")
    left_out: list[VehicleNameBody] = Field(description="Vehicles that do not fit the others.")
    difference_m: float | None = Field(description="What it would change the typical height by.")
    offer: InsetBody | None = Field(description="What the survey's inset would become, with its note.")


class TargetInsetsBody(Out):
    target: Target
    in_force: InsetBody
    is_default: bool
    measured: int
    other_insets: int = Field(description="Measured as something else (driver on the far side); not used.")
    typical_height_m: float | None
    typical_distance_m: float | None
    estimates: list[EstimateBody]


class InsetCaseBody(Out):
    target: Target
    words: str
    height_m: float
    inset_m: float
    bias_m: list[float]


class InsetCheckBody(Out):
    targets: list[TargetInsetsBody]
    camera_height_m: float
    cases_at_m: list[float]
    cases: list[InsetCaseBody]


class RecordingNameBody(Out):
    id: int
    name: str


class VehicleHeadingBody(Out):
    vehicle_id: int
    number: int
    recording_id: int
    frame: int
    source: DirectionSource
    heading_rad: float | None
    u_heading_rad: float | None
    base_m: float | None
    used: bool
    reason: str | None


class HeightChangeBody(Out):
    measurement_id: int
    vehicle_id: int
    target: Target
    height_m: float
    turned_height_m: float
    difference_m: float


class ChangesBody(Out):
    """Stored heights under the turned pose, the largest difference first; the list ends at 200."""

    count: int
    largest_m: float
    listed: list[HeightChangeBody]


class PoseCheckBody(Out):
    """A road pose in force against the traffic of its recordings."""

    pose_id: int
    recordings: list[RecordingNameBody]
    turned_from: int | None
    turned_by_rad: float | None
    vehicles: list[VehicleHeadingBody]
    used: int
    mean_rad: float | None
    u_mean_rad: float | None
    spread_rad: float | None
    proposed: bool
    reason: str | None
    verdict: str
    changes: ChangesBody | None


class WheelPairBody(Out):
    """Both tyre contacts of a vehicle on one frame."""

    id: int
    vehicle_id: int
    vehicle_number: int
    recording_id: int
    frame: int
    first: tuple[float, float]
    second: tuple[float, float]
    withdrawn: bool
    created_by: WhoBody | None
    created_at: datetime


class TrafficCheckBody(Out):
    poses: list[PoseCheckBody]
    pairs: list[WheelPairBody]


class NewWheelPair(In):
    frame: FrameNumber
    frame_crc32: Annotated[int, Field(ge=0, le=2**32 - 1)] | None = Field(
        None, description="CRC-32 of the picture that was clicked on, as in the frame table."
    )
    first: Point
    second: Point


class TurnedPose(Out):
    """A pose turned to the traffic, before it is stored: what to draw, to say, and what it changes."""

    pose_id: int
    turn_rad: float
    u_turn_rad: float
    summary: str
    warnings: list[str]
    overlay: PoseOverlay
    changes: ChangesBody


class TurnWanted(In):
    turn_rad: TurnRad
