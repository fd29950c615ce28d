"""What the audit chain vouches for, as tables and slices say it of themselves.

A table carries one of these marks in its `info`; what no row says by itself is a `Fingerprint`, registered
by the slice's `audit_query.py`.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from sqlalchemy import Column, Table
from sqlalchemy.orm import Session
from sqlalchemy.schema import SchemaItem

from sightline.enums import AuditEntity
from sightline.infra.database.types import (
    UtcDateTime,
    changed_columns,
    made_columns,
    metadata,
    numbered_table,
)
from sightline.infra.slices import load_every, load_tables

_KEY = "vouched"


@dataclass(frozen=True, slots=True)
class WrittenOnce:
    """A row never changes, and the event of this entity that made it holds the hash of its content."""

    entity: AuditEntity


@dataclass(frozen=True, slots=True)
class WrittenOnceApart:
    """A row never changes; the fingerprint of this entity says what it must be."""

    fingerprint: str


@dataclass(frozen=True, slots=True)
class ChangedByEvents:
    """Rows that people change, and delete softly: each is what its events made of it, one after the other."""

    entity: AuditEntity


@dataclass(frozen=True, slots=True)
class CarriesHead:
    """A row remembers in `audit_count` and `audit_head` how the chain was: a cut tail is shorter."""


Mark = WrittenOnce | WrittenOnceApart | ChangedByEvents | CarriesHead


@dataclass(frozen=True, slots=True)
class Event:
    """One event of the chain; `after` is empty where it holds nothing."""

    entity: str
    action: str
    entity_id: int | None
    survey_id: int | None
    after: Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Fingerprint:
    """More or less than a row: `promise` notes by number what an event says of it, `stored` what it is."""

    entity: str
    promise: Callable[[Event, dict[int, str]], None]
    stored: Callable[[Session], Iterator[tuple[int, str]]]


_fingerprints: dict[str, Fingerprint] = {}


def vouched_info(mark: Mark) -> dict[str, Any]:
    """The `info` of a table that the chain vouches for."""
    return {_KEY: mark}


def table_written_once(name: str, entity: AuditEntity, *content: SchemaItem) -> Table:
    """A table of rows that never change: a number, `content`, and who made it when (`WrittenOnce`)."""
    return numbered_table(name, *content, *made_columns(), info=vouched_info(WrittenOnce(entity)))


def table_changed_by_events(name: str, entity: AuditEntity, *content: SchemaItem) -> Table:
    """A table of rows that people change and delete softly (`ChangedByEvents`), with what each has."""
    stamps = (*changed_columns(), Column("deleted_at", UtcDateTime))
    return numbered_table(name, *content, *stamps, info=vouched_info(ChangedByEvents(entity)))


def entity_of(table: Table) -> AuditEntity:
    """The entity of the events that a table's rows are made by. Raises TypeError for one that has none."""
    mark = table.info[_KEY]
    if not isinstance(mark, WrittenOnce | ChangedByEvents):
        raise TypeError(f"rows of {table.name} are not made by events")
    return mark.entity


def register(fingerprint: Fingerprint) -> None:
    """Have this checked whenever a chain is verified."""
    _fingerprints[fingerprint.entity] = fingerprint


def fingerprints() -> tuple[Fingerprint, ...]:
    """Those of every slice."""
    load_every("audit_query")
    return tuple(_fingerprints[entity] for entity in sorted(_fingerprints))


def marked_tables() -> list[tuple[Mark, Table]]:
    """Every table with a mark, of every slice."""
    load_tables()
    return [(table.info[_KEY], table) for table in metadata.sorted_tables if _KEY in table.info]
