"""Bodies of road poses and of the geometry under the pointer."""

from datetime import datetime
from typing import Annotated, Any, Literal

from pydantic import Field

from backend.api.board_bodies import Markers, SquareM
from backend.api.bodies import Finite, FrameNumber, Id, In, Out, Point
from backend.api.measurement_bodies import InsetM, MoreFrames, SigmaPx, UInsetM
from backend.storage.records import MeasurementStatus, Target

Polyline = list[list[float]]
Corners = Annotated[int, Field(ge=2, le=60, description="Inner corners: where four squares meet.")]
HeightAboveRoad = Annotated[Finite, Field(ge=-1, le=10)]


class BoardWanted(Markers):
    frame: FrameNumber
    columns: Corners
    rows: Corners
    square_m: SquareM = None
    calibration_id: Id | None = None


class BoardBody(Out):
    """The board on one frame; where it was not found, why."""

    found: bool
    reason: str | None
    columns: int
    rows: int
    corners_px: Polyline
    outline_px: Polyline
    ids: list[int] | None = Field(
        description="Which corners were seen, counted row by row; null for all of them."
    )
    order_note: str


class PoseWanted(Markers):
    calibration_id: Id
    first_frame: FrameNumber
    last_frame: FrameNumber
    columns: Corners
    rows: Corners
    square_m: Annotated[Finite, Field(gt=0, le=5)]
    reference: Literal["top", "bottom"]
    reference_height_m: HeightAboveRoad
    u_reference_height_m: Annotated[Finite, Field(ge=0, le=1)] = 0.003
    u_lean_rad: Annotated[Finite, Field(ge=0, le=1)] = 0.005
    u_square_m: Annotated[
        Finite | None, Field(ge=0, le=1, description="Of a square's side; null: 0.1 % of it, an estimate.")
    ] = None
    u_bow_m: Annotated[Finite, Field(ge=0, le=1, description="Middle of the board out of plane.")] = 0.0005


class PoseSummaryBody(Out):
    id: int
    recording_id: int
    calibration_id: int
    created_at: datetime
    first_frame: int
    last_frame: int
    rms_px: float | None
    distance_m: float | None
    summary: str


class AxesBody(Out):
    longitudinal: Polyline
    vertical: Polyline
    transversal: Polyline
    origin_px: list[float]


class IsoHeight(Out):
    height_m: float
    points: Polyline


class PoseOverlay(Out):
    grid: list[Polyline]
    iso_heights: list[IsoHeight]
    axes: AxesBody | None
    corners_px: Polyline


class ExpectedHeight(Out):
    distance_m: float
    u_height_m: float | None
    U95_height_m: float | None
    reason: str | None


class PoseBody(PoseSummaryBody):
    document: dict[str, Any] = Field(description="The pose as pose.json.")
    warnings: list[str]
    expected: list[ExpectedHeight]
    overlay: PoseOverlay


class AxesWanted(In):
    contact: Point
    target: Target = "roof"
    inset_m: InsetM | None = None
    u_inset_m: UInsetM | None = None


class RungBody(Out):
    height_m: float
    points: Polyline
    label: bool


class AxesAnswer(Out):
    """The road's axes and the ladder of heights through a contact click; where there are none, why."""

    ok: bool
    reason: str | None
    axes: AxesBody | None
    ladder: list[RungBody]
    x_m: float | None
    y_m: float | None
    distance_m: float | None


class HeightWanted(In):
    contact: Point
    point: Point
    target: Target
    frame: FrameNumber | None = None
    sigma_px: SigmaPx | None = None
    inset_m: InsetM | None = None
    u_inset_m: UInsetM | None = None
    more_frames: MoreFrames = Field(default_factory=list)


class BudgetEntryBody(Out):
    source: str
    u_m: float


class SingleFrameBody(Out):
    """What the first frame alone would give, with the inset assumed."""

    height_m: float | None
    u_height_m: float | None
    U95_height_m: float | None


class HeightAnswer(Out):
    """One height with its uncertainty; where there is none, why."""

    status: MeasurementStatus
    reason: str | None
    height_m: float | None
    u_height_m: float | None
    U95_height_m: float | None
    uncorrected_height_m: float | None
    inset_m: float
    u_inset_m: float
    x_m: float | None
    y_m: float | None
    distance_m: float | None
    budget: list[BudgetEntryBody]
    flags: list[str]
    frames: int
    solved_inset_m: float | None
    u_solved_inset_m: float | None
    heading_rad: float | None
    u_heading_rad: float | None
    travel_m: float | None
    single: SingleFrameBody | None = Field(description="Beside a height from several frames.")
