"""The kind of board, as it goes in with calibrations and road poses."""

from typing import Annotated

from fastapi import Query
from pydantic import Field

from sightline.enums import BoardKind
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
