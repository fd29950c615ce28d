"""Runs of the finder over a scan; written once."""

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from sqlalchemy import ColumnElement, func, select
from sqlalchemy.orm import Session

from sightline.infra.audit import trail
from sightline.infra.database.people import people
from sightline.infra.database.rows import add_row, get_row, stored_hash, who
from sightline.infra.database.types import now
from sightline.scans.records import ScanRun, ScanRunValues
from sightline.scans.tables import scan_runs, scans


def add_scan_run(
    session: Session, scan_id: int, values: ScanRunValues, *, job_id: int | None = None, actor: int | None
) -> ScanRun:
    """A run that came to its end. Raises NotFound for a deleted scan."""
    scan = get_row(session, scans, scan_id, "line-scan recording", scans.c.deleted_at.is_(None))
    place = {"survey_id": scan["survey_id"], "scan_id": scan_id, "job_id": job_id}
    content = {**place, **asdict(values)}
    row_id = add_row(session, scan_runs, {**content, "created_at": now(), "created_by": actor})
    after = {**content, "content_sha256": stored_hash(session, scan_runs, row_id)}
    trail.record(session, actor, "run", "scan_run", row_id, scan["survey_id"], None, after)
    return list_where(session, scan_runs.c.id == row_id)[0]


def latest_scan_runs(session: Session, scan_ids: Sequence[int]) -> dict[int, ScanRun]:
    """The newest run over each scan, by scan."""
    if not scan_ids:
        return {}
    newest = select(func.max(scan_runs.c.id)).where(scan_runs.c.scan_id.in_(scan_ids))
    found = list_where(session, scan_runs.c.id.in_(newest.group_by(scan_runs.c.scan_id)))
    return {run.scan_id: run for run in found}


def list_where(session: Session, condition: ColumnElement[bool]) -> tuple[ScanRun, ...]:
    """The runs that meet a condition, oldest first."""
    query = (
        select(scan_runs, people.c.name.label("maker"))
        .outerjoin(people, people.c.id == scan_runs.c.created_by)
        .where(condition)
        .order_by(scan_runs.c.id)
    )
    return tuple(_run(row) for row in session.execute(query).mappings())


def _run(row: Any) -> ScanRun:
    left_out = ("created_by", "maker", "survey_id")
    values = {key: value for key, value in row.items() if key not in left_out}
    return ScanRun(created_by=who(row["created_by"], row["maker"]), **values)
