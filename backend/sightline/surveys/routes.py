"""Surveys: their words, insets, counts, and what to do next."""

from datetime import datetime
from typing import Annotated, Literal

from fastapi import APIRouter
from pydantic import Field

from sightline.geometry.insets import INSET_CHOICES
from sightline.infra.web.bodies import In, Name, Out, Text
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Writing
from sightline.surveys import store
from sightline.surveys.records import Inset

router = APIRouter()

Metres = Annotated[float, Field(ge=-10, le=10, allow_inf_nan=False)]
Uncertainty = Annotated[float, Field(ge=0, le=10, allow_inf_nan=False)]


class InsetBody(Out):
    inset_m: Metres
    u_inset_m: Uncertainty
    note: Annotated[str, Field(max_length=1000)] = ""


class InsetIn(In):
    inset_m: Metres
    u_inset_m: Uncertainty
    note: Annotated[str, Field(max_length=1000)] = ""


class Insets(Out):
    roof: InsetBody
    driver_eye: InsetBody
    taillight: InsetBody
    headlight: InsetBody
    other: InsetBody


class InsetChanges(In):
    """Targets left out keep their inset."""

    roof: InsetIn | None = None
    driver_eye: InsetIn | None = None
    taillight: InsetIn | None = None
    headlight: InsetIn | None = None
    other: InsetIn | None = None


class Counts(Out):
    recordings: int
    vehicles: int
    vehicles_measured: int
    measurements: int
    to_review: int
    accepted: int
    rejected: int


class StepBody(Out):
    key: Literal["camera", "recordings", "pose", "vehicles", "review", "results"]
    state: Literal["done", "next", "waiting"]
    summary: str


class ScanProgressBody(Out):
    """The line scans: vehicles by what was done with them, and what to do next."""

    state: Literal["none", "open", "done"]
    summary: str
    scans: int
    ready: int
    vehicles: int
    to_review: int
    accepted: int
    rejected: int
    not_measurable: int


class InsetChoice(Out):
    words: str
    inset_m: float
    u_inset_m: float


def inset_choices() -> dict[str, list[InsetChoice]]:
    """Per target what can be told apart by looking at the vehicle; the same for every survey."""
    return {
        target: [InsetChoice(words=words, inset_m=inset, u_inset_m=u) for words, inset, u in choices]
        for target, choices in INSET_CHOICES.items()
    }


class SurveyBody(Out):
    id: int
    name: str
    site: str
    description: str
    is_demo: bool
    version: int
    created_at: datetime
    insets: Insets
    inset_choices: dict[str, list[InsetChoice]] = Field(default_factory=inset_choices)
    counts: Counts
    steps: list[StepBody]
    scans: ScanProgressBody


class NewSurvey(In):
    name: Name
    site: Annotated[str, Field(max_length=200)] = ""
    description: Text = ""


class SurveyChange(NewSurvey):
    version: int = Field(
        description="The version that was changed; another's change in between is a conflict."
    )
    insets: InsetChanges | None = None


@router.get("/surveys")
def list_surveys(who: Viewer, session: Reading) -> list[SurveyBody]:
    """Every survey, newest first."""
    return [SurveyBody.model_validate(one) for one in store.list_surveys(session)]


@router.post("/surveys", status_code=201)
def add_survey(body: NewSurvey, who: Operator, session: Writing) -> SurveyBody:
    """A new, empty survey."""
    made = store.create_survey(
        session, name=body.name, site=body.site, description=body.description, actor=who.id
    )
    return SurveyBody.model_validate(made)


@router.get("/surveys/{survey_id}")
def get_survey(survey_id: PathId, who: Viewer, session: Reading) -> SurveyBody:
    """One survey with its counts and steps, computed now."""
    return SurveyBody.model_validate(store.get_survey(session, survey_id))


@router.put("/surveys/{survey_id}")
def change_survey(survey_id: PathId, body: SurveyChange, who: Operator, session: Writing) -> SurveyBody:
    """Change words or insets; insets count for measurements made from now on."""
    insets = dict(store.get_survey(session, survey_id).insets)
    for target, inset in (body.insets or InsetChanges()).model_dump(exclude_none=True).items():
        insets[target] = Inset(**inset)
    changed = store.update_survey(
        session,
        survey_id,
        name=body.name,
        site=body.site,
        description=body.description,
        insets=insets,
        version=body.version,
        actor=who.id,
    )
    return SurveyBody.model_validate(changed)
