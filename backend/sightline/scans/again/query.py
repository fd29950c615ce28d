"""What computing the heights of line scans again needs to know, for thousands of them in a few queries."""

from __future__ import annotations

from collections.abc import Iterator

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from sightline.geometry.sides import FoundSide
from sightline.measurements.again.differences import Facts
from sightline.measurements.again.query import Alike, computed_height, computed_rows
from sightline.measurements.again.records import ComputedHeight
from sightline.measurements.query import with_verdict
from sightline.measurements.tables import measurement_series, measurements
from sightline.scans.heights.pose_store import current_line_poses
from sightline.scans.heights.records import StoredLinePose
from sightline.scans.heights.store import stands
from sightline.scans.heights.tables import line_poses
from sightline.scans.tables import scan_vehicles, scans
from sightline.surveys.store import get_survey

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
    facts = (_m.target, _m.line_pose_id, _m.side, _m.inset_from, _m.inset_m, _m.u_inset_m, _m.code_version)
    each = (
        with_verdict(*facts, scan_vehicles.c.category, in_force.scalar_subquery().label("pose_id"))
        .join(scan_vehicles, scan_vehicles.c.id == _s.scan_vehicle_id)
        .join(scans, scans.c.id == _s.scan_id)
        .where(_s.survey_id == survey_id, stands)
        .subquery()
    )
    for row in session.execute(select(func.count().label("many"), *each.c).group_by(*each.c)):
        then = Facts(
            pose_id=row.line_pose_id,
            side=row.side,
            side_from=None if row.side is None else "said",
            inset_m=row.inset_m,
            u_inset_m=row.u_inset_m,
            inset_from=row.inset_from,
            solved=False,
        )
        yield Alike(
            count=row.many,
            target=row.target,
            facts=then,
            code_version=row.code_version,
            pose_id=row.pose_id,
            side=None if row.side is None else FoundSide(row.side, "said"),
            category=row.category,
            insets=insets,
        )


def computed_scan_heights(session: Session, computing_id: int) -> tuple[ComputedHeight, ...]:
    """Every height of a line scan of a computing beside what it was, as they were made."""
    query = (
        computed_rows(_s.scan_id, _m.distance_m, scan_vehicles.c.id, scan_vehicles.c.number)
        .join(scan_vehicles, scan_vehicles.c.id == _s.scan_vehicle_id)
        .where(_m.computing_id == computing_id)
        .order_by(_m.id)
    )
    return tuple(computed_height(row, x_m=None, y_m=None) for row in session.execute(query))
