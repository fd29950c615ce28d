"""Line-scan recordings in a package: rows with their description, and tampering that verify finds."""

import csv
import io
import json
import shutil
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest
from pytest import approx

from sightline.cli import main
from sightline.errors import Damaged
from sightline.export.build import build
from sightline.export.measured import statistics_of
from sightline.export.scans import scanned_motions, scans_in
from sightline.export.seal import read_seal
from sightline.export.traffic import seen_in, traffic_of_scans
from sightline.export.verify.chain import walk
from sightline.export.verify.derived import check_statistics
from sightline.export.verify.described import read_description
from sightline.export.verify.package import verify_package, verify_place
from sightline.infra.csv_package.files import FolderFiles, Staging, read_rows, undo_safe_text
from sightline.infra.csv_package.recomputing import Recomputing
from sightline.infra.services import Services
from sightline.messages import say
from sightline.recordings.filming import FILMED, Filming
from sightline.results.selection import Selection
from sightline.reviews.store import add_review
from sightline.scans.clock import ScanClock
from sightline.scans.store import update_scan
from sightline.scans.vehicles.measurement_store import append_scan_measurement
from sightline.scans.vehicles.review_store import add_scan_review
from sightline.scans.vehicles.store import change_scan_vehicle
from sightline.scans.verify import check_scans
from tests.export.report.pdf_text import words
from tests.support import samples, scans_samples
from tests.support.packages import rewrite, table_file
from tests.support.samples import Sample


