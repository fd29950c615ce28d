"""Making again what an export derived from its own tables, and comparing: what was replaced is found."""

import tempfile
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from itertools import islice, zip_longest
from typing import BinaryIO, cast

import cv2
import numpy as np

from sightline.arrays import Ints
from sightline.errors import BadInput, Damaged
from sightline.export.crops import expected_overlay
from sightline.export.derived import draw_derived_files
from sightline.export.exclusions import EXCLUSIONS, exclusion_rows
from sightline.export.measured import PackageStatistics, statistics_of
from sightline.export.response import RESPONSE, response_rows
from sightline.export.statistics_csv import TABLES, same_cell, statistics_rows
from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.files import Files, columns_lacking, read_columns, read_rows, read_whole
from sightline.infra.csv_package.schema import Row, Table, Written, cell_text
from sightline.measurements.csv import CLICKS, CLICKS_FOLDER


def check_statistics(files: Files, *, same_program: bool) -> tuple[PackageStatistics | None, int, str]:
    """Every exclusion and every statistic computed again from the rows.

    Returns the statistics, how many figures agree, and, where another program made them and they do not
    agree, what differs: no change is to be seen in that.
    """
    try:
        statistics = statistics_of(files)
        own = {EXCLUSIONS.key: exclusion_rows(files), RESPONSE.key: response_rows(files)}
        rows = {**own, **statistics_rows(statistics)}
        compared = {
            table.key: _compare(files, table, rows[table.key]) for table in (EXCLUSIONS, RESPONSE, *TABLES)
        }
        _check_clicks(files, statistics.evaluated)
    except (Damaged, BadInput, LookupError, ValueError, TypeError) as difference:
        if same_program:
            raise
        return None, 0, getattr(difference, "message", "") or repr(difference)
    return statistics, sum(count for path, count in compared.items() if path != EXCLUSIONS.key), ""


def _check_clicks(files: Files, evaluated: Ints) -> None:
    """Every file of clicks says which heights the statistics evaluate. Raises Damaged."""
    if "error_counts" in columns_lacking(files, CLICKS.key):
        return
    numbers = set(evaluated.tolist())
    alone = sorted(path for path in files.paths if path.startswith(CLICKS_FOLDER))
    for path in (CLICKS.key, *alone):
        columns = read_columns(files, path, ("id", "check_target", "counts", "error_counts"))
        for at, (id_, check, *stated) in enumerate(columns, start=2):
            is_in = int(id_.removeprefix("m")) in numbers
            expected = [str(one).lower() for one in (is_in and check == "false", is_in)]
            if stated != expected:
                raise _line_differs(path, at, "counts, error_counts", ", ".join(stated), ", ".join(expected))


def _compare(files: Files, table: Table, rows: Iterable[Row]) -> int:
    count, lacks = 0, columns_lacking(files, table.key)
    columns = [column for column in table.columns if column.name not in lacks]
    for at, (stored, row) in enumerate(zip_longest(read_rows(files, table.key), rows), start=2):
        if stored is None or row is None:
            raise Damaged(
                "export-too-rows-changed", path=table.key, value="few" if stored is None else "many"
            )
        for column in columns:
            expected = cell_text(column, column.of_mapping(row))
            if not same_cell(column, stored[column.name], expected):
                raise _line_differs(table.key, at, column.name, stored[column.name], expected)
            count += column.type == "number" and expected != ""
    return count


def _line_differs(path: str, at: int, name: str, told: str, found: str) -> Damaged:
    told, found = told or "nothing", found or "nothing"
    return Damaged("export-line-differs", path=path, at=at, name=name, told=told, found=found)


class AsOf:
    """A package whose chain ends where its tables end: what came meanwhile, its report does not tell."""

    def __init__(self, files: Files, as_of: int) -> None:
        self._files, self._events = files, as_of
        self.paths = files.paths

    @contextmanager
    def open(self, path: str) -> Iterator[BinaryIO]:
        """One file's bytes from the start."""
        with self._files.open(path) as file:
            if path != AUDIT.path:
                yield file
                return
            with tempfile.TemporaryFile() as shorter:
                shorter.writelines(islice(file, 1 + self._events))
                shorter.seek(0)
                yield cast(BinaryIO, shorter)


def check_drawn(
    files: Files, as_of: int, found: PackageStatistics, written: dict[str, Written], language: str
) -> int:
    """Figures and report drawn again, byte for byte; how many. `as_of`: the last event that they tell of."""
    redrawn = draw_derived_files(AsOf(files, as_of), found, written, language)
    for path, content in redrawn:
        if path not in files.paths or read_whole(files, path) != content:
            raise Damaged("export-drawn-file-differs", path=path)
    strange = {path for path in files.paths if path.startswith("figures/")} - {path for path, _ in redrawn}
    if strange:
        raise Damaged("export-statistics-file-added", strange=min(strange))
    return len(redrawn)


def check_crops(files: Files, written: Mapping[str, Written]) -> int:
    """Crops are those that crops.csv names, of their size, with the points of their measurement; how many.

    Whether a crop shows the frame that it names, only the video can tell.
    """
    there = {path for path in files.paths if path.startswith("crops/")}
    if not there:
        return 0
    wanted = {id_ for (id_,) in read_columns(files, "crops.csv", ("measurement_id",))}
    measured = {row["id"]: row for row in read_rows(files, "measurements.csv") if row["id"] in wanted}
    count = 0
    for row in read_rows(files, "crops.csv"):
        if not row["file"]:
            continue
        for path in (row["file"], row["overlay"]):
            if path not in there:
                raise Damaged("export-crop-missing", path=path)
            there.discard(path)
        _check_crop(files, row, measured[row["measurement_id"]], written)
        count += 1
    if there:
        raise Damaged("export-crop-added", there=min(there))
    return count


def _check_crop(
    files: Files, row: Mapping[str, str], measured: Mapping[str, str], written: Mapping[str, Written]
) -> None:
    path = row["file"]
    k = "" if row["k"] == "1" else row["k"]
    frame = measured["frame"] if not k else measured[f"frame{k}"]
    same = (row["frame"], row["recording_id"]) == (frame, measured["recording_id"])
    for word in ("contact", "target"):
        for axis in "xy":
            inside = float(measured[f"{word}{k}_{axis}_px"]) - int(row[f"{axis}_px"])
            same = same and float(row[f"{word}_{axis}_px"]) == inside
    if not same:
        raise Damaged("export-crop-points-differ", path=path)
    if written[path].sha256 != row["sha256"]:
        raise Damaged("export-crop-hash", path=path)
    picture = cv2.imdecode(np.frombuffer(read_whole(files, path), np.uint8), cv2.IMREAD_GRAYSCALE)
    if picture is None or picture.shape != (int(row["height_px"]), int(row["width_px"])):
        raise Damaged("export-crop-size", path=path)
    if read_whole(files, row["overlay"]) != expected_overlay(row, measured):
        raise Damaged("export-overlay-points", overlay=row["overlay"])
