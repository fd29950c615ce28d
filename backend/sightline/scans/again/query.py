"""What computing the heights of line scans again needs to know, for thousands of them in a few queries."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from sqlalchemy import and_, func, select
from sqlalchemy.orm import Session

from sightline.coverage import expanded
from sightline.enums import Category, DriverSide, InsetSource, Target
from sightline.measurements.again.query import changed_height
from sightline.measurements.again.records import ComputedHeight
from sightline.measurements.tables import computings
from sightline.messages.said import Said
from sightline.scans.heights.pose_store import current_line_poses
from sightline.scans.heights.records import StoredLinePose
from sightline.scans.heights.store import stands
from sightline.scans.heights.tables import line_heights, line_poses
from sightline.scans.tables import scan_vehicles, scans

_h = line_heights.c
_then = line_heights.alias("then")
_newer = line_poses.alias("newer")


def current_line_poses_of_survey(session: Session, survey_id: int) -> dict[int, StoredLinePose]:
    """The calibration that counts, by line scan; of those that have one."""
    query = select(line_poses.c.scan_id).where(line_poses.c.survey_id == survey_id).distinct()
    found = ((scan_id, current_line_poses(session, scan_id)) for scan_id in session.execute(query).scalars())
    return {scan_id: pose for scan_id, pose in found if pose is not None}


@dataclass(frozen=True, slots=True, kw_only=True)
class AlikeLines:
    """So many standing heights of line scans with the same facts; `superseded`: by another calibration."""

    count: int
    target: Target
    side: DriverSide | None
    inset_from: InsetSource
    inset_m: float
    u_inset_m: float
    code_version: str
    category: Category | None
    superseded: bool


def alike_lines(session: Session, survey_id: int) -> Iterator[AlikeLines]:
    """The standing heights of a survey's line scans, those with the same facts counted together."""
    newest = select(func.max(_newer.c.revision)).where(_newer.c.scan_id == line_poses.c.scan_id)
    superseded = line_poses.c.revision < newest.correlate(line_poses).scalar_subquery()
    facts = (_h.target, _h.side, _h.inset_from, _h.inset_m, _h.u_inset_m, _h.code_version)
    each = (
        select(*facts, scan_vehicles.c.category, superseded.label("superseded"))
        .join(line_poses, line_poses.c.id == _h.pose_id)
        .join(scan_vehicles, scan_vehicles.c.id == _h.vehicle_id)
        .join(scans, scans.c.id == _h.scan_id)
        .where(_h.survey_id == survey_id, stands)
        .subquery()
    )
    query = select(func.count().label("count"), *each.c).group_by(*each.c)
    for row in session.execute(query).mappings():
        yield AlikeLines(**{**row, "superseded": bool(row["superseded"])})


def computed_line_heights(session: Session, computing_id: int) -> tuple[ComputedHeight, ...]:
    """Every height of a line scan of a computing beside what it was, as they were made."""
    same = and_(_then.c.vehicle_id == _h.vehicle_id, _then.c.target == _h.target)
    query = (
        select(
            *(_h.id, _h.revision, _h.target, _h.height_m, _h.u_height_m, _h.distance_m, _h.status, _h.reason),
            *(_h.scan_id, _h.vehicle_id, scan_vehicles.c.number, _then.c.status.label("status_before")),
            *(_then.c.height_m.label("height_before_m"), _then.c.u_height_m.label("u_before_m")),
            *(_h.verdict_of_id, computings.c.kind),
        )
        .join(computings, computings.c.id == _h.computing_id)
        .join(scan_vehicles, scan_vehicles.c.id == _h.vehicle_id)
        .join(_then, and_(same, _then.c.revision == _h.revision - 1))
        .where(_h.computing_id == computing_id)
        .order_by(_h.id)
    )
    return tuple(
        ComputedHeight(
            line_height_id=row.id,
            scan_id=row.scan_id,
            revision=row.revision,
            vehicle_id=row.vehicle_id,
            vehicle_number=row.number,
            target=row.target,
            repeat=False,
            status_before=row.status_before,
            status=row.status,
            U95_before_m=expanded(row.u_before_m),
            U95_height_m=expanded(row.u_height_m),
            distance_m=row.distance_m,
            reason=None if row.reason is None else Said.read(row.reason),
            **changed_height(row, verdict_goes_over=row.verdict_of_id is not None),
        )
        for row in session.execute(query)
    )
