"""Figures of intervals against a count in NumPy that shares nothing with the query."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import replace
from datetime import date
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sightline.linescan.parts import STOOD, STOPPED
from sightline.linescan.traffic import Passed, length_classes
from sightline.messages.said import Said
from sightline.statistics.distributions import vehicles_for_interval
from sightline.traffic.archive import add_recorded
from sightline.traffic.query import ALL, NO_LENGTH, ArchiveTables, classes_of, percentile_column
from sightline.traffic.records import Asked, Passing, Recorded
from sightline.traffic.results import results_in, traffic_of
from tests.support.proofs import PROOFS
from tests.traffic.samples import recorded
from tests.traffic.test_archive import stood

HOURS = 26.0


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("archive")
    add_recorded(made, recorded(21, 2000, HOURS * 3600), stood("2026-05-04T05:20:00"))
    add_recorded(made, recorded(22, 700, 5000.0), stood("2026-05-04T07:00", lane="left"))
    add_recorded(made, recorded(23, 40, 600.0), stood("2026-07-01T12:00", site="Valley"))
    return made


def test_every_figure_is_a_recount(folder: Path) -> None:
    begins = 5 * 3600 + 20 * 60
    cells: dict[int, list[Passing]] = defaultdict(list)
    for one in recorded(21, 2000, HOURS * 3600).passings:
        cells[int((begins + one.front_s) // 900)].append(one)
    asked = Asked(sites=("Hill",), minutes=15, percents=(5.0, 20.0, 50.0, 80.0, 99.5))
    with ArchiveTables(folder) as tables:
        rows = [row for row in tables.intervals(asked) if row["lane"] == ""]
    assert len(rows) == 105  # of 26 h that begin at 5:20, 103 whole and two in part
    first = int(begins // 900)
    standing = merged([(one.front_s, one.rear_s) for one in recorded(21, 2000, HOURS * 3600).passings])
    for place, row in enumerate(rows):
        here = cells.get(first + place, [])
        speeds = np.array([one.speed_mps for one in here if one.speed_mps is not None])
        assert (row["vehicles"], row["measured"]) == (len(here), len(speeds))
        if not len(speeds):
            assert row["space_mean_speed_mps"] is None and row["reason"]
            continue
        assert row["time_mean_speed_mps"] == pytest.approx(speeds.mean(), rel=1e-12)
        assert row["space_mean_speed_mps"] == pytest.approx(len(speeds) / (1 / speeds).sum(), rel=1e-12)
        assert row["space_mean_speed_mps"] <= row["time_mean_speed_mps"] * (1 + 1e-12)
        assert row["u_mean_speed_mps"] == pytest.approx(4e-4 * speeds.mean(), rel=1e-12)
        few = [one for one in asked.percents if len(speeds) < vehicles_for_interval(one)]
        assert [one for one in asked.percents if row[percentile_column(one)] is None] == few
        for percent in asked.percents:
            true = np.quantile(speeds, percent / 100, method="median_unbiased")
            assert percent in few or row[percentile_column(percent)] == pytest.approx(true, rel=1e-12)
        if row["watched_s"] == 900.0:
            assert row["flow_per_hour"] == pytest.approx(4 * len(here))
            edge = (first + place) * 900.0 - begins
            parts = [
                (max(a, edge), min(b, edge + 900.0)) for a, b in standing if b > edge and a < edge + 900.0
            ]
            occupied = sum(b - a for a, b in parts)
            assert row["occupancy_ratio"] == pytest.approx(occupied / 900.0, rel=1e-8)
            told = [f"P{one:g} needs {vehicles_for_interval(one)}; there are {len(speeds)}" for one in few]
            assert (row["reason"] or "") == "; ".join(told)


def standing_passing(number: int, front_s: float, rear_s: float) -> Passing:
    """Of a vehicle before camera 1 between two moments."""
    lines = 1000.0 * front_s, 1000.0 * rear_s
    return Passing(
        number, front_s, rear_s, *lines, 5.0, 0.1, None, None, 4.5, 0.1, None, None, status="ok", reason=None
    )


def merged(spans: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """The same time without overlaps."""
    found: list[tuple[float, float]] = []
    for begin, end in sorted(spans):
        if found and begin <= found[-1][1]:
            found[-1] = found[-1][0], max(end, found[-1][1])
        else:
            found.append((begin, end))
    return found


def test_who_stands_occupies_every_interval_and_the_next_day(tmp_path: Path) -> None:
    queue = (standing_passing(1, 1750.0, 2150.0), standing_passing(2, 2160.0, 2165.0))
    add_recorded(tmp_path, Recorded("queue", "ab" * 32, 3600.0, queue, ()), stood("2026-05-04T23:30"))
    with ArchiveTables(tmp_path) as tables:
        rows = {row["from"][8:16]: row for row in tables.intervals(Asked(minutes=5))}
    # the clock shows 24:00 after 1,800 s
    assert rows["04T23:55"]["occupancy_ratio"] == pytest.approx(50 / 300)
    assert rows["05T00:00"]["occupancy_ratio"] == pytest.approx(1.0)
    assert rows["05T00:05"]["occupancy_ratio"] == pytest.approx((50 + 5) / 300)
    assert rows["05T00:10"]["occupancy_ratio"] == 0.0
    assert [rows[at]["vehicles"] for at in ("04T23:55", "05T00:00", "05T00:05")] == [1, 0, 1]
    with ArchiveTables(tmp_path) as tables:
        later = list(tables.intervals(Asked(first_day=date(2026, 5, 5), minutes=5)))
    assert later == [row for row in rows.values() if row["from"] >= "2026-05-05"]


def test_two_that_stand_beside_each_other_at_midnight_occupy_it_once(tmp_path: Path) -> None:
    """One until 200 s after it; two others until 100 and 150 s after it."""
    beside = replace(standing_passing(2, 1790.0, 1900.0), direction="camera_2_first")
    cars = (standing_passing(1, 1700.0, 2000.0), beside, standing_passing(3, 1850.0, 1950.0))
    add_recorded(tmp_path, Recorded("queue", "ab" * 32, 3600.0, cars, ()), stood("2026-05-04T23:30"))
    with ArchiveTables(tmp_path) as tables:
        rows = {row["from"][8:16]: row["occupancy_ratio"] for row in tables.intervals(Asked(minutes=5))}
    assert (rows["04T23:55"], rows["05T00:00"]) == (pytest.approx(100 / 300), pytest.approx(200 / 300))


def test_the_median_gap_is_of_measured_vehicles(tmp_path: Path) -> None:
    """Three refused vehicles came 0.1 s after others, by rough fronts; those measured 2 s."""
    came = [
        replace(standing_passing(n, 10.0 * n, 10.0 * n + 1), time_gap_s=gap, speed_mps=speed)
        for n, (gap, speed) in enumerate([(2.0, 5.0), (0.1, None), (2.0, 5.0), (0.1, None), (0.1, None)], 1)
    ]
    add_recorded(tmp_path, Recorded("gaps", "ab" * 32, 300.0, tuple(came), ()), stood("2026-05-04T12:00"))
    with ArchiveTables(tmp_path) as tables:
        (row,) = tables.intervals(Asked(minutes=5))
    assert row["median_time_gap_s"] == 2.0


def test_a_length_at_a_limit_is_of_the_shorter_class_here_and_in_flow(tmp_path: Path) -> None:
    cars = tuple(replace(standing_passing(n, 10.0 * n, 10.0 * n + 1), length_m=6.0) for n in (1, 2))
    add_recorded(tmp_path, Recorded("limit", "ab" * 32, 300.0, cars, ()), stood("2026-05-04T12:00"))
    with ArchiveTables(tmp_path) as tables:
        rows = list(tables.intervals(Asked(minutes=5, limits_m=(6.0, 12.0))))
    counts = {row["class"]: row["vehicles"] for row in rows}
    assert counts == {ALL: 2, "to 6 m": 2, "6 to 12 m": 0, "above 12 m": 0, NO_LENGTH: 0}
    passed = [Passed(one.front_s, one.occupied_s, length_m=one.length_m) for one in cars]
    assert [one.vehicles for one in length_classes(passed, (6.0, 12.0))] == [2, 0, 0]


def test_occupancy_is_empty_from_a_rear_that_nobody_saw_to_the_next_front(tmp_path: Path) -> None:
    unseen = replace(standing_passing(1, 100.0, 100.0), rear_s=None, rear_line_1=None, length_m=None)
    beside = standing_passing(2, 110.0, 110.5)  # while it stands, of which 0 was told from 300 s on
    cars = (unseen, beside, standing_passing(3, 700.0, 706.0))
    add_recorded(tmp_path, Recorded("one", "ab" * 32, 1200.0, cars, ()), stood("2026-05-04T12:00"))
    with ArchiveTables(tmp_path) as tables:
        rows = list(tables.intervals(Asked(minutes=5, limits_m=(6.0,))))
    shown = {
        name: [row["occupancy_ratio"] for row in rows if row["class"] == name] for name in (ALL, NO_LENGTH)
    }
    assert shown == {ALL: [None, None, None, 0.0], NO_LENGTH: [None, None, None, 0.0]}
    short = [row["occupancy_ratio"] for row in rows if row["class"] == "to 6 m"]
    assert short == [pytest.approx(0.5 / 300), 0.0, pytest.approx(6 / 300), 0.0]
    assert "the rear of a vehicle that stood was not seen" in rows[0]["reason"]


def test_occupancy_is_empty_to_the_end_of_a_recording_in_which_nobody_saw_it_leave(tmp_path: Path) -> None:
    """0 was told from 900 s on, after another had passed beside it."""
    unseen = replace(standing_passing(1, 400.0, 400.0), rear_s=None, rear_line_1=None, reason=str(STOOD))
    cars = (unseen, standing_passing(3, 700.0, 706.0))
    add_recorded(tmp_path, Recorded("one", "ab" * 32, 1200.0, cars, ()), stood("2026-05-04T12:00"))
    add_recorded(tmp_path, Recorded("two", "cd" * 32, 300.0, (), ()), stood("2026-05-04T12:25"))
    with ArchiveTables(tmp_path) as tables:
        rows = list(tables.intervals(Asked(minutes=5)))
    assert [row["occupancy_ratio"] for row in rows] == [0.0, None, None, None, 0.0]


@pytest.mark.parametrize(
    ("reason", "rear_s", "told"),
    [(STOOD, None, [None, None, 0.0]), (STOPPED, 1799.99, [None, None, 0.0]), (STOPPED, 1700.0, [0.0] * 3)],
)
def test_who_stands_when_a_recording_ends_is_the_road_of_the_next(
    tmp_path: Path, reason: Said, rear_s: float | None, told: list[float | None]
) -> None:
    """The next one begins 30 s later, after midnight, and told 0; one an hour later knows of nothing."""
    stands = replace(standing_passing(1, 1200.0, rear_s or 1200.0), reason=str(reason), length_m=None)
    stands = replace(stands, rear_s=rear_s, speed_mps=None, status="not_measurable")
    add_recorded(tmp_path, Recorded("one", "ab" * 32, 1800.0, (stands,), ()), stood("2026-05-04T23:30"))
    add_recorded(tmp_path, Recorded("two", "cd" * 32, 570.0, (), ()), stood("2026-05-05T00:00:30"))
    add_recorded(tmp_path, Recorded("three", "ef" * 32, 300.0, (), ()), stood("2026-05-05T01:00"))
    with ArchiveTables(tmp_path) as tables:
        rows = list(tables.intervals(Asked(minutes=5)))
        later = list(tables.intervals(Asked(first_day=date(2026, 5, 5), minutes=5)))
    assert later == [row for row in rows if row["from"] >= "2026-05-05"]
    assert [row["occupancy_ratio"] for row in later] == told
    by_flow = [one for scan in traffic_of(results_in(tmp_path)[0], 5) for one in scan.intervals]
    assert [one.occupancy_percent.value for one in by_flow[6:]] == told


def test_who_stands_through_a_whole_recording_leaves_no_trace_in_it(tmp_path: Path) -> None:
    """The third, which begins as the second ends, told 0.02; after one has driven through it is gone."""
    stands = replace(standing_passing(1, 200.0, 200.0), rear_s=None, rear_line_1=None, reason=str(STOOD))
    stands = replace(stands, speed_mps=None, status="not_measurable")
    for number, cars in enumerate(((stands,), (), (standing_passing(1, 100.0, 106.0),), ())):
        one = Recorded(f"{number}", 64 * f"{number}", 300.0, cars, ())
        add_recorded(tmp_path, one, stood(f"2026-05-04T12:{5 * number:02}"))
    with ArchiveTables(tmp_path) as tables:
        rows = list(tables.intervals(Asked(minutes=5)))
    assert [row["occupancy_ratio"] for row in rows] == [None, None, None, 0.0]
    by_flow = [one for scan in traffic_of(results_in(tmp_path)[0], 5) for one in scan.intervals]
    assert [one.occupancy_percent.value for one in by_flow] == [None, None, None, 0.0]


def test_one_of_unknown_lane_that_stands_may_stand_in_any(tmp_path: Path) -> None:
    cars = [
        replace(standing_passing(n, 30.0 * n, 30.0 * n + 0.5), lane=lane) for n, lane in ((1, "a"), (2, "b"))
    ]
    stands = replace(standing_passing(3, 1000.0, 1000.0), rear_s=None, rear_line_1=None, reason=str(STOOD))
    stands = replace(stands, speed_mps=None, u_speed_mps=None, length_m=None, status="not_measurable")
    one = Recorded("one", "ab" * 32, 1800.0, (*cars, stands), ("a", "b"))
    add_recorded(tmp_path, one, stood("2026-05-04T12:00"))
    add_recorded(
        tmp_path, Recorded("two", "cd" * 32, 900.0, tuple(cars), ("a", "b")), stood("2026-05-04T12:30")
    )
    with ArchiveTables(tmp_path) as tables:
        rows = list(tables.intervals(Asked(minutes=15)))
    share = pytest.approx(0.5 / 900)
    shown = {lane: [row["occupancy_ratio"] for row in rows if row["lane"] == lane] for lane in ("a", "b", "")}
    assert shown == {"a": [share, None, None], "b": [share, None, None], "": [0.0, None]}
    by_flow: dict[str, list[float | None]] = defaultdict(list)
    for scan in traffic_of(results_in(tmp_path)[0], 15):
        by_flow[scan.lane or ""] += [one.occupancy_percent.value for one in scan.intervals]
    percent = pytest.approx(100 * 0.5 / 900)
    assert by_flow == {"a": [percent, None, None], "b": [percent, None, None], "": [0.0, None]}


def test_one_of_unknown_lane_that_stopped_until_the_end_may_stand_in_any(tmp_path: Path) -> None:
    """Its rear was told at the end of its recording, and the next one told 0.02 for both lanes."""
    a, b = (
        replace(standing_passing(n, 100.0 * n, 100.0 * n + 6), lane=name) for n, name in ((1, "a"), (2, "b"))
    )
    stops = replace(standing_passing(3, 250.0, 299.99), reason=str(STOPPED), status="not_measurable")
    stops = replace(stops, speed_mps=None, u_speed_mps=None, length_m=None)
    for number, cars in enumerate(((a, b, stops), (a, b))):
        one = Recorded(f"{number}", 64 * f"{number}", 300.0, cars, ("a", "b"))
        add_recorded(tmp_path, one, stood(f"2026-05-04T12:{5 * number:02}"))
    with ArchiveTables(tmp_path) as tables:
        rows = list(tables.intervals(Asked(minutes=5)))
    told = {lane: [row["occupancy_ratio"] for row in rows if row["lane"] == lane] for lane in ("a", "b")}
    assert told == {lane: [pytest.approx(0.02), None] for lane in "ab"}
    by_flow = [(scan.lane, one) for scan in traffic_of(results_in(tmp_path)[0], 5) for one in scan.intervals]
    percents = {lane: [one.occupancy_percent.value for of, one in by_flow if of == lane] for lane in told}
    assert percents == {lane: [pytest.approx(2.0), None] for lane in "ab"}


@pytest.mark.parametrize("leaves", [False, True])
def test_one_of_unknown_lane_is_gone_from_each_lane_that_another_has_driven_through(
    tmp_path: Path, leaves: bool
) -> None:
    """Or from all, where it was seen to leave."""
    stands = replace(standing_passing(3, 200.0, 200.0), rear_s=None, rear_line_1=None, reason=str(STOOD))
    stands = replace(stands, speed_mps=None, u_speed_mps=None, length_m=None, status="not_measurable")
    left = replace(stands, front_s=0.0, front_line_1=0.0, rear_s=50.0, rear_line_1=5e4, reason=str(STOPPED))
    a, b = (
        replace(standing_passing(n, 100.0 * n, 100.0 * n + 6), lane=name) for n, name in ((1, "a"), (2, "b"))
    )
    by_recording = ((a, b, stands), (left,) if leaves else (a,), (a, b), (a, b))
    for number, cars in enumerate(by_recording):
        one = Recorded(f"{number}", 64 * f"{number}", 300.0, cars, ("a", "b"))
        add_recorded(tmp_path, one, stood(f"2026-05-04T12:{5 * number:02}"))
    with ArchiveTables(tmp_path) as tables:
        rows = list(tables.intervals(Asked(minutes=5)))
    shown = {lane: [row["occupancy_ratio"] for row in rows if row["lane"] == lane] for lane in ("a", "b")}
    share, stays = pytest.approx(0.02), None if not leaves else pytest.approx(0.02)
    assert shown == {"a": [None, None, share, share], "b": [None, None, stays, share]}
    by_flow: dict[str, list[float | None]] = defaultdict(list)
    for scan in traffic_of(results_in(tmp_path)[0], 5)[-4:]:
        by_flow[scan.lane or ""] += [one.occupancy_percent.value for one in scan.intervals]
    percent = pytest.approx(2.0)
    assert {lane: told for lane, told in by_flow.items() if lane} == {
        "a": [percent, percent],
        "b": [percent if leaves else None, percent],
    }


def test_one_of_unknown_lane_that_leaves_is_not_one_that_stood_in_a_known_lane(tmp_path: Path) -> None:
    stands = replace(standing_passing(3, 200.0, 200.0), rear_s=None, rear_line_1=None, reason=str(STOOD))
    stands = replace(stands, speed_mps=None, u_speed_mps=None, length_m=None, status="not_measurable")
    left = replace(stands, front_s=0.0, front_line_1=0.0, rear_s=50.0, rear_line_1=5e4, reason=str(STOPPED))
    a, b = (
        replace(standing_passing(n, 100.0 * n, 100.0 * n + 6), lane=name) for n, name in ((1, "a"), (2, "b"))
    )
    by_recording = ((b, replace(stands, lane="a")), (left, b), (a, b), (a, b))
    for number, cars in enumerate(by_recording):
        one = Recorded(f"{number}", 64 * f"{number}", 300.0, cars, ("a", "b"))
        add_recorded(tmp_path, one, stood(f"2026-05-04T12:{5 * number:02}"))
    with ArchiveTables(tmp_path) as tables:
        rows = list(tables.intervals(Asked(minutes=5)))
    shown = {lane: [row["occupancy_ratio"] for row in rows if row["lane"] == lane] for lane in ("a", "b")}
    share = pytest.approx(0.02)
    assert shown == {"a": [None, None, None, share], "b": [share] * 4}
    by_flow: dict[str | None, list[float | None]] = defaultdict(list)
    for scan in traffic_of(results_in(tmp_path)[0], 5):
        by_flow[scan.lane] += [one.occupancy_percent.value for one in scan.intervals]
    percent = pytest.approx(2.0)
    assert (by_flow["a"], by_flow["b"]) == ([None, None, percent], [percent] * 4)


def test_a_rear_that_nobody_saw_is_of_its_recording_and_goes_over_midnight(tmp_path: Path) -> None:
    unseen = replace(standing_passing(1, 1700.0, 1700.0), rear_s=None, rear_line_1=None, length_m=None)
    cars = (unseen, standing_passing(2, 2200.0, 2206.0))
    add_recorded(tmp_path, Recorded("night", "ab" * 32, 3600.0, cars, ()), stood("2026-05-04T23:30"))
    add_recorded(tmp_path, Recorded("noon", "cd" * 32, 1800.0, (unseen,), ()), stood("2026-05-05T12:30"))
    add_recorded(tmp_path, Recorded("later", "ef" * 32, 3600.0, (), ()), stood("2026-05-05T14:00"))
    with ArchiveTables(tmp_path) as tables:
        rows = {row["from"][8:16]: row["occupancy_ratio"] for row in tables.intervals(Asked(minutes=5))}
        (hour,) = [row for row in tables.intervals(Asked()) if row["from"][8:16] == "05T14:00"]
    night = [rows[at] for at in ("04T23:50", "04T23:55", "05T00:00", "05T00:05", "05T00:10")]
    assert night == [0.0, None, None, None, 0.0]
    assert [rows[at] for at in ("05T12:50", "05T12:55", "05T14:00")] == [0.0, None, 0.0]
    assert hour["occupancy_ratio"] == 0.0 and hour["reason"] == "no vehicle"


@pytest.mark.parametrize("rear_s", [None, 1800.0 + 2 * 86400.0 + 450.0])
def test_who_came_days_before_those_asked_for_stands_on_them(tmp_path: Path, rear_s: float | None) -> None:
    """Came on 4 May at 23:45, and nobody saw it leave, or it left on 7 May at 00:07:30."""
    stands = standing_passing(1, 900.0, rear_s or 900.0)
    if rear_s is None:
        stands = replace(stands, rear_s=None, rear_line_1=None, reason=str(STOOD))
    cars = (stands, standing_passing(2, 90_000.0, 90_004.0))
    add_recorded(tmp_path, Recorded("days", "ab" * 32, 3.2 * 86400.0, cars, ()), stood("2026-05-04T23:30"))
    add_recorded(tmp_path, Recorded("next", "cd" * 32, 3600.0, (), ()), stood("2026-05-08T12:00"))
    with ArchiveTables(tmp_path) as tables:
        rows = {row["from"][8:16]: row for row in tables.intervals(Asked(minutes=15))}
        for day in (5, 6, 7, 8):
            later = list(tables.intervals(Asked(first_day=date(2026, 5, day), minutes=15)))
            assert later == [row for row in rows.values() if row["from"] >= f"2026-05-{day:02}"]
    told = [
        rows[at]["occupancy_ratio"] for at in ("05T12:00", "06T12:00", "07T00:00", "07T12:00", "08T12:00")
    ]
    assert told == ([None, None, None, None, 0.0] if rear_s is None else [1.0, 1.0, 0.5, 0.0, 0.0])


def test_u_of_the_means_is_none_too_small_for_the_space_mean(tmp_path: Path) -> None:
    slow, fast = (
        replace(standing_passing(n, 60.0 * n, 60.5 * n), speed_mps=v, u_speed_mps=0.3)
        for n, v in ((1, 10.0), (2, 30.0))
    )
    add_recorded(tmp_path, Recorded("two", "ab" * 32, 300.0, (slow, fast), ()), stood("2026-05-04T12:00"))
    with ArchiveTables(tmp_path) as tables:
        (row,) = tables.intervals(Asked(minutes=5))
    # both 0.3 m/s too fast: the harmonic mean of 10.3 and 30.3 beside that of 10 and 30
    moved = 2 / (1 / 10.3 + 1 / 30.3) - 2 / (1 / 10 + 1 / 30)
    assert moved < row["u_mean_speed_mps"] == pytest.approx(0.375)


def test_what_was_watched_in_part_says_so_and_too_little_has_no_flow(folder: Path) -> None:
    with ArchiveTables(folder) as tables:
        rows = [row for row in tables.intervals(Asked(sites=("Hill",))) if row["lane"] == ""]
    first, last = rows[0], rows[-1]
    assert first["from"] == "2026-05-04T05:00+02:00" and first["watched_s"] == 2400.0
    assert first["flow_per_hour"] == pytest.approx(3600 * first["vehicles"] / 2400)
    assert first["reason"] == "watched for 2400 of 3600 s"
    assert last["from"] == "2026-05-05T07:00+02:00" and last["watched_s"] == 1200.0
    assert last["flow_per_hour"] is last["occupancy_ratio"] is None and last["vehicles"] > 0
    few = "; ".join(f"P{one} needs 23; there are {last['measured']}" for one in (15, 85))
    assert last["reason"] == f"watched for 1200 of 3600 s, too little for a flow; {few}"


def test_days_sites_and_lanes_are_kept_apart(folder: Path) -> None:
    with ArchiveTables(folder) as tables:
        rows = list(tables.intervals(Asked(first_day=date(2026, 5, 5))))
        both = {(one.site, one.lane): one for one in tables.sites()}
    assert {(row["site"], row["from"][:10]) for row in rows} == {
        ("Hill", "2026-05-05"),
        ("Valley", "2026-07-01"),
    }
    assert both["Hill", "left"].vehicles == 700 and both["Valley", ""].watched_s == 600.0
    assert both["Hill", ""].measured == sum(
        one.speed_mps is not None for one in recorded(21, 2000, HOURS * 3600).passings
    )


@settings(max_examples=100 if PROOFS else 6)
@given(
    st.sampled_from([1, 5, 15, 60, 720, 1440]),
    st.lists(st.floats(1.0, 20.0).map(lambda one: round(one, 2)), max_size=4, unique=True).map(sorted),
    st.integers(0, 2**31),
)
def test_classes_part_the_traffic_and_lose_nobody(minutes: int, limits: list[float], seed: int) -> None:
    sent = recorded(seed, 60, 2700.0, unmeasured=0.3)
    with TemporaryDirectory() as place:
        folder = Path(place)
        start = stood("2026-05-04T23:30")
        add_recorded(folder, sent, start)
        with ArchiveTables(folder) as tables:
            rows = list(tables.intervals(Asked(minutes=minutes, limits_m=tuple(limits))))
    names = classes_of(limits)
    assert [row["class"] for row in rows] == [ALL, *names] * (len(rows) // (1 + len(names)))
    assert sum(row["vehicles"] for row in rows if row["class"] == ALL) == 60
    assert sum(row["watched_s"] for row in rows if row["class"] == ALL) == pytest.approx(2700.0)
    if not names:
        return
    edges = [0.0, *limits, np.inf]
    for low, high, name in zip(edges, edges[1:], names, strict=False):
        own = [one for one in sent.passings if one.length_m is not None and low < one.length_m <= high]
        assert sum(row["vehicles"] for row in rows if row["class"] == name) == len(own)
    unknown = sum(row["vehicles"] for row in rows if row["class"] == NO_LENGTH)
    assert unknown == sum(one.length_m is None for one in sent.passings)
