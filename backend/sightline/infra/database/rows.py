"""Small helpers that every aggregate uses."""

from collections.abc import Iterable, Mapping, Sequence
from functools import cache, lru_cache
from typing import Any, TypeVar

from sqlalchemy import Column, ColumnElement, Table, insert, select, update
from sqlalchemy.orm import Session
from sqlalchemy.sql.dml import ReturningInsert

from sightline.errors import NotFound
from sightline.infra.audit.hashing import content_hash
from sightline.infra.audit.records import Who
from sightline.infra.database.people import people
from sightline.infra.database.types import HOLDS, metadata
from sightline.infra.slices import load_tables

Found = TypeVar("Found")


def add_row(session: Session, table: Table, values: Mapping[str, Any]) -> int:
    """Insert one row and return its id."""
    return int(session.execute(_insert(table), dict(values)).scalar_one())


@cache
def _insert(table: Table) -> ReturningInsert[Any]:
    """Made once: making a statement anew takes longer than the database does to answer it."""
    return insert(table).returning(table.c.id)


@cache
def _insert_some(table: Table) -> ReturningInsert[Any]:
    return insert(table).returning(table.c.id, sort_by_parameter_order=True)


def add_rows(session: Session, table: Table, rows: Sequence[Mapping[str, Any]]) -> list[int]:
    """Insert rows that have the same columns and return their ids, in their order; a few statements."""
    if not rows:
        return []
    made = session.execute(_insert_some(table), [dict(row) for row in rows])
    return [int(row_id) for row_id in made.scalars()]


def change_row(session: Session, table: Table, row_id: int, values: Mapping[str, Any]) -> None:
    """Update one row by its id."""
    session.execute(update(table).where(table.c.id == row_id).values(dict(values)))


def get_row(
    session: Session, table: Table, row_id: int, word: str, *also: ColumnElement[bool]
) -> dict[str, Any]:
    """One row as a dict. Raises NotFound in words ("There is no camera 7 ...")."""
    row = session.execute(select(table).where(table.c.id == row_id, *also)).mappings().one_or_none()
    if row is None:
        raise missing(word, row_id)
    return dict(row)


def is_held(
    session: Session, table: Table, row_id: int, ways: tuple[Mapping[str, bool], ...] = (HOLDS,)
) -> bool:
    """Whether a row of another table holds this one in one of these ways."""
    return any(
        session.execute(select(column).where(column == row_id).limit(1)).first() is not None
        for column in named_by(table, ways)
    )


def named_by(table: Table, ways: tuple[Mapping[str, bool], ...]) -> list[Column[Any]]:
    """The columns of other tables that name rows of this one in one of these ways."""
    load_tables()
    every = (column for other in metadata.tables.values() for column in other.columns)
    return [column for column in every if column.info in ways and column.references(table.c.id)]


def named_table(column: Column[Any]) -> Table:
    """The table whose rows a column names."""
    load_tables()
    (key,) = column.foreign_keys
    return key.column.table


def missing(word: str, row_id: int | None = None) -> NotFound:
    """The error for a thing that is not there."""
    number = "" if row_id is None else f" {row_id}"
    return NotFound("database-row-missing", word=word, number=number)


def the_one(found: Sequence[Found], word: str, row_id: int) -> Found:
    """What was found by its number, which is one. Raises NotFound where there is none."""
    if not found:
        raise missing(word, row_id)
    return found[0]


@lru_cache(maxsize=1024)
def who(person_id: int | None, name: str | None) -> Who | None:
    """A person's id and name, where there is one."""
    return None if person_id is None else Who(person_id, name or "")


def names(session: Session, ids: Iterable[int | None]) -> dict[int, str]:
    """The names of some people, in one query."""
    wanted = {one for one in ids if one is not None}
    if not wanted:
        return {}
    found = session.execute(select(people.c.id, people.c.name).where(people.c.id.in_(wanted)))
    return {row.id: row.name for row in found}


def name_of(session: Session, person_id: int | None) -> str:
    """A person's name for a sentence, "the system" for nobody."""
    return names(session, [person_id]).get(person_id or 0, "the system")


def last_change(session: Session, row: Mapping[Any, Any]) -> tuple[str, str]:
    """Who changed a row last, and when, for a sentence."""
    return name_of(session, row["updated_by"]), f"{row['updated_at']:%Y-%m-%d %H:%M:%S} UTC"


def stored_hash(session: Session, table: Table, row_id: int) -> str:
    """The hash of a row's content as the database gives it back; kept in the audit event that made it."""
    row = session.execute(select(table).where(table.c.id == row_id)).mappings().one()
    return row_hash(row)


def stored_hashes(session: Session, table: Table, row_ids: Sequence[int]) -> dict[int, str]:
    """`stored_hash` of some hundred rows, by id."""
    rows = session.execute(select(table).where(table.c.id.in_(row_ids))).mappings()
    return {row["id"]: row_hash(row) for row in rows}


def row_hash(row: Mapping[Any, Any]) -> str:
    """The hash of a row's content."""
    return content_hash(row_content(row))


def row_content(row: Mapping[Any, Any]) -> dict[str, Any]:
    """What is hashed of a row: all but its id."""
    return {str(key): value for key, value in row.items() if key != "id"}
