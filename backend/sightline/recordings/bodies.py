"""What comes in about when something was recorded."""

from datetime import date
from typing import Annotated

from fastapi import Depends, Query
from pydantic import Field

from sightline.infra.web.bodies import In
from sightline.recordings.filming import FilmedWithin

HourFrom = Annotated[
    int | None,
    Field(ge=0, le=23, description="From this full hour of the day on, by the clocks of the place."),
]
HourTo = Annotated[
    int | None,
    Field(
        ge=1,
        le=24,
        description="Up to this full hour; before hour_from: of the nights that begin on the days.",
    ),
]


def filmed_asked_for(
    filmed_from: Annotated[date | None, Query(description="By the clocks of the place.")] = None,
    filmed_to: Annotated[date | None, Query(description="The last day, included.")] = None,
    hour_from: HourFrom = None,
    hour_to: HourTo = None,
) -> FilmedWithin:
    """Which days and hours of filming a question is about. Raises BadInput where there are none."""
    filmed = FilmedWithin(filmed_from, filmed_to, hour_from, hour_to)
    filmed.require_sense()
    return filmed


FilmedAsked = Annotated[FilmedWithin, Depends(filmed_asked_for)]


class StartIn(In):
    """When a recording was begun, as clocks of the place showed it."""

    local: str = Field(
        max_length=40, description="ISO 8601; with its offset where the clocks showed that time twice."
    )
    time_zone: str = Field(max_length=60, description="IANA, as Europe/Paris.")
