"""Records filled from others by the names of their fields: what two of them share is written down once."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields
from operator import attrgetter
from typing import Any, TypeVar

T = TypeVar("T")
_Taker = tuple[list[str], Callable[[object], Iterable[object]]]
_TAKERS: dict[tuple[object, ...], list[_Taker]] = {}  # as many as there are kinds of records


def filled_from(kind: type[T], *records: object, **more: object) -> T:
    """A dataclass with what the records hold under its fields' names, and `more` besides.

    Of two records that hold a name the first counts. Raises TypeError where none holds a field: defaults are
    for those who write a record out, and a fact that is left behind here would not be missed.
    """
    key = (kind, *(type(record) for record in records), *more)
    take = _TAKERS.get(key) or _TAKERS.setdefault(key, _takers(kind, records, more))
    for record, (names, values_of) in zip(records, take, strict=True):
        more.update(zip(names, values_of(record), strict=True))
    return kind(**more)


def record_of(kind: type[T], row: Mapping[Any, Any], **more: object) -> T:
    """A dataclass with what a row holds under its fields' names, and `more` besides. Raises KeyError."""
    record: Any = kind
    names = (one.name for one in fields(record) if one.name not in more)
    return kind(**{name: row[name] for name in names}, **more)


def _takers(kind: Any, records: Iterable[Any], given: Iterable[str]) -> list[_Taker]:
    """Of each record the names that are taken from it, and what takes their values."""
    wanted = [field.name for field in fields(kind) if field.name not in given]
    takers: list[_Taker] = []
    for record in records:
        held = {field.name for field in fields(record)}
        names = [name for name in wanted if name in held]
        wanted = [name for name in wanted if name not in held]
        takers.append((names, _values_getter(names)))
    if wanted:
        raise TypeError(f"{kind.__name__} is filled from records that hold no {', '.join(wanted)}")
    return takers


def _values_getter(names: list[str]) -> Callable[[object], Iterable[object]]:
    """One call for all names of a record: a list of thousands of measurements is an ordinary answer."""
    if len(names) > 1:
        return attrgetter(*names)
    return lambda record: [getattr(record, name) for name in names]
