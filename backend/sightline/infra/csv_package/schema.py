"""The shape of an exported package: described tables, safe cells, and their description for machines.

Nothing here knows what is exported (each slice's `csv.py` does) or touches a disk (`files.py` does); this
file knows how a value becomes a cell (docs/formats.md) and how a Frictionless Data Package describes a file.
"""

import hashlib
import json
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from functools import cached_property
from operator import attrgetter
from typing import Any, Generic, Never

import orjson
from typing_extensions import TypeVar

from sightline.errors import Damaged
from sightline.messages import SOURCE, say_or
from sightline.messages.said import Said

Cell = str | int | float | bool | Said | None
Cells = dict[str, Cell]
Row = Mapping[str, Cell]
#: What a row is made of: a stored record, or a mapping that holds the cells by name.
Record = TypeVar("Record", contravariant=True, default=Row)

#: What a reader has to know to read a package. Another table or column is no other format: packages are read
#: by their own description. Format 1 stated no number; up to format 2 the tables of `TABLES` lay in the root.
FORMAT = 3
CHECKSUMS = "SHA256SUMS"
#: The end of the name of a column with the codes of the words in the column without it.
CODE = "_code"
DESCRIPTION = "datapackage.json"
TABLES, PARQUET = "tables/", "parquet/"
_JSON_FORM = (
    orjson.OPT_INDENT_2 | orjson.OPT_APPEND_NEWLINE | orjson.OPT_NON_STR_KEYS | orjson.OPT_SERIALIZE_NUMPY
)
_FORMULA_STARTS = ("=", "+", "-", "@", "＝", "＋", "－", "＠")
_SKIPPED = " \t\r\n\x00\ufeff\xa0"
_LOOKED_AT = frozenset((*_FORMULA_STARTS, *_SKIPPED))


@dataclass(frozen=True)
class Column(Generic[Record]):
    """One column: `type` is a Frictionless type, `unit` is empty for text and counts.

    `says`: what it means, or, of what a page explains at length, the key of that sentence in the catalogue.
    `of` gives its value of a record; None: what the record has under the column's name, an object as its
    attribute and a mapping as its value.
    """

    name: str
    type: str
    says: str
    unit: str = ""
    required: bool = False
    enum: tuple[str, ...] = ()
    minimum: float | None = None
    of: Callable[[Record], Cell] | None = field(default=None, compare=False, kw_only=True)
    #: The table whose `id` it holds, where its kind says that.
    table: str = field(default="", compare=False, kw_only=True)

    @cached_property
    def meaning(self) -> str:
        """What it means, in English."""
        return say_or(self.says, self.says, SOURCE)

    @cached_property
    def of_object(self) -> Callable[[Record], Cell]:
        """Its value of a record that is no mapping."""
        return self.of or attrgetter(self.name)

    @cached_property
    def of_mapping(self) -> Callable[[Any], Cell]:
        """Its value of a mapping, which may leave it out."""
        name = self.name
        return self.of or (lambda record: record.get(name))

    def described(self) -> dict[str, Any]:
        """The field descriptor of the Table Schema (specs.frictionlessdata.io/table-schema)."""
        constraints: dict[str, Any] = {"required": True} if self.required else {}
        if self.enum:
            constraints["enum"] = list(self.enum)
        if self.minimum is not None:
            constraints["minimum"] = self.minimum
        described: dict[str, Any] = {"name": self.name, "type": self.type, "description": self.meaning}
        if self.unit:
            described["unit"] = self.unit
        if self.type == "datetime":
            described["format"] = "any"
        if constraints:
            described["constraints"] = constraints
        return described


@dataclass(frozen=True)
class Table(Generic[Record]):
    """One CSV file of the package; `foreign` is (my columns, table, its columns), those of columns that say
    their table too.
    """

    name: str
    meaning: str
    columns: tuple[Column[Record], ...]
    primary: tuple[str, ...] = ()
    foreign: tuple[tuple[tuple[str, ...], str, tuple[str, ...]], ...] = ()

    folder: str = TABLES

    def __post_init__(self) -> None:
        held = ids_of(**{one.name: one.table for one in self.columns if one.table})
        more = (one for one in held if one not in self.foreign)
        object.__setattr__(self, "foreign", (*self.foreign, *more))

    @property
    def path(self) -> str:
        return f"{self.folder}{self.name}.csv"

    @property
    def key(self) -> str:
        """What a package of any format knows it by (`table_key`)."""
        return table_key(self.path)

    @property
    def header(self) -> list[str]:
        return [column.name for column in self.columns]

    def schema(self) -> dict[str, Any]:
        """The Table Schema: every column, the missing value, the keys."""
        schema: dict[str, Any] = {
            "fields": [column.described() for column in self.columns],
            "missingValues": [""],
        }
        if self.primary:
            schema["primaryKey"] = list(self.primary)
        if self.foreign:
            schema["foreignKeys"] = [
                {"fields": list(mine), "reference": {"resource": table, "fields": list(theirs)}}
                for mine, table, theirs in self.foreign
            ]
        return schema


def ids_of(**tables: str) -> tuple[tuple[tuple[str, ...], str, tuple[str, ...]], ...]:
    """`foreign` of columns that hold the `id` of a row of a table each."""
    return tuple(((column,), table, ("id",)) for column, table in tables.items())


#: A table whose rows nobody makes here, whatever records they are made of.
AnyTable = Table[Never]


def safe_text(text: str) -> str:
    """The text, with an apostrophe before anything that a spreadsheet would run as a formula.

    Spreadsheets skip leading blanks and control characters before they look for the sign, so this does too.
    """
    if text[:1] not in _LOOKED_AT:  # nearly all: a million rows have fifty million cells
        return text
    bare = text.lstrip(_SKIPPED)
    if bare.startswith(_FORMULA_STARTS) or text[:1] in ("\t", "\r", "\n"):
        return "'" + text
    return text


