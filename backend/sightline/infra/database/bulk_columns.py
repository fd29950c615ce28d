"""Queries of numbers as NumPy columns, fast enough for a million rows.

A value fetched by itself costs a Python object; a million rows of five cost seconds. So the database joins
each column into one value, which NumPy reads at once: text of whole numbers on SQLite, the numbers' own
bytes on PostgreSQL. No digit is lost either way.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sqlalchemy import (
    BigInteger,
    Column,
    ColumnElement,
    Float,
    LargeBinary,
    Select,
    cast,
    func,
    literal,
    select,
)
from sqlalchemy.orm import Session

Values = NDArray[Any]  # float64 or int64

_AT_ONCE = 2**19  # rows: some 10 MB a column
# A length of 1/16 to 64 m is a whole number of 2^-56 m and travels as one; a shorter one is right to 2^-57 m.
_SCALE = 2.0**56
_FAR = 2**62
_MISSING = 1 - 2**63


def columns(session: Session, query: Select[Any], by: Column[int]) -> list[Values]:
    """The columns (N,) of a query, ascending by the id `by`: float64 for floating point, else int64.

    NULL becomes NaN in columns of floating point; those of whole numbers must have none.
    """
    whole = [not isinstance(column.type, Float) for column in query.selected_columns]
    parts = [[np.empty(0, np.int64 if one else np.float64) for one in whole]]
    ordered = query.add_columns(by.label("row_id")).order_by(by).limit(_AT_ONCE)
    found, last = _some(session, ordered, whole)
    while last is not None:
        parts.append(found)
        if len(found[0]) < _AT_ONCE:
            break
        found, last = _some(session, ordered.where(by > last), whole)
    return [np.concatenate(column) for column in zip(*parts, strict=True)]


def _some(session: Session, query: Select[Any], whole: Sequence[bool]) -> tuple[list[Values], int | None]:
    """The columns of a query that ends with the row's id, without it, and the last id; None: no row."""
    rows = query.subquery().c
    sqlite = session.get_bind().dialect.name == "sqlite"
    join, read = (_text, _of_text) if sqlite else (_bytes, _of_bytes)
    joined = [join(column, one) for column, one in zip(rows, whole, strict=False)]
    told = select(*joined, func.max(rows.row_id))
    # Written out, for SQLite takes half as long again with parameters; all are this program's own.
    written = str(told.compile(session.get_bind(), compile_kwargs={"literal_binds": True}))
    *sent, last = session.connection().exec_driver_sql(written).one()
    if last is None:
        return [], None
    found = [read(one, is_whole) for one, is_whole in zip(sent, whole, strict=True)]
    there = [one for one in found if one is not None]
    return there if len(there) == len(found) else _row_by_row(session, query, whole), last


def _text(column: ColumnElement[Any], is_whole: bool) -> ColumnElement[Any]:
    """One text of a column's numbers, with spaces between."""
    scaled = column if is_whole else func.coalesce(cast(column * _SCALE, BigInteger), _MISSING)
    return func.group_concat(scaled, " ")


def _of_text(text: str, is_whole: bool) -> Values | None:
    """The numbers of a text; None if a length is too great for the scale."""
    numbers = np.fromstring(text, np.int64, sep=" ")
    if is_whole:
        return numbers
    missing = numbers == _MISSING
    if np.any(((numbers >= _FAR) | (numbers <= -_FAR)) & ~missing):
        return None
    return np.where(missing, np.nan, numbers / _SCALE)


def _row_by_row(session: Session, query: Select[Any], whole: Sequence[bool]) -> list[Values]:
    """The slow way, for numbers that the scale does not hold."""
    kinds = (np.int64 if one else np.float64 for one in whole)
    rows = zip(*session.execute(query), strict=True)
    return [np.array(values, dtype=kind) for values, kind in zip(rows, kinds, strict=False)]


def _bytes(column: ColumnElement[Any], is_whole: bool) -> ColumnElement[Any]:
    """The numbers of a column in a row, eight bytes each, the high one first."""
    nan = cast(literal("NaN"), Float(53))
    sent = (
        func.int8send(cast(column, BigInteger)) if is_whole else func.float8send(func.coalesce(column, nan))
    )
    return func.string_agg(sent, cast(literal(""), LargeBinary))


def _of_bytes(data: bytes, is_whole: bool) -> Values:
    return np.frombuffer(data, ">i8" if is_whole else ">f8").astype("i8" if is_whole else "f8")
