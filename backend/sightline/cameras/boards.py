"""The board as a person tells it: its kind, its inner corners, its square and its markers."""

from dataclasses import dataclass

from sightline.enums import BoardKind
from sightline.errors import BadInput
from sightline.geometry.board import Board
from sightline.geometry.charuco import charuco_of

# Only counts and proportions matter to detection; the side of a square is asked for when calibrating.
ANY_SQUARE_M = 0.1


@dataclass(frozen=True, kw_only=True)
class BoardTold:
    """A board of so many inner corners; without `square_m` one of any size, for detection alone."""

    columns: int
    rows: int
    square_m: float | None
    board_kind: BoardKind = "checkerboard"
    dictionary: str | None = None
    marker_m: float | None = None

    @property
    def board(self) -> Board:
        """Raises BadInput for a board half told; what no detector can look for, detection refuses."""
        charuco = None
        if self.board_kind == "charuco":
            if self.dictionary is None or self.marker_m is None or self.square_m is None:
                raise BadInput("cameras-charuco-incomplete")
            charuco = charuco_of(self.dictionary, self.marker_m)
        elif self.dictionary is not None or self.marker_m is not None:
            raise BadInput("cameras-checkerboard-without-markers")
        return Board(
            self.columns, self.rows, ANY_SQUARE_M if self.square_m is None else self.square_m, charuco
        )
