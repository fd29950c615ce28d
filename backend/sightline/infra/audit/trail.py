"""The audit chains: one event per write, in the same transaction, each hashed with the one before of its
chain.

A survey has a chain of its own; people, catalogue, studies and settings have one each. hash =
sha256(previous_hash + content_sha256), content_sha256 = sha256(the event as canonical JSON, RFC 8785).
Numbers leave no gap, the chain's row holds its length and last hash, checkpoints and exports carry them, so
changed, missing and cut-off events are all found (`verify`).
"""

import json
from collections.abc import Collection, Iterable, Mapping, Sequence
from datetime import date, datetime
from functools import cache
from typing import Any

from sqlalchemy import (
    CTE,
    ColumnElement,
    Row,
    Select,
    Update,
    and_,
    bindparam,
    insert,
    or_,
    select,
    type_coerce,
    update,
)
from sqlalchemy.orm import Session

from sightline.enums import AuditAction, AuditEntity, JsonObject
from sightline.infra.audit.hashing import GENESIS, canonical_json, chain_hash, event_hash, to_plain_json
from sightline.infra.audit.merkle import root_of
from sightline.infra.audit.records import AuditEvent, AuditHead, Who, survey_chain
from sightline.infra.audit.tables import audit_chains, audit_events
from sightline.infra.by_name import record_of
from sightline.infra.database.people import people
from sightline.infra.database.rows import add_rows
from sightline.infra.database.types import columns_of, now
from sightline.infra.idempotency.store import key_to_note, note_key, noted_values, refusing_repeats
from sightline.infra.idempotency.tables import idempotency_keys

#: The chains of what belongs to no survey, by kind; what is not named is a setting.
SETTINGS = "settings"
_CHAINS = {
    "person": "people",
    "sign_in_link": "people",
    "catalogue": "catalogue",
    "study": "studies",
    "study_result": "studies",
    "study_member": "studies",
}
#: The chain of no survey that everybody who signs in may read. Not that of settings: its checkpoints name
#: every survey, its tokens and jobs are other people's.
_FOR_EVERYBODY = "catalogue"
#: What an event is about: the row's id, what it said before and what it says after.
Change = tuple[int | None, Mapping[str, Any] | None, Mapping[str, Any] | None]


