"""The audit chain of a package: its events, each checked against its hash and the one before."""

from collections.abc import Iterator, Mapping
from typing import Any

from sightline.errors import Damaged
from sightline.infra.audit.hashing import GENESIS, event_hash, link_hash
from sightline.infra.audit.records import survey_chain
from sightline.infra.csv_package.files import Files, read_rows

Event = dict[str, str]
_NUMBERS = ("actor_id", "entity_id", "survey_id")
_TEXTS = ("at", "action", "entity", "before", "after")


def chain(files: Files) -> Iterator[Event]:
    """The events of audit.csv in order, each checked against its hash and the one before. Raises Damaged."""
    before = GENESIS
    for count, row in enumerate(read_rows(files, "audit.csv"), start=1):
        if (row["number"], row["previous_hash"]) != (str(count), before):
            raise Damaged("csv_package-event-not-next", number=row["number"])
        if link_hash(before, row["content_sha256"]) != row["hash"] or not _content_holds(row):
            raise Damaged("csv_package-event-not-hashed", number=count)
        yield row
        before = row["hash"]


def _content_holds(row: Mapping[str, str]) -> bool:
    """What a row tells is what was hashed."""
    values = hashed_values(row)
    as_written = all(row[name] == str(values[name]) for name in ("number", *_NUMBERS) if row[name])
    return as_written and event_hash(values) == row["content_sha256"]


def hashed_values(row: Mapping[str, str]) -> dict[str, Any]:
    """The row as it was hashed: numbers as numbers, empty as nothing."""
    values: dict[str, Any] = {"number": int(row["number"]), **{name: row[name] or None for name in _TEXTS}}
    values |= {name: int(row[name]) if row[name] else None for name in _NUMBERS}
    return {**values, "chain": survey_chain(int(row["survey_id"]))}


def stamp(moment: str | None) -> str:
    """A time as the tables write it."""
    return (moment or "").replace("+00:00", "Z")
