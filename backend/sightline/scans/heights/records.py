"""Records of the poses of line cameras from rod marks."""

from dataclasses import dataclass
from datetime import datetime

from sightline.enums import JsonObject
from sightline.infra.audit.records import Who


@dataclass(frozen=True, slots=True)
class LinePoseValues:
    """What a calibration with the rod consists of.

    `marks`: {distance_m, height_m, row_px, line} each. `sigma_px`: of a mark's row; None: from the residuals.
    `pose`: {parameters, covariance, row_span}, as `linescan.line_pose` has them.
    """

    marks: list[JsonObject]
    sigma_px: float | None
    u_distance_m: float
    u_lean_rad: float
    pose: JsonObject
    camera_height_m: float
    u_camera_height_m: float
    rms_px: float
    code_version: str


@dataclass(frozen=True, slots=True)
class StoredLinePose:
    """One calibration of a scan's camera 1; the newest revision counts."""

    id: int
    survey_id: int
    scan_id: int
    revision: int
    values: LinePoseValues
    created_by: Who | None
    created_at: datetime
