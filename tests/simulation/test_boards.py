"""The checkerboards can be found, lie where the truth says, and calibrate the lens."""

import cv2
import numpy as np
import pytest

from tests.simulation.board import (
    LAB_COLUMNS,
    LAB_COUNT,
    LAB_ROWS,
    LAB_SQUARE_M,
    board_corners_m,
    lab_corners_px,
    lab_image,
)
from tests.simulation.camera import DemoCamera
from tests.simulation.render import render_frame
from tests.simulation.scene import Scene, day_scene, low_light_scene

STOP = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 40, 1e-3)


def _corners(image: np.ndarray, size: tuple[int, int], window: int) -> np.ndarray:
    grey = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)
    found, corners = cv2.findChessboardCorners(grey, size)
    assert found
    return np.asarray(cv2.cornerSubPix(grey, corners, (window, window), (-1, -1), STOP)).reshape(-1, 2)


def _match(found: np.ndarray, true: np.ndarray) -> np.ndarray:
    """Distances from each true corner to the nearest found one: the order is the detector's own affair."""
    return np.asarray(np.linalg.norm(found[None] - true[:, None], axis=-1).min(1))


@pytest.mark.parametrize(
    "scene",
    [
        pytest.param(low_light_scene(), id="low_light"),
        pytest.param(day_scene(), id="day", marks=pytest.mark.proof),
    ],
)
def test_board_on_the_road_is_found_where_it_stands(scene: Scene) -> None:
    board = scene.board
    true = scene.camera.project(board_corners_m(board)).reshape(-1, 2)
    found = _corners(render_frame(scene, 40), (board.columns, board.rows), 4)
    error = _match(found, true)
    # one frame alone; noise is twice as high in low light and the sheet half as bright
    assert np.sqrt((error**2).mean()) < (0.15 if scene.light.low else 0.08)
    assert error.max() < (0.45 if scene.light.low else 0.25)


def test_board_stands_still_and_is_gone_before_the_first_vehicle() -> None:
    scene = day_scene()
    early, late = (render_frame(scene, n).astype(float) for n in (5, scene.board_frames - 1))
    assert np.abs(cv2.blur(early - late, (9, 9))).max() < 3.5
    road = render_frame(scene, scene.vehicles[0].first_frame - 2).astype(float)
    assert np.abs(cv2.blur(road - late, (9, 9))).max() > 40


@pytest.mark.parametrize("every", [2, pytest.param(1, marks=pytest.mark.proof)])
def test_lab_boards_calibrate_the_lens_to_its_truth(every: int) -> None:
    grid = np.zeros((LAB_COLUMNS * LAB_ROWS, 3), np.float32)
    grid[:, :2] = np.mgrid[0:LAB_COLUMNS, 0:LAB_ROWS].T.reshape(-1, 2) * LAB_SQUARE_M
    seen = []
    for index in range(0, LAB_COUNT, every):
        corners = _corners(lab_image(index), (LAB_COLUMNS, LAB_ROWS), 5)
        assert np.sqrt((_match(corners, lab_corners_px(index)) ** 2).mean()) < 0.08
        seen.append(corners.astype(np.float32))
    camera = DemoCamera()
    rms, matrix, distortion, _, _ = cv2.calibrateCamera([grid] * len(seen), seen, (640, 480), None, None)
    assert rms < 0.1
    assert abs(matrix[0, 0] - camera.fx_px) < 1.0
    assert abs(matrix[0, 2] - camera.cx_px) < 1.0
    assert abs(distortion.ravel()[0] - camera.distortion[0]) < 0.01


def test_lab_boards_cover_the_picture() -> None:
    points = np.concatenate([lab_corners_px(i) for i in range(LAB_COUNT)])
    assert np.all((points > 2) & (points < (637, 477)))
    cells, _, _ = np.histogram2d(points[:, 0], points[:, 1], bins=(6, 5), range=((0, 640), (0, 480)))
    assert (cells > 0).all()
