"""What measurements take and answer."""

from datetime import datetime
from typing import Annotated
from uuid import UUID

from pydantic import AliasChoices, AliasPath, Field

from sightline.enums import (
    MeasurementStatus,
    Target,
    TravelSource,
    Verdict,
)
from sightline.infra.web.bodies import FrameNumber, Id, In, Out, Point, WhoBody
from sightline.infra.web.quantities import BudgetEntryBody, InsetM, Revision, SigmaPx, UInsetM
from sightline.vehicles.bodies import VehicleAlone


class ReviewBody(Out):
    verdict: Verdict
    reason: str | None
    reviewer: WhoBody | None
    at: datetime | None


class FurtherFrameBody(Out):
    """The same two points on another frame of the pass."""

    frame: int
    pts: int
    time_s: float
    frame_crc32: int
    contact: tuple[float, float]
    target_point: tuple[float, float]


class MeasurementBody(Out):
    """The current revision of a measurement."""

    id: int = Field(description="The measurement (a series of revisions).")
    revision: int
    revision_id: int
    vehicle_id: int
    recording_id: int
    repeat_of: int | None = Field(description="The measurement that this one repeats.")
    target: Target = Field(validation_alias=AliasPath("values", "target"))
    frame: int = Field(validation_alias=AliasPath("values", "frame"))
    pts: int = Field(validation_alias=AliasPath("values", "pts"))
    time_s: float = Field(validation_alias=AliasPath("values", "time_s"))
    frame_crc32: int = Field(validation_alias=AliasPath("values", "frame_crc32"))
    contact: tuple[float, float] = Field(validation_alias=AliasPath("values", "contact"))
    target_point: tuple[float, float] = Field(validation_alias=AliasPath("values", "target_point"))
    sigma_px: float = Field(validation_alias=AliasPath("values", "sigma_px"))
    pose_id: int = Field(validation_alias=AliasPath("values", "pose_id"))
    calibration_id: int = Field(validation_alias=AliasPath("values", "calibration_id"))
    inset_m: float = Field(validation_alias=AliasPath("values", "inset_m"))
    u_inset_m: float = Field(validation_alias=AliasPath("values", "u_inset_m"))
    more_frames: list[FurtherFrameBody] = Field(
        validation_alias=AliasPath("values", "more_frames"),
        description="With any, the inset is solved for; `inset_m` is what one frame would assume.",
    )
    solved_inset_m: float | None = Field(validation_alias=AliasPath("values", "solved_inset_m"))
    u_solved_inset_m: float | None = Field(validation_alias=AliasPath("values", "u_solved_inset_m"))
    height_m: float | None = Field(validation_alias=AliasPath("values", "height_m"))
    uncorrected_height_m: float | None = Field(validation_alias=AliasPath("values", "uncorrected_height_m"))
    u_height_m: float | None = Field(validation_alias=AliasPath("values", "u_height_m"))
    U95_height_m: float | None = Field(validation_alias=AliasPath("values", "U95_height_m"))
    distance_m: float | None = Field(validation_alias=AliasPath("values", "distance_m"))
    status: MeasurementStatus = Field(validation_alias=AliasPath("values", "status"))
    reason: str | None = Field(validation_alias=AliasPath("values", "reason"))
    flags: list[str] = Field(
        validation_alias=AliasChoices("all_flags", "flags"),
        description="As stored, and, derived when read, that the camera had moved on this frame.",
    )
    budget: list[BudgetEntryBody] = Field(validation_alias=AliasPath("values", "budget"))
    code_version: str = Field(validation_alias=AliasPath("values", "code_version"))
    created_by: WhoBody | None
    created_at: datetime
    withdrawn: bool
    review: ReviewBody


class FurtherClicks(In):
    """The same two points, clicked on another frame of the pass."""

    frame: FrameNumber
    contact: Point
    target_point: Point


MoreFrames = Annotated[
    list[FurtherClicks],
    Field(max_length=7, description="The same two points on further frames: then the inset is solved for."),
]


class ClicksIn(In):
    """Two points on one frame, and on further ones."""

    frame: FrameNumber
    contact: Point
    target_point: Point
    sigma_px: SigmaPx | None = None
    inset_m: InsetM | None = None
    u_inset_m: UInsetM | None = None
    more_frames: MoreFrames = Field(default_factory=list)


class SecondFrameWanted(ClicksIn):
    """What is clicked so far; the best frame to click next is looked for in the vehicle's pass."""

    target: Target
    vehicle_id: Id


class SpotBody(Out):
    """Where both points are expected on one frame, and what clicking them there would give."""

    frame: int
    travel_m: float
    contact: tuple[float, float]
    target_point: tuple[float, float]
    u_height_m: float
    U95_height_m: float
    u_solved_inset_m: float
    assumed_kmh: float | None


class SecondFrameAnswer(Out):
    """The frame proposed with what it would gain; where none would help, why."""

    ok: bool
    reason: str | None
    frame: int | None
    source: TravelSource | None
    words: str
    u_now_m: float | None
    U95_now_m: float | None
    u_then_m: float | None
    U95_then_m: float | None
    u_solved_inset_m: float | None
    spots: list[SpotBody]


class NewMeasurement(ClicksIn):
    client_key: UUID = Field(description="Made by the client; sending it twice stores it once.")
    target: Target
    repeat_of: Annotated[int, Field(ge=1, le=2**31 - 1)] | None = Field(
        default=None, description="The measurement that these clicks repeat: it stands in no list or result."
    )


class ChangedMeasurement(ClicksIn):
    revision: Revision
    target: Target | None = None


class VehicleBody(VehicleAlone):
    measurements: list[MeasurementBody]
