"""Computing every calibration and height of an export's line scans again from its marks and clicks."""

import math
from collections import defaultdict
from collections.abc import Mapping
from dataclasses import asdict
from typing import Any, cast

from sightline.enums import Category, ComputingCause, DriverSide, InsetSource, Target
from sightline.errors import Damaged
from sightline.geometry.sides import FoundSide
from sightline.infra.audit.hashing import content_hash
from sightline.infra.csv_package.columns import code_of, join_sentences
from sightline.infra.csv_package.files import Files, read_columns, read_rows
from sightline.infra.csv_package.recomputing import Recomputing
from sightline.linescan.line_height import LineHeight
from sightline.linescan.line_pose import LinePose, LinePoseError
from sightline.measurements.again.differences import causes_now, facts_of
from sightline.measurements.again.verify import same_figures
from sightline.measurements.records import Clicks
from sightline.messages.said import Said
from sightline.scans.heights.csv import LINE_BUDGET, LINE_HEIGHTS, LINE_MARKS, LINE_POSES
from sightline.scans.heights.poses import Mark, Rod, solve
from sightline.scans.heights.service import answer
from sightline.surveys.csv import insets_in

#: The part of the program that computes what a line scan's points and passes give, by its name in
#: datapackage.json.
LINES = "line_heights"
Row = Mapping[str, str]
# Half of the last decimal that a CSV carries, and a hair for the rounding of the last binary digit.
_TOLERANCE = 0.51e-6
_CLICKED = ("contact_line", "contact_row_px", "target_line", "target_row_px", "sigma_px", "pose_id", "status")
_STORED = ("contact_x_px", "contact_y_px", "target_x_px", "target_y_px")
_FIGURES = ("distance_m", "u_distance_m", "height_m", "u_height_m", "U95_height_m")


def check_line_heights(
    files: Files, told_poses: Mapping[int, Mapping[str, Any]], recomputing: Recomputing
) -> None:
    """Solve every calibration and compute every height again. Raises Damaged.

    `told_poses`: what the audit events say of each calibration, its marks too.
    """
    _out_of_date(files)
    marks: dict[int, list[Row]] = defaultdict(list)
    for row in read_rows(files, LINE_MARKS.key):
        marks[int(row["pose_id"])].append(row)
    poses, versions = {}, {}
    for row in read_rows(files, LINE_POSES.key):
        number, mine = int(row["id"]), marks.pop(int(row["id"]), [])
        versions[number] = row["code_version"]
        rod = _rod(row, mine, told_poses[number])
        with recomputing.of(LINES, versions[number]):
            poses[number] = _pose(row, rod, mine)
    if marks:
        raise Damaged(
            "scans-calibration-no-row", path=LINE_MARKS.key, marks=min(marks), path_2=LINE_POSES.key
        )
    _heights(files, poses, versions, recomputing)


def height_or_verdict(
    entity: str, number: int, after: Mapping[str, Any], revision_ids: dict[tuple[int, int], int]
) -> tuple[str, int, dict[str, Any]]:
    """What an event of a measurement in a line scan, or of a review of one, says of a row of the tables of
    heights: entity, id and cells, as the events of earlier versions told them. `revision_ids`: by measurement
    and revision, of those told before; the one told now is added.

    Raises Damaged for an event that does not hold its own row.
    """
    if entity == "review":
        judged = revision_ids.get((after["series_id"], after["result_revision"]), 0)
        vehicle = {"vehicle_id": after["scan_vehicle_id"], "height_id": judged}
        return "line_height_review", number, {**after, **vehicle}
    row = after["row"]
    if content_hash(row) != after["content_sha256"]:
        raise Damaged("measurements-event-another-row", id=number)
    points = {name: row[column] for name, column in zip(_CLICKED, _STORED, strict=False)}
    judged = row["verdict_of_revision"]
    cells = {
        "vehicle_id": after["scan_vehicle_id"],
        "measurement_id": number,
        "pose_id": row["line_pose_id"],
        "reason_code": row["reason"] and code_of(Said.read(row["reason"])),
        "flags_code": code_of([Said.read(one) for one in row["flags"]]),
        "verdict_of_id": None if judged is None else revision_ids.get((number, judged), 0),
        "created_by_id": row["created_by"],
    }
    revision_ids[number, row["revision"]] = after["revision_id"]
    left_out = ("reason", "flags", "pose_id")
    plain = {name: value for name, value in row.items() if name not in left_out}
    return "line_height", after["revision_id"], {**plain, **points, **cells}


def _out_of_date(files: Files) -> None:
    """Standing heights are marked for another calibration or inset than the newest, and no other is."""
    insets = insets_in(files)
    scans = dict(read_columns(files, "scan_vehicles.csv", ("id", "scan_id")))
    category = dict(read_columns(files, "scan_vehicles.csv", ("id", "category")))
    newest: dict[str, tuple[int, int]] = {}
    for row in read_rows(files, LINE_POSES.key):
        of_scan = newest.get(row["scan_id"], (0, 0))
        newest[row["scan_id"]] = max(of_scan, (int(row["revision"]), int(row["id"])))
    for row in read_rows(files, LINE_HEIGHTS.key):
        causes: tuple[ComputingCause, ...] = ()
        if row["current"] == "true" and row["withdrawn"] != "true":
            clicks, of = _clicks(row), row["vehicle_id"]
            causes = causes_now(
                clicks.target,
                facts_of(clicks, int(row["pose_id"])),
                pose_id=newest[scans[of]][1],
                side=None if clicks.side is None else FoundSide(clicks.side, "said"),
                category=cast(Category | None, category[of] or None),
                insets=insets,
            )
        if row["out_of_date"] != join_sentences(causes):
            raise Damaged("computing-mark-wrong", path=LINE_HEIGHTS.key, id=row["id"])


