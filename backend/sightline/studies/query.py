"""What a study reads of its packages: DuckDB over their Parquet, nothing else and no server."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from types import TracebackType
from typing import Any

import duckdb
import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats, Ints
from sightline.enums import StatisticsTarget
from sightline.infra.csv_package.schema import parquet_path
from sightline.results.measured_columns_query import (
    CATEGORIES,
    CLASS_SETS,
    LIGHTING,
    UNCERTAINTY,
    WORDS,
    Heights,
)
from sightline.studies.records import StudiedPackage
from sightline.vehicles.records import BY_SIZE

#: The tables that a study reads of a package, with the columns that figures are made of; others may differ.
READ: dict[str, tuple[str, ...]] = {
    "survey.csv": (),
    "measurements.csv": (
        *("id", "vehicle_id", "target", "pose_id", "withdrawn", "verdict", "height_m"),
        *UNCERTAINTY,
    ),
    "vehicles.csv": (
        *("id", "recording_id", "category", "lighting", "model_chosen_by", "manufacturer_height_m"),
        *("check_target", "counts"),
    ),
    "recordings.csv": ("id", "lighting"),
    "classes.csv": ("category", "class_set"),
}
_MEMORY, _THREADS = "400MB", 2
_COUNTED = "NOT m.withdrawn AND m.height_m IS NOT NULL AND m.verdict IN ('accepted', 'fixed')"


class StudyTables:
    """The tables of many packages as one dataset. Words are codes by the lists of the columns' query."""

    def __init__(self, packages: Sequence[StudiedPackage]) -> None:
        self._db = duckdb.connect(":memory:")
        self._db.execute(
            f"SET memory_limit = '{_MEMORY}'; SET threads = {_THREADS}; SET enable_progress_bar = false"
        )
        self._files = {name: [str(one.tables / parquet_path(name)) for one in packages] for name in READ}
        self._codes(CATEGORIES, "categories")
        self._codes(LIGHTING, "lightings")
        self._codes(CLASS_SETS, "class_sets")
        self._cars()

    def __enter__(self) -> StudyTables:
        return self

    def __exit__(
        self, _kind: type[BaseException] | None, _error: BaseException | None, _trace: TracebackType | None
    ) -> None:
        self._db.close()

    def heights(self, target: StatisticsTarget) -> Heights:
        """The counted heights of one target."""
        lengths = ", ".join(f"CAST(m.{name} AS DOUBLE) AS {name}" for name in ("height_m", *UNCERTAINTY))
        rows = self._numbers(
            f"""
            SELECT c.package AS survey_id, m.id, m.pose_id, c.category, c.lighting, c.class_set, c.known_m,
              {lengths}
            FROM {self._sql("measurements.csv")} m
            JOIN cars c ON c.package = m.file_index AND c.id = m.vehicle_id
            WHERE {_COUNTED} AND m.target = $target
            """,
            target=target,
        )
        columns: dict[str, Any] = {
            name: (_floats if name.endswith("_m") else _ints)(values)
            for name, values in _in_order(rows).items()
            if name != "id"
        }
        return Heights(**columns)

    def vehicles(self) -> tuple[Ints, Ints, Ints]:
        """(package, category, lighting), (V,) each, of every vehicle with a counted height."""
        rows = self._numbers(
            f"""
            SELECT c.package AS survey_id, c.id, c.category, c.lighting FROM cars c
            SEMI JOIN (
              SELECT m.file_index, m.vehicle_id FROM {self._sql("measurements.csv")} m WHERE {_COUNTED}
            ) m ON c.package = m.file_index AND c.id = m.vehicle_id
            """
        )
        rows = _in_order(rows)
        return _ints(rows["survey_id"]), _ints(rows["category"]), _ints(rows["lighting"])

    def counted(self) -> tuple[Ints, Ints]:
        """How many heights count of each package, and how many accepted ones of the traffic do not, for their
        survey does not count what is out of its sample: (P,) each.
        """
        rows = self._numbers(
            f"""
            SELECT m.file_index AS p, count(c.id) AS n, count(*) - count(c.id) AS outside
            FROM {self._sql("measurements.csv")} m
            JOIN {self._sql("vehicles.csv")} v ON v.file_index = m.file_index AND v.id = m.vehicle_id
            LEFT JOIN cars c ON c.package = m.file_index AND c.id = m.vehicle_id
            WHERE {_COUNTED} AND NOT v.check_target GROUP BY 1
            """
        )
        found = np.zeros((2, len(self._files["measurements.csv"])), dtype=np.int64)
        found[:, _ints(rows["p"])] = _ints(rows["n"]), _ints(rows["outside"])
        return found[0], found[1]

    def _codes(self, words: Sequence[str], name: str) -> None:
        self._db.execute(f"CREATE TABLE {name} (word VARCHAR, code TINYINT)")
        self._db.executemany(f"INSERT INTO {name} VALUES (?, ?)", [(word, n) for n, word in enumerate(words)])

    def _cars(self) -> None:
        """Vehicles that count, each by its own survey; one without lighting has its recording's."""
        self._execute(
            f"""
            CREATE TABLE cars AS
            SELECT CAST(v.file_index AS INTEGER) AS package, v.id, coalesce(c.code, -1) AS category,
              coalesce(l.code, -1) AS lighting, coalesce(s.code, -1) AS class_set,
              CASE WHEN v.model_chosen_by IS DISTINCT FROM '{BY_SIZE}' THEN v.manufacturer_height_m END
                AS known_m
            FROM {self._sql("vehicles.csv")} v
            LEFT JOIN {self._sql("recordings.csv")} r ON r.file_index = v.file_index AND r.id = v.recording_id
            LEFT JOIN categories c ON c.word = v.category
            LEFT JOIN lightings l ON l.word = coalesce(v.lighting, r.lighting)
            LEFT JOIN {self._sql("classes.csv")} k ON k.file_index = v.file_index AND k.category = v.category
            LEFT JOIN class_sets s ON s.word = k.class_set
            WHERE v.counts
            """
        )

    def _sql(self, table: str) -> str:
        """A table of all packages, with which of them each row is of."""
        rows = f"read_parquet(${table.removesuffix('.csv')}, union_by_name = true)"
        return f"(SELECT {', '.join(READ[table])}, file_index FROM {rows})"

    def _execute(self, query: str, **values: Any) -> duckdb.DuckDBPyConnection:
        """With the files of the tables that a query names by `_sql`: DuckDB takes no others."""
        files = {name.removesuffix(".csv"): files for name, files in self._files.items()}
        used = {name: value for name, value in files.items() if f"${name}" in query}
        return self._db.execute(query, {**used, **values})

    def _numbers(self, query: str, **values: Any) -> dict[str, NDArray[Any]]:
        found: dict[str, NDArray[Any]] = self._execute(query, **values).fetchnumpy()
        return found


