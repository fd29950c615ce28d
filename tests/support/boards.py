"""Pictures of a checkerboard seen by a known pinhole camera, and tiny clips of them."""

from pathlib import Path

import cv2
import numpy as np
import numpy.typing as npt

from sightline.media.video.writer import write_mp4

WIDTH, HEIGHT, FOCAL_PX = 640, 480, 600.0
COLUMNS, ROWS, SQUARE_M = 9, 6, 0.025
_CELL = 40
# Turns of the board about x, y and z (rad) and its place (m): tilted every way, near and far, all over.
POSES = tuple(
    ((rx, ry, rz), (x, y, z))
    for rx, ry, rz, x, y, z in (
        (0.0, 0.0, 0.0, 0.0, 0.0, 0.40),
        (0.5, 0.0, 0.1, -0.08, -0.05, 0.45),
        (-0.5, 0.1, 0.0, 0.08, -0.05, 0.45),
        (0.1, 0.6, 0.0, -0.08, 0.06, 0.45),
        (0.0, -0.6, 0.1, 0.08, 0.06, 0.45),
        (0.4, 0.4, -0.1, 0.0, 0.0, 0.38),
        (-0.4, 0.4, 0.2, -0.1, 0.0, 0.5),
        (0.4, -0.4, 0.0, 0.1, 0.0, 0.5),
        (-0.3, -0.5, 0.1, 0.0, -0.08, 0.5),
        (0.6, 0.2, 0.0, 0.0, 0.08, 0.5),
    )
)
Picture = npt.NDArray[np.uint8]


def view(
    pose: tuple[tuple[float, float, float], tuple[float, float, float]], flat: Picture | None = None
) -> Picture:
    """The board at a pose of its centre, (HEIGHT, WIDTH, 3) BGR on a grey ground; `flat`: another print."""
    flat = _flat() if flat is None else flat
    (turn, place) = pose
    rotation, _ = cv2.Rodrigues(np.array(turn))
    half = np.array([(COLUMNS + 1) / 2, (ROWS + 1) / 2]) * SQUARE_M
    corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * half
    points = np.column_stack([corners, np.zeros(4)]) @ rotation.T + np.array(place)
    pixels = points[:, :2] / points[:, 2:] * FOCAL_PX + [(WIDTH - 1) / 2, (HEIGHT - 1) / 2]
    height, width = flat.shape
    source = np.array([[0, 0], [width, 0], [width, height], [0, height]], np.float32) - 0.5
    homography = cv2.getPerspectiveTransform(source, pixels.astype(np.float32))
    # Drawn three times as large and shrunk: edges as soft as a lens makes them.
    big = np.diag([3.0, 3.0, 1.0])
    big[:2, 2] = 1.0
    drawn = cv2.warpPerspective(flat, big @ homography, (3 * WIDTH, 3 * HEIGHT), borderValue=150)
    small = cv2.resize(drawn, (WIDTH, HEIGHT), interpolation=cv2.INTER_AREA)
    return np.repeat(small[:, :, None], 3, axis=2).astype(np.uint8)


def _flat() -> Picture:
    row, column = np.mgrid[0 : (ROWS + 1) * _CELL, 0 : (COLUMNS + 1) * _CELL] // _CELL
    return np.where((row + column) % 2 == 0, 20, 235).astype(np.uint8)


def charuco_print() -> Picture:
    """A print of the same inner corners whose white squares carry markers of 4X4_50, 3/4 of a square wide."""
    words = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
    board = cv2.aruco.CharucoBoard((COLUMNS + 1, ROWS + 1), 1.0, 0.75, words)
    ink = board.generateImage(((COLUMNS + 1) * _CELL, (ROWS + 1) * _CELL), marginSize=0)
    return np.asarray(20 + ink * (215 / 255), dtype=np.uint8)


def picture_bytes(image: Picture, suffix: str = ".png") -> bytes:
    """The picture as a file."""
    return cv2.imencode(suffix, image)[1].tobytes()


def board_clip(path: Path) -> Path:
    """A clip that shows each pose for two frames."""
    write_mp4(path, (view(pose) for pose in POSES for _ in range(2)), 25, crf=8)
    return path
