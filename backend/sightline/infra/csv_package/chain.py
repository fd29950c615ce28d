"""The audit chain of a package: its events, each checked against its hash and the one before."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from sightline.errors import Damaged
from sightline.infra.audit.hashing import event_hash, link_hash
from sightline.infra.csv_package.files import Files, read_rows

Event = dict[str, str]
_CHAINED = ("actor_id", "entity_id", "survey_id")
_TOLD = ("at", "action", "entity", "before", "after")


def chain(files: Files) -> Iterator[Event]:
    """The events of audit.csv, each checked against its hash and the one before. Raises Damaged.

    A withheld event's link is computed again like every other; only its content is taken by its hash.
    """
    before: tuple[int, str] | None = None
    for row in read_rows(files, "audit.csv"):
        number = int(row["id"])
        if before is not None and (number, row["previous_hash"]) != (before[0] + 1, before[1]):
            raise Damaged("csv_package-audit-csv-event-not-follow-one", number=number)
        if link_hash(row["previous_hash"], row["content_sha256"]) != row["hash"] or not _content_holds(row):
            raise Damaged("csv_package-audit-csv-event-not-one-hashed", number=number)
        yield row
        before = number, row["hash"]


def _content_holds(row: Mapping[str, str]) -> bool:
    """What a row tells is what was hashed; a withheld row tells nothing, for nothing would vouch for it."""
    if row["withheld"] == "true":
        return not any(row[name] for name in (*_TOLD, *_CHAINED))
    values = hashed(row)
    as_written = all(row[name] == str(values[name]) for name in ("id", *_CHAINED) if row[name])
    return as_written and event_hash(values) == row["content_sha256"]


def hashed(row: Mapping[str, str]) -> dict[str, Any]:
    """The row as it was hashed: numbers as numbers, empty as nothing."""
    values: dict[str, Any] = {"id": int(row["id"]), **{name: row[name] or None for name in _TOLD}}
    values |= {name: int(row[name]) if row[name] else None for name in _CHAINED}
    return values


def stamp(moment: str | None) -> str:
    """A time as the tables write it."""
    return (moment or "").replace("+00:00", "Z")
