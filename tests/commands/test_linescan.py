"""`sightline linescan`: vehicles of a pair of strips against the truth, and refusals in sentences."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import dataclass
from datetime import datetime, timedelta, timezone
from pathlib import Path

import cv2
import numpy as np
import pytest
import tifffile

from sightline.cli import main
from sightline.media.strips.sheet import Pixels
from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import ScanSite, ScanTruth, traffic, truths

pytestmark = pytest.mark.once

SITE = ScanSite(rows=128, misalignment_px=0.4)
KNOWN = ("--u-baseline", "0.0005", "--u-line-rate", "1e-6")
RIG = ("--baseline", str(SITE.baseline_m), "--line-rate", str(SITE.line_rate_hz), *KNOWN)


@dataclass(frozen=True)
class Road:
    """Two strips (lines, rows) in memory and as PNG with time along the width, and what is true of them."""

    pixels: tuple[Pixels, Pixels]
    files: tuple[str, str]
    truth: tuple[ScanTruth, ...]


@pytest.fixture(scope="module")
def road(tmp_path_factory: pytest.TempPathFactory) -> Road:
    folder = tmp_path_factory.mktemp("road")
    cars = traffic(5, 3, speeds_mps=(14.0, 24.0), gaps_s=(0.5, 0.8), start_s=0.8)
    pixels = strips(SITE, cars)
    files = (folder / "first.png", folder / "second.png")
    for path, strip in zip(files, pixels, strict=True):
        cv2.imwrite(str(path), strip.T)
    return Road(pixels, (str(files[0]), str(files[1])), truths(SITE, cars))


def rows_of(text: str) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(text)))


def said_by(capsys: pytest.CaptureFixture[str], *arguments: str, status: int = 0) -> str:
    assert main(["linescan", *arguments]) == status
    printed = capsys.readouterr()
    assert "Traceback" not in printed.err
    return printed.out if status == 0 else printed.err


def test_vehicles_agree_with_the_truth(
    road: Road, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "vehicles.csv"
    said = said_by(capsys, *road.files, *RIG, "-o", str(out))
    assert said.splitlines()[0] == f"3 vehicles, 3 measured; written to {out}."
    text = out.read_text()
    assert text.splitlines()[0] == (
        "id,front_line_1,rear_line_1,front_line_2,rear_line_2,speed_mps,u_speed_mps,acceleration_mps2,"
        "u_acceleration_mps2,length_m,u_length_m,fit_error_percent,time_gap_s,distance_gap_m,status,reason,direction,axles,"
        "lane"
    )
    rows = rows_of(text)
    assert [row["id"] for row in rows] == ["1", "2", "3"]
    for row, true in zip(rows, road.truth, strict=True):
        assert row["status"] == "ok" and row["reason"] == ""
        assert float(row["speed_mps"]) == pytest.approx(true.vehicle.speed_mps, rel=0.002)
        assert float(row["length_m"]) == pytest.approx(true.vehicle.length_m, abs=0.03)
        assert float(row["front_line_1"]) == pytest.approx(true.front_line_1, abs=8)
        assert float(row["rear_line_2"]) == pytest.approx(true.rear_line_2, abs=8)
        if true.time_gap_s is None or true.distance_gap_m is None:
            assert row["time_gap_s"] == row["distance_gap_m"] == ""
        else:
            assert float(row["time_gap_s"]) == pytest.approx(true.time_gap_s, abs=0.002)
            assert float(row["distance_gap_m"]) == pytest.approx(true.distance_gap_m, rel=0.02)


def test_a_calibrated_rig_with_lanes_measures_each_in_its_own(
    road: Road, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """All drive in the near lane, at 5 m; the rig's baseline there is the site's."""
    q, file = 0.004, tmp_path / "rig.json"
    near = {"name": "near", "distance_m": 5.0, "u_distance_m": 0.1, "baseline_m": 1.0}
    rows = {"tyres_from_px": 106, "tyres_to_px": 128}
    rig = {"baseline_m": SITE.baseline_m - 5 * q, "u_baseline_m": 0.0004, "divergence_rad": q}
    rig |= {"u_divergence_rad": 0.0001, "correlation": -0.9, "chi2": 3.1}
    far = {"distance_m": 8.5, "tyres_from_px": 84, "tyres_to_px": 106, "shadow_share": 0.3}
    file.write_text(json.dumps({**rig, "lanes": [{**near, **rows}, far]}))
    given = (*road.files, "--rig", str(file), "--line-rate", str(SITE.line_rate_hz))
    told = json.loads(said_by(capsys, *given, "--json"))
    assert [one["name"] for one in told["lanes"]] == ["near", "2"] and told["divergence_rad"] == q
    for one, true in zip(told["vehicles"], road.truth, strict=True):
        assert one["lane"] == "near" and one["tyres_px"] == pytest.approx(118, abs=4)
        assert one["speed_mps"] == pytest.approx(true.vehicle.speed_mps, rel=0.002)
        share = next(each for each in one["budget"] if each["source"] == "baseline")
        square = 0.0004**2 + (5 * 0.0001) ** 2 - 2 * 0.9 * 0.0004 * 5 * 0.0001 + (0.1 * q) ** 2
        assert share["u_speed_mps"] / one["speed_mps"] == pytest.approx(square**0.5 / SITE.baseline_m)
    both = said_by(capsys, *given, "--baseline", "0.6", status=2)
    assert "either --baseline" in both
    for wrong in (
        [],
        {"lanes": []},
        {**rig, "lanes": [{"name": "a"}]},
        {**rig, "lanes": [{**near, "direction": 1}]},
    ):
        file.write_text(json.dumps(wrong))
        assert "is not a rig" in said_by(capsys, *given, status=2)
    for beyond in ({"baseline_m": 10**400}, {"lanes": [{**near, "distance_m": 10**400}]}):
        file.write_text(json.dumps({**rig, **beyond}))
        assert "of inf m is out of range" in said_by(capsys, *given, status=2)
    file.write_text(json.dumps({**rig, "lanes": [near, near]}))
    assert "a name of its own" in said_by(capsys, *given, status=2)


def test_every_file_that_holds_the_strips_gives_the_same_table(
    road: Road, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    wanted = said_by(capsys, *road.files, *RIG, "--method", "paper")
    for name, pixels in zip(("first.tif", "second.tif"), road.pixels, strict=True):
        how = {"compression": "zstd", "tile": (1024, 128), "predictor": True, "bigtiff": True}
        tifffile.imwrite(tmp_path / name, pixels, **how)
    files = (str(tmp_path / "first.tif"), str(tmp_path / "second.tif"))
    assert said_by(capsys, *files, *RIG, "--method", "paper", "--time-axis", "height") == wanted


def test_json_holds_the_table_and_the_budget(road: Road, capsys: pytest.CaptureFixture[str]) -> None:
    said = json.loads(said_by(capsys, *road.files, *RIG, "--json"))
    assert (said["method"], said["rows"], said["baseline_m"]) == ("direct", 128, 0.593)
    assert len(said["vehicles"]) == 3 and said["notes"] == []
    for one in said["vehicles"]:
        assert one["status"] == "ok" and "profile" not in one
        sources = {entry["source"] for entry in one["budget"]}
        assert len(sources) == len(one["budget"]) >= 4
        total = np.sqrt(sum(entry["u_speed_mps"] ** 2 for entry in one["budget"]))
        assert one["u_speed_mps"] == pytest.approx(total, rel=1e-6)
    assert said["vehicles"][0]["gap_reason"] and said["vehicles"][1]["headway_s"] > 0
    unsure = json.loads(said_by(capsys, *road.files, *RIG[: -len(KNOWN)], "--json"))
    assert [note[note.index("(--") :] for note in unsure["notes"]] == ["(--u-baseline).", "(--u-line-rate)."]


@pytest.mark.parametrize("more_us", [0, -100])
def test_with_a_start_every_vehicle_has_its_time_of_day(
    more_us: int, road: Road, capsys: pytest.CaptureFixture[str]
) -> None:
    """The true front's time, by the offset that was given; its u is the start's and the front's own."""
    start = datetime(2026, 5, 4, 23, 59, 59, 200_000 + more_us, timezone(timedelta(hours=2)))
    options = ("--start", start.isoformat(), "--u-start", "0.02")
    said = json.loads(said_by(capsys, *road.files, *RIG, *options, "--json"))
    assert (said["start"], said["u_start_s"]) == ("2026-05-04T23:59:59.200+02:00", 0.02)
    rows = rows_of(said_by(capsys, *road.files, *RIG, *options))
    for row, one, true in zip(rows, said["vehicles"], road.truth, strict=True):
        assert row["front_at"] == one["front_at"] and row["front_at"][-6:] == "+02:00"
        true_at = start + timedelta(seconds=true.front_line_1 / SITE.line_rate_hz)
        at = datetime.fromisoformat(row["front_at"])
        assert abs((at - true_at).total_seconds()) < 0.0025
        counted = start + timedelta(seconds=float(row["front_line_1"]) / SITE.line_rate_hz)
        assert abs((at - counted).total_seconds()) <= 0.00051
        own_s = float(row["u_length_m"]) / float(row["speed_mps"])
        assert float(row["u_front_at_s"]) == pytest.approx((0.02**2 + own_s**2) ** 0.5, abs=5e-6)
    assert rows[0]["front_at"].startswith("2026-05-05T00:00:0")
    assert "front_at" not in rows_of(said_by(capsys, *road.files, *RIG))[0]
    # without the start's u that of a time is not known: the front's own alone would look like it
    unsure = json.loads(said_by(capsys, *road.files, *RIG, *options[:2], "--json"))
    assert any("--u-start" in note for note in unsure["notes"]) and said["notes"] == []
    assert {one["u_front_at_s"] for one in unsure["vehicles"]} == {None}


