"""Every cell of the line-scan tables of a package is bound: by an event, or by what it is computed from."""

import csv
import io
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from random import Random
from typing import Any

import pytest

from sightline.errors import Damaged
from sightline.export.build import build
from sightline.export.seal import read_seal
from sightline.export.verify.chain import walk
from sightline.export.verify.described import read_description
from sightline.infra.csv_package.columns import check_words
from sightline.infra.csv_package.files import FolderFiles, Staging
from sightline.infra.csv_package.recomputing import Recomputing
from sightline.infra.csv_package.schema import AnyTable
from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.linescan.parts import STOOD
from sightline.messages.said import Said
from sightline.recordings.filming import Filming
from sightline.reviews.store import add_review
from sightline.scans.clock import ScanClock
from sightline.scans.csv import GAP, LINE_SCANS, SCAN_MEASUREMENTS, SCAN_VEHICLES, TABLES
from sightline.scans.records import ScanValues
from sightline.scans.store import note_reading_failed, update_scan
from sightline.scans.vehicles.measurement_store import append_scan_measurement
from sightline.scans.vehicles.review_store import add_scan_review
from sightline.scans.vehicles.store import change_scan_vehicle, create_scan_vehicle
from sightline.scans.verify import check_scans
from tests.support import samples, scans_samples
from tests.support.mutations import MemoryFiles, Package, checked, load, with_sums
from tests.support.samples import Sample
from tests.support.scans_samples import values


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the package is that the first test made."""
    return tmp_path_factory.mktemp("forged") / "package"


@pytest.fixture
def package(services: Services, kept: Path) -> Path:
    """Of a line scan with work of every kind, one that was not read yet, and one that cannot be."""
    if not kept.exists():
        with services.writing() as session:
            one = samples.sample(session)
            _scanned(session, one)
            scans_samples.scan(session, one)
            failed = scans_samples.scan(session, one).id
            note_reading_failed(session, failed, Said("scans-import-cancelled"), actor=None)
        kept.mkdir()
        with services.reading() as session:
            build(Staging(kept), session, one.survey.id, services)
    return kept


def _scanned(session: Session, one: Sample) -> None:
    """Five vehicles: measured twice, behind it, one that stood, one behind that, one never measured."""
    scan, olga, rene = scans_samples.ready(session, one), one.olga.id, one.rene.id
    clock = ScanClock(Filming(datetime(2026, 5, 3, 6, 10, tzinfo=UTC), "Europe/Paris"), 0.5)
    update_scan(session, scan.id, {"clock": clock, "lighting": "daytime"}, version=1, actor=olga)
    scans_samples.calibrated_rig(session, one, scan.id, 2)
    ids = [create_scan_vehicle(session, scan.id, origin="found", actor=olga).id for _ in range(5)]
    budget = [
        {"source": "boundaries", "u_speed_mps": 0.002, "u_acceleration_mps2": 0.01, "u_length_m": 0.004},
        {"source": "clock", "u_speed_mps": 0.001, "u_acceleration_mps2": 0.003, "u_length_m": 0.002},
    ]
    first = values(budget=budget, warnings=[Said("scan-motion-no-wheelbase", reason="x")])
    none = [f"{u}{name}" for name in ("speed_mps", "acceleration_mps2", "length_m") for u in ("", "u_")]
    unmeasured = dict.fromkeys([*none, "fit_error_percent", "correlation"])
    stood: dict[str, Any] = {**unmeasured, "status": "not_measurable", "reason": STOOD, "budget": []}
    told = [
        first,
        _later(replace(first, speed_mps=18.5, length_m=4.4), 9000.0),
        replace(_later(first, 19000.0), **stood),
        _later(first, 29000.0),
    ]
    made = [
        append_scan_measurement(session, of, each, actor=olga) for of, each in zip(ids, told, strict=False)
    ]
    moved = replace(
        told[0],
        cause="boundaries",
        placed_by=olga,
        rear_line_1=2201.0,
        axle_lines=[1300.25, 1950.5, 2100.0],
        axles_by="person",
        front_wheel_line=1300.0,
        rear_wheel_line=1950.0,
        wheelbase_m=2.6,
        u_wheelbase_m=0.01,
    )
    again = append_scan_measurement(session, ids[0], moved, actor=olga)
    add_scan_review(session, again.id, verdict="accepted", actor=rene)
    add_scan_review(session, made[1].id, verdict="rejected", reason="A trailer.", actor=rene)
    known = {
        "make": "VW",
        "model": "Golf",
        "year": 2019,
        "category": "saloon",
        "true_length_m": 4.25,
        "u_true_length_m": 0.01,
        "true_wheelbase_m": 2.62,
        "u_true_wheelbase_m": 0.01,
        "facts_source": "maker",
        "run_of": "Golf",
        "lighting": "low_light",
        "notes": "x",
    }
    change_scan_vehicle(session, ids[0], known, version=3, actor=olga)
    scans_samples.reference(session, one, ids[0], value=18.0)
    scans_samples.reference(session, one, ids[0], 1)
    scans_samples.reference(session, one, ids[0], quantity="length", source="tape", value=4.8)
    rod = scans_samples.rod(session, one, scan.id)
    roof = scans_samples.tall(session, one, ids[0], rod)
    scans_samples.tall(session, one, ids[1], rod, target="other")
    add_review(session, roof.id, verdict="rejected", reason="A rack.", seen_revision=1, actor=rene)
    add_review(session, roof.id, verdict="accepted", seen_revision=1, actor=rene)
    scans_samples.removed(session, one)


def _later(one: ScanValues, lines: float) -> ScanValues:
    names = ("front_line_1", "rear_line_1", "front_line_2", "rear_line_2")
    return replace(one, **{name: getattr(one, name) + lines for name in names})


def _table(package: Package, table: AnyTable) -> list[list[str]]:
    return list(csv.reader(io.StringIO(package[table.path].decode(), newline="")))


def _with(package: Package, table: AnyTable, rows: list[list[str]]) -> Package:
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows(rows)
    return {**package, table.path: out.getvalue().encode()}


def _others(cell: str, column: list[str]) -> list[str]:
    """What a forger might write in a cell: another row's, nothing, what is near; not what is but rounding."""
    others = sorted({*column, "", f"{cell}1"} - {cell})
    try:
        number = float(cell)
    except ValueError:
        return others
    decimals = len(cell.partition(".")[2])
    near = f"{number + 2 * 10.0 ** -min(decimals, 5):.{decimals}f}"
    return [one for one in (*others, near) if not one or abs(float(one) - number) > 1e-5]


