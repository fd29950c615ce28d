"""Surveys as they go out: their words, insets, counts, and what to do next."""

from fastapi import APIRouter

from sightline.geometry.sides import TrafficFacts
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Writing
from sightline.measurements.again.service import ask_for_waiting
from sightline.results.overview.query import survey_overview, survey_overviews
from sightline.results.overview.records import Step, SurveyCounts, SurveyOverview
from sightline.scans.records import ScanProgress
from sightline.surveys import store
from sightline.surveys.bodies import InsetChanges, NewSurvey, SurveyChange, SurveyFacts
from sightline.surveys.classes import VehicleClass, chosen_classes
from sightline.surveys.place import Place
from sightline.surveys.records import Asked, Inset

router = APIRouter()


class SurveyBody(SurveyFacts):
    counts: SurveyCounts
    steps: tuple[Step, ...]
    scans: ScanProgress


def survey_body(overview: SurveyOverview) -> SurveyBody:
    """A survey with its overview as one object."""
    facts = SurveyFacts.model_validate(overview.survey).model_dump(exclude={"inset_choices"})
    progress = {"counts": overview.counts, "steps": overview.steps, "scans": overview.scans}
    return SurveyBody.model_validate({**facts, **progress})


def _traffic(body: NewSurvey, before: TrafficFacts) -> TrafficFacts:
    return before if body.traffic is None else TrafficFacts(**body.traffic.model_dump())


def _place(body: NewSurvey, before: Place) -> Place:
    return before if body.place is None else Place(**body.place.model_dump())


def _asked(body: NewSurvey, before: Asked) -> Asked:
    return before if body.asked is None else Asked(**body.asked.model_dump())


@router.get("/surveys")
def list_surveys(who: Viewer, session: Reading) -> list[SurveyBody]:
    """Every survey, newest first."""
    return [survey_body(overview) for overview in survey_overviews(session)]


@router.post("/surveys", status_code=201)
def add_survey(body: NewSurvey, who: Operator, session: Writing) -> SurveyBody:
    """A new, empty survey."""
    made = store.create_survey(
        session,
        name=body.name,
        site=body.site,
        description=body.description,
        traffic=_traffic(body, TrafficFacts()),
        place=_place(body, Place()),
        asked=_asked(body, Asked()),
        actor=who.id,
    )
    return survey_body(survey_overview(session, made.id))


@router.get("/surveys/{survey_id}")
def get_survey(survey_id: PathId, who: Viewer, session: Reading) -> SurveyBody:
    """One survey with its counts and steps, computed now."""
    return survey_body(survey_overview(session, survey_id))


@router.put("/surveys/{survey_id}")
def change_survey(survey_id: PathId, body: SurveyChange, who: Operator, session: Writing) -> SurveyBody:
    """Change words, traffic, place, targets or insets; they count for measurements made from now on.

    Where the traffic tells the driver's side now, a job computes the eyes that waited for it.
    """
    before = store.get_survey(session, survey_id)
    insets = dict(before.insets)
    for target, inset in (body.insets or InsetChanges()).model_dump(exclude_none=True).items():
        insets[target] = Inset(**inset)
    store.update_survey(
        session,
        survey_id,
        name=body.name,
        site=body.site,
        description=body.description,
        traffic=_traffic(body, before.traffic),
        place=_place(body, before.place),
        asked=_asked(body, before.asked),
        classes=chosen_classes(
            (VehicleClass(**one.model_dump()) for one in body.classes or ()), before.classes
        ),
        sampling=before.sampling if body.sampling is None else body.sampling.record(),
        insets=insets,
        version=body.version,
        actor=who.id,
    )
    if _traffic(body, before.traffic) != before.traffic:
        ask_for_waiting(session, survey_id, actor=who.id)
    return survey_body(survey_overview(session, survey_id))