def table_key(path: str) -> str:
    """A table's path without `TABLES`: the same in packages of every format."""
    return path.removeprefix(TABLES)


def parquet_path(csv_path: str) -> str:
    """Where the Parquet of a table is, by its path or key."""
    return f"{PARQUET}{table_key(csv_path).removesuffix('.csv')}.parquet"


def record_path(kind: str, row_id: int) -> str:
    """Where the whole stored content of a pose or calibration is, as the audit chain vouches for it."""
    return f"records/{kind}-{row_id}.json"


def cell_text(column: Column[Never], value: Cell) -> str:
    """One cell: empty for missing, six decimals for lengths, full precision otherwise (docs/formats.md)."""
    if value is None:
        return ""
    if isinstance(value, str | Said):
        return safe_text(str(value))
    if isinstance(value, float):
        if column.unit != "m":
            return repr(float(value))
        return metres_text(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    return str(value)


def metres_text(length_m: float) -> str:
    """A length to the micrometre; zero has no sign."""
    return f"{length_m:z.6f}"


def json_bytes(value: object) -> bytes:
    """JSON for people and machines: keys as given, two blanks, one line feed at the end.

    Raises ValueError for NaN, infinities and what JSON cannot hold.
    """
    json.dumps(value, allow_nan=False)  # orjson would write null for a number that is none
    try:
        return orjson.dumps(value, option=_JSON_FORM)
    except orjson.JSONEncodeError as error:
        raise ValueError(str(error)) from error


def sha256_hex(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


@dataclass(frozen=True)
class Written:
    """What was written of one file."""

    sha256: str
    size: int


@dataclass(frozen=True)
class Other:
    """A file of the package that is no table: its path, kind and meaning."""

    path: str
    mediatype: str
    meaning: str


@dataclass(frozen=True)
class About:
    """What a package says of itself; `made_with` are the versions that drew its figures and its report."""

    title: str
    description: str
    created: str | None
    made_with: Mapping[str, str]


def tables_described(description: Mapping[str, Any]) -> tuple[AnyTable, ...]:
    """The tables of a package by its own description. Raises KeyError, TypeError for one of another form,
    Damaged for a table that is described twice.
    """
    tables = tuple(_table_of(one) for one in description["resources"] if "schema" in one)
    for key, count in Counter(table.key for table in tables).items():
        if count > 1:
            raise Damaged("csv_package-table-twice", path=key)
    return tables


def _table_of(resource: Mapping[str, Any]) -> AnyTable:
    schema = resource["schema"]
    columns: tuple[Column[Never], ...] = tuple(
        Column(
            column["name"],
            column["type"],
            column["description"],
            column.get("unit", ""),
            required=column.get("constraints", {}).get("required", False),
            enum=tuple(column.get("constraints", {}).get("enum", ())),
            minimum=column.get("constraints", {}).get("minimum"),
        )
        for column in schema["fields"]
    )
    foreign = (
        (tuple(one["fields"]), one["reference"]["resource"], tuple(one["reference"]["fields"]))
        for one in schema.get("foreignKeys", ())
    )
    folder, slash, _ = resource["path"].rpartition("/")
    table = Table(
        name=resource["name"],
        meaning=resource["description"],
        columns=columns,
        primary=tuple(schema.get("primaryKey", ())),
        foreign=tuple(foreign),
        folder=folder + slash,
    )
    if table.path != resource["path"]:
        raise KeyError(resource["path"])
    return table


def description_of(
    about: About, tables: Sequence[AnyTable], others: Sequence[Other], written: Mapping[str, Written]
) -> dict[str, Any]:
    """`datapackage.json`: one resource for every table and document, with the hash and size of its bytes."""
    package: dict[str, Any] = {
        "profile": "data-package",
        "format": FORMAT,
        "name": "sightline-survey",
        "title": about.title,
        "description": about.description,
        "made_with": dict(about.made_with),
        "resources": [
            *(_table_resource(table, written.get(table.path)) for table in tables),
            *(_other_resource(other, written[other.path]) for other in others),
        ],
    }
    if about.created is not None:
        package["created"] = about.created
    return package


def _table_resource(table: AnyTable, written: Written | None) -> dict[str, Any]:
    return {
        "name": table.name,
        "path": table.path,
        "profile": "tabular-data-resource",
        "title": table.name.replace("_", " "),
        "description": table.meaning,
        "format": "csv",
        "mediatype": "text/csv",
        "encoding": "utf-8",
        "dialect": {"delimiter": ",", "lineTerminator": "\n", "header": True},
        **({} if written is None else {"bytes": written.size, "hash": f"sha256:{written.sha256}"}),
        "schema": table.schema(),
    }


def _other_resource(other: Other, written: Written) -> dict[str, Any]:
    stem, _, suffix = other.path.rpartition(".")
    if (
        suffix == "parquet"
    ):  # by its plain name Frictionless takes it for a table to be read, and counts no bytes
        suffix = other.mediatype.rpartition("/")[2]
    return {
        "name": stem.replace("/", "-").replace("_", "-").lower(),
        "path": other.path,
        "profile": "data-resource",
        "description": other.meaning,
        "format": suffix,
        "mediatype": other.mediatype,
        "bytes": written.size,
        "hash": f"sha256:{written.sha256}",
    }


def utc_text(moment: datetime | None) -> str | None:
    """ISO 8601 in UTC, to the microsecond."""
    return None if moment is None else moment.isoformat(timespec="microseconds").replace("+00:00", "Z")