def line_height_put_back(then: Row, row: Row) -> bool:
    """Whether a height stands on the very clicks and numbers of an earlier revision."""
    return all(then[name] == row[name] for name in _CLICKED) and same_figures(then, row)


def _rod(row: Row, marks: list[Row], after: Mapping[str, Any]) -> Rod:
    """What was marked, as the event tells it."""
    numbers = ("distance_m", "height_m", "row_px", "line")
    clicked = tuple(Mark(*(float(mark[column]) for column in numbers)) for mark in marks)
    numbered = all(mark["mark"] == str(number) for number, mark in enumerate(marks, 1))
    if not numbered or [asdict(mark) for mark in clicked] != after["marks"]:
        raise Damaged("scans-marks-differ", path=LINE_MARKS.key, id=row["id"])
    sigma_px = float(row["sigma_px"]) if row["sigma_px"] else None
    return Rod(clicked, sigma_px, float(row["u_distance_m"]), float(row["u_lean_rad"]))


def _pose(row: Row, rod: Rod, marks: list[Row]) -> LinePose:
    name = f"{LINE_POSES.key}: calibration {row['id']}"
    try:
        pose = solve(rod)
    except LinePoseError as error:
        raise Damaged("scans-marks-unsolvable", name=name) from error
    _compare_value(name, row, "camera_height_m", pose.camera_height_m)
    _compare_value(name, row, "u_camera_height_m", math.sqrt(pose.covariance[3, 3]))
    _compare_value(name, row, "rms_px", pose.rms_px)
    for number, (mark, one) in enumerate(zip(rod.marks, marks, strict=True), 1):
        model = float(pose.rows_of(mark.distance_m, mark.height_m))
        _compare_value(
            f"{LINE_MARKS.key}: mark {number} of {row['id']}", one, "residual_px", model - mark.row_px
        )
    return pose


def _heights(
    files: Files, poses: Mapping[int, LinePose], versions: Mapping[int, str], recomputing: Recomputing
) -> None:
    """`versions`: the one that solved each calibration, which this version may solve otherwise."""
    budget: dict[str, list[Row]] = defaultdict(list)
    for row in read_rows(files, LINE_BUDGET.key):
        budget[row["height_id"]].append(row)
    newest: dict[tuple[str, str], Row] = {}
    marked: set[str] = set()
    for row in read_rows(files, LINE_HEIGHTS.key):
        pose_id, mine = int(row["pose_id"]), budget.pop(row["id"], [])
        with recomputing.of(LINES, row["code_version"], versions[pose_id]):
            _height(row, answer(poses[pose_id], _clicks(row)), mine)
        place = row["vehicle_id"], row["target"]
        before = newest.get(place)
        if before is None or int(before["revision"]) < int(row["revision"]):
            newest[place] = row
        if row["current"] == "true":
            marked.add(row["id"])
    if marked != {row["id"] for row in newest.values()}:
        raise Damaged("scans-current-not-newest", path=LINE_HEIGHTS.key)
    if budget:
        raise Damaged(
            "scans-height-no-row", path=LINE_BUDGET.key, budget=min(budget), path_2=LINE_HEIGHTS.key
        )


def _height(row: Row, height: LineHeight, budget: list[Row]) -> None:
    name = f"{LINE_HEIGHTS.key}: height {row['id']}"
    if row["status"] != height.status:
        raise Damaged("measurements-status-differs", name=name, status=row["status"], status_2=height.status)
    for column in _FIGURES:
        _compare_value(name, row, column, getattr(height, column))
    if [one["source"] for one in budget] != [one.source for one in height.budget]:
        raise Damaged("scans-sources-differ", path=LINE_BUDGET.key, id=row["id"])
    for told, entry in zip(budget, height.budget, strict=True):
        _compare_value(f"{LINE_BUDGET.key}: {entry.source} of height {row['id']}", told, "u_m", entry.u_m)


def _clicks(row: Row) -> Clicks:
    number = {name: float(row[name]) for name in row if name.endswith(("_line", "_px", "inset_m"))}
    side = cast(DriverSide | None, row["side"] or None)
    return Clicks(
        target=cast(Target, row["target"]),
        contact=(number["contact_line"], number["contact_row_px"]),
        target_point=(number["target_line"], number["target_row_px"]),
        sigma_px=number["sigma_px"],
        inset_m=number["inset_m"],
        u_inset_m=number["u_inset_m"],
        inset_from=cast(InsetSource, row["inset_from"]),
        side=side,
        side_from=None if side is None else "said",
    )


def _compare_value(name: str, row: Row, column: str, value: float | None) -> None:
    stored = row[column]
    if not stored and value is None:
        return
    if not stored or value is None or math.fabs(float(stored) - value) > _TOLERANCE:
        computed = "nothing" if value is None else f"{value:.6f}"
        raise Damaged(
            "scans-marks-clicks-give", name=name, column=column, told=stored or "empty", computed=computed
        )
