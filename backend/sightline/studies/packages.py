"""The packages of a study: found, verified, told apart, and refused in one sentence where they do not fit."""

import json
import re
import shutil
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

from sightline.errors import BadInput, Damaged
from sightline.export.seal import read_seal
from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.files import Files, open_package, read_rows
from sightline.infra.csv_package.schema import CHECKSUMS, DESCRIPTION, parquet_path
from sightline.results.usual_standards import standards_in
from sightline.studies.query import READ, columns_of
from sightline.studies.records import StudiedPackage

#: Checks a package; the sentence that says what is wrong, or None.
Check = Callable[[Files], str | None]
_OF_MORE_FRAMES = re.compile(r"(?:frame|contact|target)\d+")


def found_places(named: Iterable[Path]) -> list[Path]:
    """Packages by names of folders and ZIPs; another folder: all packages below. Raises BadInput for none."""
    found: list[Path] = []
    for place in named:
        if place.is_file() or (place / CHECKSUMS).is_file():
            found.append(place)
            continue
        below = [one.parent for one in place.rglob(CHECKSUMS)] + list(place.rglob("*.zip"))
        if not below:
            raise BadInput("studies-no-package-there", place=place)
        found += sorted(below)
    return found


def refuse_output(output: Path, places: Sequence[Path]) -> None:
    """Raises BadInput where a study would take the place of a package, or lie within one of `places`."""
    inside = {place.resolve() for place in places if place.is_dir()}
    around = {one.resolve() for one in (output, *output.absolute().parents)}
    if (output / AUDIT.path).is_file() or inside & around:
        raise BadInput("studies-output-in-package", place=output)


def studied(places: Sequence[Path], check: Check, scratch: Path) -> list[StudiedPackage]:
    """Every package, verified by `check`, its tables where DuckDB reads them (a ZIP's in `scratch`).

    Raises BadInput for one that does not pass, of an earlier version, or given twice in whatever form.
    """
    packages = [_studied(place, check, scratch / str(n)) for n, place in enumerate(places)]
    _refuse_twice(packages)
    _refuse_versions(packages)
    return packages


def _studied(place: Path, check: Check, scratch: Path) -> StudiedPackage:
    files = open_package(place)
    problem = check(files)
    if problem is not None:
        raise BadInput("studies-package-unverified", place=place, problem=problem)
    try:
        return _read(place, files, scratch)
    except Damaged as error:
        raise BadInput("studies-package-unverified", place=place, problem=error.message) from error


def _read(place: Path, files: Files, scratch: Path) -> StudiedPackage:
    for name in READ:
        if parquet_path(name) not in files.paths:
            raise BadInput("studies-package-without-parquet", place=place)
    if not any(True for _ in read_rows(files, "poses.csv")):
        raise BadInput("studies-survey-without-poses", place=place)
    tables = place if place.is_dir() else _unpacked(files, scratch)
    row = next(read_rows(files, "survey.csv"))
    with files.open(DESCRIPTION) as file:
        made_with = str(json.load(file)["made_with"]["sightline"])
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
    for one in packages:
        if one.survey in known:
            raise BadInput("studies-same-survey-twice", first=known[one.survey].place, second=one.place)
        known[one.survey] = one


def _refuse_versions(packages: Sequence[StudiedPackage]) -> None:
    """Tables of one form: columns of further frames aside, which depend on how many were clicked."""
    first = _form(packages[0])
    if not {"counts bool", "check_target bool"} <= set(first["vehicles.csv"]):
        raise BadInput("studies-package-without-sample", place=packages[0].place)
    for one in packages[1:]:
        form = _form(one)
        for name in READ:
            if form[name] != first[name]:
                raise BadInput(
                    "studies-versions-differ",
                    first=packages[0].place,
                    first_version=packages[0].made_with,
                    second=one.place,
                    second_version=one.made_with,
                    table=name,
                )


def _form(package: StudiedPackage) -> dict[str, set[str]]:
    return {
        name: {column for column in columns if not _OF_MORE_FRAMES.match(column)}
        for name, columns in columns_of(package.tables).items()
    }
