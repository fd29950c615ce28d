"""What a field of a record means, told once: the API's description of it, and its column in a package.

It stands at the field (`Field(description=...)`), or, where a package's page explains the column in several
languages, in the catalogue, under the name of the record's table (`explained_as`). A field has both where
the answer is another thing than the package: then the API says the field's.
"""

from collections.abc import Callable
from dataclasses import dataclass
from types import NoneType
from typing import Annotated, Any, TypeVar, get_args, get_origin, get_type_hints

from pydantic import GetJsonSchemaHandler
from pydantic.fields import FieldInfo
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema

from sightline.infra.audit.records import Who
from sightline.messages import SOURCE, say_or

R = TypeVar("R")


@dataclass(frozen=True)
class Meaning:
    """That of a field, by its key; none where the catalogue has no such key."""

    key: str

    def __get_pydantic_json_schema__(
        self, core: CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchemaValue:
        """The field's schema with its description."""
        schema = handler(core)
        said = say_or(self.key, "", SOURCE)
        return {"description": f"{said[:1].upper()}{said[1:]}.", **schema} if said else schema


def explained_as(table: str) -> Callable[[type[R]], type[R]]:
    """Fields of a dataclass, which this stands under, mean what the catalogue says of a table's columns."""

    def explain(record: type[R]) -> type[R]:
        for name, hint in record.__annotations__.items():
            column = f"{name}_id" if Who in (hint, *get_args(hint)) else name
            meaning = Meaning(f"column-{table}-{column.replace('_', '-').lower()}")
            record.__annotations__[name] = Annotated[hint, meaning]
        return record

    return explain


@dataclass(frozen=True)
class Told:
    """What a field's type tells: its `kind`, a list's too; whether it may be None; what a column says of it,
    as its text or key.
    """

    kind: Any
    optional: bool
    says: str


def read_fields(record: type[Any]) -> dict[str, Told]:
    """What the types of a record's fields tell, by name."""
    hints = get_type_hints(record, include_extras=True)
    return {name: _read_hint(hint) for name, hint in hints.items()}


def _read_hint(hint: Any) -> Told:
    plain, *said = get_args(hint) if get_origin(hint) is Annotated else (hint,)
    some = [one for one in get_args(plain) if one is not NoneType]
    optional = NoneType in get_args(plain)
    keys = [one.key for one in said if isinstance(one, Meaning) and say_or(one.key, "", SOURCE)]
    described = [one.description for one in said if isinstance(one, FieldInfo) and one.description]
    says = (*keys, *map(_as_column, described), "")[0]
    return Told(kind=some[0] if optional else plain, optional=optional, says=says)


def _as_column(description: str) -> str:
    """A description as a column says it: no sentence."""
    words = description.removesuffix(".")
    return words[0].lower() + words[1:] if words[1:2].islower() or words[1:2] == " " else words
