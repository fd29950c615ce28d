"""The tables of heights in line scans in an export: what every column holds, and what rows they have."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, get_args

from sightline.coverage import expanded
from sightline.enums import (
    ComputingCause,
    DriverSide,
    InsetSource,
    JsonObject,
    MeasurementStatus,
    ScanVerdict,
    Target,
)
from sightline.infra.audit.records import Who
from sightline.infra.csv_package.columns import (
    flag,
    integer,
    joined,
    key,
    metres,
    moment,
    number,
    of_part,
    person,
    text,
)
from sightline.infra.csv_package.files import Staging
from sightline.infra.csv_package.schema import Column, Table
from sightline.infra.database import Session
from sightline.measurements.again.csv import out_of_date
from sightline.measurements.records import ReviewState
from sightline.scans.heights.pose_store import line_pose_history
from sightline.scans.heights.poses import line_pose_result
from sightline.scans.heights.records import (
    LineHeightReview,
    LineHeightValues,
    LinePoseValues,
    StoredLineHeight,
    StoredLinePose,
)
from sightline.scans.heights.review_store import reviews_of_scan_heights
from sightline.scans.heights.service import causes_now_of_line
from sightline.scans.heights.store import line_height_history_of_scan
from sightline.surveys.records import Inset

_MADE = "version of the program that computed it"
_MAKER = "who made it; empty for the program itself"
_MADE_AT = "when the revision was stored"
_MAKER_KEY = (("created_by_id",), "people", ("id",))
_REVIEWER_KEY = (("reviewer_id",), "people", ("id",))
_REVIEWER, _WHY = "who reviewed", "the reviewer's reason"


@dataclass(frozen=True, slots=True)
class RodMark:
    """A mark of the rod that a calibration is solved for from, with its residual."""

    pose_id: int
    number: int
    mark: JsonObject
    residual_px: float


@dataclass(frozen=True, slots=True)
class ListedHeight:
    """A revision of a height; `current`: it is the newest of its vehicle and target; `out_of_date`: the
    facts that it follows from and that hold no longer.
    """

    height: StoredLineHeight
    current: bool
    out_of_date: tuple[ComputingCause, ...] = ()


@dataclass(frozen=True, slots=True)
class HeightBudgetEntry:
    """One contribution to the uncertainty of a height."""

    height_id: int
    source: str
    u_m: float


_SOLVED: tuple[Column[LinePoseValues], ...] = (
    number(
        "sigma_px",
        "standard uncertainty of a mark's row; empty: from the residuals",
        "px",
        lambda v: v.sigma_px,
    ),
    metres(
        "u_distance_m",
        "standard uncertainty of each distance of the rod (k = 1)",
        lambda v: v.u_distance_m,
        required=True,
    ),
    number(
        "u_lean_rad",
        "standard uncertainty of the rod's lean at each distance (k = 1)",
        "rad",
        lambda v: v.u_lean_rad,
        required=True,
    ),
    metres(
        "camera_height_m",
        "height of the camera's centre above the road",
        lambda v: v.camera_height_m,
        required=True,
    ),
    metres(
        "u_camera_height_m",
        "standard uncertainty of camera_height_m (k = 1)",
        lambda v: v.u_camera_height_m,
        required=True,
    ),
    number("rms_px", "root mean square of the residual rows", "px", lambda v: v.rms_px, required=True),
    text("code_version", _MADE, lambda v: v.code_version, required=True),
)


def _solved(pose: StoredLinePose) -> LinePoseValues:
    return pose.values


LINE_POSES: Table[StoredLinePose] = Table(
    "line_poses",
    "Calibrations of line scans' camera 1 with a rod held upright; a recording's newest revision counts. "
    "They are solved for from line_marks.",
    (
        key("id", "calibration", lambda p: p.id),
        key("scan_id", "line-scan recording", lambda p: p.scan_id),
        key("revision", "number of the calibration, from 1", lambda p: p.revision),
        *of_part(_SOLVED, _solved),
        person("created_by_id", _MAKER, lambda p: p.created_by),
        moment("created_at", _MADE_AT, lambda p: p.created_at),
    ),
    primary=("id",),
    foreign=((("scan_id",), "line_scans", ("id",)), _MAKER_KEY),
)
LINE_MARKS: Table[RodMark] = Table(
    "line_marks",
    "The marks of the rod in strip 1 that each calibration is solved for from.",
    (
        key("pose_id", "calibration, in line_poses", lambda m: m.pose_id),
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
        number("residual_px", "the model's row minus row_px", "px", lambda m: m.residual_px, required=True),
    ),
    primary=("pose_id", "mark"),
    foreign=((("pose_id",), "line_poses", ("id",)),),
)

_TARGET: tuple[Column[LineHeightValues], ...] = (
    text("target", "what the height is of", lambda v: v.target, required=True, enum=get_args(Target)),
)
_WITHDRAWN: tuple[Column[LineHeightValues], ...] = (
    flag("withdrawn", "true if the height was withdrawn", lambda v: v.withdrawn, required=True),
)
_MEASURED: tuple[Column[LineHeightValues], ...] = (
    key("pose_id", "calibration that it was computed with, in line_poses", lambda v: v.pose_id),
    number(
        "contact_line",
        "line of strip 1 of the tyre's contact, as clicked",
        "",
        lambda v: v.contact_line,
        required=True,
    ),
    number(
        "contact_row_px",
        "row of the tyre's contact, as clicked",
        "px",
        lambda v: v.contact_row_px,
        required=True,
    ),
    number(
        "target_line",
        "line of strip 1 of the target, as clicked",
        "",
        lambda v: v.target_line,
        required=True,
    ),
    number("target_row_px", "row of the target, as clicked", "px", lambda v: v.target_row_px, required=True),
    number("sigma_px", "standard uncertainty of each clicked row", "px", lambda v: v.sigma_px, required=True),
    metres(
        "inset_m",
        "assumed inset: distance from the vertical plane through the contact to the target",
        lambda v: v.inset_m,
        required=True,
    ),
    metres("u_inset_m", "standard uncertainty of the inset (k = 1)", lambda v: v.u_inset_m, required=True),
    text(
        "inset_from",
        "the survey's usual inset, or one of its own",
        lambda v: v.inset_from,
        required=True,
        enum=get_args(InsetSource),
    ),
    text(
        "side",
        "of a driver's eye: side of the driver as entered",
        lambda v: v.side,
        enum=get_args(DriverSide),
    ),
    metres("distance_m", "horizontal, from the camera to the contact", lambda v: v.distance_m),
    metres("u_distance_m", "standard uncertainty of distance_m (k = 1)", lambda v: v.u_distance_m),
    metres("height_m", "height of the target above the road", lambda v: v.height_m),
    metres("u_height_m", "standard uncertainty of height_m (k = 1)", lambda v: v.u_height_m),
    metres("U95_height_m", "half-width of the 95 % interval of height_m", lambda v: expanded(v.u_height_m)),
    text(
        "status",
        "whether there is a height",
        lambda v: v.status,
        required=True,
        enum=get_args(MeasurementStatus),
    ),
    text("reason", "why there is no height", lambda v: v.reason),
    text(
        "warnings",
        "warnings on this height, separated by semicolons",
        lambda v: joined(v.warnings),
    ),
    text("code_version", _MADE, lambda v: v.code_version, required=True),
)


def _values(listed: ListedHeight) -> LineHeightValues:
    return listed.height.values


def _review(listed: ListedHeight) -> ReviewState:
    return listed.height.review


#: Of the revision of a motion or height: what stands of its reviews.
VERDICT: tuple[Column[ReviewState], ...] = (
    text(
        "verdict",
        "state of the review of this revision",
        lambda r: r.verdict,
        required=True,
        enum=("to_review", *get_args(ScanVerdict)),
    ),
    text("review_reason", _WHY, lambda r: r.reason),
    person("reviewer_id", _REVIEWER, lambda r: r.reviewer),
    moment("reviewed_at", "when it was reviewed", lambda r: r.at),
)

LINE_HEIGHTS: Table[ListedHeight] = Table(
    "line_heights",
    "Every revision of every height measured in a line scan, by two clicks in strip 1. A vehicle's height of "
    "a target is its newest revision, unless that was withdrawn.",
    (
        key("id", "revision of a height", lambda h: h.height.id),
        key("vehicle_id", "vehicle of a line-scan recording", lambda h: h.height.vehicle_id),
        *of_part(_TARGET, _values),
        key(
            "revision",
            "number of the revision of this vehicle and target, from 1",
            lambda h: h.height.revision,
        ),
        flag("current", "true for the newest revision", lambda h: h.current, required=True),
        *of_part(_WITHDRAWN, _values),
        *of_part(_MEASURED, _values),
        integer(
            "computing_id",
            "what computed it again, in computings; its clicks are those of the revision before",
            lambda h: h.height.computing_id,
        ),
        integer(
            "verdict_of_id",
            "of a height computed again: earlier revision whose verdict also applies to it",
            lambda h: h.height.verdict_of_id,
        ),
        person("created_by_id", "who clicked; empty for the program itself", lambda h: h.height.created_by),
        moment("created_at", _MADE_AT, lambda h: h.height.created_at),
        *of_part(VERDICT, _review),
        out_of_date("line camera's calibration", lambda h: h.out_of_date),
    ),
    primary=("id",),
    foreign=(
        (("vehicle_id",), "scan_vehicles", ("id",)),
        (("pose_id",), "line_poses", ("id",)),
        (("computing_id",), "computings", ("id",)),
        (("verdict_of_id",), "line_heights", ("id",)),
        _MAKER_KEY,
        _REVIEWER_KEY,
    ),
)
LINE_HEIGHT_REVIEWS: Table[LineHeightReview] = Table(
    "line_height_reviews",
    "Every verdict given on a revision of a height measured in a line scan, oldest first.",
    (
        key("id", "verdict", lambda r: r.id),
        key("height_id", "revision that was judged, in line_heights", lambda r: r.height_id),
        text("verdict", "verdict", lambda r: r.verdict, required=True, enum=get_args(ScanVerdict)),
        text("reason", _WHY, lambda r: r.reason),
        person("reviewer_id", _REVIEWER, lambda r: r.reviewer),
        moment("at", "when", lambda r: r.at),
    ),
    primary=("id",),
    foreign=((("height_id",), "line_heights", ("id",)), _REVIEWER_KEY),
)
LINE_BUDGET: Table[HeightBudgetEntry] = Table(
    "line_height_budget",
    "The contributions to each u_height_m of line_heights; their root sum of squares is u_height_m.",
    (
        key("height_id", "revision of a height, in line_heights", lambda e: e.height_id),
        text("source", "source of uncertainty", lambda e: e.source, required=True),
        metres(
            "u_m",
            "its contribution to the standard uncertainty of the height",
            lambda e: e.u_m,
            required=True,
        ),
    ),
    primary=("height_id", "source"),
    foreign=((("height_id",), "line_heights", ("id",)),),
)
TABLES: tuple[Table[Any], ...] = (LINE_POSES, LINE_MARKS, LINE_HEIGHTS, LINE_BUDGET, LINE_HEIGHT_REVIEWS)


@dataclass(eq=False)
class HeightRecords:
    """What the tables of heights in line scans are made of."""

    poses: list[StoredLinePose] = field(default_factory=list)
    marks: list[RodMark] = field(default_factory=list)
    heights: list[ListedHeight] = field(default_factory=list)
    budget: list[HeightBudgetEntry] = field(default_factory=list)
    reviews: list[LineHeightReview] = field(default_factory=list)

    def add_scan(
        self, session: Session, scan_id: int, vehicle_ids: Sequence[int], insets: Mapping[str, Inset]
    ) -> list[Who | None]:
        """Add one recording, its vehicles in their order; gives back who stands in the rows. `insets`: those
        of the survey, by name.
        """
        poses = line_pose_history(session, scan_id)
        self.poses += poses
        for pose in poses:
            self.marks += _marks(pose)
        makers = [pose.created_by for pose in poses]
        in_force = poses[-1].id if poses else None
        of_vehicle = line_height_history_of_scan(session, scan_id)
        living = set(vehicle_ids)
        judged = [one for one in reviews_of_scan_heights(session, scan_id) if one.vehicle_id in living]
        self.reviews += judged
        makers += [one.reviewer for one in judged]
        for vehicle_id in vehicle_ids:
            revisions = of_vehicle.get(vehicle_id, [])
            newest = {one.values.target: one.id for one in revisions}
            for one in revisions:
                makers.append(one.created_by)
                current = newest[one.values.target] == one.id
                stale = (
                    causes_now_of_line(
                        one.values,
                        superseded=one.values.pose_id != in_force,
                        insets=insets,
                        category=one.category,
                    )
                    if current and not one.values.withdrawn
                    else ()
                )
                self.heights.append(ListedHeight(one, current, stale))
                self.budget += [HeightBudgetEntry(height_id=one.id, **entry) for entry in one.values.budget]
        return makers

    def fill(self, staging: Staging) -> None:
        """Write the tables."""
        staging.fill(LINE_POSES, self.poses)
        staging.fill(LINE_MARKS, self.marks)
        staging.fill(LINE_HEIGHTS, self.heights)
        staging.fill(LINE_BUDGET, self.budget)
        staging.fill(LINE_HEIGHT_REVIEWS, self.reviews)


def _marks(pose: StoredLinePose) -> list[RodMark]:
    residuals = line_pose_result(pose).residuals_px
    return [
        RodMark(pose.id, number, mark, residual)
        for number, (mark, residual) in enumerate(zip(pose.values.marks, residuals, strict=True), 1)
    ]
