"""How a survey is reviewed: which heights a reviewer clicks again before seeing them.

They are drawn from those on frames alone: a height in a line scan has no repeats, and its strips are clicked
on the bench of their recording, where the first clicks are seen.
The plan has no table of its own (`infra/audit/choice`).
"""

from sqlalchemy.orm import Session

from sightline.errors import BadInput, Conflict
from sightline.infra.audit import choice
from sightline.infra.database.rows import get_row
from sightline.reviews.records import ReviewPlan
from sightline.surveys.tables import surveys

USUAL = ReviewPlan(5, 0)
MOST = 100
_KIND = choice.Kind("review_plan", "blind_one_in")


def get_review_plan(session: Session, survey_id: int) -> ReviewPlan:
    """The plan in force; version 0 is the usual one. Raises NotFound."""
    get_row(session, surveys, survey_id, "survey")
    found = choice.chosen(session, _KIND, [survey_id])
    return ReviewPlan(*found[survey_id]) if found else USUAL


def choose_review_plan(
    session: Session, survey_id: int, *, blind_one_in: int, version: int, actor: int | None
) -> ReviewPlan:
    """From now on one measurement in `blind_one_in` is clicked blind, none at 0.

    Raises BadInput outside 0 to 100, Conflict if `version` is not the current one, NotFound.
    """
    before = get_review_plan(session, survey_id)
    if version != before.version:
        raise Conflict("reviews-plan-changed")
    if not 0 <= blind_one_in <= MOST:
        raise BadInput("reviews-plan-range", most=MOST)
    made = choice.choose(session, _KIND, survey_id, before.blind_one_in, blind_one_in, actor)
    return ReviewPlan(blind_one_in, made)


def is_drawn(series_id: int, blind_one_in: int) -> bool:
    """Whether a measurement is clicked blind: by a hash of its number, the same ones for every reviewer."""
    return choice.one_of(f"blind {series_id}", blind_one_in)
