"""Records of heights in line scans: poses of the line camera from rod marks, and heights of vehicles."""

from dataclasses import asdict, dataclass
from datetime import datetime

from sightline.enums import (
    Category,
    DriverSide,
    InsetSource,
    JsonObject,
    MeasurementStatus,
    ScanVerdict,
    Target,
)
from sightline.infra.audit.records import Who
from sightline.measurements.records import ReviewState


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


@dataclass(frozen=True, slots=True)
class LineHeightValues:
    """One height of a scanned vehicle: the two clicks in strip 1, the inset, the result or why there is none.

    `inset_from`: "usual" where it is the survey's, which `side` chose for an eye.
    `budget`: {source, u_m} each.
    """

    target: Target
    pose_id: int
    contact_line: float
    contact_row_px: float
    target_line: float
    target_row_px: float
    sigma_px: float
    inset_m: float
    u_inset_m: float
    inset_from: InsetSource
    side: DriverSide | None
    distance_m: float | None
    u_distance_m: float | None
    height_m: float | None
    u_height_m: float | None
    status: MeasurementStatus
    reason: str | None
    budget: list[JsonObject]
    warnings: list[str]
    withdrawn: bool
    code_version: str


def same_line_height(then: LineHeightValues, now: LineHeightValues) -> bool:
    """Whether one has the very clicks of another and, by the same facts, its numbers."""
    of_both = [
        {name: value for name, value in asdict(one).items() if name not in ("code_version", "budget")}
        for one in (then, now)
    ]
    return of_both[0] == of_both[1]


@dataclass(frozen=True, slots=True)
class StoredLineHeight:
    """One revision of a target's height; the newest of a vehicle's target counts, unless it is withdrawn.

    `computing_id`: what computed it again, with the clicks of the revision before; `verdict_of_id`: the
    revision whose verdict holds for it too; `judged_id`: the one that its verdict was given on. `category`:
    the vehicle's by now.
    """

    id: int
    survey_id: int
    scan_id: int
    vehicle_id: int
    revision: int
    values: LineHeightValues
    created_by: Who | None
    created_at: datetime
    review: ReviewState
    computing_id: int | None = None
    verdict_of_id: int | None = None
    judged_id: int | None = None
    category: Category | None = None


@dataclass(frozen=True, slots=True)
class LineHeightReview:
    """One verdict given on a revision of a height."""

    id: int
    height_id: int
    vehicle_id: int
    verdict: ScanVerdict
    reason: str | None
    reviewer: Who | None
    at: datetime


@dataclass(frozen=True, slots=True)
class WaitingLineHeight:
    """A height of a line scan that waits for a verdict; `mine`: of the asker's own clicks."""

    id: int
    scan_id: int
    scan_name: str
    vehicle_id: int
    number: int
    target: Target
    height_m: float | None
    U95_height_m: float | None
    mine: bool


@dataclass(frozen=True, slots=True)
class LineHeightQueue:
    """The heights of a survey's line scans that wait: for the asker, and the asker's own."""

    to_review: int
    own: int
    items: tuple[WaitingLineHeight, ...]