def lacking_in(package: Path) -> tuple[str, str] | None:
    """A table of a package and a column of it that a study reads and that is not there; None: all are."""
    import pyarrow.parquet as pq

    for name, wanted in READ.items():
        there = pq.read_schema(package / parquet_path(name)).names
        for column in wanted:
            if column not in there:
                return name, column
    return None


def unknown_word_in(package: Path) -> tuple[str, str, str] | None:
    """A table of a package, a column of it and a word there that is not known here; None: all are."""
    import pyarrow.parquet as pq

    for name, read in READ.items():
        for column in filter(WORDS.__contains__, read):
            values = pq.read_table(package / parquet_path(name), columns=[column])[column]
            for word in values.unique().to_pylist():
                if word is not None and word not in WORDS[column]:
                    return name, column, str(word)
    return None


def _in_order(rows: dict[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
    """Rows (N,) by package and number, as sums are to be made of them: a database gives them in any order."""
    package, id_ = _ints(rows["survey_id"]), _ints(rows["id"])
    key = package * (int(id_.max(initial=0)) + 1) + id_
    if not np.any(np.diff(key) < 0):
        return rows
    order = np.argsort(key, kind="stable")
    return {name: values[order] for name, values in rows.items()}


def _ints(values: NDArray[Any]) -> Ints:
    return np.asarray(values, dtype=np.int64)


def _floats(values: NDArray[Any]) -> Floats:
    """NaN for null."""
    if isinstance(values, np.ma.MaskedArray):
        return np.asarray(values.filled(np.nan), dtype=np.float64)
    return np.asarray(values, dtype=np.float64)
