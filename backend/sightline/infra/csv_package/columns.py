"""Columns of the kinds that many tables have. Without a getter a column is its record's attribute of that
name; `columns_within` takes it from a part of the record.
"""

import json
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from datetime import datetime
from operator import attrgetter
from typing import Any, get_args

from typing_extensions import TypeVar

from sightline.errors import Damaged
from sightline.infra.audit.hashing import canonical_json
from sightline.infra.audit.records import Who
from sightline.infra.csv_package.files import Files, read_columns, undo_safe_text
from sightline.infra.csv_package.schema import CODE, Cell, Column, Row, utc_text
from sightline.infra.meaning import Told, read_fields
from sightline.messages import SOURCE, say_or
from sightline.messages.recognised import IN_UTC
from sightline.messages.said import Said

R = TypeVar("R", default=Row)
Getter = Callable[[R], Cell]


#: The unit of a number by the end of its name.
_UNITS = {
    "m": "m",
    "px": "px",
    "s": "s",
    "hz": "Hz",
    "mps": "m/s",
    "mps2": "m/s2",
    "rad": "rad",
    "deg": "deg",
    "percent": "%",
    "bytes": "byte",
}
_KINDS: dict[type, str] = {int: "integer", float: "number", str: "string", bool: "boolean"}


def columns_for(
    record: type[Any], names: str, *, required: bool = False, minimum: float | None = None
) -> tuple[Column[Any], ...]:
    """A column for each of a record's fields named here, with a blank between: type, words, unit and meaning
    are the field's (`infra/meaning.py`).

    `required`: texts are never empty; what is no text is required where the field is never None.
    """
    told = read_fields(record)
    return tuple(one for name in names.split() for one in _columns_for(name, told, required, minimum))


def _columns_for(
    name: str, told: Mapping[str, Told], required: bool, minimum: float | None
) -> tuple[Column[Any], ...]:
    field = told[name.removesuffix("_id") if name not in told else name]
    if field.kind is Who:
        return (person(name, field.says),)
    if field.kind is datetime:
        return (moment(name, field.says),)
    if Said in (field.kind, *get_args(field.kind)):
        return said_columns(name, field.says)
    words = get_args(field.kind)
    kind = "string" if words else _KINDS[field.kind]
    unit = _UNITS.get(name.rpartition("_")[2], "") if kind in ("integer", "number") else ""
    always = not field.optional and (required or field.kind is not str)
    return (Column(name, kind, field.says, unit=unit, required=always, enum=words, minimum=minimum),)


def integer(
    name: str,
    meaning: str,
    of: Getter[R] | None = None,
    *,
    unit: str = "",
    required: bool = False,
    minimum: float | None = None,
) -> Column[R]:
    """A whole number."""
    return Column(name, "integer", meaning, unit=unit, required=required, minimum=minimum, of=of)


def key(name: str, meaning: str, of: Getter[R] | None = None) -> Column[R]:
    """The number of a row, of this table or of another, that is always there."""
    return integer(name, meaning, of, required=True)


def number(
    name: str,
    meaning: str,
    unit: str = "",
    of: Getter[R] | None = None,
    *,
    required: bool = False,
    minimum: float | None = None,
) -> Column[R]:
    """A number with its unit."""
    return Column(name, "number", meaning, unit=unit, required=required, minimum=minimum, of=of)


def metres(name: str, meaning: str, of: Getter[R] | None = None, *, required: bool = False) -> Column[R]:
    """A length, written to the micrometre."""
    return number(name, meaning, "m", of, required=required)


def pixel(name: str, meaning: str, of: Getter[R] | None = None) -> Column[R]:
    """A coordinate in a frame."""
    words = f"{meaning}; (0, 0) is the centre of the top-left pixel"
    return number(name, words, "px", of, required=True)


def text(
    name: str,
    meaning: str,
    of: Getter[R] | None = None,
    *,
    required: bool = False,
    enum: tuple[str, ...] = (),
) -> Column[R]:
    """Words, or one of a closed list of them."""
    return Column(name, "string", meaning, required=required, enum=enum, of=of)


