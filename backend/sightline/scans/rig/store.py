"""Calibrations of a scan's rig: append-only."""

from dataclasses import asdict
from typing import Any

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.infra.audit import trail
from sightline.infra.database.people import people
from sightline.infra.database.rows import add_row, stored_hash, who
from sightline.infra.database.types import now
from sightline.scans.rig.records import RigCalibrationValues, StoredRigCalibration
from sightline.scans.rig.tables import rig_calibrations
from sightline.scans.store import get_scan

_VALUES = tuple(RigCalibrationValues.__slots__)


def append_rig_calibration(
    session: Session, scan_id: int, values: RigCalibrationValues, *, actor: int | None
) -> StoredRigCalibration:
    """The next calibration of a scan's rig; the former ones stay. The rig itself is not changed.

    Raises NotFound.
    """
    scan = get_scan(session, scan_id)
    history = rig_calibration_history(session, scan_id)
    content: dict[str, Any] = {"survey_id": scan.survey_id, "scan_id": scan_id, "revision": len(history) + 1}
    content |= asdict(values)
    row_id = add_row(session, rig_calibrations, {**content, "created_at": now(), "created_by": actor})
    after = {**content, "content_sha256": stored_hash(session, rig_calibrations, row_id)}
    trail.record(session, actor, "calibrate", "rig_calibration", row_id, scan.survey_id, None, after)
    return rig_calibration_history(session, scan_id)[-1]


def rig_calibration_history(session: Session, scan_id: int) -> tuple[StoredRigCalibration, ...]:
    """Every calibration of a scan's rig, oldest first."""
    query = (
        select(rig_calibrations, people.c.name.label("maker"))
        .outerjoin(people, people.c.id == rig_calibrations.c.created_by)
        .where(rig_calibrations.c.scan_id == scan_id)
        .order_by(rig_calibrations.c.revision)
    )
    return tuple(_calibration(row) for row in session.execute(query).mappings())


def _calibration(row: Any) -> StoredRigCalibration:
    return StoredRigCalibration(
        id=row["id"],
        survey_id=row["survey_id"],
        scan_id=row["scan_id"],
        revision=row["revision"],
        values=RigCalibrationValues(**{name: row[name] for name in _VALUES}),
        created_by=who(row["created_by"], row["maker"]),
        created_at=row["created_at"],
    )
