"""Planning a site from a survey's page: its camera or a plain one, its insets, and the plan."""

from dataclasses import dataclass
from math import radians

from sightline.cameras.calibrations.store import get_calibration
from sightline.cameras.store import get_camera
from sightline.errors import BadInput
from sightline.geometry.camera import Camera
from sightline.geometry.documents import camera_from_dict
from sightline.geometry.plan import Plan, plan_site
from sightline.geometry.site import Site, plain_camera
from sightline.infra.database import Session
from sightline.surveys.store import get_survey


@dataclass(frozen=True)
class PlainCamera:
    """A camera that has not been calibrated: the size of its pictures and what they show across."""

    width_px: int
    height_px: int
    field_of_view_deg: float


def plan_for_survey(
    session: Session, survey_id: int, camera: int | PlainCamera, site: Site
) -> tuple[Plan, Camera]:
    """The plan with the survey's insets, and the camera it is made with.

    camera: a calibration of one of the survey's cameras, by its id, or a plain one. Raises NotFound, and
    BadInput for a calibration of another survey or numbers that cannot be planned with.
    """
    survey = get_survey(session, survey_id)
    if isinstance(camera, PlainCamera):
        chosen = plain_camera(camera.width_px, camera.height_px, radians(camera.field_of_view_deg))
    else:
        chosen = _calibrated(session, survey_id, camera)
    insets = {target: (inset.inset_m, inset.u_inset_m) for target, inset in survey.insets.items()}
    return plan_site(chosen, site, insets), chosen


def _calibrated(session: Session, survey_id: int, calibration_id: int) -> Camera:
    calibration = get_calibration(session, calibration_id)
    if get_camera(session, calibration.camera_id).survey_id != survey_id:
        raise BadInput("cameras-calibration-other-survey", calibration_id=calibration_id)
    return camera_from_dict(calibration.document, f"calibration {calibration_id}")
