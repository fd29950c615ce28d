"""The kind of board, as it goes in with calibrations and road poses."""

from typing import Annotated

from fastapi import Query
from pydantic import Field

from sightline.cameras.boards import board_told
from sightline.enums import BoardKind
from sightline.geometry.board import Board
from sightline.infra.web.bodies import Finite, In

Dictionary = Annotated[
    str | None, Field(max_length=40, description="Of a ChArUco board's markers, such as 4X4_50.")
]
MarkerM = Annotated[Finite | None, Field(gt=0, le=10, description="Side of a marker, ChArUco only.")]
SquareM = Annotated[Finite | None, Field(gt=0, le=10, description="Needed of a ChArUco board.")]
KindAsked = Annotated[BoardKind, Query(description="Plain checkerboard, or one with markers.")]


class Markers(In):
    """The kind of board, and the markers of one that has them."""

    board_kind: BoardKind = "checkerboard"
    dictionary: Dictionary = None
    marker_m: MarkerM = None


class BoardIn(Markers):
    """A board to look for; its square is needed of one with markers alone."""

    columns: int = Field(ge=2, le=100)
    rows: int = Field(ge=2, le=100)
    square_m: SquareM = None

    @property
    def board(self) -> Board:
        """Raises BadInput for a board half told."""
        return board_told(
            self.columns, self.rows, self.square_m, self.board_kind, self.dictionary, self.marker_m
        )
