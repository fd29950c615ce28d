"""A board to print, as PDF."""

from typing import Annotated

from fastapi import APIRouter, Query, Response

from sightline.cameras.board_bodies import KindAsked
from sightline.cameras.boards import board_told
from sightline.cameras.printing.service import board_pdf
from sightline.infra.web.deps import Viewer

router = APIRouter()

Count = Annotated[int, Query(ge=1, le=1000, description="Inner corners.")]
Metres = Annotated[float, Query(gt=0, le=10, allow_inf_nan=False)]


@router.get("/boards.pdf", response_class=Response)
def print_board(
    who: Viewer,
    columns: Count,
    rows: Count,
    square_m: Metres,
    board_kind: KindAsked = "checkerboard",
    dictionary: Annotated[str | None, Query(max_length=40, description="Of a ChArUco board.")] = None,
    marker_m: Annotated[float | None, Query(gt=0, le=10, allow_inf_nan=False)] = None,
    paper: Annotated[
        str | None, Query(max_length=20, description="A4 to A0, Letter, or 841x1500 (mm).")
    ] = None,
) -> Response:
    """The board at true size with a scale bar; without a paper, on the smallest ISO sheet that holds it."""
    board = board_told(columns, rows, square_m, board_kind, dictionary, marker_m)
    name = f"sightline-board-{columns}x{rows}-{1000 * square_m:g}mm.pdf"
    headers = {"Content-Disposition": f'inline; filename="{name}"'}
    return Response(board_pdf(board, paper), media_type="application/pdf", headers=headers)
