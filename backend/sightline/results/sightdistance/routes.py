"""Sight distances from measured heights."""

from typing import Annotated, get_args

from fastapi import APIRouter, Query
from pydantic import BaseModel, Field

from sightline.enums import Category
from sightline.errors import BadInput
from sightline.infra.web.bodies import of_record
from sightline.infra.web.deps import Reading, Viewer
from sightline.results.bodies import HeightsAsked
from sightline.results.sightdistance.records import SightDistances, SightQuestion
from sightline.results.sightdistance.service import sight_distances

router = APIRouter()


@of_record(SightQuestion, "chosen", "shares")
class RoadAsked(BaseModel):
    """The standard's heights, the rule that reads the survey's, and the road."""

    share: list[str] = Field(
        default=[],
        max_length=40,
        description="A fleet's shares in percent, class:percent; none: no what-if.",
    )


@router.get("/sightdistance")
def sight_distances_of_measurements(
    who: Viewer, session: Reading, heights: HeightsAsked, road: Annotated[RoadAsked, Query()]
) -> SightDistances:
    """Crests by the standard's heights, by the survey's and by another fleet's, with sag and curve."""
    asked = road.model_dump(exclude={"share"})
    return sight_distances(session, SightQuestion(chosen=heights, shares=_shares(road.share), **asked))


def _shares(share: list[str]) -> dict[Category, float]:
    shares: dict[Category, float] = {}
    known: dict[str, Category] = {word: word for word in get_args(Category)}
    for part in share:
        word, _, percent = part.partition(":")
        try:
            number = float(percent)
        except ValueError:
            number = -1.0
        if word not in known or not 0.0 <= number <= 100.0:
            raise BadInput("sightdistance-share", share=part[:60])
        shares[known[word]] = number / 100.0
    return shares
