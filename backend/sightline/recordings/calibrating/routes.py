"""Calibrations started."""

from fastapi import APIRouter

from sightline.cameras.calibrations.bodies import CalibrationWish
from sightline.cameras.calibrations.calibrating import CalibrationRequest
from sightline.infra.web.bodies import JobBody
from sightline.infra.web.deps import Operator, PathId, Wired
from sightline.recordings.calibrating import calibrate_job

router = APIRouter()


@router.post("/cameras/{camera_id}/calibrations", status_code=202)
def start_calibration(camera_id: PathId, body: CalibrationWish, who: Operator, services: Wired) -> JobBody:
    """Calibrate; the job's result names the calibration, which becomes the camera's current one."""
    wish = CalibrationRequest(**body.model_dump())
    return JobBody.model_validate(calibrate_job.start(services, camera_id, wish, who.id))
