"""Calibrations: from images or from the frames of a recording, as a job; or from another tool's file."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from sqlalchemy.orm import Session

from sightline.cameras.boards import BoardKind, board_told
from sightline.cameras.calibrations import images as calibration_images
from sightline.cameras.calibrations.records import Calibration, CalibrationImage
from sightline.cameras.calibrations.store import add_calibration
from sightline.cameras.store import get_camera, list_calibration_images
from sightline.enums import JsonObject
from sightline.errors import BadInput
from sightline.geometry.board import Board, require_board
from sightline.geometry.calibration import CalibrationResult
from sightline.geometry.calibration_checks import CheckedCalibration, calibrate_and_check
from sightline.geometry.camera import Camera
from sightline.geometry.corners import Corners, detect
from sightline.geometry.documents import camera_to_dict
from sightline.infra.jobs import registry
from sightline.infra.jobs.records import Job
from sightline.infra.jobs.registry import Finish, JobContext
from sightline.infra.jobs.store import list_jobs
from sightline.infra.services import Services
from sightline.recordings.frames.stills import stills_of
from sightline.recordings.store import get_recording

KIND = "calibrate"
Model = Literal["brown", "fisheye"]
# Beyond this, views add time and hardly any knowledge of the lens.
MOST_FRAMES = 60
USUAL_FRAMES = 24
# Key of a calibration's document that is no key of camera.json.
CHECKS = "checks"
LOOKING, FITTING = 0.85, 0.9
MOST_IMPORT_BYTES = 2_000_000


@dataclass(frozen=True)
class Wish:
    """What to calibrate from: the camera's images, or every n-th frame of a span of a recording."""

    columns: int
    rows: int
    square_m: float
    model: Model
    recording_id: int | None = None
    every: int | None = None
    first_frame: int | None = None
    last_frame: int | None = None
    bent_board: bool = False
    board_kind: BoardKind = "checkerboard"
    dictionary: str | None = None
    marker_m: float | None = None

    @property
    def board(self) -> Board:
        markers = self.dictionary, self.marker_m
        return board_told(self.columns, self.rows, self.square_m, self.board_kind, *markers)


@dataclass(frozen=True, eq=False)
class Seen:
    """One picture that was looked at, with where it comes from."""

    name: str
    corners: Corners
    size: tuple[int, int]
    image_id: int | None = None
    frame: int | None = None


def start(services: Services, camera_id: int, wish: Wish, actor: int) -> Job:
    """Queue a calibration. Raises NotFound, BadInput for what cannot work from the outset."""
    require_board(wish.board)
    with services.writing() as session:
        camera = get_camera(session, camera_id)
        if wish.recording_id is None:
            if camera.images < 3:
                raise BadInput(
                    f"{camera.name} has {camera.images} images; add at least three, better 15 to 25."
                )
        else:
            recording = get_recording(session, wish.recording_id)
            if recording.survey_id != camera.survey_id:
                raise BadInput(f"{recording.name} belongs to another survey; choose one of this survey's.")
            if recording.state != "ready" or recording.frame_count is None:
                raise BadInput(f"{recording.name} has no frames yet; wait until its ingest is done.")
            frames_of(wish, recording.frame_count)
        payload = {"camera_id": camera_id, **vars(wish)}
        return registry.enqueue(
            session,
            KIND,
            payload,
            survey_id=camera.survey_id,
            recording_id=None,
            actor=actor,
        )


def under_way(session: Session, camera_id: int) -> Job | None:
    """The newest calibration of this camera that waits or runs."""
    survey_id = get_camera(session, camera_id).survey_id
    for state in ("running", "queued"):
        for job in list_jobs(session, survey_id=survey_id, state=state):
            if job.kind == KIND and job.payload.get("camera_id") == camera_id:
                return job
    return None


