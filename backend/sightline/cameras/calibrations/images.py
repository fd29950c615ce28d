"""Calibration images: looking for the board, keeping the file once, looking again for another board."""

import numpy as np
import numpy.typing as npt

from sightline.cameras.calibrations.records import CalibrationImage, Detection
from sightline.cameras.store import (
    add_calibration_image,
    get_camera,
    list_calibration_images,
    remove_calibration_image,
    set_detection,
)
from sightline.geometry.board import Board
from sightline.geometry.corners import Corners, find_board
from sightline.geometry.ruler import polyline
from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.infra.stored_bytes import let_go, store_bytes, suffix_of
from sightline.media.images import jpeg
from sightline.messages.said import Said

JPEG_QUALITY = 92


def look(gray: npt.NDArray[np.uint8], board: Board) -> Detection:
    """Look for the board in a picture (H, W). Raises BadInput for a board that nobody can look for."""
    return detection_of(find_board(gray, board), board)


def detection_of(corners: Corners, board: Board) -> Detection:
    """A detection in plain lists."""
    charuco, is_found, board_as_seen = board.charuco, corners.found, corners.board_as_seen
    return Detection(
        found=is_found,
        reason=None if is_found else corners.reason or Said("board-not-found"),
        corners_px=polyline(corners.points_px.reshape(-1, 2)),
        columns=board_as_seen.columns,
        rows=board_as_seen.rows,
        sharpness=float(corners.sharpness) if is_found else None,
        ids=None if corners.ids is None else corners.ids.tolist(),
        dictionary=None if charuco is None else charuco.dictionary,
        marker_share=None if charuco is None else round(charuco.marker_m / board.square_m, 6),
    )


def add_image(
    services: Services, camera_id: int, name: str, content: bytes, board: Board, actor: int
) -> CalibrationImage:
    """Store a picture with what was found in it. Raises BadInput, naming the file, for what is no picture."""
    with services.reading() as session:
        survey_id = get_camera(session, camera_id).survey_id
    gray = services.frames.image(content, name)
    detection = look(gray, board)
    height, width = gray.shape

    def note(session: Session, key: str) -> CalibrationImage:
        return add_calibration_image(
            session,
            camera_id,
            name=name,
            media_key=key,
            width_px=int(width),
            height_px=int(height),
            detection=detection,
            actor=actor,
        )

    return store_bytes(services, survey_id, content, suffix_of(name), note, actor=actor)


def detect_again(
    services: Services, camera_id: int, board: Board, actor: int
) -> tuple[CalibrationImage, ...]:
    """Look in every image of the camera for a board of another size or kind."""
    with services.reading() as session:
        get_camera(session, camera_id)
        images = list_calibration_images(session, camera_id)
    found = [(image.id, look(gray_of(services, image), board)) for image in images]
    with services.writing() as session:
        known = {image.id for image in list_calibration_images(session, camera_id)}
        for image_id, detection in found:
            if image_id in known:
                set_detection(session, image_id, detection, actor=actor)
        return list_calibration_images(session, camera_id)


def gray_of(services: Services, image: CalibrationImage) -> npt.NDArray[np.uint8]:
    """The stored picture as luminance, (H, W)."""
    return services.frames.image(services.media.local_path(image.media_key).read_bytes(), image.name)


def as_jpeg(services: Services, image: CalibrationImage) -> bytes:
    """The stored picture for a browser, at its own size."""
    content = services.media.local_path(image.media_key).read_bytes()
    return jpeg(services.frames.image_bgr(content, image.name), JPEG_QUALITY)


def remove_image(services: Services, image_id: int, actor: int) -> None:
    """Take an image out, and its file if nothing else has the same content."""
    with services.writing() as session:
        gone = remove_calibration_image(session, image_id, actor=actor)
        let_go(session, get_camera(session, gone.camera_id).survey_id, [gone.media_key], actor)
