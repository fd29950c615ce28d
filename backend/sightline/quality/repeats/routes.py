"""Repeats: what can be clicked again, what they say, and whose clicks count with a sigma of their own."""

from datetime import datetime
from typing import Annotated

from fastapi import APIRouter, Query
from pydantic import Field

from sightline.enums import Target
from sightline.infra.web.bodies import In, Out, WhoBody
from sightline.infra.web.deps import Operator, PathId, Reading, Reviewer, Viewer, Writing
from sightline.measurements.bodies import MeasurementBody
from sightline.quality.repeats import service
from sightline.surveys.store import get_survey

router = APIRouter()


class SpreadBody(Out):
    """A standard deviation with its 95 % interval; or why there is none."""

    sd: float | None
    low: float | None
    high: float | None
    freedom: int
    reason: str | None


class GaugeBody(Out):
    n: int = Field(description="Heights of items that were clicked more than once.")
    items: int
    persons: int = Field(description="Persons; of all targets together, each person and target.")
    repeatability: SpreadBody = Field(description="The same person again, m.")
    reproducibility: SpreadBody = Field(description="What another person adds, m.")
    interaction_p: float | None


class ClaimBody(Out):
    """What the repeats show against what the clicks' part of the budgets claims, m; ratio 1: as claimed."""

    ratio: float | None
    low: float | None
    high: float | None
    claimed: float | None
    observed: float | None
    freedom: int
    reason: str | None


class OfTargetBody(Out):
    target: Target | None = Field(description="None: all targets together.")
    gauge: GaugeBody
    uncertainty_check: ClaimBody
    another_frame: SpreadBody = Field(description="The same person on another frame of the pass, m.")


class ClickSigmaBody(Out):
    sigma_px: float | None = Field(description="None: the usual 1 px.")
    pairs: int
    created_by: WhoBody | None
    created_at: datetime


class OfPersonBody(Out):
    person: WhoBody
    pairs: int = Field(description="How often they clicked their own measurements again.")
    heights: SpreadBody = Field(description="Of their own repeats, m.")
    contact: SpreadBody = Field(description="Each coordinate, px.")
    target_point: SpreadBody = Field(description="Each coordinate, px.")
    sigma: SpreadBody = Field(description="Contact and target together, each coordinate, px.")
    operator_bias_m: float | None = Field(
        description="Their heights minus the others' of the same items, mean."
    )
    items: int = Field(description="Items that they and others clicked.")
    chosen: ClickSigmaBody | None
    may_choose: bool


class DifferenceBody(Out):
    """A repeat minus what it repeats; `expected_m`: twice the combined uncertainty of the clicks."""

    first_id: int
    repeat_id: int
    vehicle_id: int
    target: Target
    first_person: WhoBody
    person: WhoBody
    mean_m: float
    difference_m: float
    expected_m: float


class FindingsBody(Out):
    repeats: int
    targets: list[OfTargetBody]
    people: list[OfPersonBody]
    differences: list[DifferenceBody]
    not_compared: int = Field(description="Repeats with another road pose or inset, or without height.")


class ComparisonBody(Out):
    repeat: MeasurementBody
    first_height_m: float | None
    difference_m: float | None
    expected_m: float | None
    agrees: bool | None
    reason: str | None


class BlindBody(Out):
    """A measurement to be clicked again: neither its points nor its height."""

    measurement_id: int
    vehicle_id: int
    vehicle_number: int
    recording_id: int
    frame: int
    target: Target


class SigmaChoice(In):
    own: bool = Field(description="True: the sigma of their repeats; false: the usual 1 px again.")


@router.get("/surveys/{survey_id}/repeats")
def repeats_of_survey(survey_id: PathId, who: Viewer, session: Reading) -> FindingsBody:
    """Repeatability and reproducibility per target and per person, and every difference."""
    get_survey(session, survey_id)
    return FindingsBody.model_validate(service.findings(session, survey_id))


@router.get("/surveys/{survey_id}/repeats/sample")
def sample_to_click_again(
    survey_id: PathId,
    who: Operator,
    session: Reading,
    count: Annotated[int, Query(ge=1, le=100)] = 10,
    only_own: Annotated[bool, Query(description="Only what you clicked yourself.")] = True,
) -> list[BlindBody]:
    """Measurements for you to click again without seeing, in random order; repeat them with `repeat_of`."""
    get_survey(session, survey_id)
    chosen = service.sample(session, survey_id, person_id=who.id, count=count, only_own=only_own)
    return [BlindBody.model_validate(one) for one in chosen]


@router.get("/measurements/{measurement_id}/repeats")
def repeats_of_measurement(measurement_id: PathId, who: Viewer, session: Reading) -> list[ComparisonBody]:
    """The repeats of a measurement, each with its difference and what the clicks let one expect (k = 2)."""
    return [ComparisonBody.model_validate(one) for one in service.comparisons(session, measurement_id)]


@router.put("/surveys/{survey_id}/people/{person_id}/click-sigma")
def choose_click_sigma(
    survey_id: PathId, person_id: PathId, body: SigmaChoice, who: Reviewer, session: Writing
) -> ClickSigmaBody:
    """How a person's clicks count from now on; what is stored keeps its sigma."""
    chosen = service.use_own_sigma(session, survey_id, person_id, own=body.own, actor=who.id)
    return ClickSigmaBody.model_validate(chosen)
