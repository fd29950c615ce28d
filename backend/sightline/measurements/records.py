"""Measurements, their values and further frames, and the sheet of a vehicle that carries them."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from typing import Annotated, Generic

from pydantic import Field
from typing_extensions import TypedDict, TypeVar

from sightline.enums import (
    Category,
    ComputingCause,
    DriverSide,
    InsetSource,
    Made,
    MeasurementStatus,
    Point,
    ProposalKept,
    ReviewVerdict,
    SideBasis,
    Target,
    VehicleState,
    Verdict,
)
from sightline.infra.audit.records import Who
from sightline.infra.meaning import explained_as
from sightline.messages.said import Said
from sightline.vehicles.records import Vehicle


@dataclass(frozen=True, slots=True, kw_only=True)
class ClickedFrame:
    """Contact and target point, (x, y) in pixels, on one frame."""

    frame: int
    contact: Point
    target_point: Point


class ClickedFrames:
    """What is clicked on one frame of a pass, or on several."""

    __slots__ = ()
    frame: int
    contact: Point
    target_point: Point
    more_frames: Sequence[ClickedFrame]

    @property
    def frames(self) -> tuple[int, ...]:
        """The frames clicked on, the first one first."""
        return (self.frame, *(further.frame for further in self.more_frames))

    @property
    def contacts(self) -> tuple[Point, ...]:
        """The contact point on each of `frames`."""
        return (self.contact, *(further.contact for further in self.more_frames))

    @property
    def target_points(self) -> tuple[Point, ...]:
        """The target point on each of `frames`."""
        return (self.target_point, *(further.target_point for further in self.more_frames))


@dataclass(frozen=True, kw_only=True)
@explained_as("measurements")
class Origin:
    """How the points on the first frame came about. `snapped_from_*`: where a person clicked before the
    contact went to the tyre that Sightline found there.

    `proposal`: whether contact and target were proposed on that frame, and whether that was shown;
    `proposed_*`: where. They tell how far people lean on what they are shown, and count for no height.
    """

    made: Made = "clicked"
    snapped_from_x_px: float | None = None
    snapped_from_y_px: float | None = None
    # in no answer: who clicks the next target of a vehicle measured free is not to see them
    proposal: Annotated[ProposalKept | None, Field(exclude=True)] = None
    proposed_contact_x_px: Annotated[float | None, Field(exclude=True)] = None
    proposed_contact_y_px: Annotated[float | None, Field(exclude=True)] = None
    proposed_target_x_px: Annotated[float | None, Field(exclude=True)] = None
    proposed_target_y_px: Annotated[float | None, Field(exclude=True)] = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Clicks(Origin, ClickedFrames):
    """What one height is computed from: two points in pixels on a frame, and on further frames of the pass.

    With further frames, or points `followed` from these through the pass (followed_text.py), the inset is
    solved for. What is None is filled in before anything is computed: the
    person's own sigma, else 1 px; the survey's inset of the target. An eye's inset stays None where nobody
    knows on which side the driver sits: then one frame gives no height.
    """

    target: Target
    contact: Point
    target_point: Point
    frame: int = 0
    more_frames: tuple[ClickedFrame, ...] = ()
    followed: str | None = None
    sigma_px: float | None = None
    inset_m: float | None = None
    u_inset_m: float | None = None
    inset_from: InsetSource | None = None
    side: DriverSide | None = None
    side_from: SideBasis | None = None

    @property
    def solves_inset(self) -> bool:
        """Whether further frames or a followed pass tell the inset."""
        return bool(self.more_frames) or self.followed is not None

    @property
    def known_sigma_px(self) -> float:
        """Raises ValueError where it is not filled in."""
        if self.sigma_px is None:
            raise ValueError("clicks need their sigma filled in before a height is computed")
        return self.sigma_px

    def assumed(self) -> tuple[float, float, float]:
        """(sigma in px, inset and its standard uncertainty in m). Raises ValueError where one is missing."""
        if self.inset_m is None or self.u_inset_m is None:
            raise ValueError("clicks need their inset filled in before a height is computed")
        return self.known_sigma_px, self.inset_m, self.u_inset_m


class BudgetPart(TypedDict):
    """What one source adds to a height's standard uncertainty, metres."""

    source: str
    u_m: float


