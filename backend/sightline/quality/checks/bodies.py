"""Bodies of the checks: insets from the survey itself, and the direction of travel against a road pose."""

from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from sightline.infra.web.bodies import Finite, FrameNumber, In, Out, Point
from sightline.messages.said import Said
from sightline.poses.records import PoseOverlay
from sightline.quality.checks.records import WheelPair
from sightline.quality.checks.traffic import PoseFindings
from sightline.quality.checks.turning import Changes

# Half a turn is more than any board was ever set up askew.
TurnRad = Annotated[Finite, Field(ge=-1.6, le=1.6, description="The mean that was shown, radians.")]


class RecordingNameBody(Out):
    id: int
    name: str


@dataclass(frozen=True, kw_only=True)
class PoseCheckBody(PoseFindings):
    """A pose in force against the traffic of its recordings."""

    recordings: list[RecordingNameBody]


@dataclass(frozen=True)
class TrafficCheckBody:
    """The poses in force of a survey, and all tyre contacts."""

    poses: list[PoseCheckBody]
    pairs: tuple[WheelPair, ...]


SeenPair = Annotated[
    int, Field(ge=0, le=2**31 - 1, description="The pair that you saw; 0: none. Another one is a conflict.")
]


class NewWheelPair(In):
    frame: FrameNumber
    frame_crc32: Annotated[int, Field(ge=0, le=2**32 - 1)] | None = Field(
        None, description="CRC-32 of the picture that was clicked on, as in the frame table."
    )
    first: Point
    second: Point
    seen: SeenPair | None = None


class TurnedPose(Out):
    """A pose turned to the traffic, before it is stored: what to draw, to say, and what it changes."""

    pose_id: int
    turn_rad: float
    u_turn_rad: float
    summary: list[Said]
    warnings: list[Said]
    overlay: PoseOverlay
    changes: Changes


class TurnWanted(In):
    turn_rad: TurnRad
