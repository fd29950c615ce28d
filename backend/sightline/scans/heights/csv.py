"""The tables of heights in line scans in an export: what every column holds, and the rows."""

from __future__ import annotations

from collections.abc import Iterable
from datetime import datetime

from sqlalchemy.orm import Session

from sightline.coverage import expanded
from sightline.infra.audit.records import Who
from sightline.infra.csv_package.schema import Cells, Column, Table, when
from sightline.scans.heights.pose_store import line_pose_history
from sightline.scans.heights.poses import line_pose_result
from sightline.scans.heights.records import StoredLineHeight, StoredLinePose
from sightline.scans.heights.store import line_height_history_of_scan


def _id(name: str, meaning: str, required: bool = True) -> Column:
    return Column(name, "integer", meaning, required=required)


def _number(name: str, meaning: str, unit: str, required: bool = False) -> Column:
    return Column(name, "number", meaning, unit, required=required)


_MADE = (
    Column("code_version", "string", "version of the program that computed it", required=True),
    _id("created_by_id", "who made it; empty for the program itself", required=False),
    Column("created_at", "datetime", "when the revision was stored (ISO 8601, UTC)"),
)
_MAKER = (("created_by_id",), "people", ("id",))

LINE_POSES = Table(
    "line_poses",
    "Calibrations of line scans' camera 1 with a rod held upright; a recording's newest revision counts. "
    "They are solved for from line_marks.",
    (
        _id("id", "calibration"),
        _id("scan_id", "line-scan recording"),
        _id("revision", "number of the calibration, from 1"),
        _number("sigma_px", "standard uncertainty of a mark's row; empty: from the residuals", "px"),
        _number("u_distance_m", "standard uncertainty of each distance of the rod (k = 1)", "m", True),
        _number("u_lean_rad", "standard uncertainty of the rod's lean at each distance (k = 1)", "rad", True),
        _number("camera_height_m", "height of the camera's centre above the road", "m", True),
        _number("u_camera_height_m", "standard uncertainty of camera_height_m (k = 1)", "m", True),
        _number("rms_px", "root mean square of the residual rows", "px", True),
        *_MADE,
    ),
    primary=("id",),
    foreign=((("scan_id",), "line_scans", ("id",)), _MAKER),
)
LINE_MARKS = Table(
    "line_marks",
    "The marks of the rod in strip 1 that each calibration is solved for from.",
    (
        _id("pose_id", "calibration, in line_poses"),
        _id("mark", "number of the mark, from 1"),
        _number("distance_m", "horizontal distance of the rod from the camera's centre", "m", True),
        _number("height_m", "height of the mark above the road", "m", True),
        _number("row_px", "row of strip 1, as clicked", "px", True),
        _number("line", "line of strip 1, as clicked", "", True),
        _number("residual_px", "the model's row minus row_px", "px", True),
    ),
    primary=("pose_id", "mark"),
    foreign=((("pose_id",), "line_poses", ("id",)),),
)
LINE_HEIGHTS = Table(
    "line_heights",
    "Every revision of every height measured in a line scan, by two clicks in strip 1. A vehicle's height of "
    "a target is its newest revision, unless that was withdrawn.",
    (
        _id("id", "revision of a height"),
        _id("vehicle_id", "vehicle of a line-scan recording"),
        Column(
            "target",
            "string",
            "what the height is of",
            required=True,
            enum=("roof", "driver_eye", "taillight", "headlight", "other"),
        ),
        _id("revision", "number of the revision of this vehicle and target, from 1"),
        Column("current", "boolean", "true for the newest revision", required=True),
        Column("withdrawn", "boolean", "true where the height was taken back", required=True),
        _id("pose_id", "calibration that it was computed with, in line_poses"),
        _number("contact_line", "line of strip 1 of the tyre's contact, as clicked", "", True),
        _number("contact_row_px", "row of the tyre's contact, as clicked", "px", True),
        _number("target_line", "line of strip 1 of the target, as clicked", "", True),
        _number("target_row_px", "row of the target, as clicked", "px", True),
        _number("sigma_px", "standard uncertainty of each clicked row", "px", True),
        _number("inset_m", "how far the target lies behind the contact, as assumed", "m", True),
        _number("u_inset_m", "standard uncertainty of the inset (k = 1)", "m", True),
        _number("distance_m", "horizontal, from the camera to the contact", "m"),
        _number("u_distance_m", "standard uncertainty of distance_m (k = 1)", "m"),
        _number("height_m", "height of the target above the road", "m"),
        _number("u_height_m", "standard uncertainty of height_m (k = 1)", "m"),
        _number("U95_height_m", "half-width of the 95 % interval of height_m", "m"),
        Column("status", "string", "whether there is a height", required=True, enum=("ok", "not_measurable")),
        Column("reason", "string", "why there is no height"),
        Column("warnings", "string", "what is to be said of this height, separated by semicolons"),
        *_MADE,
    ),
    primary=("id",),
    foreign=((("vehicle_id",), "scan_vehicles", ("id",)), (("pose_id",), "line_poses", ("id",)), _MAKER),
)
LINE_BUDGET = Table(
    "line_height_budget",
    "The contributions to each u_height_m of line_heights; their root sum of squares is u_height_m.",
    (
        _id("height_id", "revision of a height, in line_heights"),
        Column("source", "string", "where the uncertainty comes from", required=True),
        _number("u_m", "its contribution to the standard uncertainty of the height", "m", True),
    ),
    primary=("height_id", "source"),
    foreign=((("height_id",), "line_heights", ("id",)),),
)
TABLES = (LINE_POSES, LINE_MARKS, LINE_HEIGHTS, LINE_BUDGET)


