"""How a survey is reviewed: which heights a reviewer clicks again before seeing them.

They are drawn from those on frames alone: a height in a line scan has no repeats, and its strips are clicked
on the bench of their recording, where the first clicks are seen.
The plan has no table of its own (`infra/audit/choice`).
"""

from sqlalchemy.orm import Session

from sightline.infra.audit import choice
from sightline.reviews.records import ReviewPlan

_PLAN = choice.DrawPlan(
    choice.Kind("review_plan", "blind_one_in"),
    usual=5,
    least=1,
    changed="reviews-plan-changed",
    refused="reviews-plan-range",
)


def get_review_plan(session: Session, survey_id: int) -> ReviewPlan:
    """The plan in force; version 0 is the usual one. Raises NotFound."""
    return ReviewPlan(*_PLAN.in_force(session, survey_id))


def choose_review_plan(
    session: Session, survey_id: int, *, blind_one_in: int, version: int, actor: int | None
) -> ReviewPlan:
    """From now on one measurement in `blind_one_in` is clicked blind, none at 0.

    Raises BadInput outside 0 to 100, Conflict if `version` is not the current one, NotFound.
    """
    return ReviewPlan(*_PLAN.choose(session, survey_id, blind_one_in, version=version, actor=actor))


def is_drawn(series_id: int, blind_one_in: int) -> bool:
    """Whether a measurement is clicked blind: by a hash of its number, the same ones for every reviewer."""
    return choice.one_of(f"blind {series_id}", blind_one_in)
