"""What somebody chose for a survey and has no table of its own.

The survey's newest audit event of the kind holds it, and so who chose it and when.
"""

import hashlib
import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from sightline.infra.audit import trail
from sightline.infra.audit.tables import audit_events


@dataclass(frozen=True, slots=True)
class Kind:
    """What is chosen: the entity of its events, and its name in them."""

    entity: str
    name: str


def chosen(session: Session, kind: Kind, survey_ids: Sequence[int]) -> dict[int, tuple[Any, int]]:
    """(what is in force, its version) by survey, of those for which somebody chose."""
    e = audit_events.c
    of_kind = (e.entity == kind.entity, e.entity_id.in_(survey_ids))
    newest = select(func.max(e.id)).where(*of_kind).group_by(e.entity_id)
    rows = session.execute(select(e.id, e.entity_id, e.after).where(e.id.in_(newest)))
    return {row.entity_id: (json.loads(row.after)[kind.name], row.id) for row in rows}


def choose(session: Session, kind: Kind, survey_id: int, before: Any, after: Any, actor: int | None) -> int:
    """Put it in force; its version."""
    then, now = ({kind.name: value} for value in (before, after))
    return trail.record(session, actor, "choose", kind.entity, survey_id, survey_id, then, now)


def one_of(text: str, one_in: int) -> bool:
    """Whether a text is the one of `one_in` (none at 0), by its SHA-256, which anybody can compute."""
    if one_in <= 0:
        return False
    digest = hashlib.sha256(text.encode()).digest()
    return int.from_bytes(digest[:8], "big") % one_in == 0
