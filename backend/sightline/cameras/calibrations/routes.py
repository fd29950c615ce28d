"""Calibrations: started, imported, looked at."""

from fastapi import APIRouter, UploadFile

from sightline.cameras.calibrations import calibrate_job, store
from sightline.cameras.calibrations.bodies import CalibrationBody, CalibrationWish, calibration_body
from sightline.infra.web.bodies import JobBody
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Wired
from sightline.infra.web.uploaded import clean_name, whole_file

router = APIRouter()


@router.post("/cameras/{camera_id}/calibrations", status_code=202)
def start_calibration(camera_id: PathId, body: CalibrationWish, who: Operator, services: Wired) -> JobBody:
    """Calibrate; the job's result names the calibration, which becomes the camera's current one."""
    wish = calibrate_job.Wish(**body.model_dump())
    return JobBody.model_validate(calibrate_job.start(services, camera_id, wish, who.id))


@router.post("/cameras/{camera_id}/calibrations/import", status_code=201)
def import_calibration(
    camera_id: PathId, file: UploadFile, who: Operator, services: Wired
) -> CalibrationBody:
    """Take intrinsics from OpenCV YAML or JSON, ROS camera_info, Kalibr or mrcal."""
    name = clean_name(file.filename or "calibration")
    content = whole_file(file, calibrate_job.MOST_IMPORT_BYTES, name)
    made = calibrate_job.import_calibration(services, camera_id, name, content, who.id)
    return calibration_body(made)


@router.get("/calibrations/{calibration_id}")
def get_calibration(calibration_id: PathId, who: Viewer, session: Reading) -> CalibrationBody:
    """One calibration, whole."""
    return calibration_body(store.get_calibration(session, calibration_id))
