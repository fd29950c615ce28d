"""Column kinds and the naming rule that every table uses, for SQLite and PostgreSQL alike."""

import json
from collections.abc import Callable, Collection, Iterator, Mapping
from datetime import UTC, datetime
from types import NoneType
from typing import Any, Literal, get_args, get_origin, get_type_hints

from pydantic_core import from_json
from sqlalchemy import (
    Boolean,
    CheckConstraint,
    Column,
    ColumnElement,
    DateTime,
    Dialect,
    Float,
    ForeignKey,
    Integer,
    MetaData,
    String,
    Table,
    Text,
    TypeDecorator,
    true,
)
from sqlalchemy.schema import SchemaItem

from sightline.messages.said import Said

NAMING = {
    "ix": "ix_%(table_name)s_%(column_0_N_name)s",
    "uq": "uq_%(table_name)s_%(column_0_N_name)s",
    "ck": "ck_%(table_name)s_%(constraint_name)s",
    "fk": "fk_%(table_name)s_%(column_0_N_name)s",
    "pk": "pk_%(table_name)s",
}

metadata = MetaData(naming_convention=NAMING)

#: `info` of a column whose rows hold the row that it names: that one may neither go nor become another.
HOLDS = {"holds": True}
# This row rests on the times of the row that is named.
KEEPS_TIMES = {"keeps_times": True}
# This row is nothing without the row that is named, and is taken out with it.
GOES_ALONG = {"goes_along": True}


def needs_media(still: Callable[[Any], ColumnElement[bool]]) -> dict[str, Any]:
    """`info` of a column whose rows, while they are not removed and `still` holds of their columns, need the
    file of the media store that it names.
    """
    return {"needs_media": still}


NEEDS_MEDIA = needs_media(lambda _columns: true())


def now() -> datetime:
    """The present, in UTC."""
    return datetime.now(UTC)


def document_text(value: Any) -> str:
    """The text in which a JSON value is stored: keys sorted, no spaces, no NaN.

    Unlike the canonical text that is hashed, it tells 1.0 from 1 and -0.0 from 0, and holds any integer.
    """
    return json.dumps(
        value,
        sort_keys=True,
        separators=(",", ":"),
        ensure_ascii=False,
        allow_nan=False,
        default=_document_of,
    )


def _document_of(value: object) -> Any:
    if isinstance(value, Said):
        return value.document
    raise TypeError(f"{value!r} is no JSON value")


class UtcDateTime(TypeDecorator[datetime]):
    """An aware UTC datetime; SQLite, which knows no zones, stores it as UTC."""

    impl = DateTime
    cache_ok = True

    def load_dialect_impl(self, dialect: Dialect) -> Any:
        return dialect.type_descriptor(DateTime(timezone=dialect.name != "sqlite"))

    def process_bind_param(self, value: datetime | None, dialect: Dialect) -> datetime | None:
        if value is None:
            return None
        if value.tzinfo is None:
            raise ValueError("a stored time needs its zone")
        utc = value.astimezone(UTC)
        return utc.replace(tzinfo=None) if dialect.name == "sqlite" else utc

    def process_result_value(self, value: datetime | None, dialect: Dialect) -> datetime | None:
        if value is None:
            return None
        return value.replace(tzinfo=UTC) if value.tzinfo is None else value.astimezone(UTC)


class CanonicalJson(TypeDecorator[Any]):
    """A JSON value kept as text, so that what is read is to the bit what was written."""

    impl = Text
    cache_ok = True

    def process_bind_param(self, value: Any, dialect: Dialect) -> str | None:
        return None if value is None else document_text(value)

    def process_result_value(self, value: str | None, dialect: Dialect) -> Any:
        return None if value is None else from_json(value)  # several times quicker than json.loads


class Saying(CanonicalJson):
    """A reason as its code and values, or a list of flags; read as `Said`."""

    cache_ok = True

    def process_result_value(self, value: str | None, dialect: Dialect) -> Any:
        try:
            return self.said(super().process_result_value(value, dialect))
        except ValueError:  # a sentence, as earlier programs stored why a job failed
            return Said.read(value or "")

    @staticmethod
    def said(read: Any) -> Any:
        """What was stored, a text of an earlier program too, as `Said`."""
        return [Said.read(one) for one in read] if isinstance(read, list) else read and Said.read(read)


def numbered_table(name: str, *content: SchemaItem, **more: Any) -> Table:
    """A table with an integer primary key that counts up, `id`."""
    return Table(name, metadata, Column("id", Integer, primary_key=True), *content, **more)


def made_columns() -> tuple[Column[Any], Column[Any]]:
    """When a row was made, and by whom: nobody where the program did it."""
    return Column("created_at", UtcDateTime, nullable=False), Column("created_by", ForeignKey("people.id"))


def changed_columns() -> tuple[Column[Any] | CheckConstraint, ...]:
    """The version of a row that changes, when it was made and last changed, and by whom."""
    return (
        Column("version", Integer, nullable=False),
        *made_columns(),
        Column("updated_at", UtcDateTime, nullable=False),
        Column("updated_by", ForeignKey("people.id")),
        CheckConstraint("version >= 1", name="version_counts"),
    )


def enum_check(column: str, words: Any) -> CheckConstraint:
    """A check that a text column holds one of a Literal's words (or nothing, where it may be empty)."""
    listed = ", ".join(f"'{word}'" for word in get_args(words))
    return CheckConstraint(f"{column} IN ({listed})", name=f"{column}_known")


def columns_for(
    record: type,
    lengths: Mapping[str, int] = {},
    keys: Mapping[str, str] = {},
    *,
    only: str = "",
    left_out: Collection[str] = (),
) -> Iterator[Column[Any] | CheckConstraint]:
    """A column for each field of a record, by its type, with a check for each that is one of some words: for
    all, or for those named in `only`, with a blank between.

    `lengths`: the most characters of texts by name, of others there is no limit; `keys`: which column of
    another table a field names; `left_out`: fields that are no such columns.
    """
    hints = get_type_hints(record)
    for name in only.split() or [name for name in hints if name not in left_out]:
        hint = hints[name]
        of = get_args(hint) if NoneType in get_args(hint) else (hint,)
        kind = next(one for one in of if one is not NoneType)
        plain = ForeignKey(keys[name]) if name in keys else _kind_for(kind, lengths.get(name))
        yield Column(name, plain, nullable=NoneType in of)
        if get_origin(kind) is Literal:
            yield enum_check(name, kind)


def _kind_for(kind: Any, length: int | None) -> Any:
    if get_origin(kind) is Literal:
        return String(20)
    if kind is str:
        return Text if length is None else String(length)
    if kind is Said or get_args(kind) == (Said,):
        return Saying
    return _PLAIN.get(kind, CanonicalJson)


_PLAIN: dict[type, Any] = {int: Integer, float: Float, bool: Boolean, datetime: UtcDateTime}


def columns_of(table: Table, *left_out: str) -> list[Column[Any]]:
    """The columns of `table` without those named."""
    return [column for column in table.columns if column.name not in left_out]
