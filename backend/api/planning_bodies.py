"""Bodies of a site's plan."""

from pydantic import Field

from backend.api.bodies import Out
from backend.api.pose_bodies import BudgetEntryBody
from backend.storage.records import MeasurementStatus


class PlannedCamera(Out):
    name: str
    width_px: int
    height_px: int
    calibration_id: int | None
    lens_known: bool = Field(description="Whether the lens's own uncertainty is known and counted.")


class PlannedSite(Out):
    camera_height_m: float
    distance_m: float
    board_distance_m: float
    sigma_px: float
    direction_deg: float
    travel_m: float


class TwoFramesBody(Out):
    reason: str | None
    u_height_m: float | None
    U95_height_m: float | None
    u_inset_m: float | None


class PlannedTargetBody(Out):
    target: str = Field(
        description="A target, or driver_eye_far: the driver on the side away from the camera."
    )
    height_m: float = Field(description="The height it is planned for; an estimate.")
    inset_m: float
    u_inset_m: float
    status: MeasurementStatus
    reason: str | None
    u_height_m: float | None
    U95_height_m: float | None
    bias_if_ignored_m: float
    budget: list[BudgetEntryBody]
    flags: list[str]
    two_frames: TwoFramesBody


class CurveBody(Out):
    """One line of a figure; a null is a point without a value."""

    target: str
    at_m: list[float]
    value_m: list[float | None]


class OutlookBody(Out):
    """Where the picture's edges look: above the horizon, and from square across the road to +X."""

    top_rad: float | None
    bottom_rad: float | None
    left_rad: float | None
    right_rad: float | None


class PlannedBoard(Out):
    columns: int
    rows: int
    square_m: float
    top_m: float


class PlanBody(Out):
    camera: PlannedCamera
    site: PlannedSite
    board: PlannedBoard
    targets: list[PlannedTargetBody]
    advice: list[str]
    U95_over_distance: list[CurveBody]
    bias_over_camera_height: list[CurveBody]
    outlook: OutlookBody
    tilt_rad: float
    track_shown_m: float
