"""Sight distances from measured heights."""

from typing import Annotated, get_args

from fastapi import APIRouter, Query

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

Number = Annotated[float, Query(allow_inf_nan=False)]
Percent = Annotated[float, Query(gt=0, lt=100, allow_inf_nan=False)]


@router.get("/sightdistance")
def sight_distances_of_measurements(
    who: Viewer,
    session: Reading,
    heights: HeightsAsked,
    eye_m: Annotated[Number, Query(description="The standard's eye.")] = 1.08,
    object_m: Annotated[Number, Query(description="The standard's object.")] = 0.60,
    eye_what: Annotated[
        EyeRule, Query(description="Whose rule the eyes are read by: it names their class.")
    ] = "eye_car",
    eye_percent: Annotated[Percent, Query(description="The rule that reads the survey's eyes.")] = 10.0,
    object_percent: Annotated[Percent, Query(description="The rule that reads its objects.")] = 5.0,
    object_target: Annotated[
        StatisticsTarget | None, Query(description="What stands for the object; none: the standard's height.")
    ] = None,
    kind: SightKind = "stopping",
    speed_mps: Number = 100 / 3.6,
    difference_percent: Annotated[Number, Query(description="Of both grades, for lengths of curves.")] = 6.0,
    headlight_m: Annotated[Number, Query(description="For a sag, with a beam that rises 1 degree.")] = 0.60,
    radius_m: Annotated[Number, Query(gt=0, description="Of a horizontal curve.")] = 500.0,
    share: Annotated[
        list[str],
        Query(max_length=40, description="A fleet's shares in percent, class:percent; none: no what-if."),
    ] = [],  # noqa: B006
    unit: Annotated[LengthUnit, Query(description="Which set of formulas and design speeds.")] = "m",
) -> SightDistances:
    """Crests by the standard's heights, by the survey's and by another fleet's, with sag and curve."""
    question = SightQuestion(
        chosen=heights,
        eye_m=eye_m,
        object_m=object_m,
        eye_percent=eye_percent,
        object_percent=object_percent,
        object_target=object_target,
        kind=kind,
        speed_mps=speed_mps,
        difference_percent=difference_percent,
        headlight_m=headlight_m,
        radius_m=radius_m,
        shares=_shares(share),
        unit=unit,
        eye_what=eye_what,
    )
    return sight_distances(session, question)


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