@dataclass(frozen=True, slots=True, kw_only=True)
@explained_as("measurements")
class FoundHeight:
    """One height with its uncertainty and budget, or why there is none (then every number is None).

    `inset_m` is the inset assumed, None for an eye whose side is unknown. Metres.
    """

    status: MeasurementStatus
    reason: Said | None
    height_m: float | None
    u_height_m: float | None
    U95_height_m: float | None
    inset_m: float | None
    u_inset_m: float | None
    inset_from: InsetSource
    side: DriverSide | None
    distance_m: float | None
    budget: list[BudgetPart]
    flags: Annotated[list[Said], Field(description="Warnings on this height.")]


@dataclass(frozen=True, slots=True, kw_only=True)
@explained_as("measurements")
class HeightOfClicks(FoundHeight):
    """A height of clicks on frames.

    `inset_m` is the inset assumed for one frame; `solved_inset_m` the one found from several.
    `uncorrected_height_m` is the first frame's with an inset of 0. `x_m`, `y_m`: the contact on the road,
    along it and across. `u_clicks_m` and `u_by_inset_m`: the parts of `u_height_m` that come from clicks and
    heading, and from the assumed inset; what is left is the road pose's.
    """

    uncorrected_height_m: float | None
    side_from: SideBasis | None
    x_m: float | None
    y_m: float | None
    solved_inset_m: float | None = None
    u_solved_inset_m: float | None = None
    u_clicks_m: float | None = None
    u_by_inset_m: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class ScanHeightValues(FoundHeight):
    """The content of one revision of a height in a line scan: two clicks in strip 1, what they give.

    Points are (line, row); `u_distance_m` is the standard uncertainty of `distance_m`, from the camera.
    """

    target: Target
    contact: Point
    target_point: Point
    sigma_px: float
    line_pose_id: int
    u_distance_m: float | None
    code_version: str

    @property
    def pose_id(self) -> int:
        """The calibration of the line camera that it was computed with."""
        return self.line_pose_id

    @property
    def more_frames(self) -> tuple[()]:
        """A line has no further frame."""
        return ()

    @property
    def side_from(self) -> SideBasis | None:
        """A strip does not tell where the driver sits: a person did."""
        return None if self.side is None else "said"


@dataclass(frozen=True, slots=True, kw_only=True)
class FurtherFrame(ClickedFrame):
    """The same two points, clicked on another frame of the pass."""

    pts: int
    time_s: float
    frame_crc32: int


@dataclass(frozen=True, slots=True, kw_only=True)
@explained_as("measurements")
class MeasurementValues(HeightOfClicks, Origin, ClickedFrames):
    """The content of one revision: what was clicked, on what, and the height computed from it.

    Points are (x, y) in pixels of the frame; `frame_crc32` is of its decoded luma. A name that ends in _m
    is in metres.
    """

    target: Target
    frame: int
    pts: int
    time_s: float
    frame_crc32: int
    contact: Point
    target_point: Point
    sigma_px: float
    made: Annotated[
        Made,
        Field(
            description="Of the first frame's points. clicked: by hand, the contact perhaps a proposed one "
            "where no target was proposed; snapped: the contact went from a click to the tyre found there, "
            "the target by hand; confirmed: both as proposed; moved: begun from proposed or found points, at "
            "least one of the two put by a person."
        ),
    ] = field()
    pose_id: int
    calibration_id: int
    code_version: str
    more_frames: Annotated[
        tuple[FurtherFrame, ...],
        Field(description="With any, the inset is solved for; `inset_m` is what one frame would assume."),
    ] = ()
    followed: str | None = None

    @property
    def first_clicks(self) -> tuple[int, Point, Point]:
        """(frame, contact, target point) of the first frame: who clicked these made the measurement."""
        return self.frame, self.contact, self.target_point


