"""The audit trail as people read it."""

from datetime import date
from typing import Annotated

from fastapi import APIRouter, Query

from sightline.infra.audit import trail
from sightline.infra.audit.records import Who
from sightline.infra.web.bodies import Id
from sightline.infra.web.deps import Reading, SurveysSeen, Viewer
from sightline.infra.web.named import SurveyId
from sightline.results.audited import query
from sightline.results.audited.records import NamedEvent

router = APIRouter()


@router.get("/audit/events")
def list_named_events(
    who: Viewer,
    session: Reading,
    seen: SurveysSeen,
    survey_id: Annotated[SurveyId | None, Query()] = None,
    entity: Annotated[str | None, Query(max_length=40)] = None,
    person_id: Annotated[Id | None, Query(description="Who did it.")] = None,
    day: Annotated[date | None, Query(description="In UTC.")] = None,
    vehicle: Annotated[Id | None, Query(description="A vehicle's number in the survey.")] = None,
    before_id: Annotated[Id | None, Query()] = None,
    limit: Annotated[int, Query(ge=1, le=1000)] = 100,
) -> tuple[NamedEvent, ...]:
    """Events with the names of what they are about, newest first; `before_id` turns the page."""
    events = trail.listing(
        session,
        survey_id=survey_id,
        entity=entity,
        actor_id=person_id,
        day=day,
        among=None if vehicle is None else query.of_vehicle(vehicle, survey_id),
        seen=seen,
        before_id=before_id,
        limit=limit,
    )
    return query.with_names(session, events)


@router.get("/audit/people")
def list_acting_people(who: Viewer, session: Reading, seen: SurveysSeen) -> tuple[Who, ...]:
    """Everybody of whom the trail tells something that one sees, by name."""
    return query.acting_people(session, seen)
