"""A write is stored once, however often its request comes: the key of the request lies beside its event.

IETF draft-ietf-httpapi-idempotency-key-header. A key is unique for each person, so the database decides which
of two that come together is the first.
"""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import datetime, timedelta
from functools import cache
from typing import Any

from sqlalchemy import Insert, bindparam, delete, event, insert, select, update
from sqlalchemy.exc import IntegrityError
from sqlalchemy.orm import Session

from sightline.errors import Conflict
from sightline.infra.database.types import now
from sightline.infra.idempotency.request import keyed_request
from sightline.infra.idempotency.tables import idempotency_keys

#: A laptop that was closed over a long weekend still sends what it holds.
KEPT_DAYS = 4
_NOTED = "key_noted"


class DoneBefore(Conflict):
    """The same request was stored already."""

    kind = "done_before"


@dataclass(frozen=True, slots=True)
class Done:
    """A request that stored something, and its answer where that is kept."""

    fingerprint: str
    at: datetime
    status: int | None
    answer: str | None


@dataclass(frozen=True, slots=True)
class Answered:
    """What a request was answered: JSON, or None for an answer without content."""

    person_id: int
    key: str
    status: int
    answer: str | None


def key_to_note(session: Session) -> dict[str, Any] | None:
    """What is stored beside the first event of a request that bears a key; None for later ones, or no key."""
    request = keyed_request()
    if request is None or request.person_id is None or request.stored or session.info.get(_NOTED, False):
        return None
    session.info[_NOTED] = True

    def committed(_session: Session) -> None:
        request.stored = True

    event.listen(session, "after_commit", committed, once=True)
    return {
        "of_person": request.person_id,
        "of_key": request.key,
        "of_fingerprint": request.fingerprint,
        "key_at": request.at,
    }


@cache
def note_key() -> Insert:
    """The statement that stores `key_to_note` beside `of_event`."""
    return insert(idempotency_keys).values(noted_values(bindparam("of_event")))


def noted_values(event_id: Any) -> dict[str, Any]:
    """A row of `key_to_note`, with its event."""
    return {
        "person_id": bindparam("of_person"),
        "key": bindparam("of_key"),
        "fingerprint": bindparam("of_fingerprint"),
        "at": bindparam("key_at"),
        "event_id": event_id,
    }


@contextmanager
def refusing_repeats() -> Iterator[None]:
    """Raises DoneBefore where the key is stored already."""
    try:
        yield
    except IntegrityError as error:
        if idempotency_keys.name not in str(error.orig):
            raise
        raise DoneBefore("request-done-before") from error


def done_with_key(session: Session, person_id: int, key: str) -> Done | None:
    """What a person stored with a key; None where nothing was, or it is forgotten."""
    c = idempotency_keys.c
    found = select(c.fingerprint, c.at, c.status, c.answer).where(c.person_id == person_id, c.key == key)
    row = session.execute(found).mappings().one_or_none()
    return None if row is None else Done(**row)


def keep_answers(session: Session, answers: Sequence[Answered]) -> None:
    """Keep answers for repeats, each beside its key."""
    c = idempotency_keys.c
    kept = update(idempotency_keys).where(c.person_id == bindparam("of_person"), c.key == bindparam("of_key"))
    rows = [
        {"of_person": one.person_id, "of_key": one.key, "status": one.status, "answer": one.answer}
        for one in answers
    ]
    session.connection().execute(kept, rows)


def forget_old_keys(session: Session) -> None:
    """Forget what was stored more than KEPT_DAYS ago: a repeat of it would be a request of its own."""
    session.execute(delete(idempotency_keys).where(idempotency_keys.c.at < now() - timedelta(days=KEPT_DAYS)))
