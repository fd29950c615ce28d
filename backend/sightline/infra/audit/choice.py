"""What somebody chose for a survey and has no table of its own: which of many things are drawn, and others.

The survey's newest audit event of the kind holds it, and so who chose it and when.
"""

import hashlib
import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from sightline.enums import AuditEntity
from sightline.errors import BadInput, Conflict
from sightline.infra.audit import trail
from sightline.infra.audit.tables import audit_events
from sightline.infra.database.rows import get_row
from sightline.infra.database.types import metadata

MOST_ONE_IN = 100


@dataclass(frozen=True, slots=True)
class Kind:
    """What is chosen: the entity of its events, and its name in them."""

    entity: AuditEntity
    name: str


def current_choices(session: Session, kind: Kind, survey_ids: Sequence[int]) -> dict[int, tuple[Any, int]]:
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


@dataclass(frozen=True, slots=True)
class DrawPlan:
    """One in so many of a survey's things is drawn, 0: none; `usual` while nobody chose. `least`: of what may
    be chosen beside 0. `changed`, `refused`: what is said of another version, and of a number out of range.
    """

    kind: Kind
    usual: int
    least: int
    changed: str
    refused: str

    def in_force(self, session: Session, survey_id: int) -> tuple[int, int]:
        """(one in how many, version); version 0 is the usual one. Raises NotFound."""
        get_row(session, metadata.tables["surveys"], survey_id, "survey")
        return current_choices(session, self.kind, [survey_id]).get(survey_id, (self.usual, 0))

    def choose(
        self, session: Session, survey_id: int, one_in: int, *, version: int, actor: int | None
    ) -> tuple[int, int]:
        """From now on one in so many; (that, its version).

        Raises BadInput outside 0 and `least` to 100, Conflict if `version` is not the current one, NotFound.
        """
        before, current = self.in_force(session, survey_id)
        if version != current:
            raise Conflict(self.changed)
        if one_in != 0 and not self.least <= one_in <= MOST_ONE_IN:
            raise BadInput(self.refused, most=MOST_ONE_IN)
        return one_in, choose(session, self.kind, survey_id, before, one_in, actor)


def one_of(text: str, one_in: int) -> bool:
    """Whether a text is the one of `one_in` (none at 0), by its SHA-256, which anybody can compute."""
    if one_in <= 0:
        return False
    digest = hashlib.sha256(text.encode()).digest()
    return int.from_bytes(digest[:8], "big") % one_in == 0
