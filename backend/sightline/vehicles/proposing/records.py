"""A point that Sightline proposes to click."""

from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from sightline.enums import Point, ProposedPoint


@dataclass(frozen=True, slots=True, kw_only=True)
class PointProposal:
    """A point of a found pass on its frame with its predicted standard error, or why there is none.

    It is no measurement: it becomes part of one when a person confirms or moves it.
    """

    vehicle_id: int
    point: ProposedPoint
    frame: int | None
    point_px: Annotated[Point | None, Field(description="None where `reason` says why.")]
    expected_px: Annotated[float | None, Field(description="Predicted standard error of the point.")]
    reason: Annotated[str | None, Field(description="A key of the catalogue of messages.")]
