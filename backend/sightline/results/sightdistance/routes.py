"""Sight distances from measured heights."""

from typing import Annotated, get_args

from fastapi import APIRouter, Query
from pydantic import BaseModel, Field

from sightline.enums import (
    Category,
    EyeRule,
    LengthUnit,
    SightKind,
    StatisticsTarget,
)
from sightline.errors import BadInput
from sightline.infra.web.deps import Reading, Viewer
from sightline.results.bodies import HeightsAsked
from sightline.results.sightdistance.records import SightDistances, SightQuestion
from sightline.results.sightdistance.service import sight_distances

router = APIRouter()

Number = Annotated[float, Field(allow_inf_nan=False)]
Percent = Annotated[float, Field(gt=0, lt=100, allow_inf_nan=False)]


class RoadAsked(BaseModel):
    """The standard's heights, the rule that reads the survey's, and the road."""

    eye_m: Number = Field(default=1.08, description="The standard's eye.")
    object_m: Number = Field(default=0.60, description="The standard's object.")
    eye_what: EyeRule = Field(
        default="eye_car", description="Whose rule the eyes are read by: it names their class."
    )
    eye_percent: Percent = Field(default=10.0, description="The rule that reads the survey's eyes.")
    object_percent: Percent = Field(default=5.0, description="The rule that reads its objects.")
    object_target: StatisticsTarget | None = Field(
        default=None, description="What stands for the object; none: the standard's height."
    )
    kind: SightKind = "stopping"
    speed_mps: Number = 100 / 3.6
    difference_percent: Number = Field(default=6.0, description="Of both grades, for lengths of curves.")
    headlight_m: Number = Field(default=0.60, description="For a sag, with a beam that rises 1 degree.")
    radius_m: Number = Field(default=500.0, gt=0, description="Of a horizontal curve.")
    share: list[str] = Field(
        default=[],
        max_length=40,
        description="A fleet's shares in percent, class:percent; none: no what-if.",
    )
    unit: LengthUnit = Field(default="m", description="Which set of formulas and design speeds.")


@router.get("/sightdistance")
def sight_distances_of_measurements(
    who: Viewer, session: Reading, heights: HeightsAsked, road: Annotated[RoadAsked, Query()]
) -> SightDistances:
    """Crests by the standard's heights, by the survey's and by another fleet's, with sag and curve."""
    asked = road.model_dump(exclude={"share"})
    return sight_distances(session, SightQuestion(chosen=heights, shares=_shares(road.share), **asked))


def _shares(share: list[str]) -> dict[Category, float]:
    found: dict[Category, float] = {}
    known: dict[str, Category] = {word: word for word in get_args(Category)}
    for one in share:
        word, _, percent = one.partition(":")
        try:
            number = float(percent)
        except ValueError:
            number = -1.0
        if word not in known or not 0.0 <= number <= 100.0:
            raise BadInput("sightdistance-share", share=one[:60])
        found[known[word]] = number / 100.0
    return found
