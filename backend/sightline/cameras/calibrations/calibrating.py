"""What a calibration is made of: what was asked for, the pictures, the rows stored of them; or a file."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from sightline.cameras.boards import BoardTold
from sightline.cameras.calibrations.records import Calibration, CalibrationImage
from sightline.cameras.calibrations.store import add_calibration
from sightline.cameras.store import get_camera
from sightline.enums import JsonObject, LensModel
from sightline.errors import BadInput
from sightline.geometry.board import Board
from sightline.geometry.calibration import CalibrationResult, told_apart
from sightline.geometry.calibration_checks import CheckedCalibration
from sightline.geometry.camera import Camera
from sightline.geometry.corners import Corners
from sightline.geometry.documents import camera_to_dict
from sightline.infra.database import Session
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.store import jobs_under_way
from sightline.infra.services import Services
from sightline.messages.said import Said

CALIBRATE = "calibrate"
# Beyond this, views add time and hardly any knowledge of the lens.
MOST_FRAMES = 60
USUAL_FRAMES = 24
# Key of a calibration's document that is no key of camera.json.
CHECKS = "checks"
MOST_IMPORT_BYTES = 2_000_000


@dataclass(frozen=True, kw_only=True)
class CalibrationRequest(BoardTold):
    """What to calibrate from: the camera's images, or every n-th frame of a span of a recording."""

    model: LensModel
    recording_id: int | None = None
    every: int | None = None
    first_frame: int | None = None
    last_frame: int | None = None
    bent_board: bool = False


@dataclass(frozen=True, eq=False)
class DetectedView:
    """One picture that was looked at, with where it comes from."""

    name: str
    corners: Corners
    size: tuple[int, int]
    image_id: int | None = None
    frame: int | None = None


def under_way(session: Session, camera_id: int) -> Job | None:
    """The newest calibration of this camera that waits or runs."""
    survey_id = get_camera(session, camera_id).survey_id
    found = jobs_under_way(session, CALIBRATE, survey_id=survey_id)
    return next((job for job in found if job.payload.get("camera_id") == camera_id), None)


def frames_of(wish: CalibrationRequest, frame_count: int) -> list[int]:
    """The frames to look at. Raises BadInput for a span outside the recording or too many frames."""
    first = wish.first_frame or 0
    last = frame_count - 1 if wish.last_frame is None else wish.last_frame
    if not 0 <= first <= last < frame_count:
        raise BadInput("cameras-frames-outside", first=first, last=last, frame_count=frame_count - 1)
    every = wish.every or max(1, -(-(last - first + 1) // USUAL_FRAMES))
    frames = list(range(first, last + 1, every))
    if len(frames) > MOST_FRAMES:
        least = -(-(last - first + 1) // MOST_FRAMES)
        raise BadInput("cameras-too-many-views", every=every, count=len(frames), least=least)
    return frames


def document_of(camera: Camera, checked: CheckedCalibration) -> JsonObject:
    """camera.json with the checks beside its own keys: they are written once with it, and never change."""
    return {**camera_to_dict(camera), CHECKS: checked.documents()}


def made_for(image: CalibrationImage, board: Board) -> bool:
    """Whether the stored detection looked for this board, lying or standing; its size does not matter."""
    if {image.columns, image.rows} != {board.columns, board.rows}:
        return False
    if board.charuco is None or image.marker_share is None:
        return board.charuco is None and image.dictionary is None
    share = board.charuco.marker_m / board.square_m
    return image.dictionary == board.charuco.dictionary and abs(image.marker_share - share) < 1e-3


def stored_corners(image: CalibrationImage, board: Board) -> Corners:
    """A stored detection of the board as the geometry takes it."""
    shape = (image.rows, image.columns, 2) if image.ids is None else (-1, 2)
    points = np.asarray(image.corners_px, dtype=np.float64).reshape(shape)
    points.setflags(write=False)
    board_as_seen = replace(board, columns=image.columns, rows=image.rows)
    ids = None if image.ids is None else np.asarray(image.ids, dtype=np.intp)
    return Corners(
        found=True,
        points_px=points,
        board_as_seen=board_as_seen,
        reason=None,
        sharpness=image.sharpness or 0.0,
        detector="stored",
        ids=ids,
    )


def unique_names(seen: Sequence[DetectedView]) -> list[DetectedView]:
    """The same pictures, their names told apart."""
    names = told_apart(view.name for view in seen)
    return [replace(one, name=name) for one, name in zip(seen, names, strict=True)]


def view_rows(seen: Sequence[DetectedView], result: CalibrationResult) -> list[JsonObject]:
    """What is stored of each picture: used or why not, corners and residuals, row by row."""
    verdicts = {view.file: view for view in result.camera.views}
    rows: list[JsonObject] = []
    for view in seen:
        verdict = verdicts[view.name]
        residuals = result.residuals_px.get(view.name)
        rows.append(
            {
                "file": view.name,
                "image_id": view.image_id,
                "frame": view.frame,
                "used": verdict.used,
                "reason": verdict.reason,
                "rms_px": verdict.rms_px,
                "corners_px": view.corners.points_px.reshape(-1, 2).tolist() if view.corners.found else [],
                "residuals_px": [] if residuals is None else residuals.reshape(-1, 2).tolist(),
            }
        )
    return rows


def summary_of(camera: Camera, used: int, given: int) -> Said:
    """How many views, how well they fit, and the focal length with its uncertainty."""
    rms_px, focal_px = round(camera.rms_px or 0.0, 2), round(camera.fx_px, 1)
    if camera.covariance is None:
        return Said("calibration-made", used=used, given=given, rms_px=rms_px, focal_px=focal_px)
    return Said(
        "calibration-made-u",
        used=used,
        given=given,
        rms_px=rms_px,
        focal_px=focal_px,
        u_focal_px=round(float(np.sqrt(camera.covariance[0, 0])), 1),
    )


def import_calibration(
    services: Services, camera_id: int, file_name: str, content: bytes, actor: int, which: str | None = None
) -> Calibration:
    """Take intrinsics from another tool's file, the camera `which` of several.

    Raises BadInput, naming the file and what is wrong in it.
    """
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise BadInput("cameras-not-text", file_name=file_name) from error
    from sightline.geometry.imports import read_camera  # with its YAML only when it is asked for

    imported = read_camera(text, file_name, which=which)
    camera = imported.camera
    # What had to be guessed (the lens model, which of several cameras) is said wherever the camera is used.
    warnings = [*imported.notes, *([] if camera.covariance is not None else [NO_COVARIANCE])]
    focal_px = round(camera.fx_px, 1)
    with services.writing() as session:
        return add_calibration(
            session,
            camera_id,
            source="import",
            document=camera_to_dict(camera),
            trusted=True,
            warnings=warnings,
            coverage=[],
            views=[],
            summary=Said("calibration-imported", file_name=file_name, model=camera.model, focal_px=focal_px),
            actor=actor,
        )


NO_COVARIANCE = Said("calibration-no-covariance")