def _forged(package: Package, table: AnyTable, row: int, name: str, other: str) -> Package:
    """One cell; of a vehicle's newest motion that of the vehicle too, which repeats it."""
    rows = _table(package, table)
    (number,) = (one for name, one in zip(rows[0], rows[row], strict=True) if name == rows[0][0])
    rows[row][rows[0].index(name)] = other
    forged = _with(package, table, rows)
    vehicles = _table(package, SCAN_VEHICLES)
    if table is SCAN_MEASUREMENTS and name in vehicles[0] and name not in ("id", "vehicle_id"):
        for one in vehicles[1:]:
            if one[vehicles[0].index("measurement_id")] == number:
                one[vehicles[0].index(name)] = other
        forged = _with(forged, SCAN_VEHICLES, vehicles)
    return forged


@pytest.mark.parametrize("most", [1, pytest.param(1000, marks=pytest.mark.proof)])
def test_every_cell_is_bound(package: Path, most: int) -> None:
    """By the rows and events alone: who forges one can make all sums, the seal and the statistics fit."""
    files, whole, random = FolderFiles(package), load(package), Random(most)
    headers = read_description(files).headers
    told = walk(files, read_seal(files), headers)

    def problem(forged: Package) -> str | None:
        try:
            check_words(MemoryFiles(forged), {table.key: headers[table.key] for table in TABLES})
            check_scans(MemoryFiles(forged), told.replay, {}, Recomputing(lambda *_: True), "")
        except (Damaged, ValueError) as found:  # ValueError: not the form of a cell, which `verify` tells
            return str(found)
        return None

    assert problem(whole) is None
    unbound = set[str]()
    for table in TABLES:
        header, *body = _table(whole, table)
        for at, name in enumerate(header):
            for row, line in random.sample(list(enumerate(body, 1)), min(most, len(body))):
                others = _others(line[at], [one[at] for one in body])
                for other in random.sample(others, min(most + 1, len(others))):
                    if problem(_forged(whole, table, row, name, other)) is None:
                        unbound.add(f"{table.key}, {name}, row {row}: {line[at]!r} -> {other!r}")
    assert not unbound


@pytest.mark.parametrize("name", [column.name for column in GAP if column.name != "gap_reason"])
def test_a_gap_is_computed_again(package: Path, name: str) -> None:
    """With all sums, seal and signature written anew; a reason with its words."""
    whole = load(package)
    header, *body = _table(whole, SCAN_VEHICLES)
    names = ("gap_reason", name) if name == "gap_reason_code" else (name,)
    cells = [[line[header.index(one)] for one in names] for line in body]
    row = next(row for row, found in enumerate(cells) if found[0])
    forged = whole
    for one, other in zip(names, next(one for one in cells if one != cells[row]), strict=True):
        forged = _forged(forged, SCAN_VEHICLES, row + 1, one, other)
    told = checked(with_sums(forged, whole, seal=True)).problem
    assert told is not None and f"scan_vehicles.csv: {name} of vehicle" in told, told


def test_line_scans_that_were_not_read_are_told_and_verify(package: Path) -> None:
    found = checked(load(package))
    assert found.ok, found.problem
    header, *body = _table(load(package), LINE_SCANS)
    told = [dict(zip(header, line, strict=True)) for line in body]
    read = "50000000", "Some lines lost."
    assert [(one["lines"], one["notes"]) for one in told] == [read, read, ("", ""), ("", "")]
