"""A point that Sightline proposes to click."""

from dataclasses import dataclass, replace
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
    withheld: Annotated[bool, Field(description="Its vehicle was drawn to be measured free.")] = False

    @property
    def as_shown(self) -> "PointProposal":
        """Without its place where it is withheld; the frame stays, for free clicks to be on the same one."""
        if not self.withheld or self.point_px is None:
            return self
        return replace(self, point_px=None, expected_px=None, reason="proposals-withheld")


@dataclass(frozen=True, slots=True)
class FreePlan:
    """How many vehicles are measured free of proposals, to know how far people lean on them."""

    free_one_in: Annotated[int, Field(description="One in so many shows no proposal; 0: none.")]
    version: int
