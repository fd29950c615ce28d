"""Heights of scanned vehicles from two clicks in strip 1: to look at, stored, withdrawn.

What is shown while the pointer moves, what is stored and what a check recomputes all come from `answer`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Protocol

from sightline.coverage import expanded
from sightline.enums import Category, ComputingCause, DriverSide, InsetSource, Target
from sightline.errors import BadInput
from sightline.geometry.insets import SIDE_UNKNOWN
from sightline.infra.database import Session
from sightline.infra.version import code_version
from sightline.linescan.line_height import LineHeight, contact_distance, ladder, line_height
from sightline.linescan.line_pose import LinePose
from sightline.measurements.again.differences import WithInset, same_inset
from sightline.measurements.height_of_clicks import DEFAULT_SIGMA_PX, inset_for
from sightline.scans.heights.pose_store import current_line_poses
from sightline.scans.heights.poses import LENGTH_DECIMALS, pose_of
from sightline.scans.heights.records import LineHeightValues, StoredLineHeight, StoredLinePose
from sightline.scans.heights.store import append_line_height
from sightline.scans.records import ScanVehicle
from sightline.scans.service import shows
from sightline.scans.store import get_scan
from sightline.scans.vehicles.store import get_scan_vehicle
from sightline.surveys.records import Inset
from sightline.surveys.store import get_survey

_BESIDE = "A click lies outside the vehicle's front and rear; it may belong to another vehicle."
# Bumpers' boundaries are found to some lines; a mirror or an aerial stands out no further than this share.
_MARGIN = 0.05


@dataclass(frozen=True)
class RowClicks:
    """(line, row) of the tyre's contact and of the target in strip 1, their sigma, and the target's inset.

    `inset_from`: "usual" where it is the survey's, for an eye that of the driver's `side`.
    """

    target: Target
    contact: tuple[float, float]
    target_point: tuple[float, float]
    sigma_px: float
    inset_m: float
    u_inset_m: float
    inset_from: InsetSource = "own"
    side: DriverSide | None = None


@dataclass(frozen=True)
class Clicked:
    """What a person clicked; None is filled in: 1 px, the survey's inset. `point` None: only the contact.

    An eye needs its inset or the driver's `side`: strips do not tell on which side of a vehicle that is.
    """

    target: Target
    contact: tuple[float, float]
    target_point: tuple[float, float] | None
    sigma_px: float | None = None
    inset_m: float | None = None
    u_inset_m: float | None = None
    side: DriverSide | None = None


@dataclass(frozen=True)
class HeightPreview:
    """A height not stored yet, with the ladder of (height m, row) above the contact, `inset_m` behind it.

    An eye of unknown side has neither.
    """

    found: LineHeight
    inset_m: float | None
    u_inset_m: float | None
    ladder: tuple[tuple[float, float], ...]

    @property
    def U95_distance_m(self) -> float | None:
        return expanded(self.found.u_distance_m)


def preview_line_height(
    session: Session, scan_id: int, clicked: Clicked, vehicle_id: int | None
) -> HeightPreview:
    """The height that these clicks would be stored with on a vehicle of this scan.

    Raises NotFound, BadInput without a calibration.
    """
    scan = get_scan(session, scan_id)
    pose = pose_of(_pose(session, scan_id).values)
    category = None
    if vehicle_id is not None:
        vehicle = get_scan_vehicle(session, vehicle_id)
        category = vehicle.category if vehicle.scan_id == scan_id else None
    clicks = _filled(session, scan.survey_id, clicked, category)
    distance_m = contact_distance(pose, clicked.contact[1])
    if clicks is None:
        reason = None if clicked.target_point is None and distance_m is not None else str(SIDE_UNKNOWN)
        return HeightPreview(LineHeight("not_measurable", reason, distance_m), None, None, ())
    rungs = ladder(pose, distance_m + clicks.inset_m, scan.rows_px or 0) if distance_m is not None else ()
    only_contact = clicked.target_point is None and distance_m is not None
    found = LineHeight("not_measurable", None, distance_m) if only_contact else answer(pose, clicks)
    return HeightPreview(found, clicks.inset_m, clicks.u_inset_m, rungs)


def store_line_height(
    session: Session, vehicle_id: int, clicked: Clicked, *, seen_revision: int, actor: int | None
) -> StoredLineHeight:
    """Store the height of a target, with the newest calibration; `seen_revision`: 0 where none was there.

    Raises NotFound, Conflict, BadInput without a calibration, for clicks outside the strip, or for an eye
    without its inset.
    """
    vehicle = get_scan_vehicle(session, vehicle_id)
    scan = get_scan(session, vehicle.scan_id)
    clicks = _filled(session, scan.survey_id, clicked, vehicle.category)
    if clicks is None:
        raise BadInput("scans-eye-needs-side-say-which")
    for line, row in (clicks.contact, clicks.target_point):
        if not shows(scan, line, row):
            raise BadInput("scans-click-line-row-lies-outside-strip", line=line, row=row)
    pose = _pose(session, scan.id)
    found = answer(pose_of(pose.values), clicks)
    values = height_values(pose.id, clicks, found, _beside(vehicle, clicks))
    return append_line_height(session, vehicle_id, values, seen_revision=seen_revision, actor=actor)


def answer(pose: LinePose, clicks: RowClicks) -> LineHeight:
    """The height that clicks give."""
    return line_height(
        pose,
        clicks.contact[1],
        clicks.target_point[1],
        sigma_px=clicks.sigma_px,
        inset_m=clicks.inset_m,
        u_inset_m=clicks.u_inset_m,
    )


def height_values(
    pose_id: int, clicks: RowClicks, found: LineHeight, warnings: list[str]
) -> LineHeightValues:
    """What was found as it is stored; `warnings`: what is to be said beside what it says itself."""
    return LineHeightValues(
        target=clicks.target,
        pose_id=pose_id,
        contact_line=clicks.contact[0],
        contact_row_px=clicks.contact[1],
        target_line=clicks.target_point[0],
        target_row_px=clicks.target_point[1],
        sigma_px=clicks.sigma_px,
        inset_m=clicks.inset_m,
        u_inset_m=clicks.u_inset_m,
        inset_from=clicks.inset_from,
        side=clicks.side,
        distance_m=found.distance_m,
        u_distance_m=found.u_distance_m,
        height_m=found.height_m,
        u_height_m=found.u_height_m,
        status=found.status,
        reason=found.reason,
        budget=[asdict(entry) for entry in found.budget],
        warnings=[*found.warnings, *warnings],
        withdrawn=False,
        code_version=code_version(),
    )


def _pose(session: Session, scan_id: int) -> StoredLinePose:
    found = current_line_poses(session, scan_id)
    if found is None:
        raise BadInput("scans-heights-need-line-cameras-pose-calibrate")
    return found


def _filled(
    session: Session, survey_id: int, clicked: Clicked, category: Category | None
) -> RowClicks | None:
    """The clicks with what was left out; None for an eye without its inset."""
    return filled_in(clicked, get_survey(session, survey_id).insets, category)


def filled_in(clicked: Clicked, insets: Mapping[str, Inset], category: Category | None) -> RowClicks | None:
    """The clicks with 1 px and the survey's inset where these were left out; None for an eye that has neither
    an inset nor a side. An inset that is the survey's is the usual one, whoever said it.
    """
    side = clicked.side if clicked.target == "driver_eye" else None
    usual = inset_for(clicked.target, side, category, insets)
    inset_m = usual.inset_m if clicked.inset_m is None and usual else clicked.inset_m
    u_inset_m = usual.u_inset_m if clicked.u_inset_m is None and usual else clicked.u_inset_m
    if inset_m is None or u_inset_m is None:
        return None
    told = round(inset_m, LENGTH_DECIMALS), round(u_inset_m, LENGTH_DECIMALS)
    is_usual = usual is not None and told == (
        round(usual.inset_m, LENGTH_DECIMALS),
        round(usual.u_inset_m, LENGTH_DECIMALS),
    )
    return RowClicks(
        target=clicked.target,
        contact=clicked.contact,
        target_point=clicked.target_point or clicked.contact,
        sigma_px=DEFAULT_SIGMA_PX if clicked.sigma_px is None else clicked.sigma_px,
        inset_m=told[0],
        u_inset_m=told[1],
        inset_from="usual" if is_usual else "own",
        side=side,
    )


def clicks_to_compute_again(values: LineHeightValues) -> Clicked:
    """What a person clicked and said for a stored revision, without what followed from the survey."""
    own = values.inset_from == "own"
    return Clicked(
        target=values.target,
        contact=(values.contact_line, values.contact_row_px),
        target_point=(values.target_line, values.target_row_px),
        sigma_px=values.sigma_px,
        inset_m=values.inset_m if own else None,
        u_inset_m=values.u_inset_m if own else None,
        side=values.side,
    )


class InsetOfTarget(WithInset, Protocol):
    """What is kept of a stored height's inset."""

    @property
    def target(self) -> Target: ...
    @property
    def side(self) -> DriverSide | None: ...
    @property
    def inset_from(self) -> InsetSource: ...


def causes_now_of_line(
    stored: InsetOfTarget, *, superseded: bool, insets: Mapping[str, Inset], category: Category | None
) -> tuple[ComputingCause, ...]:
    """Which facts of a stored height no longer hold; an inset of its own always does. `superseded`: its
    calibration is not the newest.
    """
    own = stored.inset_from == "own"
    usual = None if own else inset_for(stored.target, stored.side, category, insets)
    told: tuple[tuple[ComputingCause, bool], ...] = (
        ("pose", superseded),
        ("inset", usual is not None and not same_inset(stored, usual)),
    )
    return tuple(cause for cause, holds in told if holds)


def remarks_on_clicks(values: LineHeightValues) -> list[str]:
    """What was said of a stored revision's clicks beside what their height says itself."""
    return [one for one in values.warnings if one == _BESIDE]


def _beside(vehicle: ScanVehicle, clicks: RowClicks) -> list[str]:
    if vehicle.measurement is None:
        return []
    front, rear = vehicle.measurement.values.front_line_1, vehicle.measurement.values.rear_line_1
    margin = _MARGIN * (rear - front)
    inside = all(front - margin <= line <= rear + margin for line, _ in (clicks.contact, clicks.target_point))
    return [] if inside else [_BESIDE]
