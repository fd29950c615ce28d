"""Making again what an export derived from its own tables, and comparing: what was replaced is found."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from itertools import zip_longest

import cv2
import numpy as np

from sightline.errors import Damaged
from sightline.export.contents import about_of, others_of, tables_of
from sightline.export.crops import expected_overlay
from sightline.export.derived import drawn
from sightline.export.exclusions import EXCLUSIONS, exclusion_rows
from sightline.export.measured import PackageStatistics, statistics_of
from sightline.export.statistics_csv import TABLES, same_cell, statistics_rows
from sightline.export.verify.chain import ReplayedState
from sightline.infra.csv_package.files import Files, read_columns, read_header, read_rows, read_whole
from sightline.infra.csv_package.schema import (
    DESCRIPTION,
    AnyTable,
    Row,
    Table,
    Written,
    cell_text,
    description_of,
)

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
        found = json.loads(read_whole(files, DESCRIPTION))
        made_with = dict(found["made_with"])
    except (ValueError, KeyError, TypeError) as error:
        raise Damaged(f"{DESCRIPTION} cannot be read; take the whole export again.") from error
    words = {name: str(told.survey.get(name, "")) for name in ("name", "site", "description")}
    about = about_of(**words, created=told.moment)
    expected = description_of(about, described_tables(files), others_of(written), written)
    other = {
        name for name in {*made_with, *about.made_with} if made_with.get(name) != about.made_with.get(name)
    }
    expected["made_with"] = found["made_with"]
    notes = []
    for name in sorted({*found, *expected} - {"resources"}):
        if found.get(name) != expected.get(name):
            raise Damaged(f"{DESCRIPTION} has another {name} than the files and the chain; it was changed.")
    none: dict[str, object] = {}
    for mine, theirs in zip_longest(expected["resources"], found["resources"], fillvalue=none):
        if mine == theirs:
            continue
        if "sightline" not in other or _sums(mine) != _sums(theirs):
            named = (theirs or mine).get("path", "a file")
            raise Damaged(f"{DESCRIPTION} describes {named} otherwise than this program; it was changed.")
        notes.append(f"{mine['path']} is described otherwise by this version.")
    drawn_alike = not other - {"sightline"}
    if not drawn_alike:
        notes.append("Figures and report were made by another version: not drawn again, only summed.")
    if notes:
        notes.append(f"The package was made with {made_with.get('sightline')}; verify it with that for more.")
    return drawn_alike, notes


def _sums(resource: Mapping[str, object]) -> list[object]:
    return [resource.get(name) for name in ("name", "path", "bytes", "hash")]


def check_statistics(files: Files, *, same_program: bool) -> tuple[PackageStatistics, int, list[str]]:
    """Every exclusion and every statistic computed again from the rows.

    Returns the statistics, how many figures agree, and notes: another program may estimate otherwise, so
    where this one did not make the package a difference is told and not called a change.
    """
    found = statistics_of(files)
    rows = {EXCLUSIONS.path: exclusion_rows(files), **statistics_rows(found)}
    count, notes = 0, []
    for table in (EXCLUSIONS, *TABLES):
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
            raise Damaged(f"{table.path} has too {'few' if told is None else 'many'} rows; it was changed.")
        for column in table.columns:
            found = cell_text(column, row.get(column.name))
            if not same_cell(column, told[column.name], found):
                raise Damaged(
                    f"{table.path}, line {at}: {column.name} says {told[column.name] or 'nothing'}, the rows "
                    f"give {found or 'nothing'}; one is wrong."
                )
            count += column.type == "number" and found != ""
    return count


def check_drawn(files: Files, found: PackageStatistics, written: dict[str, Written]) -> int:
    """Figures and report drawn again, byte for byte; how many."""
    made = drawn(files, found, written)
    for path, content in made:
        if path not in files.paths or read_whole(files, path) != content:
            raise Damaged(f"{path} is not the one that these rows and statistics give; it was replaced.")
    strange = {path for path in files.paths if path.startswith("figures/")} - {path for path, _ in made}
    if strange:
        raise Damaged(f"{min(strange)} does not follow from these statistics; it was put in.")
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
                raise Damaged(f"{path} is missing or named twice in crops.csv; take the whole export again.")
            there.discard(path)
        _check_crop(files, row, measured[row["measurement_id"]], written)
        count += 1
    if there:
        raise Damaged(f"{min(there)} is in no row of crops.csv; it was put in.")
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
        raise Damaged(f"crops.csv: {path} has other points or frames than its measurement; one is wrong.")
    if written[path].sha256 != row["sha256"]:
        raise Damaged(f"{path} is not the one whose hash crops.csv holds; it was exchanged.")
    picture = cv2.imdecode(np.frombuffer(read_whole(files, path), np.uint8), cv2.IMREAD_GRAYSCALE)
    if picture is None or picture.shape != (int(row["height_px"]), int(row["width_px"])):
        raise Damaged(f"{path} is no picture of the size that crops.csv tells; it was exchanged.")
    if read_whole(files, row["overlay"]) != expected_overlay(row, measured):
        raise Damaged(f"{row['overlay']} does not show the points of its measurement; it was changed.")
