"""Video and line scans of invented vehicles, rendered from a known scene: what tests hold results against.

`make.py` draws the demonstration's files with it.

    day_scene(), low_light_scene() -> Scene    frozen, hashable, picklable; `.frames`, `.fps`, `.board`
    render_frame(scene, n) -> (480, 640, 3)    uint8 BGR; pure in (scene, n): share frames out to processes in
                                               contiguous ranges, as textures are kept per vehicle
    frames(scene), day_frames(), low_light_frames()   generators of all frames in order
    lab_image(i) for i < LAB_COUNT             LAB_COLUMNS x LAB_ROWS inner corners of LAB_SQUARE_M
    lab_corners_px(i)                            their true corners
    truth(scene) -> tuple[PassTruth, ...]        spots, heights, insets, pixels by frame
    truth_document(scene) -> dict                the same, ready for JSON, with camera, pose and board

Frames 0 .. scene.board_frames - 1 show the board (scene.board: inner corners, square, height of the
top row) standing still and square on the road. The board is gone FADE_FRAMES later. Spots:
contact_rear, contact_front, roof, driver_eye, taillight (lower edge of the lit area), headlight.
Nothing here opens a file.
"""

from collections.abc import Iterator

from tests.simulation.board import (
    LAB_COLUMNS,
    LAB_COUNT,
    LAB_ROWS,
    LAB_SQUARE_M,
    board_corners_m,
    lab_corners_px,
    lab_image,
)
from tests.simulation.camera import DemoCamera, Image
from tests.simulation.models import MODELS, Model
from tests.simulation.render import render_frame
from tests.simulation.scene import FADE_FRAMES, RoadBoard, Scene, Vehicle, day_scene, low_light_scene
from tests.simulation.truth import (
    FramePixels,
    PassTruth,
    Spot,
    camera_document,
    spot_pixel,
    spots_of,
    truth,
    truth_document,
)

__all__ = [
    "FADE_FRAMES",
    "LAB_COLUMNS",
    "LAB_COUNT",
    "LAB_ROWS",
    "LAB_SQUARE_M",
    "MODELS",
    "DemoCamera",
    "FramePixels",
    "Model",
    "PassTruth",
    "RoadBoard",
    "Scene",
    "Spot",
    "Vehicle",
    "board_corners_m",
    "camera_document",
    "day_frames",
    "day_scene",
    "frames",
    "lab_corners_px",
    "lab_image",
    "low_light_frames",
    "low_light_scene",
    "render_frame",
    "spot_pixel",
    "spots_of",
    "truth",
    "truth_document",
]


def frames(scene: Scene) -> Iterator[Image]:
    """All frames of a scene in order."""
    return (render_frame(scene, n) for n in range(scene.frames))


def day_frames() -> Iterator[Image]:
    """All frames of the daytime video."""
    return frames(day_scene())


def low_light_frames() -> Iterator[Image]:
    """All frames of the low-light video."""
    return frames(low_light_scene())
