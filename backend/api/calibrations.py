"""Calibrations: started, imported, looked at."""

from fastapi import APIRouter, UploadFile

from backend.api.bodies import JobBody
from backend.api.calibration_bodies import CalibrationBody, CalibrationWish, calibration_body
from backend.api.cameras import whole_file
from backend.api.deps import Operator, PathId, Reading, Viewer, Wired
from backend.api.uploads import clean_name
from backend.storage import calibrations
from backend.work import calibrating

router = APIRouter()


@router.post("/cameras/{camera_id}/calibrations", status_code=202)
def start_calibration(camera_id: PathId, body: CalibrationWish, who: Operator, services: Wired) -> JobBody:
    """Calibrate; the job's result names the calibration, which becomes the camera's current one."""
    wish = calibrating.Wish(**body.model_dump())
    return JobBody.model_validate(calibrating.start(services, camera_id, wish, who.id))


@router.post("/cameras/{camera_id}/calibrations/import", status_code=201)
def import_calibration(
    camera_id: PathId, file: UploadFile, who: Operator, services: Wired
) -> CalibrationBody:
    """Take intrinsics from OpenCV YAML or JSON, ROS camera_info, Kalibr or mrcal."""
    name = clean_name(file.filename or "calibration")
    content = whole_file(file, calibrating.MOST_IMPORT_BYTES, name)
    made = calibrating.import_calibration(services, camera_id, name, content, who.id)
    return calibration_body(made)


@router.get("/calibrations/{calibration_id}")
def get_calibration(calibration_id: PathId, who: Viewer, session: Reading) -> CalibrationBody:
    """One calibration, whole."""
    return calibration_body(calibrations.get(session, calibration_id))
