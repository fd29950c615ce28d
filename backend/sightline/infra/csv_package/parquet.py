"""The tables of a package as Parquet beside their CSV: the same cells, typed, for programs that read columns.

Made from the CSV alone, so that nothing stands in one and not in the other; a check reads both and compares.
Texts are those of the CSV, the apostrophe before a formula included. Units and meanings are the metadata of
each column (Arrow), and the whole Table Schema stands in the file's own as `sightline.schema`.
"""

import json
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import product, zip_longest
from typing import Any, NoReturn

import pyarrow as pa
import pyarrow.csv as arrow_csv
import pyarrow.parquet as pq

from sightline.errors import Damaged
from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.files import Files, Staging, read_header, read_whole
from sightline.infra.csv_package.schema import PARQUET, AnyTable, parquet_path

_TYPES = {
    "integer": pa.int64(),
    "number": pa.float64(),
    "boolean": pa.bool_(),
    "string": pa.string(),
    "datetime": pa.timestamp("us", "UTC"),
}
_BLOCK_BYTES = 8 << 20
_ROWS_AT_ONCE = 65_536
_MOST_ROWS_OF_A_GROUP = 1 << 17
_SCHEMA = b"sightline.schema"
Schema = Mapping[str, Any]  # a Table Schema, as datapackage.json has it


def has_parquet(csv_path: str) -> bool:
    """All described tables but the chain, whose last line names every other file by its hash."""
    return csv_path != AUDIT.path


def write_parquet(staging: Staging, tables: Sequence[AnyTable]) -> None:
    """The Parquet of every table that was written. Raises Damaged for a cell that is not of its type."""
    files = staging.files()
    for table in tables:
        if table.path in staging.written and has_parquet(table.path):
            schema = arrow_schema(table.schema())
            with staging.file(parquet_path(table.path)) as file:
                write_table(file, schema, _csv_batches(files, table.path, schema))


def write_table(file: Any, schema: pa.Schema, batches: Iterable[pa.RecordBatch]) -> None:
    """One Parquet file (Zstandard), whose bytes depend on schema and rows alone."""
    with pq.ParquetWriter(file, schema, compression="zstd") as out:
        for batch in _pieces(batches, _MOST_ROWS_OF_A_GROUP):
            out.write_table(batch, row_group_size=_MOST_ROWS_OF_A_GROUP)


def arrow_schema(schema: Schema) -> pa.Schema:
    """Columns with type, unit and meaning, from a Table Schema."""
    columns = []
    for field in schema["fields"]:
        told = {"description": field["description"], "unit": field.get("unit", "")}
        columns.append(pa.field(field["name"], _TYPES[field["type"]], metadata=told))
    text = json.dumps(schema, ensure_ascii=False, sort_keys=True, separators=(",", ":"))
    return pa.schema(columns, metadata={_SCHEMA: text.encode()})


def check_parquet(files: Files, described: Mapping[str, Schema]) -> int:
    """Every table has its Parquet with the same columns, metadata and cells, and there is no other; how many.

    described: the Table Schema of each CSV by path. Raises Damaged.
    """
    wanted = {parquet_path(path): path for path in described if path in files.paths and has_parquet(path)}
    there = {path for path in files.paths if path.startswith(PARQUET)}
    if there != set(wanted):
        raise Damaged("csv_package-parquet-not-paired", path=min(there ^ set(wanted)))
    for path, csv_path in wanted.items():
        _check_table(files, path, csv_path, arrow_schema(described[csv_path]))
    return len(wanted)


def _check_table(files: Files, path: str, csv_path: str, schema: pa.Schema) -> None:
    try:
        found = pq.ParquetFile(pa.BufferReader(read_whole(files, path)))
        if not found.schema_arrow.equals(schema, check_metadata=True):
            raise Damaged("csv_package-parquet-described-otherwise", path=path)
        pieces = _pieces(found.iter_batches(_ROWS_AT_ONCE, use_threads=False), _ROWS_AT_ONCE)
        told = _pieces(_csv_batches(files, csv_path, schema), _ROWS_AT_ONCE)
        at = 0
        for mine, theirs in zip_longest(pieces, told):
            if mine is None or theirs is None or not mine.equals(theirs):
                _tell_difference(path, csv_path, mine, theirs, at)
            at += mine.num_rows
    except (pa.ArrowException, OSError) as error:
        raise Damaged("csv_package-parquet-unreadable", path=path) from error


def _tell_difference(
    path: str, csv_path: str, mine: pa.Table | None, theirs: pa.Table | None, before: int
) -> NoReturn:
    """Name the first row and column that differ; NaN, which no cell holds, equals nothing."""
    if mine is not None and theirs is not None:
        rows = range(min(mine.num_rows, theirs.num_rows))
        for name, n in product(mine.column_names, rows):
            if mine[name][n] != theirs[name][n]:
                at = before + n + 1
                raise Damaged("csv_package-parquet-not-csv", path=path, csv_path=csv_path, name=name, at=at)
    raise Damaged("csv_package-parquet-other-rows", path=path, csv_path=csv_path)


def _csv_batches(files: Files, path: str, schema: pa.Schema) -> Iterator[pa.RecordBatch]:
    """The rows of one CSV as typed columns; an empty cell is null. Raises Damaged."""
    if read_header(files, path) != schema.names:
        raise Damaged("csv_package-parquet-described-otherwise", path=path)
    with files.open(path) as file:
        try:
            reader = arrow_csv.open_csv(
                pa.PythonFile(file, mode="r"),
                read_options=arrow_csv.ReadOptions(block_size=_BLOCK_BYTES, use_threads=False),
                parse_options=arrow_csv.ParseOptions(newlines_in_values=True),
                convert_options=arrow_csv.ConvertOptions(
                    column_types={field.name: field.type for field in schema},
                    null_values=[""],
                    strings_can_be_null=True,
                    true_values=["true"],
                    false_values=["false"],
                ),
            )
            yield from reader
        except (pa.ArrowException, OSError) as error:
            raise Damaged("csv_package-cell-type", path=path) from error


def _pieces(batches: Iterable[pa.RecordBatch], rows: int) -> Iterator[pa.Table]:
    """The same rows in tables of `rows` each, the last one shorter, however they came."""
    held: list[pa.RecordBatch] = []
    count = 0
    for batch in batches:
        while batch.num_rows:
            part = batch.slice(0, rows - count)
            held.append(part)
            count += part.num_rows
            batch = batch.slice(part.num_rows)
            if count == rows:
                yield _table(held)
                held, count = [], 0
    if held:
        yield _table(held)


def _table(batches: Sequence[pa.RecordBatch]) -> pa.Table:
    """One table, each column in one piece; metadata is compared apart."""
    return pa.Table.from_batches(batches).combine_chunks()
