"""Calibrations of a scan's rig from a CSV of passes: looked at, stored and put in force, listed."""

from typing import Annotated

from fastapi import APIRouter, Depends, File, Query, UploadFile

from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Wired
from sightline.infra.web.uploaded import whole_file
from sightline.scans.bodies import ScanBody
from sightline.scans.presenters import scan_body
from sightline.scans.rig import calibrating
from sightline.scans.rig.calibrating import Given
from sightline.scans.rig.passes_csv import MOST_BYTES
from sightline.scans.rig.records import CalibrationLook, RigCalibrationShown
from sightline.scans.store import get_scan

router = APIRouter()
Sent = Annotated[UploadFile, File(description="CSV in UTF-8, a pass a row.")]
Said = Annotated[Given, Depends()]


@router.get("/scans/{scan_id}/rig-calibrations")
def list_rig_calibrations(scan_id: PathId, who: Viewer, session: Reading) -> list[RigCalibrationShown]:
    """Every calibration of this recording's rig, newest first, and which is in force."""
    return list(calibrating.rig_calibrations_of(session, scan_id))


@router.post("/scans/{scan_id}/rig-calibrations/preview")
def preview_rig_calibration(
    scan_id: PathId, who: Operator, services: Wired, file: Sent, said: Said
) -> CalibrationLook:
    """What the passes of a CSV give; nothing is stored."""
    name = file.filename or "The file"
    data = whole_file(file, MOST_BYTES, name)
    with services.reading() as session:
        return calibrating.preview_rig_calibration(session, scan_id, data, name, said)


@router.post("/scans/{scan_id}/rig-calibrations", status_code=201)
def store_rig_calibration(
    scan_id: PathId,
    who: Operator,
    services: Wired,
    file: Sent,
    version: Annotated[int, Query(ge=1, le=2**31 - 1, description="The version that you saw.")],
    said: Said,
) -> ScanBody:
    """Store the calibration of these passes and put its values in force; results keep those that they had."""
    name = file.filename or "The file"
    data = whole_file(file, MOST_BYTES, name)
    with services.writing() as session:
        calibrating.store_rig_calibration(session, scan_id, data, name, said, version=version, actor=who.id)
        return scan_body(get_scan(session, scan_id))
