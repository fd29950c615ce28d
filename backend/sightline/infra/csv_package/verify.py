"""Holding the tables of a package against each other and against what audit events say."""

import json
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from sightline.errors import Damaged
from sightline.infra.audit.hashing import content_hash
from sightline.infra.csv_package.chain import stamp
from sightline.infra.csv_package.files import Files, read_columns, read_rows, read_whole
from sightline.infra.csv_package.replay import first_difference
from sightline.infra.csv_package.schema import AnyTable, record_path

_ELSEWHERE = ("id", "created_at", "document", "columns", "rows")


def check_keys(files: Files, described: Sequence[AnyTable]) -> int:
    """Every key is there once and every foreign key leads somewhere; how many were followed."""
    wanted = {
        (table, columns) for described_table in described for _, table, columns in described_table.foreign
    }
    paths = {table.name: table.path for table in described}
    known = {(table, columns): _keys(files, paths[table], columns) for table, columns in wanted}
    followed = 0
    for described_table in described:
        if described_table.primary:
            _keys(files, described_table.path, described_table.primary)
        for mine, table, theirs in described_table.foreign:
            for values in read_columns(files, described_table.path, mine):
                if all(values) and tuple(values) not in known[table, theirs]:
                    raise Damaged(
                        "csv_package-row-dangling",
                        path=described_table.path,
                        mine=" ".join(mine),
                        values=" ".join(values),
                        table=table,
                    )
                followed += 1
    return followed


def _keys(files: Files, path: str, columns: tuple[str, ...]) -> set[tuple[str, ...]]:
    keys: set[tuple[str, ...]] = set()
    for values in read_columns(files, path, columns):
        key = tuple(values)
        if key in keys:
            raise Damaged(
                "csv_package-twice-one-put", path=path, columns=" ".join(columns), values=" ".join(values)
            )
        keys.add(key)
    return keys


def check_records(
    files: Files,
    kind: str,
    table: AnyTable,
    path_of: Callable[[int], str],
    expected: Mapping[int, str],
    values_of: Callable[[Mapping[str, Any]], Mapping[str, Any]],
) -> None:
    """Each row of a table of what is written once is the record that the chain vouches for.

    `expected`: the hash of each record's content by number; `values_of`: its cells by column. Raises Damaged.
    """
    rows = {int(row["id"]): row for row in read_rows(files, table.key)}
    columns = {column.name: column for column in table.columns}
    if set(rows) != set(expected):
        odd = min(set(rows) ^ set(expected))
        raise Damaged("csv_package-without-event", path=table.key, kind_name=kind, odd=odd)
    for id_, row in rows.items():
        path = record_path(kind, id_)
        record = json.loads(read_whole(files, path))
        if content_hash(record) != expected[id_]:
            raise Damaged("csv_package-event-differs", path=path)
        if json.loads(read_whole(files, path_of(id_))) != record["document"]:
            raise Damaged("csv_package-chain-file-changed", path_of=path_of(id_))
        stamped = [row["created_at"], row["created_by_id"]]
        if stamped != [stamp(record["created_at"]), str(record["created_by"] or "")]:
            raise Damaged("csv_package-author-or-time", path=table.key, kind_name=kind, id=id_, path_2=path)
        values = values_of(record)
        told = {name: text for name, text in row.items() if name not in _ELSEWHERE}
        elsewhere = row.get("document", path_of(id_)) != path_of(id_)
        if elsewhere or first_difference(columns, told, values) is not None:
            raise Damaged(
                "csv_package-differs-one-changed", path=table.key, kind_name=kind, id=id_, path_2=path
            )
