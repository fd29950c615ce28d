"""Making again what an export derived from its own tables, and comparing: what was replaced is found."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from itertools import islice, zip_longest
from typing import BinaryIO, cast

import cv2
import numpy as np

from sightline.errors import Damaged
from sightline.export.contents import about_of, described, tables_of
from sightline.export.crops import expected_overlay
from sightline.export.derived import drawn
from sightline.export.exclusions import EXCLUSIONS, exclusion_rows
from sightline.export.measured import PackageStatistics, statistics_of
from sightline.export.page import check_page
from sightline.export.report.words import selection_words
from sightline.export.response import RESPONSE, response_rows
from sightline.export.statistics_csv import TABLES, same_cell, statistics_rows
from sightline.export.verify.chain import ReplayedState
from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.files import Files, read_columns, read_header, read_rows, read_whole
from sightline.infra.csv_package.forms import read_json
from sightline.infra.csv_package.parquet import check_parquet
from sightline.infra.csv_package.schema import (
    DESCRIPTION,
    AnyTable,
    Row,
    Table,
    Written,
    cell_text,
    json_bytes,
)
from sightline.messages import languages
from sightline.results.csv import selection_in

_FRAME = re.compile(r"frame(\d+)")


def described_tables(files: Files) -> tuple[AnyTable, ...]:
    """The tables that this program would write, for as many frames as this package has columns for."""
    header = read_header(files, "measurements.csv")
    numbers = [int(found[1]) for name in header if (found := _FRAME.fullmatch(name))]
    return tables_of(max(numbers, default=2))


def check_description(
    files: Files, told: ReplayedState, written: Mapping[str, Written]
) -> tuple[bool, list[str]]:
    """datapackage.json is what this program would say of these files. Returns whether this program also draws
    what drew the figures and the report, and what could not be compared for being of another version.
    """
    try:
        found = read_json(files, DESCRIPTION)
        made_with, language = dict(found["made_with"]), str(found["language"])
    except (KeyError, TypeError) as error:
        raise Damaged("export-cannot-read-take-whole-export-again", description=DESCRIPTION) from error
    words = {name: str(told.survey.get(name, "")) for name in ("name", "site", "description")}
    about = about_of(**words, created=told.moment, only=selection_words(selection_in(files)))
    expected = described(about, language, described_tables(files), written)
    other = {
        name for name in {*made_with, *about.made_with} if made_with.get(name) != about.made_with.get(name)
    }
    expected["made_with"] = found["made_with"]
    notes: list[str] = []
    if list(found) != list(expected):
        raise Damaged("export-another-files-chain-changed", description=DESCRIPTION, name="order")
    for name in sorted({*found, *expected} - {"resources"}):
        if json_bytes(found[name]) == json_bytes(expected[name]):
            continue
        if "sightline" not in other:
            raise Damaged("export-another-files-chain-changed", description=DESCRIPTION, name=name)
        notes.append(f"This version has another {name} for a package.")
    none: dict[str, object] = {}
    for mine, theirs in zip_longest(expected["resources"], found["resources"], fillvalue=none):
        if json_bytes(mine) == json_bytes(theirs):
            continue
        if "sightline" not in other or _sums(mine) != _sums(theirs):
            named = (theirs or mine).get("path", "a file")
            raise Damaged("export-describes-otherwise-program-changed", description=DESCRIPTION, named=named)
        notes.append(f"{mine['path']} is described otherwise by this version.")
    drawn_alike = not other - {"sightline", "page"}
    if drawn_alike and language not in languages():
        raise Damaged("export-another-files-chain-changed", description=DESCRIPTION, name="language")
    if not drawn_alike:
        notes.append("Figures and report were made by another version: not drawn again, but sealed.")
    if notes:
        notes.append(f"The package was made with {made_with.get('sightline')}; verify it with that for more.")
    return drawn_alike, notes


def check_page_again(files: Files, written: Mapping[str, Written]) -> list[str]:
    """The page is the program that the description names and carries these tables; notes. Raises Damaged."""
    made_with = read_json(files, DESCRIPTION)["made_with"]
    return check_page(files, made_with, described_tables(files), written)


def check_tables_again(files: Files) -> int:
    """Each table's Parquet holds what its CSV holds, as datapackage.json describes it; how many."""
    described = read_json(files, DESCRIPTION)["resources"]
    return check_parquet(files, {one["path"]: one["schema"] for one in described if "schema" in one})


