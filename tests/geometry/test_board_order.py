"""The corner order: whatever a detector returns, n_x points down."""

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.errors import BadInput
from sightline.geometry.board import Board, canonical_order, require_board, road_points
from sightline.geometry.corners import find_board
from tests.geometry.simulate import Lens, Scene, picture
from tests.support.proofs import every

# the eight ways in which a detector may number one and the same grid of corners
ORDERS = [
    lambda g: g, lambda g: g[::-1, ::-1], lambda g: g[:, ::-1], lambda g: g[::-1],
    lambda g: g.transpose(1, 0, 2), lambda g: g[::-1, ::-1].transpose(1, 0, 2),
    lambda g: g[:, ::-1].transpose(1, 0, 2), lambda g: g[::-1].transpose(1, 0, 2),
]  # fmt: skip


@given(
    st.integers(3, 9), st.integers(3, 9), st.floats(-60, 60), st.floats(-30, 30), st.floats(0, 18),
    st.integers(0, 7),
)  # fmt: skip
def test_every_order_becomes_the_order_as_seen(columns, rows, roll, yaw, pitch, order) -> None:
    if columns == rows and abs(roll) > 40:
        return  # a square grid tells its turn only to 45 degrees
    eye = (0.05 * columns - 3 * np.tan(np.radians(yaw)), -3.0, 1.5)
    scene = Scene(Lens(), eye, yaw, pitch, roll)
    truth = scene.look(scene.board(columns, rows, 0.1, 1.5).reshape(-1, 3)).reshape(rows, columns, 2)
    given_grid = ORDERS[order](truth)
    ordered, as_seen = canonical_order(given_grid, Board(columns, rows, 0.1))
    assert (as_seen.columns, as_seen.rows) == (columns, rows)
    assert np.array_equal(ordered, truth)


@given(st.integers(3, 9), st.integers(3, 9), st.floats(-20, 20), st.integers(0, 7))
def test_exchanged_columns_and_rows_are_seen_in_the_picture(columns, rows, roll, order) -> None:
    scene = Scene(Lens(), (0.05 * columns, -3.0, 1.5), 0.0, 5.0, roll)
    truth = scene.look(scene.board(columns, rows, 0.1, 1.5).reshape(-1, 3)).reshape(rows, columns, 2)
    ordered, as_seen = canonical_order(ORDERS[order](truth), Board(rows, columns, 0.1))
    assert (as_seen.columns, as_seen.rows) == (columns, rows)
    assert np.array_equal(ordered, truth)


@pytest.mark.parametrize("roll", every(2, [-60, -25, 0, 30, 60]))
@pytest.mark.parametrize(("columns", "rows"), [(6, 4), (4, 6), (6, 5)])
def test_both_detectors_and_both_orders_on_pictures(roll, columns, rows) -> None:
    """6x4 corners is symmetric under half a turn: OpenCV's detectors disagree about its first corner."""
    scene = Scene(Lens(), (0.3 - 1.0, -3.0, 1.4), 18.0, 4.0, roll)
    grey = picture(scene, columns, rows, 0.1, 1.5, samples=5)
    truth = scene.look(scene.board(columns, rows, 0.1, 1.5).reshape(-1, 3)).reshape(rows, columns, 2)
    for pattern in ((columns, rows), (rows, columns)):
        if pattern != (columns, rows) and abs(roll) > 25:
            continue  # a board given the wrong way round is put right as far as the picture can tell
        for points in raw_detections(grey, pattern):
            grid = points.reshape(pattern[1], pattern[0], 2)
            ordered, as_seen = canonical_order(grid, Board(*pattern, 0.1))
            assert (as_seen.columns, as_seen.rows) == (columns, rows)
            assert np.abs(ordered - truth).max() < 1.5
    found = find_board(grey, Board(columns, rows, 0.1))
    assert found.found, found.reason
    assert np.sqrt(np.square(found.points_px - truth).mean()) < 0.08


def raw_detections(grey, pattern):
    classic = cv2.findChessboardCorners(grey, pattern, flags=cv2.CALIB_CB_ADAPTIVE_THRESH)
    sector = cv2.findChessboardCornersSB(grey, pattern, flags=cv2.CALIB_CB_NORMALIZE_IMAGE)
    found = [np.asarray(points, dtype=np.float64) for ok, points in (classic, sector) if ok]
    assert found
    return found


def test_road_points_stand_below_the_reference_row() -> None:
    board = Board(6, 4, 0.1)
    top, bottom = road_points(board, "top", 1.0), road_points(board, "bottom", 0.7)
    assert np.allclose(top, bottom)
    assert top[0] == pytest.approx([0, 0, 1.0])
    assert top[-1] == pytest.approx([0.5, 0, 0.7])
    assert (top[:, 1] == 0).all()


@pytest.mark.parametrize(
    "board", [Board(1, 5, 0.1), Board(6, 200, 0.1), Board(6, 4, 0.0), Board(6, 4, float("nan"))]
)
def test_impossible_boards_are_bad_input(board) -> None:
    with pytest.raises(BadInput):
        require_board(board)
