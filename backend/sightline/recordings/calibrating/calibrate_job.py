"""Calibrating a camera from its images or from the frames of a recording, as a job."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from sightline.cameras.calibrations import images as calibration_images
from sightline.cameras.calibrations.calibrating import (
    CALIBRATE,
    CalibrationRequest,
    DetectedView,
    document_of,
    frames_of,
    made_for,
    stored_corners,
    summary_of,
    unique_names,
    view_rows,
)
from sightline.cameras.calibrations.records import CalibrationImage
from sightline.cameras.calibrations.store import add_calibration
from sightline.cameras.store import get_camera, list_calibration_images
from sightline.errors import BadInput
from sightline.geometry.board import Board, require_board
from sightline.geometry.calibration_checks import calibrate_and_check
from sightline.geometry.corners import find_board
from sightline.infra.database import Session
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.registry import Finish, JobContext
from sightline.infra.services import Services
from sightline.messages.said import Said
from sightline.recordings.frames.stills import stills_of
from sightline.recordings.store import get_ready_recording

LOOKING, FITTING = 0.85, 0.9


def start(services: Services, camera_id: int, wish: CalibrationRequest, actor: int) -> Job:
    """Queue a calibration. Raises NotFound, BadInput for what cannot work from the outset."""
    require_board(wish.board)
    with services.writing() as session:
        camera = get_camera(session, camera_id)
        if wish.recording_id is None:
            if camera.images < 3:
                raise BadInput("recordings-too-few-images", name=camera.name, images=camera.images)
        else:
            recording = get_ready_recording(session, wish.recording_id)
            if recording.survey_id != camera.survey_id:
                raise BadInput("recordings-other-survey", name=recording.name)
            frames_of(wish, recording.frame_count or 0)
        payload = {"camera_id": camera_id, **vars(wish)}
        return registry.enqueue(
            session, CALIBRATE, payload, survey_id=camera.survey_id, recording_id=None, actor=actor
        )


@registry.handler(CALIBRATE, long=True)
def run_calibration(context: JobContext) -> Finish:
    """Detect where that was not done yet, fit, and store the result as the camera's current calibration."""
    services = context.services
    asked = dict(context.payload)
    camera_id = int(asked.pop("camera_id"))
    context.progress(0.0, Said("job-board-searching"))
    wish = CalibrationRequest(**asked)
    with services.reading() as session:
        camera = get_camera(session, camera_id)
    detected = (
        _from_images(context, services, camera_id, wish)
        if wish.recording_id is None
        else (_from_recording(context, services, wish))
    )
    context.progress(FITTING, Said("job-lens-fitting"))
    views = unique_names(detected)
    named_views = [(one.name, one.corners, one.size) for one in views]
    checked = calibrate_and_check(named_views, wish.board, wish.model, wish.bent_board)
    result = checked.result
    named = replace(result.camera, name=camera.name)
    rows = view_rows(views, result)
    summary = summary_of(named, len(result.corners), len(views))

    def finish(session: Session) -> Mapping[str, Any]:
        calibration = add_calibration(
            session,
            camera_id,
            source="images" if wish.recording_id is None else "clip",
            document=document_of(named, checked),
            trusted=result.trusted,
            warnings=list(result.warnings),
            coverage=result.coverage.astype(int).tolist(),
            views=rows,
            summary=summary,
            recording_id=wish.recording_id,
            actor=context.actor,
        )
        return {"calibration_id": calibration.id, "camera_id": camera_id}

    return finish


def _from_images(
    context: JobContext, services: Services, camera_id: int, wish: CalibrationRequest
) -> list[DetectedView]:
    with services.reading() as session:
        images = list_calibration_images(session, camera_id)
    seen = []
    for index, image in enumerate(images):
        context.progress(LOOKING * index / len(images), Said("job-board-searching-in", name=image.name))
        seen.append(_seen_image(services, image, wish.board))
    return seen


def _seen_image(services: Services, image: CalibrationImage, board: Board) -> DetectedView:
    """The stored detection where it was made for this board, else a fresh one."""
    if image.found and made_for(image, board):
        corners = stored_corners(image, board)
    else:
        corners = find_board(calibration_images.gray_of(services, image), board)
    return DetectedView(image.name, corners, (image.width_px, image.height_px), image_id=image.id)


def _from_recording(context: JobContext, services: Services, wish: CalibrationRequest) -> list[DetectedView]:
    assert wish.recording_id is not None
    opened = stills_of(services).open(wish.recording_id)
    frames = frames_of(wish, len(opened.media))
    views = []
    for index, n in enumerate(frames):
        context.progress(LOOKING * index / len(frames), Said("job-board-searching-frame", frame=n))
        gray = stills_of(services).gray(wish.recording_id, n)
        size = (int(gray.shape[1]), int(gray.shape[0]))
        views.append(
            DetectedView(f"{opened.recording.name} frame {n}", find_board(gray, wish.board), size, frame=n)
        )
    return views
