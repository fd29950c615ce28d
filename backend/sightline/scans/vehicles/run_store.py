"""Runs of the finder over a scan; written once."""

from collections.abc import Sequence
from dataclasses import asdict

from sqlalchemy import ColumnElement, func, select
from sqlalchemy.orm import Session

from sightline.enums import JsonObject
from sightline.infra.audit.written import written_once, written_rows
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import get_row
from sightline.messages.said import Said
from sightline.scans.records import RunSummary, ScanRun, ScanRunValues
from sightline.scans.tables import scan_runs, scans


def add_scan_run(
    session: Session, scan_id: int, values: ScanRunValues, *, job_id: int | None = None, actor: int | None
) -> ScanRun:
    """A run that came to its end. Raises NotFound for a deleted scan."""
    scan = get_row(session, scans, scan_id, "line-scan recording", scans.c.deleted_at.is_(None))
    place = {"survey_id": scan["survey_id"], "scan_id": scan_id, "job_id": job_id}
    row_id = written_once(session, scan_runs, {**place, **asdict(values)}, "run", actor=actor)
    return _fetch_runs(session, scan_runs.c.id == row_id)[0]


def latest_scan_runs(session: Session, scan_ids: Sequence[int]) -> dict[int, ScanRun]:
    """The newest run over each scan, by scan."""
    if not scan_ids:
        return {}
    newest = select(func.max(scan_runs.c.id)).where(scan_runs.c.scan_id.in_(scan_ids))
    found = _fetch_runs(session, scan_runs.c.id.in_(newest.group_by(scan_runs.c.scan_id)))
    return {run.scan_id: run for run in found}


def _fetch_runs(session: Session, condition: ColumnElement[bool]) -> tuple[ScanRun, ...]:
    rows = written_rows(session, scan_runs, condition)
    return tuple(record_of(ScanRun, row, summary=_summary(row["summary"])) for row in rows)


def _summary(stored: JsonObject) -> RunSummary:
    words = stored["misalignment_words"]
    return RunSummary(**{**stored, "misalignment_words": words and Said.read(words)})
