"""One camera in several surveys: each has it with its calibration, and its own chain vouches for both."""

from sightline.cameras.calibrations.records import Detection
from sightline.cameras.calibrations.store import add_calibration, get_calibration
from sightline.cameras.records import Camera
from sightline.cameras.store import add_calibration_image, create_camera, get_camera, list_calibration_images
from sightline.enums import JsonObject
from sightline.errors import BadInput, Conflict
from sightline.infra.by_name import filled_from
from sightline.infra.database import Session
from sightline.surveys.store import get_survey


def take_camera(session: Session, survey_id: int, camera_id: int, *, actor: int | None) -> Camera:
    """The camera with its current calibration in this survey too; a later calibration of one is not the
    other's. Raises NotFound, BadInput where it has no calibration, Conflict where it is here already.
    """
    there = get_camera(session, camera_id)
    if there.current_calibration_id is None:
        raise BadInput("cameras-taken-without-calibration", camera=there.name)
    if there.survey_id == survey_id:
        raise Conflict("cameras-taken-from-itself", camera=there.name)
    said = f"{get_survey(session, there.survey_id).name}: {there.name}"
    words = {name: getattr(there, name) for name in ("name", "notes", "lens", "zoom", "focus")}
    here = create_camera(session, survey_id, **words, taken_from=said[:500], actor=actor)
    calibration = get_calibration(session, there.current_calibration_id)
    images = _images(session, camera_id, here.id, calibration.views, actor)
    add_calibration(
        session,
        here.id,
        source=calibration.source,
        document=calibration.document,
        trusted=calibration.trusted,
        warnings=calibration.warnings,
        coverage=calibration.coverage,
        views=[{**view, "image_id": images.get(view.get("image_id"))} for view in calibration.views],
        summary=calibration.summary,
        actor=actor,
    )
    return get_camera(session, here.id)


def _images(
    session: Session, there: int, here: int, views: list[JsonObject], actor: int | None
) -> dict[int | None, int]:
    """The pictures that the calibration looked at, again under the camera here, by their number there."""
    looked_at = {view.get("image_id") for view in views}
    return {
        image.id: add_calibration_image(
            session,
            here,
            name=image.name,
            media_key=image.media_key,
            width_px=image.width_px,
            height_px=image.height_px,
            detection=filled_from(Detection, image),
            actor=actor,
        ).id
        for image in list_calibration_images(session, there)
        if image.id in looked_at
    }
