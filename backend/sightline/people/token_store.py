"""API tokens of people: made, listed, revoked; what is stored is their hash."""

import hashlib
import secrets
from collections.abc import Collection, Mapping
from datetime import timedelta
from typing import Any, get_args

from sqlalchemy import func, select
from sqlalchemy.orm import Session

from sightline.enums import Scope
from sightline.errors import BadInput, Conflict
from sightline.infra.audit import trail
from sightline.infra.by_name import record_of
from sightline.infra.database.rows import add_row, change_row, get_row
from sightline.infra.database.types import now
from sightline.infra.web.bearer import BEGINS, ApiToken
from sightline.people.tables import api_tokens

MOST_TOKENS = 50
MOST_DAYS = 366

_t = api_tokens.c


def create_api_token(
    session: Session, person_id: int, *, name: str, scopes: Collection[Scope], days: int
) -> tuple[ApiToken, str]:
    """A new token of the person's own, and its text, which is kept nowhere.

    Raises:
        BadInput: no name, no scope, or a time that is too long.
        Conflict: the person has very many already.
    """
    if not name.strip() or not scopes or not 1 <= days <= MOST_DAYS:
        raise BadInput("people-token-incomplete", most_days=MOST_DAYS)
    moment = now()
    mine = select(func.count()).where(
        _t.person_id == person_id, _t.revoked_at.is_(None), _t.expires_at > moment
    )
    if session.execute(mine).scalar_one() >= MOST_TOKENS:
        raise Conflict("people-token-too-many", most=MOST_TOKENS)
    text = BEGINS + secrets.token_urlsafe(32)
    ordered = [scope for scope in get_args(Scope) if scope in scopes]
    content = {"name": name.strip(), "scopes": ordered, "expires_at": moment + timedelta(days=days)}
    stamps = {"person_id": person_id, "created_at": moment, "token_hash": token_hash(text)}
    token_id = add_row(session, api_tokens, {**content, **stamps})
    trail.record(
        session, person_id, "create", "api_token", token_id, None, None, {"person_id": person_id, **content}
    )
    return get_api_token(session, token_id), text


def get_api_token(session: Session, token_id: int) -> ApiToken:
    """One token. Raises NotFound."""
    return _token(get_row(session, api_tokens, token_id, "token"))


def list_api_tokens(session: Session, person_id: int) -> tuple[ApiToken, ...]:
    """A person's tokens that were not revoked, newest first; those that have ended too."""
    query = (
        select(api_tokens).where(_t.person_id == person_id, _t.revoked_at.is_(None)).order_by(_t.id.desc())
    )
    return tuple(_token(row) for row in session.execute(query).mappings())


def api_token_by_text(session: Session, text: str) -> ApiToken | None:
    """The token that holds: not revoked, not ended."""
    query = select(api_tokens).where(_t.token_hash == token_hash(text))
    row = session.execute(query).mappings().one_or_none()
    if row is None or row["revoked_at"] is not None or row["expires_at"] <= now():
        return None
    return _token(row)


def revoke_api_token(session: Session, person_id: int, token_id: int, *, actor: int | None) -> None:
    """End a token of a person's. Raises NotFound for others' and for one that was revoked."""
    own = _t.person_id == person_id, _t.revoked_at.is_(None)
    row = get_row(session, api_tokens, token_id, "token", *own)
    change_row(session, api_tokens, token_id, {"revoked_at": now()})
    before = {"person_id": person_id, "name": row["name"], "scopes": row["scopes"]}
    trail.record(session, actor, "revoke", "api_token", token_id, None, before, None)


def note_api_token_used(session: Session, token_id: int) -> None:
    """Note that it was used now; not an event."""
    change_row(session, api_tokens, token_id, {"last_used_at": now()})


def token_hash(text: str) -> str:
    """A token is as random as its hash is long: no salt and no slow hash is needed."""
    return hashlib.sha256(text.encode()).hexdigest()


def _token(row: Mapping[Any, Any]) -> ApiToken:
    return record_of(ApiToken, row, scopes=tuple(row["scopes"]))
