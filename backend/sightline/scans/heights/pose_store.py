"""Poses of a scan's line camera from rod marks: append-only, a new one supersedes the one before."""

from dataclasses import asdict
from typing import Any

from sqlalchemy import ColumnElement, select
from sqlalchemy.orm import Session

from sightline.errors import Conflict
from sightline.infra.audit import trail
from sightline.infra.audit.records import name_or_somebody
from sightline.infra.database.people import people
from sightline.infra.database.rows import add_row, get_row, missing, stored_hash, who
from sightline.infra.database.types import now
from sightline.scans.heights.records import LinePoseValues, StoredLinePose
from sightline.scans.heights.tables import line_poses
from sightline.scans.tables import scans

_VALUES = tuple(LinePoseValues.__slots__)


def append_line_pose(
    session: Session, scan_id: int, values: LinePoseValues, *, seen_revision: int, actor: int | None
) -> StoredLinePose:
    """The next calibration of a scan. Heights keep the one that they were computed with.

    `seen_revision`: 0 where none was there. Raises NotFound, Conflict if another one came meanwhile.
    """
    scan = get_row(session, scans, scan_id, "line-scan recording", scans.c.deleted_at.is_(None))
    before = current_line_poses(session, scan_id)
    revision = before.revision if before else 0
    if revision != seen_revision:
        name = name_or_somebody(before.created_by if before else None)
        raise Conflict("scans-calibrated-line-scan-meanwhile-look-calibration", name=name)
    content: dict[str, Any] = {"survey_id": scan["survey_id"], "scan_id": scan_id, "revision": revision + 1}
    content |= asdict(values)
    row_id = add_row(session, line_poses, {**content, "created_at": now(), "created_by": actor})
    told = {name: value for name, value in content.items() if name != "pose"}
    after = {**told, "content_sha256": stored_hash(session, line_poses, row_id)}
    then = (
        None if before is None else {"revision": revision, "camera_height_m": before.values.camera_height_m}
    )
    trail.record(session, actor, "calibrate", "line_pose", row_id, scan["survey_id"], then, after)
    return get(session, row_id)


def get(session: Session, pose_id: int) -> StoredLinePose:
    """One calibration. Raises NotFound."""
    found = _where(session, line_poses.c.id == pose_id)
    if not found:
        raise missing("calibration of a line camera", pose_id)
    return found[0]


def current_line_poses(session: Session, scan_id: int) -> StoredLinePose | None:
    """The newest calibration of a scan, None where there is none."""
    found = line_pose_history(session, scan_id)
    return found[-1] if found else None


def line_pose_history(session: Session, scan_id: int) -> tuple[StoredLinePose, ...]:
    """Every calibration of a scan, oldest first."""
    return _where(session, line_poses.c.scan_id == scan_id)


def _where(session: Session, condition: ColumnElement[bool]) -> tuple[StoredLinePose, ...]:
    query = (
        select(line_poses, people.c.name.label("maker"))
        .outerjoin(people, people.c.id == line_poses.c.created_by)
        .where(condition)
        .order_by(line_poses.c.scan_id, line_poses.c.revision)
    )
    return tuple(_pose(row) for row in session.execute(query).mappings())


def _pose(row: Any) -> StoredLinePose:
    return StoredLinePose(
        id=row["id"],
        survey_id=row["survey_id"],
        scan_id=row["scan_id"],
        revision=row["revision"],
        values=LinePoseValues(**{name: row[name] for name in _VALUES}),
        created_by=who(row["created_by"], row["maker"]),
        created_at=row["created_at"],
    )