def _sums(resource: Mapping[str, object]) -> list[object]:
    return [resource.get(name) for name in ("name", "path", "bytes", "hash")]


def check_statistics(files: Files, *, same_program: bool) -> tuple[PackageStatistics, int, list[str]]:
    """Every exclusion and every statistic computed again from the rows.

    Returns the statistics, how many figures agree, and notes: another program may estimate otherwise, so
    where this one did not make the package a difference is told and not called a change.
    """
    found = statistics_of(files)
    own = {EXCLUSIONS.path: exclusion_rows(files), RESPONSE.path: response_rows(files)}
    rows = {**own, **statistics_rows(found)}
    count, notes = 0, []
    for table in (EXCLUSIONS, RESPONSE, *TABLES):
        try:
            compared = _compare(files, table, rows[table.path])
        except Damaged as difference:
            if same_program:
                raise
            notes.append(f"Another version computed the statistics: {difference.message}")
        else:
            count += compared if table is not EXCLUSIONS else 0
    return found, count, notes


def _compare(files: Files, table: Table, rows: Iterable[Row]) -> int:
    count = 0
    for at, (told, row) in enumerate(zip_longest(read_rows(files, table.path), rows), start=2):
        if told is None or row is None:
            raise Damaged("export-too-rows-changed", path=table.path, value="few" if told is None else "many")
        for column in table.columns:
            found = cell_text(column, row.get(column.name))
            if not same_cell(column, told[column.name], found):
                raise Damaged(
                    "export-line-says-rows-give-one-wrong",
                    path=table.path,
                    at=at,
                    name=column.name,
                    told=told[column.name] or "nothing",
                    found=found or "nothing",
                )
            count += column.type == "number" and found != ""
    return count


class AsOf:
    """A package whose chain ends where its tables end: what came while it was made, its report does not
    tell.
    """

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


def check_drawn(files: Files, as_of: int, found: PackageStatistics, written: dict[str, Written]) -> int:
    """Figures and report drawn again, byte for byte; how many. `as_of`: the last event that they tell of."""
    made = drawn(AsOf(files, as_of), found, written, read_json(files, DESCRIPTION)["language"])
    for path, content in made:
        if path not in files.paths or read_whole(files, path) != content:
            raise Damaged("export-not-one-these-rows-statistics-give", path=path)
    strange = {path for path in files.paths if path.startswith("figures/")} - {path for path, _ in made}
    if strange:
        raise Damaged("export-not-follow-these-statistics-put", strange=min(strange))
    return len(made)


def check_crops(files: Files, written: Mapping[str, Written]) -> int:
    """Crops are those that crops.csv names, of their size, with the points of their measurement; how many.

    Whether a crop shows the frame that it names, only the video can tell.
    """
    there = {path for path in files.paths if path.startswith("crops/")}
    if not there:
        return 0
    measured = _points(files, {id_ for (id_,) in read_columns(files, "crops.csv", ("measurement_id",))})
    count = 0
    for row in read_rows(files, "crops.csv"):
        if not row["file"]:
            continue
        for path in (row["file"], row["overlay"]):
            if path not in there:
                raise Damaged("export-missing-named-twice-crops-csv-take", path=path)
            there.discard(path)
        _check_crop(files, row, measured[row["measurement_id"]], written)
        count += 1
    if there:
        raise Damaged("export-no-row-crops-csv-put", there=min(there))
    return count


def _points(files: Files, wanted: set[str]) -> dict[str, dict[str, str]]:
    return {row["id"]: row for row in read_rows(files, "measurements.csv") if row["id"] in wanted}


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
        raise Damaged("export-crops-csv-other-points-frames-measurement", path=path)
    if written[path].sha256 != row["sha256"]:
        raise Damaged("export-not-one-whose-hash-crops-csv", path=path)
    picture = cv2.imdecode(np.frombuffer(read_whole(files, path), np.uint8), cv2.IMREAD_GRAYSCALE)
    if picture is None or picture.shape != (int(row["height_px"]), int(row["width_px"])):
        raise Damaged("export-no-picture-size-crops-csv-tells", path=path)
    if read_whole(files, row["overlay"]) != expected_overlay(row, measured):
        raise Damaged("export-not-show-points-measurement-changed", overlay=row["overlay"])
