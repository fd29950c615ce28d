"""Line-scan recordings in a package: rows with their description, and tampering that verify finds."""

import csv
from pathlib import Path

import pytest

from sightline.errors import Damaged
from sightline.export.build import build
from sightline.export.seal import read_seal
from sightline.export.verify.chain import walk
from sightline.export.verify.derived import check_statistics
from sightline.export.verify.package import verify_place
from sightline.infra.csv_package.files import FolderFiles, Staging
from sightline.infra.services import Services
from sightline.scans.heights.review_store import add_line_height_review
from sightline.scans.vehicles.measurement_store import append_scan_measurement
from sightline.scans.vehicles.review_store import add_scan_review
from sightline.scans.verify import check_scans
from tests.export.report.pdf_text import words
from tests.support import samples, scans_samples
from tests.support.samples import Sample


@pytest.fixture
def one(services: Services) -> Sample:
    """A survey with a measured, corrected and reviewed scanned vehicle, and one that was taken out."""
    with services.writing() as session:
        made = samples.sample(session)
        first = scans_samples.measured(session, made)
        scans_samples.run(session, made, first.scan_id)
        moved = scans_samples.values(cause="boundaries", placed_by=made.olga.id, rear_line_1=2201.0)
        second = append_scan_measurement(session, first.vehicle_id, moved, actor=made.olga.id)
        add_scan_review(session, second.id, verdict="accepted", actor=made.rene.id)
        rod = scans_samples.rod(session, made, first.scan_id)
        roof = scans_samples.tall(session, made, first.vehicle_id, rod)
        scans_samples.tall(session, made, first.vehicle_id, rod, target="other")
        add_line_height_review(session, roof.id, verdict="rejected", reason="A rack.", actor=made.rene.id)
        add_line_height_review(session, roof.id, verdict="accepted", actor=made.rene.id)
        scans_samples.removed(session, made)
    return made


@pytest.fixture
def package(services: Services, one: Sample, tmp_path: Path) -> Path:
    """The exported folder."""
    folder = tmp_path / "package"
    folder.mkdir()
    with services.reading() as session:
        build(Staging(folder), session, one.survey.id, services)
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
    (pose,) = rows(package, "line_poses")
    assert (pose["camera_height_m"], pose["sigma_px"]) == ("1.100000", "0.5")
    assert len(rows(package, "line_marks")) == 8
    height, other = rows(package, "line_heights")
    assert (height["height_m"], height["distance_m"], height["current"]) == ("1.400000", "3.000000", "true")
    last = rows(package, "line_height_reviews")[-1]
    assert (height["verdict"], height["reviewer_id"], height["reviewed_at"]) == (
        "accepted",
        last["reviewer_id"],
        last["at"],
    )
    assert (other["verdict"], other["reviewer_id"], other["reviewed_at"]) == ("to_review", "", "")
    assert [one["verdict"] for one in rows(package, "line_height_reviews")] == ["rejected", "accepted"]
    assert len(rows(package, "line_height_budget")) == 8
    found = verify_place(package)
    assert found.ok, found.problem


