"""People: accounts, roles, passwords (as hashes made elsewhere) and one-time sign-in links."""

import secrets
from collections.abc import Mapping
from datetime import timedelta
from typing import Any, get_args

from sqlalchemy import func, select
from sqlalchemy import update as sql_update
from sqlalchemy.orm import Session

from sightline.enums import Role
from sightline.errors import BadInput, Conflict, NotSignedIn
from sightline.infra.audit import trail
from sightline.infra.audit.hashing import to_plain_json
from sightline.infra.by_name import record_of
from sightline.infra.database.people import people, sign_in_links
from sightline.infra.database.rows import add_row, change_row, get_row
from sightline.infra.database.types import now
from sightline.infra.web.person import Person
from sightline.people.token_store import list_api_tokens, revoke_api_token, token_hash

LINK_LIFETIME = timedelta(days=7)


def get_person(session: Session, person_id: int) -> Person:
    """One person. Raises NotFound."""
    return _person(get_row(session, people, person_id, "person"))


def get_person_still(session: Session, known: Person) -> Person:
    """The person as they are now. Raises NotSignedIn where the session in which they were `known` is over."""
    person = get_person(session, known.id)
    if not person.active or person.session_key != known.session_key:
        raise NotSignedIn("web-not-signed-in")
    return person


def person_by_email(session: Session, email: str) -> Person | None:
    """The account with this address, whatever its case."""
    query = select(people).where(people.c.email == email.strip().lower())
    row = session.execute(query).mappings().one_or_none()
    return None if row is None else _person(row)


def list_people(session: Session) -> tuple[Person, ...]:
    """Everybody, by name."""
    rows = session.execute(select(people).order_by(func.lower(people.c.name), people.c.id)).mappings()
    return tuple(_person(row) for row in rows)


def create_person(session: Session, *, name: str, email: str, role: Role, actor: int | None) -> Person:
    """A new account without a password; give them a link. Raises Conflict if the address is taken."""
    name, email = _check_person(name, role), email.strip().lower()
    if "@" not in email:
        raise BadInput("people-email-form", email=email)
    if person_by_email(session, email) is not None:
        raise Conflict("people-account-exists", email=email)
    values = {"name": name, "email": email, "role": role, "active": True, "created_at": now()}
    person_id = add_row(session, people, values)
    after = {"name": name, "email": email, "role": role, "active": True}
    trail.record(session, actor, "create", "person", person_id, None, None, after)
    return get_person(session, person_id)


def update_person(
    session: Session, person_id: int, *, name: str, role: Role, active: bool, actor: int | None
) -> Person:
    """Change name, role or access. Raises Conflict for the last admin.

    Switching off ends sessions, one-time links and tokens for good.
    """
    before = get_person(session, person_id)
    name = _check_person(name, role)
    if before.role == "admin" and before.active and not (role == "admin" and active):
        _keep_an_admin(session, person_id)
    change: dict[str, Any] = {"name": name, "role": role, "active": active}
    if before.active and not active:
        change["session_key"] = _another_key(before.session_key)
        _end_links(session, person_id)
        for token in list_api_tokens(session, person_id):
            revoke_api_token(session, person_id, token.id, actor=actor)
    change_row(session, people, person_id, change)
    after = get_person(session, person_id)
    what = trail.changed_fields(to_plain_json(before), to_plain_json(after), ("name", "role", "active"))
    trail.record(session, actor, "update", "person", person_id, None, *what)
    return after


def _keep_an_admin(session: Session, person_id: int) -> None:
    others = select(people.c.id).where(people.c.role == "admin", people.c.active, people.c.id != person_id)
    if session.execute(others).first() is None:
        raise Conflict("people-last-admin")


def password_hash_of(session: Session, person_id: int) -> str | None:
    """The stored hash of the password, None where none was set."""
    found = get_row(session, people, person_id, "person")["password_hash"]
    return None if found is None else str(found)


