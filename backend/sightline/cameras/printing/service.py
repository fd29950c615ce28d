"""Boards to print: a PDF at true size, with a bar by which the print is checked."""

import json
from pathlib import Path
from typing import Any

from sightline.geometry.board import Board
from sightline.geometry.printed_board import PrintedBoard, printed_board
from sightline.messages import say

_TEMPLATE = Path(__file__).parent / "board.typ"


def board_pdf(board: Board, paper: str | None = None) -> bytes:
    """The board on `paper`, else on the smallest ISO sheet that holds it. Raises as `printed_board`."""
    from sightline.infra.typesetting.pdf import set_pdf  # here, so that a server starts without Typst

    return set_pdf(board_sources(board, printed_board(board, paper)), 0)


def board_sources(board: Board, printed: PrintedBoard) -> dict[str, bytes]:
    """The files that Typst compiles."""
    values = json.dumps(_values(board, printed), ensure_ascii=False).encode()
    return {"main.typ": _TEMPLATE.read_bytes(), "values.json": values}


def _values(board: Board, printed: PrintedBoard) -> dict[str, Any]:
    left, top, length = (round(1000.0 * one, 3) for one in printed.bar_m)
    values: dict[str, str | float] = {"columns": board.columns, "rows": board.rows}
    values["square_mm"] = round(1000.0 * board.square_m, 3)
    title = say("print-board-title", values)
    if board.charuco is not None:
        values |= {
            "dictionary": board.charuco.dictionary,
            "marker_mm": round(1000.0 * board.charuco.marker_m, 3),
        }
        title = say("print-board-title-charuco", values)
    return {
        "title": title,
        "alt": title,
        "check": say("print-board-check", {"bar_mm": length, "paper": printed.paper}),
        "width_mm": round(1000.0 * printed.size_m[0], 3),
        "height_mm": round(1000.0 * printed.size_m[1], 3),
        "black": (1000.0 * printed.black).round(4).tolist(),
        "white": (1000.0 * printed.white).round(4).tolist(),
        "bar": {"x": left, "y": top, "length": length},
    }
