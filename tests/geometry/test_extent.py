"""A board larger than it was said to be is refused: a part of it would give a wrong reference row."""

import os
from pathlib import Path

import cv2
import numpy as np
import pytest

from sightline.geometry.board import Board
from sightline.geometry.corners import find_board
from sightline.geometry.extent import goes_on

DATA = Path(
    os.environ.get("SIGHTLINE_SHARED_DATA") or Path(__file__).resolve().parents[2].parent / "shared/data"
)
REAL = DATA / "calibration" / "opencv_left"


def picture(columns: int, rows: int, square: int = 30) -> np.ndarray:
    """A board of columns x rows inner corners on a white margin, seen at a slant, a little blurred."""
    cells = np.indices((rows + 1, columns + 1)).sum(axis=0) % 2
    flat = np.kron(255 * cells, np.ones((square, square))).astype(np.uint8)
    flat = cv2.copyMakeBorder(flat, 60, 60, 60, 60, cv2.BORDER_CONSTANT, value=255)
    height, width = flat.shape
    corners = np.array([[0, 0], [width, 0], [width, height], [0, height]], dtype=np.float32)
    slanted = corners + np.array([[20, 10], [-30, 25], [-10, -15], [15, -5]], dtype=np.float32)
    warp = cv2.getPerspectiveTransform(corners, slanted)
    return np.asarray(
        cv2.GaussianBlur(cv2.warpPerspective(flat, warp, (width, height), borderValue=255), (0, 0), 1)
    )


@pytest.mark.parametrize(("columns", "rows"), [(9, 6), (4, 6), (5, 5), (6, 9)])
def test_the_whole_board_ends_where_it_was_found(columns: int, rows: int) -> None:
    found = find_board(picture(columns, rows), Board(columns, rows, 0.03))
    assert found.found, found.reason


@pytest.mark.parametrize(
    ("cut", "side"),
    [
        (np.s_[:, :-1], "right"),
        (np.s_[:, 1:], "left"),
        (np.s_[:-1], "below"),
        (np.s_[1:], "above"),
    ],
)
def test_a_part_of_a_board_goes_on(cut: tuple[slice, slice], side: str) -> None:
    gray = picture(9, 6)
    whole = find_board(gray, Board(9, 6, 0.03))
    assert goes_on(gray, whole.points_px) is None
    assert goes_on(gray, whole.points_px[cut]) == side


@pytest.mark.skipif(not REAL.exists(), reason="the shared data folder is not here")
@pytest.mark.parametrize(
    ("turn", "every", "wrong"),
    [
        (0, 6, (5, 6)),
        pytest.param(0, 3, (5, 6), marks=pytest.mark.proof),
        pytest.param(1, 3, (8, 6), marks=pytest.mark.proof),
        pytest.param(2, 3, (9, 5), marks=pytest.mark.proof),
    ],
)
def test_real_pictures_of_a_larger_board_are_refused(turn: int, every: int, wrong: tuple[int, int]) -> None:
    pictures = sorted(REAL.glob("*.jpg"))[turn::every]  # looking for what is not there is slow
    assert len(pictures) >= 12 // every
    for path in pictures:
        gray = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
        found = find_board(gray, Board(*wrong, 0.025), time_limit_s=1.0)
        assert not found.found, path.name
