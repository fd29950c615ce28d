"""How a survey is reviewed: which measurements a reviewer clicks again before seeing them.

The plan has no table of its own: the survey's newest audit event of this kind holds it, and so who chose it.
"""

import hashlib
import json

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.errors import BadInput, Conflict
from sightline.infra.audit import trail
from sightline.infra.audit.tables import audit_events
from sightline.infra.database.rows import get_row
from sightline.reviews.records import ReviewPlan
from sightline.surveys.tables import surveys

USUAL = ReviewPlan(5, 0)
MOST = 100
_ENTITY = "review_plan"


def get_review_plan(session: Session, survey_id: int) -> ReviewPlan:
    """The plan in force; version 0 is the usual one. Raises NotFound."""
    get_row(session, surveys, survey_id, "survey")
    e = audit_events.c
    newest = select(e.id, e.after).where(e.entity == _ENTITY, e.entity_id == survey_id).order_by(e.id.desc())
    row = session.execute(newest.limit(1)).one_or_none()
    return USUAL if row is None else ReviewPlan(json.loads(row.after)["blind_one_in"], row.id)


def choose_review_plan(
    session: Session, survey_id: int, *, blind_one_in: int, version: int, actor: int | None
) -> ReviewPlan:
    """From now on one measurement in `blind_one_in` is clicked blind, none at 0.

    Raises BadInput outside 0 to 100, Conflict if `version` is not the current one, NotFound.
    """
    before = get_review_plan(session, survey_id)
    if version != before.version:
        raise Conflict("reviews-somebody-changed-plan-meanwhile")
    if not 0 <= blind_one_in <= MOST:
        raise BadInput("reviews-plan-one-in-between", most=MOST)
    then, now = ({"blind_one_in": value} for value in (before.blind_one_in, blind_one_in))
    made = trail.record(session, actor, "choose", _ENTITY, survey_id, survey_id, then, now)
    return ReviewPlan(blind_one_in, made)


def is_drawn(series_id: int, blind_one_in: int) -> bool:
    """Whether a measurement is clicked blind: by a hash of its number, the same ones for every reviewer."""
    if blind_one_in <= 0:
        return False
    digest = hashlib.sha256(f"blind {series_id}".encode()).digest()
    return int.from_bytes(digest[:8], "big") % blind_one_in == 0