def set_password(session: Session, person_id: int, hashed: str, *, actor: int | None) -> Person:
    """Store a new hash and end all their other sessions (a new session_key) and one-time links."""
    before = get_person(session, person_id)
    _end_links(session, person_id)
    change_row(
        session, people, person_id, {"password_hash": hashed, "session_key": _another_key(before.session_key)}
    )
    trail.record(session, actor, "set_password", "person", person_id, None)
    return get_person(session, person_id)


def end_sessions(session: Session, person_id: int, *, actor: int | None) -> Person:
    """End every session of a person, on all their devices (a new session_key): signing out."""
    before = get_person(session, person_id)
    change_row(session, people, person_id, {"session_key": _another_key(before.session_key)})
    trail.record(session, actor, "sign_out", "person", person_id, None)
    return get_person(session, person_id)


def _another_key(before: int) -> int:
    """A key that nobody guesses, so that nobody who learned the installation's secret makes a session."""
    while (key := secrets.randbelow(2**31)) == before:
        pass
    return key


def rehash_password(session: Session, person_id: int, before: str, hashed: str) -> None:
    """The same password under newer hash parameters, unless it was changed; not a change, so not an event."""
    same = (people.c.id == person_id, people.c.password_hash == before)
    session.execute(sql_update(people).where(*same).values(password_hash=hashed))


def note_person_seen(session: Session, person_id: int) -> None:
    """Note that they were here now; not an event."""
    change_row(session, people, person_id, {"last_seen_at": now()})


def create_sign_in_link(
    session: Session,
    person_id: int,
    *,
    actor: int | None,
    valid_for: timedelta = LINK_LIFETIME,
    beside_others: bool = False,
) -> str:
    """Make a one-time sign-in link and return its token; only the token's hash is stored.

    Older ones end, now or (`beside_others`) as soon as one of them all is used.
    Raises Conflict for an account that is switched off: the link would hold once it is switched on again.
    """
    person = get_person(session, person_id)
    if not person.active:
        raise Conflict("people-link-switched-off", person=person.name)
    token, moment = secrets.token_urlsafe(32), now()
    if not beside_others:
        _end_links(session, person_id)
    values = {"person_id": person_id, "created_at": moment, "expires_at": moment + valid_for}
    link_id = add_row(session, sign_in_links, {**values, "token_hash": token_hash(token)})
    after = {"person_id": person_id, "email": person.email, "expires_at": moment + valid_for}
    trail.record(session, actor, "create", "sign_in_link", link_id, None, None, after)
    return token


def use_sign_in_link(session: Session, token: str) -> Person:
    """Whose link this is; it works once. Raises NotSignedIn for a used, old or unknown one."""
    refused = NotSignedIn("people-link-used")
    query = select(sign_in_links).where(sign_in_links.c.token_hash == token_hash(token))
    link = session.execute(query).mappings().one_or_none()
    if link is None or link["used_at"] is not None or link["expires_at"] <= now():
        raise refused
    person = get_person(session, link["person_id"])
    if not person.active:
        raise refused
    change_row(session, sign_in_links, link["id"], {"used_at": now()})
    _end_links(session, person.id)
    trail.record(session, person.id, "use", "sign_in_link", link["id"], None)
    return person


def _end_links(session: Session, person_id: int) -> None:
    session.execute(
        sql_update(sign_in_links)
        .where(sign_in_links.c.person_id == person_id, sign_in_links.c.used_at.is_(None))
        .values(expires_at=now())
    )


def _check_person(name: str, role: str) -> str:
    if not name.strip():
        raise BadInput("people-no-name")
    if role not in get_args(Role):
        raise BadInput("people-role-unknown", role=role, roles=", ".join(get_args(Role)))
    return name.strip()


def _person(row: Mapping[Any, Any]) -> Person:
    return record_of(Person, row, has_password=row["password_hash"] is not None)
