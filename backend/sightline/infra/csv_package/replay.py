"""A row of a package is what its events say: what they say together, and the one comparison with the row.

A slice declares each of its tables of rows that events make (`Replayed`); what follows from other rows,
and what is computed again, it checks by itself on the rows that were held.
"""

import hashlib
from collections import defaultdict
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, cast

from sightline.errors import Damaged
from sightline.infra.audit.hashing import canonical_json
from sightline.infra.csv_package.chain import Event, stamp
from sightline.infra.csv_package.files import Files, read_rows
from sightline.infra.csv_package.schema import CODE, AnyTable, Column, Table, cell_text

#: What the events say of one row, by their own words, with `id`, `deleted`, `created_by_id` (who did the
#: first), and of the last `actor_id` and `event`, its number.
Told = dict[str, Any]
Cells = Mapping[str, Any]
Row = dict[str, str]


@dataclass(frozen=True)
class Replayed:
    """A table whose rows are what the events of `entity` say, in other words where `cells` gives them.

    `within`: the word that names what a row is part of, and the entity of that, with which it is deleted.
    """

    table: AnyTable
    entity: str
    within: tuple[str, str] | None = None
    cells: Callable[[Told], Cells] = field(default=lambda told: told, compare=False)


class Replay:
    """What the events of a chain say of rows, by entity and number. `within`: as `Replayed` has it."""

    def __init__(self, within: Mapping[str, tuple[str, str]]) -> None:
        self._within = within
        self._rows: dict[str, dict[int, Told]] = defaultdict(dict)

    def add(self, event: Event, after: Mapping[str, Any]) -> None:
        """An event of a row that it makes, changes or deletes."""
        actor = int(event["actor_id"]) if event["actor_id"] else None
        told = self.row(event["entity"], int(event["entity_id"]))
        told.setdefault("created_by_id", actor)
        told.update(after, actor_id=actor, event=int(event["number"]))

    def row(self, entity: str, number: int) -> Told:
        """What is said of one row; a new one where nothing was said yet."""
        return self._rows[entity].setdefault(number, {"id": number, "deleted": False})

    def of(self, entity: str) -> Mapping[int, Told]:
        """What is said of every row of a kind, deleted ones too, by number."""
        return self._rows[entity]

    def is_gone(self, entity: str, number: int) -> bool:
        """Whether a row was deleted in the end, or what it is part of; it is then in no table."""
        row = self._rows[entity].get(number)
        if row is None:
            return False
        part_of = self._within.get(entity)
        return bool(row["deleted"]) or (
            part_of is not None and self.is_gone(part_of[1], int(row[part_of[0]]))
        )

    def standing(self, entity: str) -> Iterator[Told]:
        """What is said of the rows of a kind that are not gone."""
        return (told for number, told in self._rows[entity].items() if not self.is_gone(entity, number))

    def hold(self, files: Files, replayed: Replayed) -> Iterator[Row]:
        """The rows of a table, each as its events say (`hold`). Raises Damaged."""
        return hold(files, replayed.table, map(replayed.cells, self.standing(replayed.entity)))


class Digests:
    """What events say of the rows of a table of which a package may have a million: a digest of each, by its
    key, which begins with the entity's number.

    `header`: the columns that the package has. Words whose codes stand beside them, in the package and in
    `table`, are not compared: an event holds the codes, and later versions word them otherwise.
    """

    def __init__(self, table: AnyTable, header: Collection[str]) -> None:
        self._path = table.key
        both = {one.name for one in table.columns} & set(header)
        self._columns = [one for one in table.columns if one.name in both and f"{one.name}{CODE}" not in both]
        self._told: dict[tuple[int, ...], bytes] = {}

    def __contains__(self, key: object) -> bool:
        return key in self._told

    def tell(self, key: tuple[int, ...], *records: Any) -> None:
        """An event says a row of this key, or several; what was said of it before holds no longer."""
        cells = [cell_text(one, one.of_object(record)) for record in records for one in self._columns]
        self._told[key] = _digest(cells)

    def are_told(self, key: tuple[int, ...], *rows: Mapping[str, str]) -> bool:
        """Whether the rows of a key, which is not asked for again, are those that its event says."""
        cells = [row.get(one.name, "") for row in rows for one in self._columns]
        return self._told.pop(key, None) == _digest(cells)

    def hold(self, key: tuple[int, ...], row: Mapping[str, str]) -> None:
        """A row of the package is the one that its event says. Raises Damaged."""
        said = " ".join(map(str, key))
        if key not in self:
            raise Damaged("csv_package-row-without-event", path=self._path, key=said)
        if not self.are_told(key, row):
            raise Damaged("csv_package-event-differs", path=f"{self._path}: row {said}")

    def require_none_left(self, is_gone: Callable[[int], bool]) -> None:
        """Every row that an event says was held, but for those of deleted ones. Raises Damaged."""
        for key in self._told:
            if not is_gone(key[0]):
                raise Damaged("csv_package-row-missing", path=self._path, key=" ".join(map(str, key)))


def _digest(cells: list[str]) -> bytes:
    return hashlib.blake2b(canonical_json(cells).encode(), digest_size=12).digest()


def hold(
    files: Files, table: AnyTable, expected: Iterable[Cells], *, in_order: bool = False
) -> Iterator[Row]:
    """The rows of a table, each compared with what is expected of it by the table's key; none is missing at
    the end and none too many. `in_order`: the rows come as expected, one after another.

    What `expected` does not name, or tells in parts, is not compared, nor a column that a package of another
    version lacks. Raises Damaged.
    """
    columns = {column.name: column for column in table.columns}
    names = () if in_order else table.primary
    wanted = {
        tuple(cell_text(columns[name], one[name]) for name in names) or (str(at),): one
        for at, one in enumerate(expected, start=1)
    }
    for at, row in enumerate(read_rows(files, table.key), start=1):
        key = tuple(row[name] for name in names) or (str(at),)
        told = wanted.pop(key, None)
        if told is None:
            raise Damaged("csv_package-row-without-event", path=table.key, key=" ".join(key))
        name = first_difference(columns, row, told)
        if name is not None:
            said = " ".join(row[each] for each in table.primary) or str(at)
            raise Damaged("csv_package-row-differs", path=table.key, name=name, key=said)
        yield row
    if wanted:
        raise Damaged("csv_package-row-missing", path=table.key, key=" ".join(min(wanted)))


def hold_all(files: Files, table: AnyTable, expected: Iterable[Cells], *, in_order: bool = False) -> None:
    """As `hold`, where nothing else follows from the rows. Raises Damaged."""
    for _ in hold(files, table, expected, in_order=in_order):
        pass


def first_difference(columns: Mapping[str, Column[Any]], row: Mapping[str, str], told: Cells) -> str | None:
    """The first column whose cell is not what is told of it, as it would be written."""
    for name, value in told.items():
        if name in columns and name in row and isinstance(value, str | int | float | None):
            column = columns[name]
            if column.type == "number" and isinstance(value, int):  # RFC 8785 writes 3.0 as 3
                value = float(value)
            text = cell_text(column, value)
            if row[name] not in (text, stamp(text) if column.type == "datetime" else text):
                return name
    return None


def values_of(table: AnyTable, record: object) -> dict[str, Any]:
    """The values of a record's row by column."""
    columns = cast(Table[object], table).columns
    return {column.name: column.of_object(record) for column in columns}
