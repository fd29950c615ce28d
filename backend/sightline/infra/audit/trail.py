"""The audit chain: one event per write, in the same transaction, each hashed with the one before.

hash = sha256(previous_hash + content_sha256), content_sha256 = sha256(the event as canonical JSON, RFC 8785).
Ids leave no gap, the anchor row holds the length and the last hash, and exports carry both, so changed,
missing and cut-off events are all found (`verify`).
"""

import json
from collections.abc import Iterable, Mapping, Sequence
from datetime import date, datetime
from typing import Any

from sqlalchemy import ColumnElement, Row, insert, select, update
from sqlalchemy.orm import Session

from sightline.enums import JsonObject
from sightline.infra.audit.hashing import canonical_json, chain_hash, event_hash, plain
from sightline.infra.audit.records import AuditEvent, AuditHead, Who
from sightline.infra.audit.tables import audit_anchor, audit_events
from sightline.infra.database.engine import lock_chain
from sightline.infra.database.people import people
from sightline.infra.database.types import now

#: What an event is about: the row's id, what it said before and what it says after.
Change = tuple[int | None, Mapping[str, Any] | None, Mapping[str, Any] | None]


def record(
    session: Session,
    actor: int | None,
    action: str,
    entity: str,
    entity_id: int | None,
    survey_id: int | None,
    before: Mapping[str, Any] | None = None,
    after: Mapping[str, Any] | None = None,
) -> int:
    """Append one event to the chain and return its id; call it once in every function that writes."""
    return record_many(session, actor, action, entity, survey_id, [(entity_id, before, after)])


def record_many(
    session: Session,
    actor: int | None,
    action: str,
    entity: str,
    survey_id: int | None,
    changes: Sequence[Change],
) -> int:
    """Append an event for each change, in their order, and return the last one's id."""
    lock_chain(session)
    last = head(session)
    rows: list[dict[str, Any]] = []
    for number, (entity_id, before, after) in enumerate(changes, last.count + 1):
        row = {
            "id": number,
            "at": now().isoformat(timespec="microseconds"),
            "actor_id": actor,
            "action": action,
            "entity": entity,
            "entity_id": entity_id,
            "survey_id": survey_id,
            "before": None if before is None else canonical_json(before),
            "after": None if after is None else canonical_json(after),
            "previous_hash": rows[-1]["hash"] if rows else last.hash,
        }
        rows.append({**row, "hash": chain_hash(row)})
    if not rows:
        return last.count
    session.execute(insert(audit_events), rows)
    session.execute(
        update(audit_anchor).where(audit_anchor.c.id == 1).values(count=rows[-1]["id"], hash=rows[-1]["hash"])
    )
    return last.count + len(rows)


def head(session: Session) -> AuditHead:
    """How long the chain is and its last hash."""
    row = session.execute(select(audit_anchor.c.count, audit_anchor.c.hash)).one()
    return AuditHead(row[0], row[1])


def listing(
    session: Session,
    *,
    survey_id: int | None = None,
    entity: str | None = None,
    actor_id: int | None = None,
    day: date | None = None,
    among: ColumnElement[bool] | None = None,
    before_id: int | None = None,
    limit: int = 100,
) -> tuple[AuditEvent, ...]:
    """Events, newest first, of a person, of a day (UTC), or `among` some; `before_id` turns the page."""
    query = _events().order_by(audit_events.c.id.desc()).limit(min(max(limit, 1), 1000))
    if survey_id is not None:
        query = query.where(audit_events.c.survey_id == survey_id)
    if entity is not None:
        query = query.where(audit_events.c.entity == entity)
    if actor_id is not None:
        query = query.where(audit_events.c.actor_id == actor_id)
    if day is not None:
        query = query.where(audit_events.c.at.startswith(day.isoformat()))
    if among is not None:
        query = query.where(among)
    if before_id is not None:
        query = query.where(audit_events.c.id < before_id)
    return tuple(_event(row) for row in session.execute(query))


def for_export(session: Session, survey_id: int | None = None) -> tuple[AuditEvent, ...]:
    """All events oldest first, of one survey or of all."""
    query = _events().order_by(audit_events.c.id)
    if survey_id is not None:
        query = query.where(audit_events.c.survey_id == survey_id)
    return tuple(_event(row) for row in session.execute(query))


def _events() -> Any:
    return select(audit_events, people.c.name.label("actor_name")).outerjoin(
        people, people.c.id == audit_events.c.actor_id
    )


def _event(row: Row[Any]) -> AuditEvent:
    return AuditEvent(
        id=row.id,
        at=datetime.fromisoformat(row.at),
        actor=None if row.actor_id is None else Who(row.actor_id, row.actor_name or ""),
        action=row.action,
        entity=row.entity,
        entity_id=row.entity_id,
        survey_id=row.survey_id,
        before=_object(row.before),
        after=_object(row.after),
        hash=row.hash,
        previous_hash=row.previous_hash,
        content_sha256=event_hash({column.name: getattr(row, column.name) for column in audit_events.c}),
    )


def _object(text: str | None) -> JsonObject | None:
    return None if text is None else dict(json.loads(text))


def changed(
    before: Mapping[str, Any], after: Mapping[str, Any], keys: Iterable[str]
) -> tuple[JsonObject, JsonObject]:
    """Only what differs, as (before, after) for an event."""
    different = [key for key in keys if plain(before[key]) != plain(after[key])]
    return {key: plain(before[key]) for key in different}, {key: plain(after[key]) for key in different}
