"""A board to print, as PDF."""

from typing import Annotated

from fastapi import APIRouter, Query, Response
from pydantic import Field

from sightline.cameras.board_bodies import Markers
from sightline.cameras.boards import BoardTold
from sightline.cameras.printing.service import board_pdf
from sightline.infra.web.bodies import Finite
from sightline.infra.web.deps import Viewer

router = APIRouter()


class BoardToPrint(Markers):
    columns: int = Field(ge=1, le=1000, description="Inner corners.")
    rows: int = Field(ge=1, le=1000, description="Inner corners.")
    square_m: Finite = Field(gt=0, le=10)
    paper: str | None = Field(default=None, max_length=20, description="A4 to A0, Letter, or 841x1500 (mm).")


@router.get("/boards.pdf", response_class=Response)
def print_board(who: Viewer, asked: Annotated[BoardToPrint, Query()]) -> Response:
    """The board at true size with a scale bar; without a paper, on the smallest ISO sheet that holds it."""
    board = BoardTold(**asked.model_dump(exclude={"paper"})).board
    name = f"sightline-board-{board.columns}x{board.rows}-{1000 * board.square_m:g}mm.pdf"
    headers = {"Content-Disposition": f'inline; filename="{name}"'}
    return Response(board_pdf(board, asked.paper), media_type="application/pdf", headers=headers)
