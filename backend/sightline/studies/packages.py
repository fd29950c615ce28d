"""The packages of a study: found, verified, told apart, and refused in one sentence where they do not fit."""

import json
import shutil
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

from sightline.errors import BadInput, Damaged
from sightline.export.seal import read_seal
from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.files import Files, open_package, read_rows
from sightline.infra.csv_package.schema import CHECKSUMS, DESCRIPTION, parquet_path
from sightline.results.usual_standards import standards_in
from sightline.studies.query import READ, lacking_in, unknown_word_in
from sightline.studies.records import StudiedPackage

#: Checks a package; the sentence that says what is wrong, or None.
Check = Callable[[Files], str | None]


def found_places(named: Iterable[Path]) -> list[Path]:
    """Packages by names of folders and ZIPs; another folder: all packages below. Raises BadInput for none."""
    places: list[Path] = []
    for place in named:
        if place.is_file() or (place / CHECKSUMS).is_file():
            places.append(place)
            continue
        below = [one.parent for one in place.rglob(CHECKSUMS)] + list(place.rglob("*.zip"))
        if not below:
            raise BadInput("studies-no-package-there", place=place)
        places += sorted(below)
    return places


def refuse_output(output: Path, places: Sequence[Path]) -> None:
    """Raises BadInput where a study would take the place of a package, or lie within one of `places`."""
    inside = {place.resolve() for place in places if place.is_dir()}
    around = {one.resolve() for one in (output, *output.absolute().parents)}
    if (output / AUDIT.path).is_file() or inside & around:
        raise BadInput("studies-output-in-package", place=output)


def read_packages(places: Sequence[Path], check: Check, scratch: Path) -> list[StudiedPackage]:
    """Every package, verified by `check`, its tables where DuckDB reads them (a ZIP's in `scratch`).

    Raises BadInput for one that does not pass, lacks what a study reads, or is given twice in whatever form.
    """
    packages = [_studied(place, check, scratch / str(n)) for n, place in enumerate(places)]
    _refuse_twice(packages)
    return packages


def _studied(place: Path, check: Check, scratch: Path) -> StudiedPackage:
    files = open_package(place)
    problem = check(files)
    if problem is not None:
        raise BadInput("studies-package-unverified", place=place, problem=problem)
    try:
        return _read_package(place, files, scratch)
    except Damaged as error:
        raise BadInput("studies-package-unverified", place=place, problem=error.message) from error


def _read_package(place: Path, files: Files, scratch: Path) -> StudiedPackage:
    for name in READ:
        if parquet_path(name) not in files.paths:
            raise BadInput("studies-package-without-parquet", place=place)
    if not any(True for _ in read_rows(files, "poses.csv")):
        raise BadInput("studies-survey-without-poses", place=place)
    tables = place if place.is_dir() else _unpacked(files, scratch)
    row = next(read_rows(files, "survey.csv"))
    with files.open(DESCRIPTION) as file:
        made_with = str(json.load(file)["made_with"]["sightline"])
    if lacking := lacking_in(tables):
        table, column = lacking
        raise BadInput(
            "studies-package-lacks-column", place=place, version=made_with, table=table, column=column
        )
    if unknown := unknown_word_in(tables):
        table, column, word = unknown
        raise BadInput(
            "studies-package-word-unknown",
            place=place,
            version=made_with,
            table=table,
            column=column,
            word=word,
        )
    first = next(read_rows(files, "audit.csv"))
    seal = read_seal(files)
    return StudiedPackage(
        place=str(place),
        name=row["name"],
        site=row["site"] or row["name"],
        simulated=row.get("simulated") == "true",
        made_with=made_with,
        standards=standards_in(files),
        seal=seal.before_sha256,
        tables=tables,
        survey=first["hash"],
    )


def _unpacked(files: Files, scratch: Path) -> Path:
    for name in READ:
        target = scratch / parquet_path(name)
        target.parent.mkdir(parents=True, exist_ok=True)
        with files.open(parquet_path(name)) as source, target.open("wb") as out:
            shutil.copyfileobj(source, out)
    return scratch


def _refuse_twice(packages: Sequence[StudiedPackage]) -> None:
    known: dict[str, StudiedPackage] = {}
    for package in packages:
        if package.survey in known:
            raise BadInput(
                "studies-same-survey-twice", first=known[package.survey].place, second=package.place
            )
        known[package.survey] = package
