"""Calibrations: imported, looked at."""

from typing import Annotated

from fastapi import APIRouter, Query, Response, UploadFile

from sightline.cameras.calibrations import calibrating, store
from sightline.cameras.calibrations.bodies import CalibrationBody, calibration_body, camera_document
from sightline.infra.csv_package.schema import json_bytes
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Wired
from sightline.infra.web.uploaded import clean_name, whole_file

router = APIRouter()


@router.post("/cameras/{camera_id}/calibrations/import", status_code=201)
def import_calibration(
    camera_id: PathId,
    file: UploadFile,
    who: Operator,
    services: Wired,
    which: Annotated[
        str | None, Query(max_length=100, description="The camera to read from a file of several.")
    ] = None,
) -> CalibrationBody:
    """Take intrinsics from OpenCV YAML or JSON, ROS camera_info, Kalibr or mrcal."""
    name = clean_name(file.filename or "calibration")
    content = whole_file(file, calibrating.MOST_IMPORT_BYTES, name)
    made = calibrating.import_calibration(services, camera_id, name, content, who.id, which)
    return calibration_body(made)


@router.get("/calibrations/{calibration_id}")
def get_calibration(calibration_id: PathId, who: Viewer, session: Reading) -> CalibrationBody:
    """One calibration, whole."""
    return calibration_body(store.get_calibration(session, calibration_id))


@router.get("/calibrations/{calibration_id}/camera.json", response_class=Response)
def download_camera(calibration_id: PathId, who: Viewer, session: Reading) -> Response:
    """A calibration as `camera.json`, as the command line reads it."""
    document = camera_document(store.get_calibration(session, calibration_id))
    headers = {"Content-Disposition": f'attachment; filename="camera-{calibration_id}.json"'}
    return Response(json_bytes(document), media_type="application/json", headers=headers)
