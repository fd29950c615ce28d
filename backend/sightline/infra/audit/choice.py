"""Numbers that somebody chose for a survey and that have no table of their own.

The survey's newest audit event of the kind holds the number, and so who chose it and when.
"""

import hashlib
import json
from dataclasses import dataclass

from sqlalchemy import select
from sqlalchemy.orm import Session

from sightline.infra.audit import trail
from sightline.infra.audit.tables import audit_events


@dataclass(frozen=True, slots=True)
class Kind:
    """A number that is chosen: the entity of its events, and the name of the number in them."""

    entity: str
    name: str


def chosen(session: Session, kind: Kind, survey_id: int) -> tuple[int, int] | None:
    """(the number in force, its version); None while nobody chose one."""
    e = audit_events.c
    newest = (
        select(e.id, e.after)
        .where(e.entity == kind.entity, e.entity_id == survey_id)
        .order_by(e.id.desc())
        .limit(1)
    )
    row = session.execute(newest).one_or_none()
    return None if row is None else (int(json.loads(row.after)[kind.name]), row.id)


def choose(session: Session, kind: Kind, survey_id: int, before: int, after: int, actor: int | None) -> int:
    """Put a number in force; its version."""
    then, now = ({kind.name: value} for value in (before, after))
    return trail.record(session, actor, "choose", kind.entity, survey_id, survey_id, then, now)


def one_of(text: str, one_in: int) -> bool:
    """Whether a text is the one of `one_in` (none at 0), by its SHA-256, which anybody can compute."""
    if one_in <= 0:
        return False
    digest = hashlib.sha256(text.encode()).digest()
    return int.from_bytes(digest[:8], "big") % one_in == 0
