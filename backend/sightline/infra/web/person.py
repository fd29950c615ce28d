"""A person who signs in."""

from dataclasses import dataclass
from datetime import datetime

from sightline.enums import Role, Scope

#: The numbers of the surveys that a person sees; None: every one.
Seen = frozenset[int] | None


@dataclass(frozen=True, slots=True)
class PersonFacts:
    """What is told of an account."""

    id: int
    name: str
    email: str
    role: Role
    active: bool
    created_at: datetime
    last_seen_at: datetime | None
    has_password: bool


@dataclass(frozen=True, slots=True)
class Person(PersonFacts):
    """An account. `session_key` changes when every signed-in session of theirs must end."""

    session_key: int


@dataclass(frozen=True, slots=True)
class Asking:
    """Who asks: a person, or a program with a token of theirs and its scopes."""

    person: Person
    scopes: tuple[Scope, ...] | None = None
