"""Calibrations of a scan's rig: append-only."""

from dataclasses import asdict

from sqlalchemy.orm import Session

from sightline.infra.audit.written import written_once, written_rows
from sightline.infra.by_name import record_of
from sightline.scans.records import StoredRevision
from sightline.scans.rig.records import RigCalibrationValues, StoredRigCalibration
from sightline.scans.rig.tables import rig_calibrations
from sightline.scans.store import get_scan


def append_rig_calibration(
    session: Session, scan_id: int, values: RigCalibrationValues, *, actor: int | None
) -> StoredRigCalibration:
    """The next calibration of a scan's rig; former ones stay, the rig is not changed. Raises NotFound."""
    scan, history = get_scan(session, scan_id), rig_calibration_history(session, scan_id)
    place = {"survey_id": scan.survey_id, "scan_id": scan_id, "revision": len(history) + 1}
    written_once(session, rig_calibrations, {**place, **asdict(values)}, "calibrate", actor=actor)
    return rig_calibration_history(session, scan_id)[-1]


def rig_calibration_history(session: Session, scan_id: int) -> tuple[StoredRigCalibration, ...]:
    """Every calibration of a scan's rig, oldest first."""
    rows = written_rows(session, rig_calibrations, rig_calibrations.c.scan_id == scan_id)
    return tuple(record_of(StoredRevision, row, values=record_of(RigCalibrationValues, row)) for row in rows)
