"""What computing the heights of line scans again needs to know, for thousands of them in a few queries."""

from collections.abc import Iterator

from sqlalchemy import and_, case, func, select
from sqlalchemy.orm import Session

from sightline.geometry.sides import FoundSide
from sightline.infra.by_name import record_of
from sightline.measurements.again.differences import Facts, moved_beyond_u
from sightline.measurements.again.query import Alike
from sightline.measurements.again.records import ComputedHeight
from sightline.measurements.query import with_verdict
from sightline.measurements.tables import computings, measurement_series, measurements
from sightline.messages.said import Said
from sightline.scans.heights.pose_store import current_line_poses
from sightline.scans.heights.records import StoredLinePose
from sightline.scans.heights.store import stands
from sightline.scans.heights.tables import line_poses
from sightline.scans.tables import scan_vehicles, scans
from sightline.surveys.store import get_survey
from sightline.vehicles.tables import vehicles

_m, _s = measurements.c, measurement_series.c


def current_line_poses_of_survey(session: Session, survey_id: int) -> dict[int, StoredLinePose]:
    """The calibration that counts, by line scan; of those that have one."""
    query = select(line_poses.c.scan_id).where(line_poses.c.survey_id == survey_id).distinct()
    found = ((scan_id, current_line_poses(session, scan_id)) for scan_id in session.execute(query).scalars())
    return {scan_id: pose for scan_id, pose in found if pose is not None}


def alike_lines(session: Session, survey_id: int) -> Iterator[Alike]:
    """The standing heights of a survey's line scans, those with the same facts counted together."""
    insets = get_survey(session, survey_id).insets
    in_force = select(func.max(line_poses.c.id)).where(line_poses.c.scan_id == _s.scan_id)
    facts = (_m.target, _m.side, _m.inset_from, _m.inset_m, _m.u_inset_m, _m.code_version)
    poses = (_m.line_pose_id.label("of_pose"), in_force.scalar_subquery().label("pose_id"))
    each = (
        with_verdict(*facts, *poses, scan_vehicles.c.category)
        .join(scan_vehicles, scan_vehicles.c.id == _s.scan_vehicle_id)
        .join(scans, scans.c.id == _s.scan_id)
        .where(_s.survey_id == survey_id, stands)
        .subquery()
    )
    for row in session.execute(select(func.count().label("count"), *each.c).group_by(*each.c)):
        side = None if row.side is None else FoundSide(row.side, "said")
        of = {"pose_id": row.of_pose, "side_from": side and side.basis, "solved": False}
        facts_then = record_of(Facts, row._mapping, **of)
        more = {"named": "", "in_line_scan": True, "has_height": True, "insets": insets}
        yield record_of(Alike, row._mapping, facts=facts_then, side=side, **more)


def computed_heights(session: Session, computing_id: int) -> Iterator[ComputedHeight]:
    """Every height of a computing beside what it was, those of recordings first, as they were made."""
    then, film, scanned = measurements.alias("then"), vehicles.c, scan_vehicles.c
    query = (
        select(
            *(_m.series_id.label("measurement_id"), _m.revision, _m.target, _m.height_m, _m.u_height_m),
            *(_m.U95_height_m, _m.status, _m.reason, _m.x_m, _m.y_m, _s.repeat_of, _s.scan_id),
            case((_s.scan_id.is_not(None), _m.distance_m)).label("distance_m"),
            func.coalesce(film.id, scanned.id).label("vehicle_id"),
            func.coalesce(film.number, scanned.number).label("vehicle_number"),
            *(then.c.status.label("status_before"), then.c.height_m.label("height_before_m")),
            *(then.c.u_height_m.label("u_before_m"), then.c.U95_height_m.label("U95_before_m")),
            *(_m.verdict_of_revision, computings.c.kind),
        )
        .select_from(measurements)
        .join(computings, computings.c.id == _m.computing_id)
        .join(measurement_series, _s.id == _m.series_id)
        .join(then, and_(then.c.series_id == _m.series_id, then.c.revision == _m.revision - 1))
        .outerjoin(vehicles, film.id == _s.vehicle_id)
        .outerjoin(scan_vehicles, scanned.id == _s.scan_vehicle_id)
        .where(_m.computing_id == computing_id)
        .order_by(_s.scan_id.is_not(None), _m.id)
    )
    for row in session.execute(query):
        before, now = row.height_before_m, row.height_m
        change = None if now is None or before is None else now - before
        moved = moved_beyond_u(before, row.u_before_m, now)
        yield record_of(
            ComputedHeight,
            row._mapping,
            repeat=row.repeat_of is not None,
            change_m=change,
            moved_by_u=abs(change) / row.u_before_m if change is not None and row.u_before_m else None,
            to_review=moved and row.verdict_of_revision is None and row.kind != "undo",
            reason=None if row.reason is None else Said.read(row.reason),
        )
