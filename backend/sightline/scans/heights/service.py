"""Heights of scanned vehicles from two clicks in strip 1: to look at, and stored.

What is shown while the pointer moves, what is stored and what a check recomputes all come from `answer`.
Points are (line, row) of strip 1.
"""

from collections.abc import Mapping
from dataclasses import asdict, dataclass

from sightline.coverage import expanded
from sightline.enums import Category, ComputingCause, LineClicksStatus
from sightline.errors import BadInput
from sightline.geometry.insets import SIDE_UNKNOWN
from sightline.geometry.sides import FoundSide
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.infra.version import code_version
from sightline.linescan.line_height import LineHeight, contact_distance, ladder, line_height
from sightline.linescan.line_pose import LinePose
from sightline.measurements.again.differences import causes_now, facts_of
from sightline.measurements.height_of_clicks import filled_in
from sightline.measurements.records import Clicks, ScanHeight, ScanHeightValues
from sightline.messages.said import Said
from sightline.scans.heights.pose_store import current_line_poses
from sightline.scans.heights.poses import pose_of
from sightline.scans.heights.records import StoredLinePose
from sightline.scans.heights.store import append_scan_height
from sightline.scans.records import ScanVehicle
from sightline.scans.service import is_within_strips
from sightline.scans.store import get_scan
from sightline.scans.vehicles.store import get_scan_vehicle
from sightline.surveys.records import Inset
from sightline.surveys.store import get_survey

_BESIDE = Said("line-height-beside-vehicle")
# Bumpers' boundaries are found to some lines; a mirror or an aerial stands out no further than this share.
_MARGIN = 0.05


@dataclass(frozen=True)
class LineRung:
    """The row of a height above the contact, at the target's distance."""

    height_m: float
    row_px: float


@dataclass(frozen=True, kw_only=True)
class HeightPreview(LineHeight):
    """A height not stored yet, with the ladder above the contact, `inset_m` behind it; an eye of unknown side
    has neither. `contact`: only the contact was clicked, and it stands on the road.
    """

    status: LineClicksStatus  # type: ignore[assignment]
    U95_distance_m: float | None
    inset_m: float | None
    u_inset_m: float | None
    ladder: tuple[LineRung, ...] = ()


def preview_line_height(
    session: Session, scan_id: int, clicked: Clicks, vehicle_id: int | None, *, only_contact: bool
) -> HeightPreview:
    """The height that these clicks would be stored with on a vehicle of this scan. `only_contact`: the target
    was not clicked yet.

    Raises NotFound, BadInput without a calibration.
    """
    scan = get_scan(session, scan_id)
    pose = pose_of(_pose(session, scan_id).values)
    category = None
    if vehicle_id is not None:
        vehicle = get_scan_vehicle(session, vehicle_id)
        category = vehicle.category if vehicle.scan_id == scan_id else None
    clicks = filled_in(clicked, get_survey(session, scan.survey_id).insets, category)
    distance_m = contact_distance(pose, clicked.contact[1])
    only_contact = only_contact and distance_m is not None
    rungs: tuple[LineRung, ...] = ()
    if only_contact or clicks.inset_m is None:
        height = LineHeight("not_measurable", None if only_contact else SIDE_UNKNOWN, distance_m)
    else:
        height = answer(pose, clicks)
    if clicks.inset_m is not None and distance_m is not None:
        rungs = tuple(LineRung(*one) for one in ladder(pose, distance_m + clicks.inset_m, scan.rows_px or 0))
    return filled_from(
        HeightPreview,
        height,
        status="contact" if only_contact else height.status,
        U95_distance_m=expanded(height.u_distance_m),
        inset_m=clicks.inset_m,
        u_inset_m=clicks.u_inset_m,
        ladder=rungs,
    )


def store_scan_height(
    session: Session, vehicle_id: int, clicked: Clicks, *, seen_revision: int, actor: int | None
) -> ScanHeight:
    """Store the height of a target, with the newest calibration; `seen_revision`: 0 where none was there.

    Raises NotFound, Conflict, BadInput without a calibration, for clicks outside the strip, or for an eye
    without its inset: strips do not tell on which side of a vehicle the driver sits.
    """
    vehicle = get_scan_vehicle(session, vehicle_id)
    scan = get_scan(session, vehicle.scan_id)
    clicks = filled_in(clicked, get_survey(session, scan.survey_id).insets, vehicle.category)
    if clicks.inset_m is None:
        raise BadInput("scans-side-missing")
    for line, row in (clicks.contact, clicks.target_point):
        if not is_within_strips(scan, line, row):
            raise BadInput("scans-click-outside", line=line, row=row)
    pose = _pose(session, scan.id)
    found = answer(pose_of(pose.values), clicks)
    values = height_values(pose.id, clicks, found, _warn_beside_vehicle(vehicle, clicks))
    return append_scan_height(session, vehicle_id, values, seen_revision=seen_revision, actor=actor)


def answer(pose: LinePose, clicks: Clicks) -> LineHeight:
    """The height that clicks give, everything filled in."""
    sigma_px, inset_m, u_inset_m = clicks.assumed()
    return line_height(
        pose,
        clicks.contact[1],
        clicks.target_point[1],
        sigma_px=sigma_px,
        inset_m=inset_m,
        u_inset_m=u_inset_m,
    )


def height_values(pose_id: int, clicks: Clicks, height: LineHeight, flags: list[Said]) -> ScanHeightValues:
    """What was found as it is stored; `flags`: what is to be said beside what it says itself."""
    return filled_from(
        ScanHeightValues,
        height,
        clicks,
        line_pose_id=pose_id,
        budget=[asdict(entry) for entry in height.budget],
        flags=[*height.flags, *flags],
        code_version=code_version(),
    )


def clicks_to_compute_again(values: ScanHeightValues) -> Clicks:
    """What a person clicked and said for a stored revision, without what followed from the survey."""
    own = values.inset_from == "own"
    return Clicks(
        target=values.target,
        contact=values.contact,
        target_point=values.target_point,
        sigma_px=values.sigma_px,
        inset_m=values.inset_m if own else None,
        u_inset_m=values.u_inset_m if own else None,
        side=values.side,
    )


def causes_now_of_scan(
    values: ScanHeightValues, pose_id: int | None, insets: Mapping[str, Inset], category: Category | None
) -> tuple[ComputingCause, ...]:
    """Which facts of a stored height no longer hold. `pose_id`: the calibration that counts now."""
    side = None if values.side is None else FoundSide(values.side, "said")
    then = facts_of(values, values.pose_id)
    return causes_now(values.target, then, pose_id=pose_id, side=side, category=category, insets=insets)


def remarks_on_clicks(values: ScanHeightValues) -> list[Said]:
    """What was said of a stored revision's clicks beside what their height says itself."""
    return [one for one in values.flags if one == _BESIDE]


def _pose(session: Session, scan_id: int) -> StoredLinePose:
    found = current_line_poses(session, scan_id)
    if found is None:
        raise BadInput("scans-no-pose")
    return found


def _warn_beside_vehicle(vehicle: ScanVehicle, clicks: Clicks) -> list[Said]:
    if vehicle.measurement is None:
        return []
    front, rear = vehicle.measurement.values.front_line_1, vehicle.measurement.values.rear_line_1
    margin = _MARGIN * (rear - front)
    inside = all(front - margin <= line <= rear + margin for line, _ in (clicks.contact, clicks.target_point))
    return [] if inside else [_BESIDE]
