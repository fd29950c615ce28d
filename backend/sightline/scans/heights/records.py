"""Records of the poses of line cameras from rod marks."""

from dataclasses import dataclass

from sightline.enums import JsonObject
from sightline.scans.records import StoredRevision


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


StoredLinePose = StoredRevision[LinePoseValues]
