"""Poses of a scan's line camera from rod marks: append-only, a new one supersedes the one before."""

from dataclasses import asdict

from sqlalchemy.orm import Session

from sightline.errors import Conflict
from sightline.infra.audit.records import name_or_somebody
from sightline.infra.audit.written import written_once, written_rows
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import get_row
from sightline.scans.heights.records import LinePoseValues, StoredLinePose
from sightline.scans.heights.tables import line_poses
from sightline.scans.records import StoredRevision
from sightline.scans.tables import scans


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
        raise Conflict("scans-calibrated-meanwhile", name=name)
    content = {"survey_id": scan["survey_id"], "scan_id": scan_id, "revision": revision + 1, **asdict(values)}
    written_once(
        session,
        line_poses,
        content,
        "calibrate",
        before={"revision": revision, "camera_height_m": before.values.camera_height_m} if before else None,
        untold=("pose",),
        actor=actor,
    )
    return line_pose_history(session, scan_id)[-1]


def current_line_poses(session: Session, scan_id: int) -> StoredLinePose | None:
    """The newest calibration of a scan, None where there is none."""
    found = line_pose_history(session, scan_id)
    return found[-1] if found else None


def line_pose_history(session: Session, scan_id: int) -> tuple[StoredLinePose, ...]:
    """Every calibration of a scan, oldest first."""
    rows = written_rows(session, line_poses, line_poses.c.scan_id == scan_id)
    return tuple(record_of(StoredRevision, row, values=record_of(LinePoseValues, row)) for row in rows)
