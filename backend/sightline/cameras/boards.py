"""The board as a person tells it: its kind, its inner corners, its square and its markers."""

from sightline.enums import BoardKind
from sightline.errors import BadInput
from sightline.geometry.board import Board
from sightline.geometry.charuco import charuco_of

# Only counts and proportions matter to detection; the side of a square is asked for when calibrating.
ANY_SQUARE_M = 0.1


def board_told(
    columns: int,
    rows: int,
    square_m: float | None,
    kind: BoardKind = "checkerboard",
    dictionary: str | None = None,
    marker_m: float | None = None,
) -> Board:
    """The board of so many inner corners; without `square_m` one of any size, for detection alone.

    Raises BadInput for a board half told; what no detector can look for, detection refuses.
    """
    charuco = None
    if kind == "charuco":
        if dictionary is None or marker_m is None or square_m is None:
            raise BadInput("cameras-charuco-board-needs-dictionary-markers-side")
        charuco = charuco_of(dictionary, marker_m)
    elif dictionary is not None or marker_m is not None:
        raise BadInput("cameras-plain-checkerboard-no-markers-choose-charuco")
    return Board(columns, rows, ANY_SQUARE_M if square_m is None else square_m, charuco)
