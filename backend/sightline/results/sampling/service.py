"""How far a survey's sample has come: its quotas, and what became of its passes."""

from collections.abc import Iterable

from sightline.infra.database import Session
from sightline.results.sampling.query import pass_answers
from sightline.results.sampling.records import QuotaProgress, SampleProgress
from sightline.statistics.sampling import PassAnswers, Quota, response
from sightline.surveys.store import get_survey


def sample_progress(session: Session, survey_id: int) -> SampleProgress:
    """Quotas and response of a survey as it stands. Raises NotFound."""
    survey = get_survey(session, survey_id)
    passes = pass_answers(session, survey)
    quotas = tuple(_progress(one, passes) for one in survey.sampling.quotas)
    return SampleProgress(quotas, tuple(response(passes)))


def _progress(quota: Quota, passes: Iterable[PassAnswers]) -> QuotaProgress:
    of = [
        one.end
        for one in passes
        if one.lighting == quota.lighting and quota.class_set in (None, one.class_set)
    ]
    return QuotaProgress(
        quota.lighting, quota.class_set, quota.wanted, of.count("measured"), of.count("open")
    )
