"""What a route answers is a record: a body that says the same fields once more is refused.

A body that comes in has a class of its own: it refuses keys that it does not know, and has limits.
"""

import dataclasses
import importlib
import inspect
import pkgutil
from collections.abc import Iterator
from functools import cache
from types import UnionType
from typing import Annotated, Any, Union, get_args, get_origin, get_type_hints

from pydantic import create_model

import sightline
from sightline.infra.web.bodies import Out
from sightline.surveys.place import Place

# With fewer fields two things may be alike by chance, as a recording's id and name are a person's.
LEAST_FIELDS = 3
# With fewer, a part of a record may be one by chance.
LEAST_SHARED = 6
# Answers whose documents are read as they go out, which a record's are not.
WITH_DOCUMENTS = {"CalibrationBody", "JobBody", "PoseSummaryBody"}


@cache
def classes() -> list[type]:
    """Every class of the package, in the module that makes it."""
    names = [one.name for one in pkgutil.walk_packages(sightline.__path__, "sightline.")]
    modules = [importlib.import_module(name) for name in names if not name.endswith("__main__")]
    return [
        one
        for module in modules
        for one in vars(module).values()
        if inspect.isclass(one) and one.__module__ == module.__name__
    ]


def plain(hint: Any) -> Any:
    """A type without what is said of it: lists and tuples are one, a union has no order."""
    origin, arguments = get_origin(hint), get_args(hint)
    if origin is Annotated:
        return plain(arguments[0])
    if origin in (Union, UnionType):
        return frozenset(map(plain, arguments))
    if origin in (list, tuple):
        return "several", tuple(plain(one) for one in arguments if one is not Ellipsis)
    return (origin, tuple(map(plain, arguments))) if arguments else hint


def names_of(kind: type) -> list[str]:
    """The fields of a body or record."""
    return [*kind.model_fields] if issubclass(kind, Out) else [one.name for one in dataclasses.fields(kind)]


def types_of(kind: type) -> list[Any]:
    """The type of each field, by the fields' names in order."""
    hints = get_type_hints(kind, include_extras=True)
    return [plain(hints[name]) for name in sorted(names_of(kind))]


def copies(bodies: list[type], records: list[type]) -> Iterator[tuple[str, str]]:
    """Each body that is a record once more, with the record."""
    by_names = [(record, sorted(names_of(record))) for record in records]
    for body in bodies:
        names = sorted(names_of(body))
        alike = [record for record, known in by_names if known == names and len(names) >= LEAST_FIELDS]
        yield from (
            (body.__name__, record.__name__) for record in alike if types_of(body) == types_of(record)
        )


def fields_of(kind: type) -> dict[str, Any]:
    """The type of each field by its name."""
    try:
        return dict(zip(sorted(names_of(kind)), types_of(kind), strict=True))
    except (TypeError, NameError):  # of services or functions, which no answer has
        return {}


def parts(bodies: list[type], records: list[type]) -> Iterator[tuple[str, str]]:
    """Each body that writes down once more what it could take over: a record whole, with more beside it, or
    a part of one and nothing else. What is told extends the record, or what is stored extends what is told.
    """
    known = [(record, fields_of(record)) for record in records]
    for body in bodies:
        told = fields_of(body)
        for record, stored in known:
            same = sum(name in stored and stored[name] == kind for name, kind in told.items())
            if same >= LEAST_SHARED and same in (len(told), len(stored)):
                yield body.__name__, record.__name__


def records() -> list[type]:
    return [one for one in classes() if dataclasses.is_dataclass(one)]


def test_no_answer_copies_a_record() -> None:
    bodies = [one for one in classes() if issubclass(one, Out)]
    assert len(bodies) > 50 and len(records()) > 300
    assert list(copies(bodies, records())) == []


def test_no_answer_writes_a_part_of_a_record_once_more() -> None:
    bodies = [one for one in classes() if issubclass(one, Out)]
    assert {body for body, _ in parts(bodies, records())} == WITH_DOCUMENTS


def test_a_planted_copy_is_found() -> None:
    hints = get_type_hints(Place, include_extras=True)
    planted = create_model("PlaceBody", __base__=Out, **{name: (hint, ...) for name, hint in hints.items()})
    assert list(copies([planted], records())) == [("PlaceBody", "Place")]
    longer = create_model("LongerBody", __base__=planted, more=(int, ...))
    assert list(copies([longer], records())) == []
    shorter = create_model(
        "ShorterBody", __base__=Out, **{name: (hints[name], ...) for name in list(hints)[1:]}
    )
    assert list(parts([longer, shorter], [Place])) == [("LongerBody", "Place"), ("ShorterBody", "Place")]