def test_statistics_figures_and_report_tell_of_line_scans(package: Path) -> None:
    means = {one["quantity"]: one for one in rows(package / "statistics", "scan_quantities")}
    assert (means["speed"]["n"], means["speed"]["unit"], means["speed"]["mean"]) == ("1", "m/s", "19.31415")
    assert "time_gap" not in means  # the first vehicle has none before it
    speeds = [one for one in rows(package / "statistics", "scan_percentiles") if one["quantity"] == "speed"]
    assert {one["value"] for one in speeds} == {"19.31415"} and all(one["reason"] for one in speeds)
    other, roof = rows(package / "statistics", "scan_heights")
    assert (roof["target"], roof["n"], roof["mean_m"], roof["sd_m"]) == ("roof", "1", "1.400000", "")
    assert (other["target"], other["n"], other["to_review"], other["mean_m"]) == ("other", "0", "1", "")
    said = "".join(words((package / "report.pdf").read_bytes()).split())
    for expected in (
        "Linescans",
        "1acceptedvehiclecountsof1found.",
        "69.5",
        "fromthetraffic",
        "Roof11.400",
        "Other0––––1",
    ):
        assert expected in said
    assert (package / "figures" / "scan-speed.svg").is_file()
    table = package / "statistics" / "scan_quantities.csv"
    kept = table.read_text(encoding="utf-8")
    table.write_text(kept.replace("19.31415", "20.31415"), encoding="utf-8")
    with pytest.raises(Damaged, match=r"scan_quantities\.csv, line 2: mean says 20.31415"):
        check_statistics(FolderFiles(package), same_program=True)
    table.write_text(kept, encoding="utf-8")
    heights = package / "statistics" / "scan_heights.csv"
    heights.write_text(heights.read_text(encoding="utf-8").replace("1.400000", "1.410000"), encoding="utf-8")
    with pytest.raises(Damaged, match=r"scan_heights\.csv, line 3: mean_m says 1.410000"):
        check_statistics(FolderFiles(package), same_program=True)


TAMPERED = {
    "a speed": ("scan_measurements.csv", "19.31415", "18.31415", "scan_measurements.csv: speed_mps of row 1"),
    "a speed in the list": ("scan_vehicles.csv", "19.31415", "18.31415", "vehicle 1 is not its newest"),
    "a boundary": ("scan_measurements.csv", "2201.0", "2203.0", "rear_line_1 of row 2"),
    "a baseline": ("line_scans.csv", "0.593000", "0.600000", "baseline_m of row"),
    "a revision removed": ("scan_measurements.csv", "\n2,1,2", "\n7,1,2", "row 2 is there without|row 7 is"),
    "a line camera's height": ("line_poses.csv", "1.100000", "1.200000", "camera_height_m of row 1"),
    "a mark of the rod": ("line_marks.csv", "5.000000,0.500000", "5.100000,0.500000", "not those of its"),
    "a height": ("line_heights.csv", "1.400000", "1.410000", "height_m of row 1"),
    "an interval": ("line_heights.csv", ",ok,", "9,ok,", "U95_height_m"),
    "a share of the budget": ("line_height_budget.csv", "inset,0", "inset,1", "inset of height 1"),
    "a verdict": ("scan_reviews.csv", "accepted", "rejected", "verdict of row 1"),
    "a verdict's reviewer": ("scan_reviews.csv", "accepted,,2", "accepted,,1", "reviewer_id of row 1"),
    "a height's verdict given": (
        "line_height_reviews.csv",
        "2,1,accepted",
        "2,1,rejected",
        "verdict of row 2",
    ),
    "a height's verdict": ("line_heights.csv", ",accepted,", ",rejected,", "line_heights.csv: .*1"),
    "a verdict on a height that waits": (
        "line_heights.csv",
        ",to_review,",
        ",accepted,",
        "line_heights.csv: .*2",
    ),
    "who judged a height": ("line_heights.csv", ",accepted,,2,", ",accepted,,1,", "line_heights.csv: .*1"),
    "a height's refusal removed": ("line_height_reviews.csv", "\n1,1,", "\n7,1,", "row 1 is there|row 7 is"),
}


def test_tampering_is_found(package: Path) -> None:
    """By the audit events alone: whoever tampers can write new sums."""
    files = FolderFiles(package)
    assert check_scans(files, walk(files, read_seal(files))) == 11
    for name, old, new, problem in TAMPERED.values():
        path = package / name
        text = path.read_text(encoding="utf-8")
        assert old in text
        path.write_text(text.replace(old, new), encoding="utf-8")
        with pytest.raises(Damaged, match=problem):
            check_scans(files, walk(files, read_seal(files)))
        path.write_text(text, encoding="utf-8")
