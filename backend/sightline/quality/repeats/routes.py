"""Repeats: what can be clicked again, what they say, and whose clicks count with a sigma of their own."""

from dataclasses import dataclass
from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import Field

from sightline.infra.by_name import filled_from
from sightline.infra.web.bodies import In
from sightline.infra.web.deps import Operator, PathId, Reading, Reviewer, Viewer, Writing
from sightline.measurements.bodies import MeasurementBody, measurement_body
from sightline.measurements.records import ClickSigma
from sightline.quality.repeats import service
from sightline.quality.repeats.anchoring import Anchoring, anchoring
from sightline.quality.repeats.query import Blind

router = APIRouter()


@dataclass(frozen=True, kw_only=True)
class ComparisonBody(service.Compared):
    """A repeat beside the measurement that it repeats."""

    repeat: MeasurementBody


class SigmaChoice(In):
    own: bool = Field(description="True: the sigma of their repeats; false: the usual 1 px again.")


@router.get("/surveys/{survey_id}/repeats")
def repeats_of_survey(survey_id: PathId, who: Viewer, session: Reading) -> service.Findings:
    """Repeatability and reproducibility per target and per person, and every difference."""
    return service.findings(session, survey_id)


@router.get("/surveys/{survey_id}/anchoring")
def anchoring_of_survey(survey_id: PathId, who: Viewer, session: Reading) -> Anchoring:
    """How far showing proposals moves heights: those of vehicles shown against those measured free."""
    return anchoring(session, survey_id)


@router.get("/surveys/{survey_id}/repeats/sample")
def sample_to_click_again(
    survey_id: PathId,
    who: Operator,
    session: Reading,
    count: Annotated[int, Query(ge=1, le=100)] = 10,
    only_own: Annotated[bool, Query(description="Only what you clicked yourself.")] = True,
) -> tuple[Blind, ...]:
    """Measurements for you to click again without seeing, in random order; repeat them with `repeat_of`."""
    return service.sample(session, survey_id, person_id=who.id, count=count, only_own=only_own)


@router.get("/measurements/{measurement_id}/repeats")
def repeats_of_measurement(measurement_id: PathId, who: Viewer, session: Reading) -> list[ComparisonBody]:
    """The repeats of a measurement, each with its difference and the U95 of that."""
    found = service.comparisons(session, measurement_id)
    return [filled_from(ComparisonBody, one, repeat=measurement_body(one.repeat)) for one in found]


@router.put("/surveys/{survey_id}/people/{person_id}/click-sigma")
def choose_click_sigma(
    survey_id: PathId, person_id: PathId, body: SigmaChoice, who: Reviewer, session: Writing
) -> ClickSigma:
    """How a person's clicks count from now on; what is stored keeps its sigma."""
    return service.use_own_sigma(session, survey_id, person_id, own=body.own, actor=who.id)