def flag(name: str, meaning: str, of: Getter[R] | None = None, *, required: bool = False) -> Column[R]:
    """True or false."""
    return Column(name, "boolean", meaning, required=required, of=of)


def moment(name: str, meaning: str, of: Callable[[R], datetime | None] | None = None) -> Column[R]:
    """A time in UTC, to the microsecond."""
    given = of or attrgetter(name)
    return instant(name, meaning, lambda record: utc_text(given(record)))


def instant(name: str, meaning: str, of: Getter[R]) -> Column[R]:
    """A time in UTC that the record has as its cell."""
    return Column(name, "datetime", say_or(meaning, meaning, SOURCE) + IN_UTC, of=of)


def person(name: str, meaning: str, of: Callable[[R], Who | None] | None = None) -> Column[R]:
    """The number of a person, who is the record's attribute of the column's name without `_id`."""
    given = of or attrgetter(name.removesuffix("_id"))

    def number_of(record: R) -> Cell:
        who = given(record)
        return None if who is None else who.id

    return replace(integer(name, meaning, number_of), table="people")


def join_sentences(words: Iterable[str]) -> str:
    """Several sentences in one cell."""
    return "; ".join(words)


def said_columns(
    name: str, meaning: str, of: Callable[[Any], Said | Sequence[Said] | None] | None = None
) -> tuple[Column[Any], Column[Any]]:
    """What is said in words, and beside it the codes and values that the words are made of."""
    given = of or attrgetter(name)
    return (
        text(name, meaning, lambda record: words_of(given(record))),
        text(f"{name}{CODE}", f"{name} by code and values (JSON)", lambda record: code_of(given(record))),
    )


def words_of(given: Said | Sequence[Said] | None, language: str = SOURCE) -> str | None:
    """A reason, or several flags with semicolons between."""
    each = [given] if isinstance(given, Said) else given or ()
    return join_sentences(one.sentence(language) for one in each) or None


def code_of(given: Said | Sequence[Said] | None) -> str | None:
    """The same as JSON: an object, or a list of objects."""
    return canonical_json(given) if given else None


def code_in(cell: str) -> Said | None:
    """The one saying that a cell holds. Raises Damaged."""
    found = said_in(cell)
    if isinstance(found, list):
        raise Damaged("csv-package-no-code", cell=cell)
    return found


def said_in(code: str) -> Said | list[Said] | None:
    """What a cell of `code_of` holds. Raises Damaged."""
    if not code:
        return None
    try:
        found = json.loads(code)
        return [Said.read(one) for one in found] if isinstance(found, list) else Said.read(found)
    except (ValueError, TypeError, LookupError, AttributeError) as error:
        raise Damaged("csv-package-no-code", cell=code) from error


def check_words(files: Files, headers: Mapping[str, Collection[str]]) -> None:
    """Cells of words say the codes beside them in this program's words; `headers` by key. Raises Damaged."""
    for path, header in headers.items():
        for code in sorted(name for name in header if name.endswith(CODE)):
            words = code.removesuffix(CODE)
            cells = read_columns(files, path, (words, code)) if words in header else ()
            for row, (told, by) in enumerate(cells, 2):
                if undo_safe_text(told) != (words_of(said_in(by)) or ""):
                    raise Damaged("measurements-words-differ", name=f"{path}:{row}", column=words)


def columns_within(
    part: str | Callable[[Any], Any], *columns: Column[Any], required: bool = True
) -> tuple[Column[Any], ...]:
    """The same columns for records that hold such a record, as the attribute of this name or by a function;
    empty where they hold none.

    `required`: False where they may hold none.
    """
    part_of: Callable[[Any], Any] = attrgetter(part) if isinstance(part, str) else part
    return tuple(_within(part_of, column, required) for column in columns)


def _within(part_of: Callable[[Any], Any], column: Column[Any], required: bool) -> Column[Any]:
    getter = column.of_object

    def of(record: Any) -> Cell:
        held = part_of(record)
        return None if held is None else getter(held)

    return replace(column, required=column.required and required, of=of)
