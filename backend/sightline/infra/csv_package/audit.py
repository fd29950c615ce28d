"""The table of the audit chain in the package."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from sightline.infra.csv_package.columns import flag, integer, key, text
from sightline.infra.csv_package.schema import Cell, Table


@dataclass(frozen=True, slots=True)
class Link:
    """An event of the chain; where it is `withheld` only its hashes are told."""

    event: Mapping[str, Cell]
    withheld: bool


def _told(name: str) -> Callable[[Link], Cell]:
    """The text that was hashed, or nothing."""
    return lambda link: None if link.withheld else link.event[name]


AUDIT: Table[Link] = Table(
    "audit",
    "Who did what, when, chained by hash: hash = SHA-256 of previous_hash followed by content_sha256, "
    "content_sha256 = SHA-256 of the canonical JSON (keys sorted, no spaces, empty cells null) of id, at, "
    "actor_id, action, entity, entity_id, survey_id, before and after. Rows of other surveys and of accounts "
    "are links of the chain only: their content is withheld, their hashes can still be computed again.",
    (
        key("id", "audit event", lambda link: link.event["id"]),
        text("at", "when (ISO 8601, UTC), as it was hashed", _told("at")),
        integer("actor_id", "who; empty for the program itself", _told("actor_id")),
        text("action", "what was done", _told("action")),
        text("entity", "to what kind of thing", _told("entity")),
        integer("entity_id", "to which one", _told("entity_id")),
        integer("survey_id", "survey it belongs to", _told("survey_id")),
        text("before", "the thing before, as JSON", _told("before")),
        text("after", "the thing after, as JSON", _told("after")),
        text(
            "previous_hash",
            "hash of the event before",
            lambda link: link.event["previous_hash"],
            required=True,
        ),
        text(
            "content_sha256",
            "hash of this event's content, withheld or not",
            lambda link: link.event["content_sha256"],
            required=True,
        ),
        text("hash", "hash of this event", lambda link: link.event["hash"], required=True),
        flag("withheld", "true where only the hashes are given", lambda link: link.withheld, required=True),
    ),
    primary=("id",),
)