@dataclass(frozen=True, slots=True)
class ReviewState:
    """The verdict on a revision; `to_review` while nobody has looked."""

    verdict: Verdict
    reason: str | None = None
    reviewer: Who | None = None
    at: datetime | None = None
    lot_id: Annotated[int | None, Field(description="The lot whose sample it rests on; null: its own.")] = (
        None
    )


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
    lot_id: int | None = None


Content = TypeVar("Content", MeasurementValues, ScanHeightValues)


@dataclass(frozen=True, kw_only=True)
@explained_as("measurements")
class RevisionFacts:
    """What every revision of a measurement has beside its values, in an answer too."""

    id: int
    revision: int
    revision_id: int
    vehicle_id: int
    withdrawn: bool
    computing_id: int | None
    created_by: Who | None
    created_at: datetime
    review: ReviewState


@dataclass(frozen=True, slots=True, kw_only=True)
@explained_as("measurements")
class Revision(RevisionFacts, Generic[Content]):
    """One revision of a measurement (`id` is the series), of a frame or of a line scan.

    `repeat_of`: the measurement that this one repeats, which then stands in no list and counts for no result.
    """

    survey_id: int
    repeat_of: int | None
    values: Content
    #: Of a revision computed again, or put back: the one before it whose verdict holds for it too.
    verdict_of_revision: int | None = None
    #: The revision that the verdict was given to.
    judged_revision: int | None = None
    #: Filled in for the package alone: the facts that it follows from and that hold no longer, and who
    #: clicked the points that stand, and when.
    out_of_date: tuple[ComputingCause, ...] = ()
    operator: Who | None = None
    clicked_at: datetime | None = None

    @property
    def all_flags(self) -> list[Said]:
        """What is said of its height."""
        return self.values.flags


@dataclass(frozen=True, slots=True, kw_only=True)
@explained_as("measurements")
class Measurement(Revision[MeasurementValues]):
    """One revision of a measurement on frames; lists and lookups give the current one."""

    recording_id: int
    #: Derived when read, never stored: the camera had moved on this frame.
    drift_flag: Said | None = None
    #: Derived too: when its first frame was filmed, ISO 8601 with offset; None: the start is not confirmed.
    filmed_at: str | None = None

    @property
    def place(self) -> dict[str, int]:
        """Where its vehicle passed, as events tell it."""
        return {"vehicle_id": self.vehicle_id, "recording_id": self.recording_id}

    @property
    def all_flags(self) -> list[Said]:
        """What was stored, and what was found out since about the camera."""
        flags = self.values.flags
        return flags if self.drift_flag is None else [*flags, self.drift_flag]


def revision_of_clicks(revisions: Iterable[Measurement], standing: Measurement) -> Measurement:
    """The revision in which the points that stand were clicked, not one that restored them: its maker is the
    operator, its moment that of measuring. `revisions`: from the first to the one that stands, at least.
    """
    return next(one for one in revisions if one.values.first_clicks == standing.values.first_clicks)


@dataclass(frozen=True, slots=True, kw_only=True)
class ScanHeight(Revision[ScanHeightValues]):
    """One revision of a height in a line scan; its vehicle is one of the scan's. `category`: by now."""

    scan_id: int
    category: Category | None = None

    @property
    def place(self) -> dict[str, int]:
        """Where its vehicle passed, as events tell it."""
        return {"scan_vehicle_id": self.vehicle_id, "scan_id": self.scan_id}


@dataclass(frozen=True, slots=True)
class ClickSigma:
    """A person's own click sigma in a survey, from `pairs` repeats; None: the usual one."""

    id: int
    survey_id: int
    person: Who | None
    sigma_px: Annotated[float | None, Field(description="None: the usual 1 px.")]
    pairs: int
    created_by: Who | None
    created_at: datetime


@dataclass(frozen=True, slots=True)
@explained_as("vehicles")
class VehicleInState(Vehicle):
    """A record and how far one has come with it."""

    state: VehicleState


@dataclass(frozen=True, slots=True)
class VehicleSheet(VehicleInState):
    """A record with its standing measurements, which make its state."""

    measurements: tuple[Measurement, ...]