@pytest.fixture
def one(services: Services) -> Sample:
    """A survey with a measured, corrected and reviewed scanned vehicle, and one that was taken out."""
    with services.writing() as session:
        made = samples.sample(session)
        first = scans_samples.measured(session, made)
        clock = ScanClock(Filming(datetime(2026, 5, 3, 6, 10, tzinfo=UTC), "Europe/Paris"), 0.5)
        lane = {"name": "=near", "distance_m": 5.5, "tyres_from_px": 200, "tyres_to_px": 256.0}
        update_scan(session, first.scan_id, {"clock": clock, "lanes": [lane]}, version=1, actor=made.olga.id)
        scans_samples.run(session, made, first.scan_id)
        moved = scans_samples.values(cause="boundaries", placed_by=made.olga.id, rear_line_1=2201.0)
        moved = replace(moved, axle_lines=[1300.25, 1950.5, 2100.0], axles_by="person")
        moved = replace(moved, lane="=near", lane_by="machine", tyres_px=240.0)
        second = append_scan_measurement(session, first.vehicle_id, moved, actor=made.olga.id)
        add_scan_review(session, second.id, verdict="accepted", actor=made.rene.id)
        scans_samples.reference(session, made, first.vehicle_id, value=18.0)
        scans_samples.reference(session, made, first.vehicle_id, 1, source="radar")
        scans_samples.reference(session, made, first.vehicle_id, quantity="length", source="tape", value=4.8)
        change_scan_vehicle(session, first.vehicle_id, {"run_of": "Golf"}, version=3, actor=made.olga.id)
        scans_samples.calibrated_rig(session, made, first.scan_id, 2)
        rod = scans_samples.rod(session, made, first.scan_id)
        roof = scans_samples.tall(session, made, first.vehicle_id, rod)
        scans_samples.tall(session, made, first.vehicle_id, rod, target="other")
        by: dict[str, Any] = {"seen_revision": 1, "actor": made.rene.id}
        add_review(session, roof.id, verdict="rejected", reason="A rack.", **by)
        add_review(session, roof.id, verdict="accepted", **by)
        scans_samples.removed(session, made)
    return made


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the package is that the first test made."""
    return tmp_path_factory.mktemp("exported") / "package"


@pytest.fixture
def package(request: pytest.FixtureRequest, services: Services, kept: Path, tmp_path: Path) -> Path:
    """The exported folder."""
    if not kept.exists():
        one: Sample = request.getfixturevalue("one")
        kept.mkdir()
        with services.reading() as session:
            build(Staging(kept), session, one.survey.id, services)
    return shutil.copytree(kept, tmp_path / "package")


def rows(package: Path, name: str) -> list[dict[str, str]]:
    with table_file(package, f"{name}.csv").open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def test_rows_say_what_is_stored(package: Path) -> None:
    first, unclocked = rows(package, "line_scans")
    assert (first["started_at"], first["u_start_s"]) == ("2026-05-03T08:10:00.000+02:00", "0.5")
    assert (unclocked["started_at"], unclocked["time_zone"]) == ("", "")
    assert '"distance_m":5.5' in first["lanes"] and '"tyres_from_px":200,' in first["lanes"]
    assert unclocked["lanes"] == ""
    (vehicle,) = rows(package, "scan_vehicles")
    assert (undo_safe_text(vehicle["lane"]), vehicle["lane_by"], vehicle["tyres_px"]) == (
        "=near",
        "machine",
        "240.0",
    )
    assert {undo_safe_text(one["lane"]) for one in rows(package, "statistics/traffic_intervals")} == {"=near"}
    assert (vehicle["speed_mps"], vehicle["length_m"]) == ("19.31415", "4.742100")
    assert (vehicle["revision"], vehicle["verdict"], vehicle["rear_line_1"]) == ("2", "accepted", "2201.0")
    assert vehicle["filmed_at"] == "2026-05-03T08:10:00.205+02:00"
    assert float(vehicle["u_filmed_at_s"]) == pytest.approx(0.5, rel=1e-5)
    revisions = rows(package, "scan_measurements")
    assert [one["cause"] for one in revisions] == ["found", "boundaries"]
    assert revisions[0]["baseline_m"] == "0.593000"
    assert [one["verdict"] for one in rows(package, "scan_reviews")] == ["accepted"]
    old, radar, tape = rows(package, "scan_references")
    assert (old["value"], old["current"], old["difference"]) == ("18.0", "false", "")
    assert (radar["value"], radar["unit"], radar["revision"], radar["current"]) == (
        "19.4",
        "m/s",
        "2",
        "true",
    )
    assert float(radar["difference"]) == pytest.approx(19.31415 - 19.4) and radar["within"] == "true"
    assert (tape["source"], tape["device"], tape["unit"]) == ("tape", "Gun 2", "m")
    assert vehicle["run_of"] == "Golf"
    (pose,) = rows(package, "line_poses")
    assert (pose["camera_height_m"], pose["sigma_px"]) == ("1.100000", "0.5")
    assert len(rows(package, "line_marks")) == 8
    (calibration,) = rows(package, "rig_calibrations")
    assert (first["baseline_m"], first["divergence_rad"]) == (
        calibration["baseline_m"],
        calibration["divergence_rad"],
    )
    assert (first["baseline_correlation"], first["u_distance_m"]) == (
        calibration["baseline_correlation"],
        "0.000000",
    )
    passes = rows(package, "rig_passes")
    assert [one["kind"] for one in passes] == ["positions"] * 4 + ["board"]
    assert (passes[4]["front_line_2"], passes[4]["span_m"], passes[0]["span_m"]) == (
        "1590.0",
        "0.596000",
        "0.596200",
    )
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
    assert {one["value"] for one in speeds} == {""}
    assert {one["reason"] for one in speeds if float(one["percent"]) == 50.0} == {"P50 needs 6; there is 1"}
    other, roof = rows(package / "statistics", "scan_heights")
    assert (roof["target"], roof["n"], roof["mean_m"], roof["sd_m"]) == ("roof", "1", "1.400000", "")
    assert (other["target"], other["n"], other["to_review"], other["mean_m"]) == ("other", "0", "1", "")
    by = {
        (one["quantity"], one["source"]): one for one in rows(package / "statistics", "scan_reference_errors")
    }
    assert set(by) == {("speed", "radar"), ("length", "tape")}  # each of one source: no row says it once more
    assert (by["speed", "radar"]["n"], by["speed", "radar"]["share_within"]) == ("1", "1.0")
    (car,) = rows(package / "statistics", "scan_cars")
    assert (car["car"], car["n"], car["verdict"], car["chi_square"]) == ("Golf", "1", "too_few", "")
    length = float(rows(package, "scan_vehicles")[0]["length_m"])
    said = "".join(words((package / "report.pdf").read_bytes()).split())
    for expected in (
        "Linescans",
        "1of1detectedvehiclesaccepted.",
        "69.5",
        "fromthetraffic",
        "Roof11.400",
        "Other0––––1",
        # 19.31415 m/s beside the radar's 19.4 m/s (u 0.1 m/s), and the tape's 4.8 m
        "Speed(km/h)Radar1−0.31–0.311of1100.0%2.5to100.0%",
        f"Length(mm)Tape1{1000 * (length - 4.8):+.1f}–{1000 * abs(length - 4.8):.1f}".replace("-", "−"),
    ):
        assert expected in said
    assert (package / "figures" / "scan-speed.svg").is_file()
    table = package / "statistics" / "scan_quantities.csv"
    kept = table.read_text(encoding="utf-8")
    table.write_text(kept.replace("19.31415", "20.31415"), encoding="utf-8")
    with pytest.raises(Damaged, match=r"scan_quantities\.csv, line 2: mean states 20.31415"):
        check_statistics(FolderFiles(package), same_program=True)
    table.write_text(kept, encoding="utf-8")
    heights = package / "statistics" / "scan_heights.csv"
    heights.write_text(heights.read_text(encoding="utf-8").replace("1.400000", "1.410000"), encoding="utf-8")
    with pytest.raises(Damaged, match=r"scan_heights\.csv, line 3: mean_m states 1.410000"):
        check_statistics(FolderFiles(package), same_program=True)


@pytest.mark.parametrize(("hours", "of_it"), [((8, 9), 1), ((9, None), 0)])
def test_a_package_of_hours_of_filming(
    services: Services, one: Sample, tmp_path: Path, hours: tuple[int, int | None], of_it: int
) -> None:
    """The vehicle of 08:10 counts, and intervals are those that begin within the hours."""
    place = tmp_path / "package"
    place.mkdir()
    with services.reading() as session:
        selection = Selection(hour_from=hours[0], hour_to=hours[1])
        build(Staging(place), session, one.survey.id, services, selection=selection)
    chosen = [list(row.values()) for row in rows(place, "selection")]
    assert chosen == [[name, str(hour)] for name, hour in zip(FILMED[2:], hours, strict=True) if hour]
    lengths = rows(place / "statistics", "scan_quantities")
    assert {row["n"] for row in lengths if row["quantity"] == "speed"} == ({"1"} if of_it else set())
    told = rows(place / "statistics", "traffic_intervals")
    begun = {int(row["begins_at"][11:13]) for row in told}
    assert (begun == {8}) if of_it else min(begun) == 9
    assert sum(int(row["vehicles"]) for row in told if row["minutes"] == "60") == of_it
    assert {row["refused"] for row in told} == {"0"}
    assert verify_package(FolderFiles(place)).ok


def test_traffic_is_counted_and_computed_again(package: Path, capsys: pytest.CaptureFixture[str]) -> None:
    told = rows(package / "statistics", "traffic_intervals")
    hours = [one for one in told if one["minutes"] == "60"]
    assert {one["scan_id"] for one in told} == {"1"}  # the other has no confirmed start
    first = hours[0]
    assert first["begins_at"] == "2026-05-03T08:10:00.000+02:00" and first["partial"] == "true"
    assert (first["vehicles"], first["measured"], first["flow_per_hour"]) == ("1", "1", "1.2")
    assert hours[1]["begins_at"] == "2026-05-03T09:00:00.000+02:00" and hours[1]["vehicles"] == "0"
    assert {one["direction"] for one in told} == {"camera_1_first"}
    classes = [one for one in rows(package / "statistics", "traffic_classes") if one["minutes"] == "60"]
    assert main(["flow", str(package), "--interval", "60"]) == 0
    printed = list(csv.DictReader(io.StringIO(capsys.readouterr().out)))
    assert [(one["interval_start"], one["vehicles"]) for one in printed] == [
        (one["begins_at"], one["vehicles"]) for one in hours
    ]
    assert float(printed[0]["speed_mean_mps"]) == pytest.approx(float(first["time_mean_speed_mps"]))
    counted = [(one["vehicles"], one["axles_2"], one["axles_3"], one["axles_unknown"]) for one in classes]
    assert counted == [("1", "0", "1", "0"), *[("0", "0", "0", "0")] * 3]
    table = package / "statistics" / "traffic_intervals.csv"
    text = table.read_text(encoding="utf-8")
    table.write_text(text.replace(",1.2,", ",1.3,", 1), encoding="utf-8")
    with pytest.raises(Damaged, match=r"traffic_intervals\.csv, line .*: flow_per_hour states 1.3"):
        check_statistics(FolderFiles(package), same_program=True)


def test_flow_of_a_package_says_and_lists_what_its_intervals_hold(
    package: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Overlaps within its days and hours; none of the vehicles that another line rate leaves uncounted."""

    def told() -> tuple[list[str], int, int]:
        assert main(["flow", str(package), "--interval", "60", "--json"]) == 0
        found = json.loads(capsys.readouterr().out)
        counted = sum(one["vehicles"] for one in found["intervals"])
        return found["notes"], len(found["vehicles"]), counted

    first, _ = rows(package, "line_scans")
    (car,) = rows(package, "scan_vehicles")
    later = {**first, "id": "2", "name": "later", "started_at": "2026-05-03T08:10:01.000+02:00"}
    whole_s = int(first["lines"]) / float(first["line_rate_hz"])
    rewrite(package, "line_scans.csv", [first, later])
    rewrite(package, "scan_vehicles.csv", [car, {**car, "id": "2", "scan_id": "2"}])
    said = f"{first['name']} and later overlap for {{}} s: a vehicle that both contain counts in each."
    assert told() == ([said.format(f"{round(whole_s - 1):,}".replace(",", "\u202f"))], 2, 2)
    selection = package / "tables" / "selection.csv"
    selection.write_text("by,word\r\nhour_to,9\r\n")
    assert told() == ([said.format(2999)], 2, 2)
    selection.write_text("by,word\r\nfilmed_from,2026-05-04\r\n")
    assert told() == ([], 0, 0)
    selection.write_text("by,word\r\n")
    rewrite(package, "line_scans.csv", [first, {**later, "line_rate_hz": "2441.4"}])
    (note,), listed, counted = told()
    assert (listed, counted) == (1, 1) and "another line rate" in note


