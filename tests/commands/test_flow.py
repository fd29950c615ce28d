"""`sightline flow`: intervals against figures made by hand, an archive, and an hour of simulated traffic."""

from __future__ import annotations

import json
from collections.abc import Sequence
from datetime import timedelta
from math import ceil, hypot
from pathlib import Path
from statistics import fmean, harmonic_mean
from typing import Any

import pytest

from sightline.cli import main
from sightline.commands.scanned import about_rig, object_of
from sightline.errors import BadInput
from sightline.infra.local_time import instant_of
from sightline.linescan.finding import Finder
from sightline.linescan.parts import Lane, Rig
from sightline.linescan.passing import measure_passages
from sightline.linescan.rig import rig_from
from sightline.linescan.traffic import LENGTH_LIMITS_M
from sightline.traffic.archive import add_recorded
from sightline.traffic.query import ArchiveTables
from sightline.traffic.records import Asked, Stood
from sightline.traffic.sources import read_recorded
from tests.simulation.scan_strips import recording
from tests.simulation.scan_traffic import ScanSite, ScanTruth, traffic, truths
from tests.traffic.flow_files import (
    BY_HAND,
    LINE_0,
    RATE_HZ,
    ROWS,
    Row,
    as_json,
    flow,
    table,
    vehicle,
    written,
)
from tests.traffic.samples import recorded

pytestmark = pytest.mark.once


