"""Bodies of a site's plan."""

from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from sightline.enums import MeasurementStatus
from sightline.geometry.height import BudgetEntry
from sightline.geometry.plan import Curve
from sightline.geometry.plan_passing import Passing
from sightline.geometry.plan_targets import TwoFrames
from sightline.geometry.site import Outlook
from sightline.infra.web.bodies import Out, of_record
from sightline.linescan.exposure import ExposurePlan
from sightline.linescan.planner import LinePlan, PlannedValue
from sightline.messages.said import Said


@dataclass(frozen=True, kw_only=True)
class PlannedCamera:
    """The camera that is planned with."""

    name: str
    width_px: int
    height_px: int
    calibration_id: int | None
    lens_known: Annotated[bool, Field(description="Whether the lens's own uncertainty is known and counted.")]


@dataclass(frozen=True, kw_only=True)
class PlannedSite:
    """Where things are to stand."""

    camera_height_m: float
    distance_m: float
    board_distance_m: float
    sigma_px: float
    direction_deg: float
    travel_m: float


@dataclass(frozen=True, kw_only=True)
class PlannedTargetBody:
    """What to expect of one target."""

    target: Annotated[
        str,
        Field(description="A target, or driver_eye_far: the driver on the side away from the camera."),
    ]
    height_m: Annotated[float, Field(description="The height it is planned for; an estimate.")]
    inset_m: float
    u_inset_m: float
    status: MeasurementStatus
    reason: Said | None
    u_height_m: float | None
    U95_height_m: float | None
    bias_if_ignored_m: float
    budget: tuple[BudgetEntry, ...]
    flags: tuple[Said, ...]
    two_frames: TwoFrames


@dataclass(frozen=True, kw_only=True)
class PlannedBoard:
    """The board that the pose is planned with."""

    columns: int
    rows: int
    square_m: float
    top_m: float


@dataclass(frozen=True, kw_only=True)
class PlanBody:
    """Expected uncertainties of a set-up, with advice."""

    camera: PlannedCamera
    site: PlannedSite
    board: PlannedBoard
    targets: list[PlannedTargetBody]
    advice: tuple[Said, ...]
    U95_over_distance: tuple[Curve, ...]
    bias_over_camera_height: tuple[Curve, ...]
    outlook: Outlook
    tilt_rad: float
    track_shown_m: float
    passing: tuple[Passing, ...]


class LineFormBody(Out):
    """Equation (2) in one of its forms: the line rate for the wanted error, the error at the line rate."""

    line_rate_hz: float = Field(description="Keeps the speed within the wanted error.")
    error: float = Field(description="Share by which the speed may be off at the planned line rate.")
    error_mps: float


@of_record(LinePlan, "wanted", "expected", "words")
class LinePlanBody(Out):
    """What a line rate and a baseline are worth for a vehicle; `u_` are standard uncertainties."""

    line_rate_hz: float = Field(description="As given, else fine_hz.")
    fine_hz: float = Field(description="At which the vehicle moves 10 mm from line to line.")
    error: float = Field(description="Share that the speed's U95 may be, as wanted.")
    lines: float = Field(description="From camera 1 to camera 2.")
    printed: LineFormBody = Field(description="The printed right side, 2 / (n + 2).")
    corrected: LineFormBody = Field(description="The equation's middle term, 2 / n.")
    one_line_m: float = Field(description="What the vehicle travels in one line.")
    u_strips_mps: float = Field(description="Of registering both strips, as the default method does.")
    values: list[PlannedValue] = Field(description="Speed, length, time gap, distance gap: m/s, m, s, m.")
    exposure: ExposurePlan | None = Field(description="null: pixels, lens or distance were not given.")
    advice: list[Said]