@pytest.mark.parametrize("chosen", [("category", "saloon"), ("lighting", "low_light")])
def test_traffic_of_a_package_of_one_class_or_lighting_is_that_of_all_vehicles(
    package: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    chosen: tuple[str, str],
) -> None:
    """Nine vehicles two seconds apart by day, each third a saloon: the road is as full whoever is chosen."""
    (first,) = rows(package, "scan_vehicles")
    line_rate_hz = float(rows(package, "line_scans")[0]["line_rate_hz"])
    many = []
    for k in range(9):
        since = {
            name: str(float(first[name]) + 2.0 * k * line_rate_hz) for name in ("front_line_1", "rear_line_1")
        }
        many.append({**first, **since, "id": str(k + 1), "category": "van" if k % 3 else "saloon"})
    rewrite(package, "scan_vehicles.csv", many)
    files = FolderFiles(package)
    cars = list(scanned_motions(files))
    whole = traffic_of_scans(seen_in(files, cars), (60,))
    assert (whole[0].intervals[0].vehicles, whole[0].intervals[0].mean_headway_s) == (9, approx(2.0))
    (package / "tables" / "selection.csv").write_text(f"by,word\r\n{','.join(chosen)}\r\n")
    chosen_alone = traffic_of_scans(seen_in(files, cars), (60,))
    assert [vars(one) for one in chosen_alone] == [vars(one) for one in whole]
    assert scans_in(files, cars).counted["vehicles"] == (3 if chosen[0] == "category" else 0)
    read = list[str]()

    def reading(of: Any, name: str) -> Any:
        read.append(name)
        return read_rows(of, name)

    monkeypatch.setattr("sightline.export.scans.read_rows", reading)
    statistics_of(files)
    assert main(["flow", str(package), "--interval", "60", "--json"]) == 0
    assert read == 2 * ["scan_vehicles.csv"]  # once each
    assert len(json.loads(capsys.readouterr().out)["vehicles"]) == 9
    assert "traffic of line scans is limited by days and hours alone" in say("export-of-help", {})


