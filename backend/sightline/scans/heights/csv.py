"""The tables of heights in line scans in an export: what every column holds, and what rows they have."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, get_args

from sightline.enums import JsonObject, Point, ScanVerdict
from sightline.infra.csv_package.columns import (
    columns_within,
    flag,
    integer,
    key,
    metres,
    moment,
    number,
    person,
    text,
)
from sightline.infra.csv_package.files import Staging
from sightline.infra.csv_package.schema import Column, Table, ids_of
from sightline.infra.database import Session
from sightline.measurements.again.csv import out_of_date
from sightline.measurements.csv import MEASUREMENTS, given_verdict
from sightline.measurements.query import reviews_of_series
from sightline.measurements.records import Review, ScanHeight, ScanHeightValues
from sightline.measurements.tables import measurement_series
from sightline.scans.heights.pose_store import line_pose_history
from sightline.scans.heights.poses import line_pose_result
from sightline.scans.heights.records import LinePoseValues, StoredLinePose
from sightline.scans.heights.service import causes_now_of_scan
from sightline.scans.heights.store import scan_height_history_of_scan
from sightline.surveys.records import Inset

_MADE = "version of the program that computed it"
_MAKER = "who made it; empty for the program itself"
_MADE_AT = "when the revision was stored"


@dataclass(frozen=True, slots=True)
class RodMark:
    """A mark of the rod that a calibration is solved for from, with its residual."""

    pose_id: int
    number: int
    mark: JsonObject
    residual_px: float


@dataclass(frozen=True, slots=True)
class ListedHeight:
    """A revision; `current`: its vehicle's and target's newest; `verdict_of_id`: whose verdict it keeps."""

    height: ScanHeight
    current: bool
    verdict_of_id: int | None


@dataclass(frozen=True, slots=True)
class JudgedHeight:
    """A verdict, and the revision of a height that it holds for."""

    review: Review
    height_id: int


@dataclass(frozen=True, slots=True)
class HeightBudgetEntry:
    """One contribution to the uncertainty of a height."""

    height_id: int
    source: str
    u_m: float


_SOLVED: tuple[Column[LinePoseValues], ...] = (
    number("sigma_px", "standard uncertainty of a mark's row; empty: from the residuals", "px"),
    metres("u_distance_m", "standard uncertainty of each distance of the rod (k = 1)", required=True),
    number(
        "u_lean_rad", "standard uncertainty of the rod's lean at each distance (k = 1)", "rad", required=True
    ),
    metres("camera_height_m", "height of the camera's centre above the road", required=True),
    metres("u_camera_height_m", "standard uncertainty of camera_height_m (k = 1)", required=True),
    number("rms_px", "root mean square of the residual rows", "px", required=True),
    text("code_version", _MADE, required=True),
)


LINE_POSES: Table[StoredLinePose] = Table(
    "line_poses",
    "Calibrations of line scans' camera 1 with a rod held upright; a recording's newest revision counts. "
    "They are solved for from line_marks.",
    (
        key("id", "calibration"),
        key("scan_id", "line-scan recording"),
        key("revision", "number of the calibration, from 1"),
        *columns_within("values", *_SOLVED),
        person("created_by_id", _MAKER),
        moment("created_at", _MADE_AT),
    ),
    primary=("id",),
    foreign=ids_of(scan_id="line_scans"),
)
LINE_MARKS: Table[RodMark] = Table(
    "line_marks",
    "The marks of the rod in strip 1 that each calibration is solved for from.",
    (
        key("pose_id", "calibration, in line_poses"),
        key("mark", "number of the mark, from 1", lambda m: m.number),
        metres(
            "distance_m",
            "horizontal distance of the rod from the camera's centre",
            lambda m: m.mark["distance_m"],
            required=True,
        ),
        metres("height_m", "height of the mark above the road", lambda m: m.mark["height_m"], required=True),
        number("row_px", "row of strip 1, as clicked", "px", lambda m: m.mark["row_px"], required=True),
        number("line", "line of strip 1, as clicked", "", lambda m: m.mark["line"], required=True),
        number("residual_px", "the model's row minus row_px", "px", required=True),
    ),
    primary=("pose_id", "mark"),
    foreign=ids_of(pose_id="line_poses"),
)


Columns = tuple[Column[ListedHeight], ...]


def _clicked(what: str, meaning: str, of: Callable[[ScanHeightValues], Point]) -> Columns:
    """Line and row of a click."""
    return (
        number(
            f"{what}_line",
            f"line of strip 1 of the {meaning}, as clicked",
            "",
            lambda h: of(h.height.values)[0],
            required=True,
        ),
        number(
            f"{what}_row_px",
            f"row of the {meaning}, as clicked",
            "px",
            lambda h: of(h.height.values)[1],
            required=True,
        ),
    )


_COLUMNS = {one.name: one for one in MEASUREMENTS.columns}


def _as_of_frames(*names: str) -> Columns:
    """Columns of measurements.csv: what they are of is in a height of a line scan by the same names."""
    return columns_within("height", *(_COLUMNS[name] for name in names))


LINE_HEIGHTS: Table[ListedHeight] = Table(
    "line_heights",
    "Every revision of every height measured in a line scan, by two clicks in strip 1. A vehicle's height of "
    "a target is its newest revision, unless that was withdrawn.",
    (
        key("id", "revision of a height", lambda h: h.height.revision_id),
        key("measurement_id", "measurement that this is a revision of", lambda h: h.height.id),
        *columns_within("height", key("vehicle_id", "vehicle of a line-scan recording")),
        *_as_of_frames("target", "revision"),
        flag("current", "true for the newest revision", required=True),
        *_as_of_frames("withdrawn"),
        *columns_within(
            "height.values", key("pose_id", "calibration that it was computed with, in line_poses")
        ),
        *_clicked("contact", "tyre's contact", lambda v: v.contact),
        *_clicked("target", "target", lambda v: v.target_point),
        *_as_of_frames("sigma_px", "inset_m", "u_inset_m", "inset_from"),
        *_as_of_frames("side", "distance_m"),
        *columns_within(
            "height.values", metres("u_distance_m", "standard uncertainty of distance_m (k = 1)")
        ),
        *_as_of_frames("height_m", "u_height_m", "U95_height_m", "status", "reason", "reason_code"),
        *_as_of_frames("flags", "flags_code", "code_version", "computing_id"),
        integer(
            "verdict_of_id", "of a height computed again: earlier revision whose verdict also applies to it"
        ),
        *_as_of_frames("created_by_id", "created_at"),
        *_as_of_frames("verdict", "review_reason", "reviewer_id", "reviewed_at"),
        *columns_within("height", out_of_date("line camera's calibration")),
    ),
    primary=("id",),
    foreign=ids_of(
        vehicle_id="scan_vehicles",
        pose_id="line_poses",
        computing_id="computings",
        verdict_of_id="line_heights",
    ),
)


LINE_HEIGHT_REVIEWS: Table[JudgedHeight] = Table(
    "line_height_reviews",
    "Every verdict given on a revision of a height measured in a line scan, oldest first.",
    (
        *columns_within("review", key("id", "verdict")),
        key("height_id", "revision that was judged, in line_heights"),
        *columns_within("review", *given_verdict(get_args(ScanVerdict))),
    ),
    primary=("id",),
    foreign=ids_of(height_id="line_heights"),
)
LINE_BUDGET: Table[HeightBudgetEntry] = Table(
    "line_height_budget",
    "The contributions to each u_height_m of line_heights; their root sum of squares is u_height_m.",
    (
        key("height_id", "revision of a height, in line_heights"),
        text("source", "source of uncertainty", required=True),
        metres("u_m", "its contribution to the standard uncertainty of the height", required=True),
    ),
    primary=("height_id", "source"),
    foreign=ids_of(height_id="line_heights"),
)
TABLES: tuple[Table[Any], ...] = (LINE_POSES, LINE_MARKS, LINE_HEIGHTS, LINE_BUDGET, LINE_HEIGHT_REVIEWS)


def fill_heights(
    staging: Staging, session: Session, vehicles_of: Mapping[int, Sequence[int]], insets: Mapping[str, Inset]
) -> None:
    """Write the tables of heights. `vehicles_of`: living ones by recording, in order; `insets`: by name."""
    poses = {scan_id: line_pose_history(session, scan_id) for scan_id in vehicles_of}
    solved = [pose for history in poses.values() for pose in history]
    staging.fill(LINE_POSES, solved)
    staging.fill(LINE_MARKS, (mark for pose in solved for mark in _marks(pose)))
    heights: list[ListedHeight] = []
    reviews: list[JudgedHeight] = []
    for scan_id, vehicle_ids in vehicles_of.items():
        history = scan_height_history_of_scan(session, scan_id)
        revisions = [one for vehicle_id in vehicle_ids for one in history.get(vehicle_id, ())]
        in_force = poses[scan_id][-1].id if poses[scan_id] else None
        id_of: dict[tuple[int, int | None], int] = {
            (one.id, one.revision): one.revision_id for one in revisions
        }
        heights += _listed(revisions, in_force, insets, id_of)
        for review in reviews_of_series(session, measurement_series.c.scan_id == scan_id):
            judged = id_of.get((review.measurement_id, review.result_revision))
            if judged is not None:
                reviews.append(JudgedHeight(review, judged))
    staging.fill(LINE_BUDGET, (entry for one in heights for entry in _budget(one.height)))
    staging.fill(LINE_HEIGHTS, sorted(heights, key=lambda one: one.height.revision_id))
    staging.fill(LINE_HEIGHT_REVIEWS, sorted(reviews, key=lambda one: one.review.id))


def _listed(
    revisions: Sequence[ScanHeight],
    pose_id: int | None,
    insets: Mapping[str, Inset],
    id_of: Mapping[tuple[int, int | None], int],
) -> Iterator[ListedHeight]:
    """The revisions of a recording's heights, each height's oldest first; `pose_id`: the calibration that
    counts; `id_of`: each by height and number.
    """
    newest = {revision.id: revision.revision for revision in revisions}
    for revision in revisions:
        current = newest[revision.id] == revision.revision
        if current and not revision.withdrawn:
            revision = replace(
                revision, out_of_date=causes_now_of_scan(revision.values, pose_id, insets, revision.category)
            )
        yield ListedHeight(revision, current, id_of.get((revision.id, revision.verdict_of_revision)))


def _budget(height: ScanHeight) -> Iterator[HeightBudgetEntry]:
    for entry in height.values.budget:
        yield HeightBudgetEntry(height.revision_id, entry["source"], entry["u_m"])


def _marks(pose: StoredLinePose) -> list[RodMark]:
    residuals = line_pose_result(pose).residuals_px
    return [
        RodMark(pose.id, number, mark, residual)
        for number, (mark, residual) in enumerate(zip(pose.values.marks, residuals, strict=True), 1)
    ]
