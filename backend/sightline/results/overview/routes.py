"""Surveys as they go out: their words, insets, counts, and what to do next."""

from dataclasses import dataclass, replace
from typing import Annotated, TypeVar

from fastapi import APIRouter
from pydantic import BaseModel, Field

from sightline.enums import ActingRole, Category, InsetName
from sightline.geometry.insets import ROOF_OF_CLASS
from sightline.geometry.sides import TrafficFacts
from sightline.infra.by_name import filled_from
from sightline.infra.web.deps import ActingAs, Operator, PathId, Reading, SurveysSeen, Viewer, Writing
from sightline.measurements.again.service import ask_for_waiting
from sightline.results.overview.query import survey_overview, survey_overviews
from sightline.results.overview.records import ChangesSince, Step, SurveyCounts, SurveyOverview
from sightline.scans.records import ScanProgress
from sightline.surveys import store
from sightline.surveys.bodies import (
    FirstSurvey,
    InsetChanges,
    InsetChoice,
    Insets,
    SurveyChange,
    inset_choices,
)
from sightline.surveys.classes import VehicleClass, chosen_classes
from sightline.surveys.members.store import put_member, roles_by_thing
from sightline.surveys.place import Place
from sightline.surveys.records import Asked, Inset, SurveyFacts

router = APIRouter()
T = TypeVar("T")


@dataclass(frozen=True, slots=True, kw_only=True)
class SurveyBody(SurveyFacts):
    """A survey with its overview, as one object."""

    insets: Insets
    inset_choices: Annotated[
        dict[str, list[InsetChoice]], Field(description="What can be told apart by looking at a vehicle.")
    ]
    roof_insets: Annotated[
        dict[Category, InsetName],
        Field(description="Which inset the roof of each class has; one not named has that of no class."),
    ]
    my_role: Annotated[ActingRole, Field(description="What the person who asks is in this survey.")]
    counts: SurveyCounts
    steps: tuple[Step, ...]
    scans: ScanProgress
    since_package: Annotated[
        ChangesSince | None,
        Field(description="Added or changed since the newest package was built; null without a package."),
    ]


def survey_body(overview: SurveyOverview, role: ActingRole) -> SurveyBody:
    """A survey with its overview as one object."""
    insets = overview.survey.insets
    return filled_from(
        SurveyBody,
        overview.survey,
        overview,
        insets=Insets.model_validate(insets),
        inset_choices=inset_choices(insets),
        roof_insets=dict(ROOF_OF_CLASS),
        my_role=role,
    )


def _part_of_body(kind: type[T], part: BaseModel | None, before: T) -> T:
    """What a body says of a part of a survey; left out, it is what it was before."""
    return before if part is None else kind(**part.model_dump())


@router.get("/surveys")
def list_surveys(who: Viewer, session: Reading, seen: SurveysSeen) -> list[SurveyBody]:
    """Every survey that the person sees, newest first."""
    found = survey_overviews(session, seen)
    roles = roles_by_thing(session, who, "surveys", [one.survey.id for one in found])
    return [survey_body(one, roles[one.survey.id]) for one in found]


@router.post("/surveys", status_code=201)
def add_survey(body: FirstSurvey, who: Operator, session: Writing) -> SurveyBody:
    """A new, empty survey; whoever makes it manages it."""
    survey = store.create_survey(
        session,
        name=body.name,
        site=body.site,
        description=body.description,
        traffic=_part_of_body(TrafficFacts, body.traffic, TrafficFacts()),
        place=_part_of_body(Place, body.place, Place()),
        asked=_part_of_body(Asked, body.asked, Asked()),
        open_to_all=body.open_to_all,
        actor=who.id,
    )
    put_member(session, survey.id, who.id, "manager", actor=who.id)
    role: ActingRole = "admin" if who.role == "admin" else "manager"
    return survey_body(survey_overview(session, survey.id), role)


@router.get("/surveys/{survey_id}")
def get_survey(survey_id: PathId, who: Viewer, role: ActingAs, session: Reading) -> SurveyBody:
    """One survey with its counts and steps, computed now."""
    return survey_body(survey_overview(session, survey_id), role)


@router.put("/surveys/{survey_id}")
def change_survey(
    survey_id: PathId, body: SurveyChange, who: Operator, role: ActingAs, session: Writing
) -> SurveyBody:
    """Change words, traffic, place, targets or insets; they count for measurements made from now on.

    Where the traffic tells the driver's side now, a job computes the eyes that waited for it.
    """
    before = store.get_survey(session, survey_id)
    insets = (body.insets or InsetChanges()).model_dump(exclude_none=True)
    changed = replace(
        before,
        name=body.name,
        site=body.site,
        description=body.description,
        traffic=_part_of_body(TrafficFacts, body.traffic, before.traffic),
        place=_part_of_body(Place, body.place, before.place),
        asked=_part_of_body(Asked, body.asked, before.asked),
        classes=chosen_classes(
            (VehicleClass(**one.model_dump()) for one in body.classes or ()), before.classes
        ),
        sampling=before.sampling if body.sampling is None else body.sampling.record(),
        insets={**before.insets, **{name: Inset(**inset) for name, inset in insets.items()}},
        version=body.version,
    )
    store.update_survey(session, changed, actor=who.id)
    if changed.traffic != before.traffic:
        ask_for_waiting(session, survey_id, actor=who.id)
    return survey_body(survey_overview(session, survey_id), role)
