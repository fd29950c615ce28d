"""Audit events, the head of their chain, and what a verification found."""

from dataclasses import dataclass
from datetime import datetime

from sightline.enums import JsonObject
from sightline.messages.said import Said


@dataclass(frozen=True, slots=True)
class Who:
    """A person as others see them."""

    id: int
    name: str


def name_or_somebody(person: Who | None) -> str:
    """A person's name for a sentence."""
    return person.name if person else "Somebody"


def survey_chain(survey_id: int) -> str:
    """The name of a survey's audit chain."""
    return f"survey/{survey_id}"


@dataclass(frozen=True, slots=True)
class AuditEvent:
    id: int
    chain: str
    number: int
    at: datetime
    actor: Who | None
    action: str
    entity: str
    entity_id: int | None
    survey_id: int | None
    before: JsonObject | None
    after: JsonObject | None
    hash: str
    previous_hash: str
    content_sha256: str


@dataclass(frozen=True, slots=True)
class AuditHead:
    """How many events a chain has and the hash of the last; kept outside, it proves nothing was cut off.

    Of all chains: how many events they have together, and the root over their ends (`merkle`).
    """

    count: int
    hash: str


@dataclass(frozen=True, slots=True)
class Verification:
    """The answer of an audit check; `problem` is one sentence, None when all is well."""

    ok: bool
    checked: int
    head_hash: str
    problem: Said | None

    def notes(self) -> list[Said]:
        """What is to be said of how far it holds."""
        return []


@dataclass(frozen=True, slots=True)
class AnchoredVerification(Verification):
    """`vouched`: how many of the events what was kept elsewhere vouches for."""

    vouched: int

    def notes(self) -> list[Said]:
        if self.vouched == self.checked:
            return []
        return [Said("audit-vouched-events", vouched=self.vouched, count=self.checked)]


@dataclass(frozen=True, slots=True)
class Checkpoint:
    """The ends of all chains at one moment, as signed (`by`: who asked, None on the command line)."""

    id: int
    at: datetime
    by: Who | None
    chains: int
    events: int
    root: str
    key: str
    signature: str


@dataclass(frozen=True, slots=True)
class Checkpoints:
    """What an installation signed, newest first, and the key that signs now (None before the first)."""

    key: str | None
    keys_before: int
    newest: tuple[Checkpoint, ...]