def frames_of(wish: Wish, frame_count: int) -> list[int]:
    """The frames to look at. Raises BadInput for a span outside the recording or too many frames."""
    first = wish.first_frame or 0
    last = frame_count - 1 if wish.last_frame is None else wish.last_frame
    if not 0 <= first <= last < frame_count:
        raise BadInput(
            f"Frames {first} to {last} are not in the recording; it has frames 0 to {frame_count - 1}."
        )
    every = wish.every or max(1, -(-(last - first + 1) // USUAL_FRAMES))
    frames = list(range(first, last + 1, every))
    if len(frames) > MOST_FRAMES:
        least = -(-(last - first + 1) // MOST_FRAMES)
        raise BadInput(
            f"Every {every}th frame would be {len(frames)} views; take every {least}th or fewer frames."
        )
    return frames


@registry.handler(KIND)
def run_calibration(context: JobContext) -> Finish:
    """Detect where that was not done yet, fit, and store the result as the camera's current calibration."""
    services = context.services
    asked = dict(context.payload)
    camera_id = int(asked.pop("camera_id"))
    context.progress(0.0, "Looking for the board.")
    wish = Wish(**asked)
    with services.reading() as session:
        camera = get_camera(session, camera_id)
    seen = (
        _from_images(context, services, camera_id, wish)
        if wish.recording_id is None
        else (_from_recording(context, services, wish))
    )
    context.progress(FITTING, "Fitting the lens, and its two halves apart.")
    views = unique_names(seen)
    named_views = [(one.name, one.corners, one.size) for one in views]
    checked = calibrate_and_check(named_views, wish.board, wish.model, wish.bent_board)
    result = checked.result
    named = replace(result.camera, name=camera.name)
    rows = view_rows(views, result)
    summary = summary_of(named, len(result.corners), len(views))

    def finish(session: Session) -> Mapping[str, Any]:
        made = add_calibration(
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
        return {"calibration_id": made.id, "camera_id": camera_id}

    return finish


def document_of(camera: Camera, checked: CheckedCalibration) -> JsonObject:
    """camera.json with the checks beside its own keys: they are written once with it, and never change."""
    return {**camera_to_dict(camera), CHECKS: checked.documents()}


def _from_images(context: JobContext, services: Services, camera_id: int, wish: Wish) -> list[Seen]:
    with services.reading() as session:
        images = list_calibration_images(session, camera_id)
    seen = []
    for index, image in enumerate(images):
        context.progress(LOOKING * index / len(images), f"Looking for the board in {image.name}.")
        seen.append(_seen_image(services, image, wish.board))
    return seen


def _seen_image(services: Services, image: CalibrationImage, board: Board) -> Seen:
    """The stored detection where it was made for this board, else a fresh one."""
    if image.found and made_for(image, board):
        corners = stored_corners(image, board)
    else:
        corners = detect(calibration_images.gray_of(services, image), board)
    return Seen(image.name, corners, (image.width_px, image.height_px), image_id=image.id)


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
    seen = replace(board, columns=image.columns, rows=image.rows)
    ids = None if image.ids is None else np.asarray(image.ids, dtype=np.intp)
    return Corners(
        found=True,
        points_px=points,
        board_as_seen=seen,
        reason=None,
        sharpness=image.sharpness or 0.0,
        detector="stored",
        ids=ids,
    )


def _from_recording(context: JobContext, services: Services, wish: Wish) -> list[Seen]:
    assert wish.recording_id is not None
    opened = stills_of(services).open(wish.recording_id)
    frames = frames_of(wish, len(opened.media))
    seen = []
    for index, n in enumerate(frames):
        context.progress(LOOKING * index / len(frames), f"Looking for the board in frame {n}.")
        gray = stills_of(services).gray(wish.recording_id, n)
        size = (int(gray.shape[1]), int(gray.shape[0]))
        seen.append(Seen(f"{opened.recording.name} frame {n}", detect(gray, wish.board), size, frame=n))
    return seen


def unique_names(seen: Sequence[Seen]) -> list[Seen]:
    """The same pictures; a name that was there before gets a number: results are told apart by name."""
    taken: set[str] = set()
    named = []
    for one in seen:
        name, number = one.name, 1
        while name in taken:
            number += 1
            name = f"{one.name} ({number})"
        taken.add(name)
        named.append(replace(one, name=name))
    return named


def view_rows(seen: Sequence[Seen], result: CalibrationResult) -> list[JsonObject]:
    """What is stored of each picture: used or why not, corners and residuals, row by row."""
    verdicts = {view.file: view for view in result.camera.views}
    rows: list[JsonObject] = []
    for one in seen:
        verdict = verdicts[one.name]
        residuals = result.residuals_px.get(one.name)
        rows.append(
            {
                "file": one.name,
                "image_id": one.image_id,
                "frame": one.frame,
                "used": verdict.used,
                "reason": verdict.reason,
                "rms_px": verdict.rms_px,
                "corners_px": one.corners.points_px.reshape(-1, 2).tolist() if one.corners.found else [],
                "residuals_px": [] if residuals is None else residuals.reshape(-1, 2).tolist(),
            }
        )
    return rows


def summary_of(camera: Camera, used: int, given: int) -> str:
    """In one sentence: how many views, how well they fit, and the focal length with its uncertainty."""
    focal = f"focal length {camera.fx_px:.1f} px"
    if camera.covariance is not None:
        focal += f" (standard uncertainty {float(np.sqrt(camera.covariance[0, 0])):.1f} px)"
    return f"{used} of {given} views used, residual {camera.rms_px:.2f} px, {focal}."


def import_calibration(
    services: Services, camera_id: int, file_name: str, content: bytes, actor: int
) -> Calibration:
    """Take intrinsics from another tool's file. Raises BadInput, naming the file and what is wrong in it."""
    if len(content) > MOST_IMPORT_BYTES:
        raise BadInput(
            f"{file_name} is too large for a calibration file; choose the file that holds the intrinsics."
        )
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise BadInput(
            f"{file_name} is not a text file; choose a calibration as YAML, JSON or cameramodel."
        ) from error
    from sightline.geometry.imports import read_camera  # with its YAML only when it is asked for

    imported = read_camera(text, file_name)
    camera = imported.camera
    # What had to be guessed (the lens model, which of several cameras) is said wherever the camera is used.
    warnings = [*imported.notes, *([] if camera.covariance is not None else [NO_COVARIANCE])]
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
            summary=f"Imported from {file_name}: {camera.model} model, focal length {camera.fx_px:.1f} px.",
            actor=actor,
        )


NO_COVARIANCE = (
    "The file states no uncertainty of the lens, so that part is left out of every height's uncertainty."
)
