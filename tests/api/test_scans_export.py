"""Line-scan recordings in a package: rows with their description, and tampering that verify finds."""

import csv
from pathlib import Path

import pytest

from backend.errors import Damaged
from backend.storage import database, scans_measurements, scans_reviews
from backend.work.exporting_build import build
from backend.work.packaging_files import FolderFiles, Staging
from backend.work.verifying import verify_place
from backend.work.verifying_chain import walk
from backend.work.verifying_scans import check_scans
from tests.storage import samples, scans_samples
from tests.storage.samples import Sample


@pytest.fixture
def one(factory: database.SessionFactory) -> Sample:
    """A survey with a measured, corrected and reviewed scanned vehicle, and one that was taken out."""
    with database.writing(factory) as session:
        made = samples.sample(session)
        first = scans_samples.measured(session, made)
        scans_samples.run(session, made, first.scan_id)
        moved = scans_samples.values(cause="boundaries", placed_by=made.olga.id, rear_line_1=2201.0)
        second = scans_measurements.append(session, first.vehicle_id, moved, actor=made.olga.id)
        scans_reviews.add(session, second.id, verdict="accepted", actor=made.rene.id)
        scans_samples.removed(session, made)
    return made


@pytest.fixture
def package(factory: database.SessionFactory, one: Sample, tmp_path: Path) -> Path:
    """The exported folder."""
    folder = tmp_path / "package"
    folder.mkdir()
    with database.reading(factory) as session:
        build(Staging(folder), session, one.survey.id)
    return folder


def rows(package: Path, name: str) -> list[dict[str, str]]:
    with (package / f"{name}.csv").open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def test_rows_say_what_is_stored(package: Path) -> None:
    assert len(rows(package, "line_scans")) == 2
    (vehicle,) = rows(package, "scan_vehicles")
    assert (vehicle["speed_mps"], vehicle["length_m"]) == ("19.31415", "4.742100")
    assert (vehicle["revision"], vehicle["verdict"], vehicle["rear_line_1"]) == ("2", "accepted", "2201.0")
    revisions = rows(package, "scan_measurements")
    assert [one["cause"] for one in revisions] == ["found", "boundaries"]
    assert revisions[0]["baseline_m"] == "0.593000"
    assert [one["verdict"] for one in rows(package, "scan_reviews")] == ["accepted"]
    found = verify_place(package)
    assert found.ok, found.problem


TAMPERED = {
    "a speed": ("scan_measurements.csv", "19.31415", "18.31415", "scan_measurements.csv: speed_mps of row 1"),
    "a speed in the list": ("scan_vehicles.csv", "19.31415", "18.31415", "vehicle 1 is not its newest"),
    "a boundary": ("scan_measurements.csv", "2201.0", "2203.0", "rear_line_1 of row 2"),
    "a baseline": ("line_scans.csv", "0.593000", "0.600000", "baseline_m of row"),
    "a revision removed": ("scan_measurements.csv", "\n2,1,2", "\n7,1,2", "row 2 is there without|row 7 is"),
    "a verdict": ("scan_reviews.csv", "accepted", "rejected", "verdict of row 1"),
}


def test_tampering_is_found(package: Path) -> None:
    """By the audit events alone: whoever tampers can write new sums."""
    files = FolderFiles(package)
    assert check_scans(files, walk(files)) == 6
    for name, old, new, problem in TAMPERED.values():
        path = package / name
        text = path.read_text(encoding="utf-8")
        assert old in text
        path.write_text(text.replace(old, new), encoding="utf-8")
        with pytest.raises(Damaged, match=problem):
            check_scans(files, walk(files))
        path.write_text(text, encoding="utf-8")