def add_scan(
    session: Session, scan_id: int, vehicle_ids: Iterable[int], found: dict[str, list[Cells]]
) -> list[Who | None]:
    """Add the rows of one recording, its vehicles in their order; gives back who stands in them."""
    makers: list[Who | None] = []
    for pose in line_pose_history(session, scan_id):
        makers.append(pose.created_by)
        found["line_poses"].append(pose_row(pose))
        found["line_marks"] += mark_rows(pose)
    of_vehicle = line_height_history_of_scan(session, scan_id)
    for vehicle_id in vehicle_ids:
        revisions = of_vehicle.get(vehicle_id, [])
        newest = {one.values.target: one.id for one in revisions}
        for one in revisions:
            makers.append(one.created_by)
            found["line_heights"].append(height_row(one, newest[one.values.target] == one.id))
            found["line_height_budget"] += [{"height_id": one.id, **entry} for entry in one.values.budget]
    return makers


def pose_row(one: StoredLinePose) -> Cells:
    """One row of line_poses."""
    row: Cells = {name: getattr(one, name) for name in ("id", "scan_id", "revision")}
    row |= {column.name: getattr(one.values, column.name) for column in LINE_POSES.columns[3:-2]}
    return {**row, **_made(one.created_by, one.created_at)}


def mark_rows(one: StoredLinePose) -> list[Cells]:
    """The rows of line_marks of one calibration."""
    residuals = line_pose_result(one).residuals_px
    return [
        {"pose_id": one.id, "mark": number, **mark, "residual_px": residual}
        for number, (mark, residual) in enumerate(zip(one.values.marks, residuals, strict=True), 1)
    ]


def height_row(one: StoredLineHeight, current: bool) -> Cells:
    """One row of line_heights."""
    values = one.values
    own: Cells = {"id": one.id, "vehicle_id": one.vehicle_id, "revision": one.revision, "current": current}
    left_out = (*own, "U95_height_m", "warnings", "created_by_id", "created_at")
    own |= {name: getattr(values, name) for name in LINE_HEIGHTS.header if name not in left_out}
    own["U95_height_m"] = expanded(values.u_height_m)
    own["warnings"] = "; ".join(values.warnings)
    return {**own, **_made(one.created_by, one.created_at)}


def _made(maker: Who | None, at: datetime) -> Cells:
    return {"created_by_id": maker.id if maker else None, "created_at": when(at)}
