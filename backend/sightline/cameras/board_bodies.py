"""The kind of board, as it goes in with calibrations and road poses."""

from pydantic import Field

from sightline.cameras.boards import BoardTold
from sightline.enums import BoardKind
from sightline.geometry.board import Board
from sightline.infra.web.bodies import Finite, In


class Markers(In):
    """The kind of board, and the markers of one that has them."""

    board_kind: BoardKind = Field(
        default="checkerboard", description="Plain checkerboard, or one with markers."
    )
    dictionary: str | None = Field(
        default=None, max_length=40, description="Of a ChArUco board's markers, such as 4X4_50."
    )
    marker_m: Finite | None = Field(default=None, gt=0, le=10, description="Side of a marker, ChArUco only.")


class BoardIn(Markers):
    """A board to look for; its square is needed of one with markers alone."""

    columns: int = Field(ge=2, le=100)
    rows: int = Field(ge=2, le=100)
    square_m: Finite | None = Field(default=None, gt=0, le=10, description="Needed of a ChArUco board.")

    @property
    def board(self) -> Board:
        """Raises BadInput for a board half told."""
        return BoardTold(**self.model_dump(include=set(BoardTold.__dataclass_fields__))).board
