"""Boards to print: what a detector finds on the sheet is the board, at its size."""

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.errors import BadInput
from sightline.geometry.board import Board
from sightline.geometry.charuco import Charuco, find_charuco
from sightline.geometry.printed_board import PAPERS, PrintedBoard, printed_board

PPM = 4000  # pixels a metre of the sheet


def seen(printed: PrintedBoard) -> np.ndarray:
    """The sheet as a picture, grey as paper and ink are."""
    across, down = (round(PPM * side) for side in printed.size_m)
    sheet = np.full((down, across), 230, np.uint8)
    for rectangles, ink in ((printed.black, 20), (printed.white, 230)):
        for left, top, width, height in rectangles:
            rows = slice(round(PPM * top), round(PPM * (top + height)))
            sheet[rows, round(PPM * left) : round(PPM * (left + width))] = ink
    return sheet


@pytest.mark.parametrize(
    ("columns", "rows", "square_m"),
    [
        (9, 6, 0.025),
        (6, 4, 0.05),
        (7, 7, 0.02),
        pytest.param(6, 4, 0.1, marks=pytest.mark.proof),
    ],
)
def test_a_checkerboard_has_its_corners_at_its_size(columns: int, rows: int, square_m: float) -> None:
    found, corners = cv2.findChessboardCornersSB(
        seen(printed_board(Board(columns, rows, square_m))), (columns, rows)
    )
    assert found
    places = corners.reshape(rows, columns, 2) / PPM
    across, down = np.diff(places, axis=1), np.diff(places, axis=0)
    for steps in (across, down):
        assert np.abs(np.linalg.norm(steps, axis=2) - square_m).max() < 1.5 / PPM


@pytest.mark.parametrize(("columns", "rows"), [(9, 6), (8, 5), (5, 7)])
def test_a_charuco_board_has_its_numbers_where_the_detector_expects_them(columns: int, rows: int) -> None:
    charuco = Charuco("5X5_100", 0.022)
    printed = printed_board(Board(columns, rows, 0.03, charuco))
    found = find_charuco(seen(printed), charuco, columns, rows, 0.03)
    assert found is not None
    numbers, at = found
    assert list(numbers) == list(range(columns * rows))
    first = np.array([printed.black[:, 0].min(), printed.black[:, 1].min()]) + 0.03
    grid = np.column_stack([numbers % columns, numbers // columns]) * 0.03
    assert np.abs((at + 0.5) / PPM - first - grid).max() < 1.0 / PPM


@given(
    columns=st.integers(3, 30),
    rows=st.integers(3, 30),
    square_mm=st.floats(1.0, 300.0),
    paper=st.sampled_from([None, *PAPERS, "900x4000", "120x120"]),
)
def test_all_ink_lies_on_the_sheet_or_the_size_that_is_needed_is_said(
    columns: int, rows: int, square_mm: float, paper: str | None
) -> None:
    try:
        printed = printed_board(Board(columns, rows, 0.001 * square_mm), paper)
    except BadInput as error:
        assert "larger" in error.message or "not fit on" in error.message
        largest_mm = float(error.values["square_mm"])
        assert largest_mm < square_mm and f"squares of at most {largest_mm:g} mm" in error.message
        printed_board(Board(columns, rows, 0.001 * largest_mm), paper)
        with pytest.raises(BadInput):
            printed_board(Board(columns, rows, 0.001 * (largest_mm + 0.1)), paper)
        return
    far = printed.black[:, :2] + printed.black[:, 2:]
    assert printed.black[:, :2].min() >= 0.0099 and (far <= np.array(printed.size_m) - 0.0099).all()
    left, top, length = printed.bar_m
    assert length == 0.1 and left >= 0.0099
    assert top >= far[:, 1].max() and left + length <= printed.size_m[0] and top + 0.014 <= printed.size_m[1]
    assert np.isclose(printed.black[:, 2:].prod(axis=1).sum(), len(printed.black) * (0.001 * square_mm) ** 2)


UNPRINTABLE = [
    ("B7", "Paper 'B7' cannot be used"),
    ("12x", "cannot be used"),
    ("119x300", "each 120 to 5000"),  # no room for the bar
    ("A4", "not fit on A4"),
    (None, "larger than A0"),
]


@pytest.mark.parametrize(("paper", "said"), UNPRINTABLE)
def test_what_cannot_be_printed_is_said(paper: str | None, said: str) -> None:
    with pytest.raises(BadInput, match=said):
        printed_board(Board(20, 20, 0.2), paper)