def record(
    session: Session,
    actor: int | None,
    action: AuditAction,
    entity: AuditEntity,
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
    action: AuditAction,
    entity: AuditEntity,
    survey_id: int | None,
    changes: Sequence[Change],
) -> int:
    """Append an event for each change to the chain that it belongs to, in their order; the last one's id."""
    chain = chain_of(entity, survey_id)
    last = hold_chain_end(session, chain)
    rows: list[dict[str, Any]] = []
    for number, (entity_id, before, after) in enumerate(changes, last.count + 1):
        row = {
            "chain": chain,
            "number": number,
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
        return 0
    end = {"of_chain": chain, "end_count": rows[-1]["number"], "end_hash": rows[-1]["hash"]}
    note = key_to_note(session)
    with refusing_repeats():
        if len(rows) == 1 and session.get_bind().dialect.name == "postgresql":
            added = session.execute(_add_one(keyed=note is not None), {**rows[0], **end, **(note or {})})
            return int(added.scalar_one())
        ids = add_rows(session, audit_events, rows)
        session.execute(_move_last(), end)
        if note is not None:
            session.execute(note_key(), {**note, "of_event": ids[-1]})
    return ids[-1]


def chain_of(entity: AuditEntity, survey_id: int | None) -> str:
    """The name of the chain that an event belongs to."""
    if survey_id is not None:
        return survey_chain(survey_id)
    return _CHAINS.get(entity, SETTINGS)


def hold_chain_end(session: Session, chain: str) -> AuditHead:
    """The end of a chain, which nobody else adds to before this transaction ends; begun where it is new."""
    row = session.execute(_last_held(), {"of_chain": chain}).one_or_none()
    if row is None:
        session.execute(insert(audit_chains), {"name": chain, "count": 0, "hash": GENESIS})
        return AuditHead(0, GENESIS)
    return AuditHead(row[0], row[1])


@cache
def _last() -> Select[int, str]:
    return select(audit_chains.c.count, audit_chains.c.hash).where(
        audit_chains.c.name == bindparam("of_chain")
    )


@cache
def _last_held() -> Select[int, str]:
    return _last().with_for_update()


@cache
def _move_last() -> Update:
    end = update(audit_chains).values(count=bindparam("end_count"), hash=bindparam("end_hash"))
    return end.where(audit_chains.c.name == bindparam("of_chain"))


@cache
def _add_one(*, keyed: bool) -> Select[int]:
    """An event, its chain's new end and its request's key in one statement, which SQLite does not know."""
    values: dict[str, Any] = {one.name: bindparam(one.name) for one in columns_of(audit_events, "id")}
    added = insert(audit_events).values(values).returning(audit_events.c.id).cte("added")
    ctes: list[CTE] = [_move_last().cte("moved")]
    if keyed:
        noted = noted_values(added.c.id)
        columns = [type_coerce(value, idempotency_keys.c[name].type) for name, value in noted.items()]
        ctes.append(insert(idempotency_keys).from_select(list(noted), select(*columns)).cte("noted"))
    return select(added.c.id).add_cte(*ctes)


def heads(session: Session) -> dict[str, AuditHead]:
    """The end of every chain by its name, in the order of names."""
    c = audit_chains.c
    rows = session.execute(select(c.name, c.count, c.hash))
    return {name: AuditHead(count, hash_) for name, count, hash_ in sorted(tuple(row) for row in rows)}


def head(session: Session, survey_id: int | None = None) -> AuditHead:
    """The end of a survey's chain; of all chains together, how many events they have and their root."""
    if survey_id is not None:
        row = session.execute(_last(), {"of_chain": survey_chain(survey_id)}).one_or_none()
        return AuditHead(0, GENESIS) if row is None else AuditHead(row[0], row[1])
    ends = heads(session)
    return AuditHead(sum(one.count for one in ends.values()), root_of(ends))


def listing(
    session: Session,
    *,
    survey_id: int | None = None,
    entity: str | None = None,
    actor_id: int | None = None,
    day: date | None = None,
    among: ColumnElement[bool] | None = None,
    seen: Collection[int] | None = None,
    before_id: int | None = None,
    limit: int = 100,
) -> tuple[AuditEvent, ...]:
    """Events, newest first, of a person, of a day (UTC), or `among` some; `before_id` turns the page.

    `seen`: only what is of these surveys and of the catalogue.
    """
    query = _events().order_by(audit_events.c.id.desc()).limit(min(max(limit, 1), 1000))
    wanted = {"survey_id": survey_id, "entity": entity, "actor_id": actor_id}
    query = query.where(*(audit_events.c[name] == one for name, one in wanted.items() if one is not None))
    if day is not None:
        query = query.where(audit_events.c.at.startswith(day.isoformat()))
    if among is not None:
        query = query.where(among)
    if seen is not None:
        query = query.where(in_sight(seen))
    if before_id is not None:
        query = query.where(audit_events.c.id < before_id)
    return tuple(_event(row) for row in session.execute(query))


def newest_moment(session: Session) -> datetime | None:
    """When the newest event was written, by the clock of then; None where there is none."""
    query = select(audit_events.c.at).order_by(audit_events.c.id.desc()).limit(1)
    at = session.execute(query).scalar_one_or_none()
    return None if at is None else datetime.fromisoformat(at)


def one_event(session: Session, entity: str, event_id: int) -> AuditEvent | None:
    """One event of this kind; None where there is none."""
    c = audit_events.c
    row = session.execute(_events().where(c.entity == entity, c.id == event_id)).one_or_none()
    return None if row is None else _event(row)


def in_sight(seen: Collection[int]) -> ColumnElement[bool]:
    """Events for whoever sees these surveys; accounts, studies and settings are for administrators."""
    c = audit_events.c
    return or_(c.survey_id.in_(seen), and_(c.survey_id.is_(None), c.chain == _FOR_EVERYBODY))


def _events() -> Any:
    return select(audit_events, people.c.name.label("actor_name")).outerjoin(
        people, people.c.id == audit_events.c.actor_id
    )


def _event(row: Row[Any]) -> AuditEvent:
    return record_of(
        AuditEvent,
        row._mapping,
        at=datetime.fromisoformat(row.at),
        actor=None if row.actor_id is None else Who(row.actor_id, row.actor_name or ""),
        before=object_of(row.before),
        after=object_of(row.after),
        content_sha256=event_hash({column.name: getattr(row, column.name) for column in audit_events.c}),
    )


def object_of(text: str | None) -> JsonObject | None:
    """The JSON object of an event's text, None where there is none."""
    return None if text is None else dict(json.loads(text))


def changed_fields(
    before: Mapping[str, Any], after: Mapping[str, Any], keys: Iterable[str]
) -> tuple[JsonObject, JsonObject]:
    """Only what differs, as (before, after) for an event."""
    different = [key for key in keys if to_plain_json(before[key]) != to_plain_json(after[key])]
    was, now_is = ({key: to_plain_json(one[key]) for key in different} for one in (before, after))
    return was, now_is