TAMPERED = {
    "a reference": ("scan_references.csv", "19.4,0.1", "19.3,0.1", "value of row 2 differs"),
    "a reference's uncertainty": ("scan_references.csv", "19.4,0.1", "19.4,0.2", "u of row 2 differs"),
    "which instrument": ("scan_references.csv", "Gun 2,-", "Gun 3,-", "device of row 2 differs"),
    "what stands": (
        "scan_references.csv",
        "radar,1,false",
        "radar,1,true",
        "current of row 1",
    ),
    "a difference": ("scan_references.csv", "Gun 2,-0.08", "Gun 2,-0.01", "difference of row 2 does not"),
    "which way it went": ("scan_measurements.csv", "camera_1_first", "camera_2_first", "direction of row"),
    "how many axles": ("scan_measurements.csv", ",3,1300.250", ",2,1300.250", "axles of row 2"),
    "where a wheel is": ("scan_vehicles.csv", "2100.000", "2101.000", "not its newest revision"),
    "what is within": ("scan_references.csv", ",true,1,", ",false,1,", "within of row"),
    "a reference removed": (
        "scan_references.csv",
        "\n2,1,",
        "\n7,1,",
        "row 2 has no audit event|row 7 has no audit event",
    ),
    "whose run it is": ("scan_vehicles.csv", "Golf", "Polo", "run_of of row 1"),
    "a speed": ("scan_measurements.csv", "19.31415", "18.31415", "scan_measurements.csv: speed_mps of row 1"),
    "a speed in the list": ("scan_vehicles.csv", "19.31415", "18.31415", "vehicle 1 is not its newest"),
    "a speed's interval": (
        "scan_measurements.csv",
        "0.021559603829940592",
        "0.011559603829940592",
        "U95_speed_mps of row 1",
    ),
    "a length's interval": ("scan_measurements.csv", "0.015680", "0.005680", "U95_length_m of row 1"),
    "a boundary": ("scan_measurements.csv", "2201.0", "2203.0", "rear_line_1 of row 2"),
    "a baseline": ("line_scans.csv", "0.593000", "0.600000", "baseline_m of row"),
    "a start": ("line_scans.csv", "08:10:00.000", "08:10:01.000", "started_at of row 1"),
    "a start's uncertainty": ("line_scans.csv", "Europe/Paris,0.5", "Europe/Paris,0.4", "u_start_s of row 1"),
    "a start that nobody said": ("line_scans.csv", ",,,,,Some", ",,,Europe/Paris,,Some", "time_zone of row"),
    "a time of day": ("scan_vehicles.csv", "08:10:00.205", "08:10:00.206", "has another passing time"),
    "a time of day's uncertainty": (
        "scan_vehicles.csv",
        "+02:00,0.5",
        "+02:00,0.4",
        "has another passing time",
    ),
    "a line rate": ("scan_measurements.csv", "4882.8", "4800.0", "line_rate_hz of row 1"),
    "a revision removed": (
        "scan_measurements.csv",
        "\n2,1,2",
        "\n7,1,2",
        "row 2 has no audit event|row 7 has no audit event",
    ),
    "a line camera's height": ("line_poses.csv", "1.100000", "1.200000", "camera_height_m of row 1"),
    "a mark of the rod": (
        "line_marks.csv",
        "5.000000,0.500000",
        "5.100000,0.500000",
        "differ from its event",
    ),
    "a rig's pass": ("rig_passes.csv", "0.596200,0.001000", "0.596300,0.001000", "differ from its audit"),
    "a pass removed": ("rig_passes.csv", "\n1,5,", "\n1,6,", "differ from its audit"),
    "a pass of nothing": ("rig_passes.csv", "\n1,5,", "\n2,5,", "differ from its audit"),
    "what a pass gives": ("rig_passes.csv", ",0.596000,", ",0.596100,", "span_m of calibration 1 is not"),
    "how a pass tells": ("rig_passes.csv", ",board,board,", ",board,speed,", "kind of calibration 1"),
    "a tape's scale": ("rig_calibrations.csv", ",0.0001,", ",0.0002,", "u_tape_ratio of row 1"),
    "who calibrated": ("rig_calibrations.csv", "\n1,1,1,", "\n1,1,2,", "revision of row 1"),
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
    "a height's refusal removed": (
        "line_height_reviews.csv",
        "\n1,1,",
        "\n7,1,",
        "row 1 has no audit event|row 7 has no audit event",
    ),
}


def test_tampering_is_found(package: Path) -> None:
    """By the audit events alone: whoever tampers can write new sums."""
    files = FolderFiles(package)

    def checked() -> int:
        told = walk(files, read_seal(files), read_description(files).headers)
        return check_scans(files, told.replay, {}, Recomputing(lambda *_: True), "")

    assert checked() == 15
    for name, old, new, problem in TAMPERED.values():
        path = table_file(package, name)
        text = path.read_text(encoding="utf-8")
        assert old in text
        path.write_text(text.replace(old, new), encoding="utf-8")
        with pytest.raises(Damaged, match=problem):
            checked()
        path.write_text(text, encoding="utf-8")