def test_notes_of_a_recorder_with_a_rate_beyond_every_number_are_refused(
    road: Road, capsys: pytest.CaptureFixture[str]
) -> None:
    notes = Path(f"{road.files[0]}.json")
    notes.write_text(json.dumps({"line_rate_hz": 10**400}))
    try:
        assert "line_rate_hz" in said_by(capsys, *road.files, *RIG, status=2)
    finally:
        notes.unlink()


def test_swapped_strips_are_recognised(road: Road, capsys: pytest.CaptureFixture[str]) -> None:
    said = json.loads(said_by(capsys, *reversed(road.files), *RIG, "--json"))
    assert {(one["direction"], one["status"]) for one in said["vehicles"]} == {("camera_2_first", "ok")}
    assert any("swapped" in note for note in said["notes"])


def test_lost_lines_leave_the_others_right(
    road: Road, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Eleven lines are gone from both strips in the middle of the second vehicle."""
    true = road.truth[1]
    at = int((true.front_line_1 + true.rear_line_1) / 2)
    files = []
    for name, pixels in zip(("first.tif", "second.tif"), road.pixels, strict=True):
        tifffile.imwrite(tmp_path / name, np.delete(pixels, range(at, at + 11), axis=0))
        (tmp_path / f"{name}.json").write_text(json.dumps({"dropped_lines": [[at, 11]]}))
        files.append(str(tmp_path / name))
    rows = rows_of(said_by(capsys, *files, *RIG, "--time-axis", "height"))
    assert [row["status"] for row in rows] == ["ok", "not_measurable", "ok"]
    assert "lost 11 lines of" in rows[1]["reason"]
    for row, true in zip(rows[2:], road.truth[2:], strict=True):
        assert float(row["front_line_1"]) == pytest.approx(true.front_line_1 - 11, abs=8)
        assert float(row["speed_mps"]) == pytest.approx(true.vehicle.speed_mps, rel=0.002)


def test_an_empty_road_is_a_table_without_rows(
    road: Road, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name, pixels in zip("ab", road.pixels, strict=True):
        cv2.imwrite(str(tmp_path / f"{name}.png"), pixels[:3000].T)
    assert road.truth[0].front_line_1 > 3500
    assert main(["linescan", str(tmp_path / "a.png"), str(tmp_path / "b.png"), *RIG]) == 0
    printed = capsys.readouterr()
    assert len(printed.out.splitlines()) == 1 and printed.err.startswith("No vehicle was found")


def test_bad_input_is_one_sentence_and_leaves_nothing(
    road: Road, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    first, second = road.pixels
    cv2.imwrite("first.png", first.T)
    cv2.imwrite("lower.png", second[:, 8:].T)
    cv2.imwrite("shorter.png", second[:-7].T)
    Path("text.png").write_text("nothing to see " * 20)
    Path("cut.png").write_bytes(Path(road.files[1]).read_bytes()[:200_000])
    before = sorted(tmp_path.iterdir())
    cases = {
        ("first.png", "nowhere.png", *RIG): "nowhere.png is not a file",
        ("first.png", "first.png", *RIG): "given twice",
        ("first.png", "lower.png", *RIG): "120",
        ("first.png", "shorter.png", *RIG): "shorter.png",
        ("first.png", "text.png", *RIG): "text.png is a text file",
        ("first.png", "cut.png", *RIG): "cut.png is cut off",
        ("first.png", road.files[1], *RIG, "--time-axis", "height"): "time along its height",
        ("first.png", road.files[1], *RIG, "-o", "nowhere/out.csv"): "nowhere/out.csv",
        ("first.png", road.files[1], "--baseline", "0", "--line-rate", "5000"): "--baseline of 0 m",
        ("first.png", road.files[1], "--baseline", "nan", "--line-rate", "5000"): "--baseline of nan m",
        ("first.png", road.files[1], "--baseline", "0.6", "--line-rate", "1"): "--line-rate of 1 Hz",
        ("first.png", road.files[1], "--baseline", "0.6"): "--line-rate",
        (*road.files, *RIG, "--start", "2026-05-04T06:00:00"): "has no offset from UTC",
        (*road.files, *RIG, "--start", "2026-05-04"): "has no offset from UTC",
        (*road.files, *RIG, "--start", "six o'clock"): "--start six o'clock is not a time",
        (*road.files, *RIG, "--start", "0001-01-01T00:00:00+02:00"): "is not a time that can be used",
        (*road.files, *RIG, "--start", "2026-05-04T06:00:00Z", "--u-start", "-1"): "--u-start -1",
        (*road.files, *RIG, "--u-start", "0.1"): "needs --start",
    }
    for arguments, word in cases.items():
        said = said_by(capsys, *arguments, status=2)
        assert word in said and said.count("\n") == 1, said
    assert sorted(tmp_path.iterdir()) == before
