"""What measurements take and answer."""

from dataclasses import dataclass
from typing import Annotated
from uuid import UUID

from pydantic import AwareDatetime, Field

from sightline.enums import MadeAsSaid, Target, Verdict
from sightline.infra.by_name import filled_from
from sightline.infra.meaning import explained_as
from sightline.infra.web.bodies import FrameNumber, In, Point, Text, example
from sightline.infra.web.named import MeasurementId, VehicleId
from sightline.infra.web.quantities import InsetM, Revision, SigmaPx, UInsetM
from sightline.measurements.records import (
    Measurement,
    MeasurementValues,
    RevisionFacts,
    VehicleInState,
    VehicleSheet,
)
from sightline.messages.said import Said
from sightline.statistics.plausible import Doubt, Height, doubts


@dataclass(frozen=True, slots=True, kw_only=True)
@explained_as("measurements")
class MeasurementBody(MeasurementValues, RevisionFacts):
    """The current revision of a measurement: its values, and what stands around them."""

    recording_id: int
    repeat_of: Annotated[int | None, Field(description="The measurement that this one repeats.")]
    flags: Annotated[
        list[Said],
        Field(description="As stored, and, derived when read, that the camera had moved on this frame."),
    ]
    filmed_at: str | None


def measurement_body(found: Measurement) -> MeasurementBody:
    return filled_from(MeasurementBody, found, found.values, flags=found.all_flags)


class FurtherClicks(In):
    """The same two points, clicked on another frame of the pass."""

    frame: FrameNumber
    contact: Point
    target_point: Point


MoreFrames = Annotated[
    list[FurtherClicks],
    Field(max_length=7, description="The same two points on further frames: then the inset is solved for."),
]


class OnFrameIn(In):
    """Two points on one frame."""

    frame: FrameNumber
    contact: Point
    target_point: Point
    sigma_px: SigmaPx | None = None
    inset_m: InsetM | None = None
    u_inset_m: UInsetM | None = None


class ClicksIn(OnFrameIn):
    """Two points on one frame, and on further ones."""

    more_frames: MoreFrames = Field(default_factory=list)


class FollowIn(In):
    """The vehicle is followed through its pass from contact and target."""

    second_contact: Annotated[
        Point | None,
        Field(description="Where the other tyre of that side stands, px; then the wheelbase follows."),
    ] = None


class FollowWanted(OnFrameIn):
    """The points on one frame from which a vehicle is to be followed."""

    model_config = example(target="driver_eye", frame=2, contact=[169.5, 194.5], target_point=[189.5, 134.5])

    target: Target
    second_contact: Point | None = None


Follow = Annotated[
    FollowIn | None,
    Field(description="Measure by the whole pass: the server follows the points and keeps what it finds."),
]


class OtherTarget(In):
    """Another target that stands on the same frame and tyre contact."""

    target: Target
    target_point: Point
    more_frames: MoreFrames = Field(default_factory=list)
    sigma_px: SigmaPx | None = None
    inset_m: InsetM | None = None
    u_inset_m: UInsetM | None = None


class SecondFrameWanted(ClicksIn):
    """What is clicked so far; the best frame to click next is looked for in the vehicle's pass."""

    target: Target
    vehicle_id: VehicleId
    others: list[OtherTarget] = Field(
        default_factory=list,
        max_length=7,
        description="What is clicked after it: one frame for all of them is chosen where one shows them all.",
    )


SnappedFrom = Annotated[
    Point | None,
    Field(
        description="Where the contact was clicked, if it went from there to the tyre found; this is checked."
    ),
]


class NewMeasurement(ClicksIn):
    model_config = example(
        client_key="6f1c2d3e-0000-4000-8000-000000000001",
        target="roof",
        frame=2,
        contact=[169.5, 194.5],
        target_point=[189.5, 134.5],
    )

    made: MadeAsSaid = Field(
        default="clicked",
        description="confirmed: both points as proposed, which is checked; moved: begun from a proposal.",
    )
    snapped_from: SnappedFrom = None
    follow: Follow = None
    client_key: UUID = Field(description="Made by the client; sending it twice stores it once.")
    target: Target
    repeat_of: MeasurementId | None = Field(
        default=None, description="The measurement that these clicks repeat: it stands in no list or result."
    )


class VerdictIn(In):
    """A verdict's reason, and the verdict in whose place it is given."""

    reason: Text | None = None
    seen: Verdict | None = Field(
        default=None, description="The verdict that you saw; another one is a conflict. null: not compared."
    )
    seen_at: AwareDatetime | None = Field(
        default=None,
        description="When it was given (`at`), sent back as it was answered; another time is a conflict."
        " null: not compared.",
    )


class ChangedMeasurement(ClicksIn):
    revision: Revision
    target: Target | None = None
    snapped_from: SnappedFrom = None
    follow: Follow = None


@dataclass(frozen=True, slots=True)
class VehicleBody(VehicleInState):
    """A vehicle record with its standing measurements."""

    measurements: list[MeasurementBody]
    doubts: Annotated[tuple[Doubt, ...], Field(description="Heights to look at again; nothing is refused.")]


def vehicle_body(sheet: VehicleSheet) -> VehicleBody:
    found = [measurement_body(one) for one in sheet.measurements]
    return filled_from(VehicleBody, sheet, measurements=found, doubts=_doubts(sheet))


def _doubts(sheet: VehicleSheet) -> tuple[Doubt, ...]:
    """Of the heights that may count: a rejected one speaks against no other."""
    heights = {
        one.values.target: Height(one.values.height_m, one.values.u_height_m or 0.0)
        for one in sheet.measurements
        if one.values.height_m is not None and one.review.verdict != "rejected"
    }
    return doubts(heights, sheet.category, sheet.reference_m, sheet.u_reference_m)