def test_intervals_are_those_made_by_hand(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = written(tmp_path / "vehicles.csv", ROWS)
    first, second, empty, last = table(flow(capsys, path, "--interval", "5"))
    starts = [one["interval_start"][11:19] for one in (first, second, empty, last)]
    assert starts == ["06:00:00", "06:05:00", "06:10:00", "06:15:00"]
    assert {one["interval_s"] for one in (first, second, empty, last)} == {"300.000000"}
    assert [one["vehicles"] for one in (first, second, empty, last)] == ["1", "3", "0", "1"]
    assert [one["refused"] for one in (first, second, empty, last)] == ["0", "1", "0", "0"]
    figures = {
        "flow_per_h": 36.0,
        "speed_mean_mps": 25.0,
        "speed_harmonic_mean_mps": 24.0,
        "headway_mean_s": 4.0,  # 3, 5 and 4 s
        "occupancy_percent": 100 * (0.30 + 0.30 + 0.22) / 300,
        "density_per_km": 36.0 / (3.6 * 24.0),
    }
    assert {name: float(second[name]) for name in figures} == pytest.approx(figures, abs=2e-6)
    assert {second[f"speed_p{percent}_mps"] for percent in (15, 50, 85)} == {""}
    assert "P85 needs 23; there are 2" in second["reasons"]
    lengths = [name for name in second if name.startswith("length_")]
    assert [second[name] for name in lengths] == ["1", "0", "1", "0", "1"]
    axles = [name for name in second if name.startswith("axles_")]
    assert [second[name] for name in axles] == ["1", "1", "0", "0", "0"]
    assert (float(empty["flow_per_h"]), empty["speed_mean_mps"]) == (0.0, "") and empty["reasons"]
    assert float(last["headway_mean_s"]) == pytest.approx(650.0) and last[lengths[3]] == "1"


def test_every_vehicle_is_in_one_interval_of_each_length(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = written(tmp_path / "vehicles.csv", ROWS)
    out, cars = tmp_path / "intervals.csv", tmp_path / "cars.csv"
    said = flow(capsys, path, "-o", out, "--vehicles", cars)
    assert said.startswith("5 vehicles, ") and "does not say how long was recorded" in said
    rows = table(out.read_text())
    counted = {
        length: sum(int(one["vehicles"]) for one in rows if one["minutes"] == length)
        for length in ("1", "5", "15", "60")
    }
    assert counted == dict.fromkeys(("1", "5", "15", "60"), 5)
    told = table(cars.read_text())
    assert [one["headway_s"] for one in told] == ["", "3.000000", "5.000000", "4.000000", "650.000000"]
    assert [one["state"] for one in told][1] == "not_measurable" and told[1]["reason"]
    assert [float(one["occupied_s"]) for one in told] == pytest.approx([one[1] for one in BY_HAND], abs=1e-5)


def test_no_headway_runs_from_one_that_was_in_view_when_the_recording_began(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Nobody saw its front, which is told as line 0."""
    path = written(tmp_path / "vehicles.csv", [vehicle(9, 0.0, 0.2, None, None, None), *ROWS])
    cars = tmp_path / "cars.csv"
    flow(capsys, path, "-o", tmp_path / "intervals.csv", "--vehicles", cars)
    told = [one["headway_s"] for one in table(cars.read_text())]
    assert told == ["", "", "3.000000", "5.000000", "4.000000", "650.000000"]
    first, *_ = table(flow(capsys, path, "--interval", "5"))
    assert (first["vehicles"], first["headway_mean_s"]) == ("2", "")


def test_the_ends_of_a_recording_are_parts_of_intervals(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """JSON says how long was recorded: 06:04:50 to 06:16:10."""
    path = as_json(tmp_path / "recording.json", 680.0, baseline_m=0.5, u_baseline_m=0.0005)
    rows = table(flow(capsys, path, "--interval", "5"))
    assert [float(one["interval_s"]) for one in rows] == [10.0, 300.0, 300.0, 70.0]
    assert [one["partial"] for one in rows] == ["true", "false", "false", "true"]
    assert [float(one["flow_per_h"]) for one in rows] == [360.0, 36.0, 0.0, pytest.approx(3600 / 70)]
    # all of the u is the rig's, which does not shrink with the number of vehicles
    assert float(rows[1]["u_speed_mean_mps"]) == pytest.approx(0.001 * 25.0, rel=1e-3)


def test_both_directions_and_lanes_are_apart(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    rows = [{**row, "lane": "near" if at % 2 else "far"} for at, row in enumerate(ROWS)]
    rows[2]["direction"] = "camera_2_first"
    found = table(flow(capsys, written(tmp_path / "vehicles.csv", rows), "--interval", "60"))
    counts = {(one["direction"], one["lane"]): one["vehicles"] for one in found}
    ways = [("camera_1_first", "far"), ("camera_1_first", "near"), ("camera_2_first", "far")]
    assert counts == dict(zip(ways, ("2", "2", "1"), strict=True))


@pytest.mark.parametrize("known", ["table", "json"])
def test_u_of_a_lanes_mean_is_not_that_of_another_lane(
    known: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Planes open by 10 +- 1 mrad: 0.5 permille of a speed at 5 m and 4 permille at 40 m, both common."""
    rig = Rig(
        *(10.0, 5000.0, 0.0, 0.0, 0.0, 1e-3),
        lanes=(Lane("near", 5.0, 1.0, "camera_1_first"), Lane("far", 40.0, 1.0, "camera_2_first")),
    )
    cars = [
        {
            **vehicle(n, 10.0 * n, 0.2, 20.0, 4.0, 2),
            "direction": way,
            "lane": lane,
            "u_speed_mps": str(20.0 * ratio),
        }
        for n, (way, lane, ratio) in enumerate(
            [("camera_1_first", "near", 5e-4), ("camera_2_first", "far", 4e-3)] * 9, 1
        )
    ]
    if known == "table":
        path = written(tmp_path / "vehicles.csv", cars)
    else:
        words = ("status", "direction", "lane")
        rows = [
            {name: cell if name in words else float(cell) for name, cell in one.items() if name != "front_at"}
            for one in cars
            if not one.pop("reason")
        ]
        for row in rows:
            row |= {end + "_s": row[end + "_line_1"] / RATE_HZ for end in ("front", "rear")}
        path = tmp_path / "recording.json"
        whole = {**about_rig(rig), "duration_s": 300.0, "start": LINE_0.isoformat(), "vehicles": rows}
        path.write_text(json.dumps(whole))
    near, far = table(flow(capsys, path, "--interval", "60"))
    assert (near["lane"], near["vehicles"], far["vehicles"]) == ("near", "9", "9")
    assert float(near["u_speed_mean_mps"]) == pytest.approx(20.0 * 5e-4, rel=1e-3)
    assert float(far["u_speed_mean_mps"]) == pytest.approx(20.0 * 4e-3, rel=1e-3)


def test_the_json_tells_the_rig_at_its_vehicles(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """0.5 permille at the cameras, with the divergence 1 permille at the vehicles, all of their u."""
    rig = Rig(0.6, 5000.0, 3e-4, 0.0, 0.0, 1.04e-4, 5.0)
    assert rig_from(about_rig(rig)) == rig
    path = as_json(tmp_path / "recording.json", 680.0, **about_rig(rig))
    second = table(flow(capsys, path, "--interval", "5"))[1]
    assert float(second["u_speed_mean_mps"]) == pytest.approx(0.001 * 25.0, rel=1e-3)


def test_a_resumed_stream_is_on_one_clock(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A pipe of 06:00, resumed at 09:00 after a kill: seconds begin anew, one vehicle came twice."""
    first = {
        **{name: None for name in ("reason", "lane", "u_speed_mps", "length_m", "u_length_m")},
        **{"id": 1, "segment": 1, "status": "ok", "direction": "camera_1_first", "speed_mps": 20.0},
        **{"front_s": 5.0, "rear_s": 5.2, "front_line_1": 25_000.0, "rear_line_1": 26_000.0},
        "front_at": "2026-05-04T06:00:05+00:00",
    }
    later = {"front_s": 9.0, "rear_s": 9.2, "front_at": "2026-05-04T06:00:09.000001+00:00"}
    second = {**first, "id": 2, **later}
    third = {**first, "id": 3, "segment": 2, "front_at": "2026-05-04T09:00:05+00:00"}
    path = tmp_path / "stream.jsonl"
    path.write_text("\n".join(map(json.dumps, (first, second, second, third))))
    rows = table(flow(capsys, path, "--interval", "60"))
    hours = {one["interval_start"][11:13]: one for one in rows}
    assert {hour: one["vehicles"] for hour, one in hours.items()} == {
        "06": "2",
        "07": "0",
        "08": "0",
        "09": "1",
    }
    assert float(hours["06"]["headway_mean_s"]) == pytest.approx(4.0, abs=1e-5)
    assert {one["near_edge"] for one in rows} == {"", "0"} and hours["07"]["near_edge"] == "0"
    told = read_recorded(path, 4 * 3600.0)
    assert [one.front_s for one in told.passings] == pytest.approx([5.0, 9.0, 3 * 3600 + 5.0], abs=1e-5)
    assert told.passings[2].rear_s == pytest.approx(3 * 3600 + 5.2)
    unseen = {"front_s": 20.0, "rear_s": None, "rear_line_1": None, "front_at": "2026-05-04T09:00:20+00:00"}
    path.write_text("\n".join(map(json.dumps, (first, second, third, {**third, "id": 4, **unseen}))))
    told = read_recorded(path, 4 * 3600.0)
    seconds = [(one.front_s, one.rear_s) for one in told.passings[2:]]
    assert seconds == [
        pytest.approx((3 * 3600 + 5.0, 3 * 3600 + 5.2)),
        (pytest.approx(3 * 3600 + 20.0), None),
    ]
    path.write_text(json.dumps({name: value for name, value in first.items() if name != "front_s"}))
    with pytest.raises(BadInput, match="front_s"):
        read_recorded(path, 4 * 3600.0)


def test_lost_lines_and_whole_ms_leave_the_time_before_the_camera(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """2 vehicles within a second, 1500 of 2000 lines between them lost."""
    rows = [vehicle(n, at, 0.2, 20.0, 4.0, 2) for n, at in ((1, 8.0), (2, 8.4004))]
    rows[1] |= {name: str(float(rows[1][name]) - 1500) for name in ("front_line_1", "rear_line_1")}
    cars = tmp_path / "cars.csv"
    flow(capsys, written(tmp_path / "vehicles.csv", rows), "-o", tmp_path / "out.csv", "--vehicles", cars)
    assert [float(one["occupied_s"]) for one in table(cars.read_text())] == pytest.approx([0.2, 0.2])


def test_a_folder_is_read_file_by_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    written(tmp_path / "a.csv", ROWS)
    as_json(tmp_path / "b.json", 680.0)
    (tmp_path / "notes.json").write_text("{}")
    said = json.loads(flow(capsys, tmp_path, "--interval", "60", "--json"))
    assert {one["recording"] for one in said["intervals"]} == {"a.csv", "b.json"}
    assert len(said["vehicles"]) == 10 and any("notes.json" in note for note in said["notes"])


def test_an_archive_agrees_with_its_own_figures(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Two computations that share only who counts: DuckDB's over Parquet, and this."""
    zone = "Europe/Paris"
    stood = Stood("Hill", "near", zone, instant_of("2026-05-04T05:00", zone), 0.1)
    add_recorded(tmp_path, recorded(4, 500, 7200.0), stood)
    found = table(flow(capsys, tmp_path, "--interval", "15"))
    with ArchiveTables(tmp_path) as tables:
        rows = list(tables.intervals(Asked(minutes=15)))
    assert len(found) == len(rows) == 8
    for ours, theirs in zip(found, rows, strict=True):
        assert ours["interval_start"][:16] == theirs["from"][:16] and ours["lane"] == "near"
        assert int(ours["vehicles"]) == theirs["vehicles"] and int(ours["measured"]) == theirs["measured"]
        assert int(ours["refused"]) == theirs["vehicles"] - theirs["measured"] > 0
        for own, other in (
            ("flow_per_h", "flow_per_hour"),
            ("speed_mean_mps", "time_mean_speed_mps"),
            ("speed_harmonic_mean_mps", "space_mean_speed_mps"),
            ("speed_p85_mps", "p85_speed_mps"),
        ):
            assert float(ours[own]) == pytest.approx(theirs[other], abs=2e-6)


def test_an_archive_keeps_the_u_of_the_line_rate(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """After 670 s 1e-4 are 67 ms, which the archive's vehicles went without."""
    path = as_json(tmp_path / "recording.json", 680.0, u_start_s=0.1, u_line_rate_ratio=1e-4)
    add_recorded(tmp_path / "archive", read_recorded(path, None), Stood("Hill", "", "UTC", LINE_0, 0.1))
    assert not json.loads(flow(capsys, path, "--json"))["notes"]
    untold = as_json(tmp_path / "untold.json", 680.0)
    (note,) = json.loads(flow(capsys, untold, "--json"))["notes"]
    assert note.startswith("The uncertainties of the times of untold.json and near_edge are left out")
    bare = written(tmp_path / "untold.csv", [{**row, "u_front_at_s": ""} for row in ROWS])
    notes = json.loads(flow(capsys, bare, "--json"))["notes"]
    assert any(one.startswith("The uncertainties of the times of untold.csv") for one in notes)
    told = []
    for place in (path, tmp_path / "archive"):
        cars = tmp_path / "cars.csv"
        flow(capsys, place, "-o", tmp_path / "out.csv", "--vehicles", cars)
        told.append([one["u_front_at_s"] for one in table(cars.read_text())])
    assert told[0] == told[1] and float(told[0][-1]) == pytest.approx(hypot(0.1, 0.067), rel=1e-3)


def test_times_of_a_stream_have_no_u_for_that_of_its_start_is_not_known(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """0.2 ms of its front alone would look like the u of a time that a computer's clock told."""
    recording = json.loads(as_json(tmp_path / "recording.json", 680.0).read_text())
    ats = {"segment": 1, "reason": None}
    cars = [
        {**one, **ats, "front_at": (LINE_0 + timedelta(seconds=one["front_s"])).isoformat()}
        for one in recording["vehicles"]
    ]
    path = tmp_path / "stream.jsonl"
    path.write_text("\n".join(map(json.dumps, cars)))
    told = json.loads(flow(capsys, path, "--interval", "5", "--json"))
    assert {one["u_front_at_s"] for one in told["vehicles"]} == {None}
    assert {one["near_edge"] for one in told["intervals"] if one["vehicles"]} == {None}
    refused = {"status": "not_measurable", "reason": "", **dict.fromkeys(("speed_mps", "u_speed_mps"))}
    refused |= dict.fromkeys(("length_m", "u_length_m"))
    path.write_text("\n".join(json.dumps({**one, **refused}) for one in cars))
    alone = json.loads(flow(capsys, path, "--interval", "5", "--json"))["intervals"]
    assert any(one["refused"] for one in alone) and not any(one["measured"] for one in alone)
    assert {one["near_edge"] for one in alone if one["vehicles"]} == {None}
    assert any(note.startswith("The uncertainties of the times of stream.jsonl") for note in told["notes"])


def test_times_of_a_table_have_the_u_that_it_states_or_none(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = written(tmp_path / "vehicles.csv", ROWS)
    said = "The uncertainties of the times of vehicles.csv"
    assert not any(said in note for note in json.loads(flow(capsys, path, "--json"))["notes"])
    written(path, [{**row, "u_front_at_s": ""} for row in ROWS])
    told = json.loads(flow(capsys, path, "--json"))
    assert any(said in note for note in told["notes"])
    assert {one["near_edge"] for one in told["intervals"] if one["vehicles"]} == {None}
    written(path, [{**row, "u_front_at_s": "-0.01"} for row in ROWS])
    assert main(["flow", str(path)]) == 2
    assert "line 2: u_front_at_s is “-0.01”; an uncertainty is not below 0" in capsys.readouterr().err


def _without(row: Row, *names: str) -> Row:
    return {name: cell for name, cell in row.items() if name not in names}


@pytest.mark.parametrize(
    ("rows", "arguments", "said"),
    [
        (ROWS, ("--interval", "7"), "--interval 7 cannot be used"),
        (ROWS, ("--interval", "x"), "--interval x cannot be used"),
        ([_without(row, "front_at", "u_front_at_s") for row in ROWS], (), "does not state when its vehicles"),
        ([{**ROWS[0], "front_at": "2026-05-04T06:05:00"}], (), "does not state when its vehicles"),
        ([_without(row, "rear_line_1") for row in ROWS], (), "rear_line_1"),
        ([{**ROWS[0], "speed_mps": "20,1"}], (), "line 2"),
        ([ROWS[1]], (), "single vehicle without a motion"),
        ([ROWS[0], ROWS[2], {**ROWS[3], "rear_line_1": "0"}], (), "outside the recording"),
        ([ROWS[0], {**ROWS[2], "id": "1"}], (), "twice"),
        ([ROWS[0], {**ROWS[2], "front_at": "2036-05-04T06:05:00+02:00"}], (), "outside the recording"),
    ],
)  # fmt: skip
def test_what_cannot_be_used_is_refused_in_words(
    rows: list[Row], arguments: tuple[str, ...], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert said in flow(capsys, written(tmp_path / "vehicles.csv", rows), *arguments, status=2)


def test_nothing_to_read_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert "does not exist" in flow(capsys, tmp_path / "nowhere", status=2)
    assert "contains no scanned vehicles" in flow(capsys, tmp_path, status=2)
    as_json(tmp_path / "recording.json", 680.0, start=None)
    assert "does not state when" in flow(capsys, tmp_path, status=2)
    (tmp_path / "recording.json").write_text("")
    assert "contains no vehicle" in flow(capsys, tmp_path / "recording.json", status=2)


def test_a_single_vehicles_motion_gives_its_time_before_the_camera(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """10 m/s and 2 m/s2: 5.25 m take 0.5 s."""
    row = {**ROWS[0], "speed_mps": "10", "length_m": "5.25", "acceleration_mps2": "1.0"}
    (one,) = table(flow(capsys, written(tmp_path / "vehicles.csv", [row]), "--interval", "60"))
    slow = 10.0 / 1.0 * ((1 + 2 * 1.0 * 5.25 / 100) ** 0.5 - 1)
    assert float(one["occupancy_percent"]) == pytest.approx(100 * slow / 3600, abs=1e-6)


@pytest.mark.parametrize(
    ("seed", "vehicles", "gaps_s"),
    [(5, 3, (0.6, 1.4)), pytest.param(31, 690, (0.6, 9.0), marks=pytest.mark.proof)],
)
def test_simulated_traffic_against_its_truth(
    seed: int,
    vehicles: int,
    gaps_s: tuple[float, float],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """From strips to intervals; with 690 vehicles an hour of them."""
    site = ScanSite(rows=64, line_rate_hz=2000.0)
    cars = traffic(seed, vehicles, speeds_mps=(14.0, 30.0), gaps_s=gaps_s)
    true, duration_s = truths(site, cars), cars[-1].clear_s(site.baseline_m) + 0.4
    path = tmp_path / "recording.json"
    path.write_text(json.dumps(scanned(site, cars, duration_s)))
    rows = table(flow(capsys, path))
    lengths = [name for name in rows[0] if name.startswith("length_")][:-1]
    for minutes in (1, 5, 15, 60):
        own = [one for one in rows if one["minutes"] == str(minutes)]
        assert (
            len(own) == ceil(duration_s / (60 * minutes))
            and sum(int(one["vehicles"]) for one in own) == vehicles
        )
        for number, one in enumerate(own):
            begin_s = 60.0 * minutes * number
            watched_s = min(60.0 * minutes, duration_s - begin_s)
            here = [car for car in true if begin_s <= car.vehicle.front_s < begin_s + 60 * minutes]
            assert int(one["vehicles"]) == len(here)
            assert float(one["flow_per_h"]) == pytest.approx(3600 * len(here) / watched_s, rel=1e-3)
            assert float(one["occupancy_percent"]) == pytest.approx(
                occupied_percent(true, site, begin_s, watched_s), rel=3e-3, abs=1e-3
            )
            speeds = [car.vehicle.speed_mps for car in here]
            if one["refused"] == "0" and speeds:
                assert float(one["speed_mean_mps"]) == pytest.approx(fmean(speeds), rel=1e-3)
                assert float(one["speed_harmonic_mean_mps"]) == pytest.approx(harmonic_mean(speeds), rel=1e-3)
                assert sum(int(one[name]) for name in lengths) == len(here)
                shorter = sum(car.vehicle.length_m <= LENGTH_LIMITS_M[0] for car in here)
                assert int(one[lengths[0]]) == shorter
    whole = rows[-1] if vehicles > 5 else None
    assert whole is None or float(whole["refused"]) <= 0.01 * vehicles


def scanned(site: ScanSite, cars: Any, duration_s: float) -> dict[str, Any]:
    """What `linescan --json` says of simulated strips."""
    rig = Rig(site.baseline_m, site.line_rate_hz)
    finder = Finder(site.rows, rig)

    def passages() -> Any:
        for pair in recording(site, cars):
            yield from finder.push(*pair)
        yield from finder.finish()

    found = [object_of(one) for one in measure_passages(passages(), rig, "direct", lambda lines: lines)]
    start = "2026-05-04T06:00:00.000+02:00"
    return {**about_rig(rig), "duration_s": duration_s, "start": start, "vehicles": found}


def occupied_percent(true: Sequence[ScanTruth], site: ScanSite, begin_s: float, watched_s: float) -> float:
    """Vehicles of one lane are never beside each other."""
    ends = [(one.front_line_1 / site.line_rate_hz, one.rear_line_1 / site.line_rate_hz) for one in true]
    inside = [min(rear, begin_s + watched_s) - max(front, begin_s) for front, rear in ends]
    return 100 * sum(one for one in inside if one > 0) / watched_s
