"""Traffic of a lane: what must hold whatever passes, and numbers that are known otherwise."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from math import sqrt
from zoneinfo import ZoneInfo

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.enums import ScanDirection
from sightline.linescan.traffic import (
    MINUTES,
    Passed,
    headways_s,
    intervals,
    mean_speeds,
    poisson_interval,
    streams_of,
)

VEHICLE = st.tuples(
    st.floats(0, 7199), st.floats(0.05, 9), st.floats(2.5, 40), st.floats(2, 20), st.booleans()
)


def clock(into_hour_s: float = 0.0) -> Callable[[float], float]:
    """Of a place whose clocks are not put forward or back."""
    return lambda since_s: (into_hour_s + since_s) % 3600.0


def traffic_of(drawn: list[tuple[float, float, float, float, bool]]) -> list[Passed]:
    """Vehicles in the order of passing; those without a motion have neither speed nor length."""
    return [
        Passed(since, occupied, 0.01, *((speed, 0.01, length, 0.02) if moves else ()))
        for since, occupied, speed, length, moves in sorted(drawn)
    ]


@given(drawn=st.lists(VEHICLE, max_size=40), into_hour=st.floats(0, 3599.9), minutes=st.sampled_from(MINUTES))
def test_nothing_is_lost_and_nothing_counted_twice(
    drawn: list[tuple[float, float, float, float, bool]], into_hour: float, minutes: int
) -> None:
    passed = traffic_of(drawn)
    found = intervals(passed, 7200.0, clock(into_hour), minutes)
    assert sum(one.vehicles for one in found) == len(passed)
    assert sum(one.measured for one in found) == sum(one.speed_mps is not None for one in passed)
    for one in found:
        assert sum(kind.vehicles for kind in one.classes) + one.unclassed == one.vehicles
        assert 0 < one.watched_s <= 60 * minutes + 1e-9
        assert one.partial == (one.watched_s < 60 * minutes - 1e-6)
        assert 0 <= (one.occupancy_percent.value or 0) <= 100 + 1e-9
        assert one.flow_low <= one.flow_per_hour <= one.flow_high
        time_mean, space_mean = one.time_mean_speed_mps.value, one.space_mean_speed_mps.value
        assert (
            (time_mean is None)
            == (one.measured == 0)
            == bool("an accepted speed" in " ".join(map(str, one.reasons)))
        )
        if time_mean is not None and space_mean is not None:
            assert space_mean <= time_mean * (1 + 1e-12)
        # edges stand where the clocks of the place show whole intervals
        begins = (one.begin_s + into_hour) % (60 * minutes)
        assert one.begin_s == 0 or min(begins, 60 * minutes - begins) < 1e-6
    assert sum(one.watched_s for one in found) == pytest.approx(7200.0)


@dataclass(frozen=True)
class Came:
    since_s: float | None
    direction: ScanDirection | None = "camera_1_first"
    lane: str | None = None


def test_a_vehicle_without_a_direction_follows_those_of_the_first_stream() -> None:
    """Headways of vehicles and intervals are of the same streams."""
    near, nowhere, other = Came(9.0), Came(4.0, None), Came(5.0, "camera_2_first")
    never, first = Came(None, None), Came(1.0)
    found = streams_of([near, other, never, nowhere, first])
    assert found == {
        ("camera_1_first", None): [first, nowhere, near, never],
        ("camera_2_first", None): [other],
    }
    assert streams_of([other, nowhere]) == {("camera_2_first", None): [nowhere, other]}
    assert streams_of([never]) == {("camera_1_first", None): [never]}
    assert (headways_s([1.0, 4.0, 9.0], 3 * [True]), headways_s([], [])) == ([None, 3.0, 5.0], [])
    # nobody saw the front of one that was in view when the recording began
    assert headways_s([0.0, 4.0, 9.0], [False, True, True]) == [None, None, 5.0]
    # one of unknown lane came between two of them, and none of its kind has a headway
    assert headways_s([1.0, 4.0, 9.0], 3 * [True], [2.0]) == [None, None, 5.0]
    assert headways_s([1.0, 4.0, 9.0], 3 * [True], [1.0, 4.0, 9.0]) == [None, None, None]


def test_figures_of_a_steady_stream() -> None:
    """A vehicle every 4 s, in turns at 20 and 30 m/s, 4.5 m long: 900 an hour, and the rest follows."""
    passed = [
        Passed(4.0 * n + 1, 4.5 / v, 1e-3, v, 0.1, 4.5, 0.01)
        for n in range(900)
        for v in [20.0 if n % 2 else 30.0]
    ]
    whole, *_ = intervals(passed, 3600.0, clock(), 60)
    assert (whole.vehicles, whole.flow_per_hour, whole.partial) == (900, 900.0, False)
    assert whole.mean_headway_s == pytest.approx(4.0)
    assert whole.time_mean_speed_mps.value == pytest.approx(25.0)
    assert whole.space_mean_speed_mps.value == pytest.approx(24.0)
    assert whole.occupancy_percent.value == pytest.approx(100 * 4.5 / 24.0 / 4.0)
    assert whole.density_per_km.value == pytest.approx(900 / (24.0 * 3.6))
    # Wardrop: the time mean is the space mean and the variance along the road over it
    variance = 0.6 * (20 - 24.0) ** 2 + 0.4 * (30 - 24.0) ** 2
    assert whole.time_mean_speed_mps.value == pytest.approx(24.0 + variance / 24.0)
    assert [kind.vehicles for kind in whole.classes] == [900, 0, 0, 0]


def test_what_all_share_does_not_average_out() -> None:
    own, shared = 0.2, 0.001
    cars = [
        Passed(float(n), 0.2, None, 20.0, sqrt(own**2 + (shared * 20) ** 2), rig_ratio=shared)
        for n in range(400)
    ]
    time_mean, space_mean = mean_speeds(cars)
    expected = sqrt((own / 20) ** 2 + (shared * 20) ** 2)
    assert (time_mean.u, space_mean.u) == (pytest.approx(expected), pytest.approx(expected))


def test_a_space_means_uncertainty_is_that_of_a_simulation() -> None:
    rng = np.random.default_rng(20261123)
    true, u, ratio = np.array([8.0, 15.0, 33.0]), np.array([0.1, 0.2, 0.3]), 0.004
    own = rng.normal(true, np.sqrt(u**2 - (ratio * true) ** 2), (200_000, 3))
    seen = own * (1 + rng.normal(0, ratio, (200_000, 1)))
    cars = [
        Passed(float(n), 0.2, None, v, s, rig_ratio=ratio)
        for n, (v, s) in enumerate(zip(true.tolist(), u.tolist(), strict=True))
    ]
    time_mean, space_mean = mean_speeds(cars)
    assert time_mean.u == pytest.approx(seen.mean(axis=1).std(), rel=0.01)
    assert space_mean.u == pytest.approx((3 / (1 / seen).sum(axis=1)).std(), rel=0.01)


def test_an_interval_of_a_count_covers() -> None:
    rng = np.random.default_rng(7)
    ends = {n: poisson_interval(n) for n in range(60)}
    for mean in (0.5, 3.0, 20.0):
        covered = [ends[n][0] <= mean <= ends[n][1] for n in rng.poisson(mean, 20_000).tolist()]
        assert np.mean(covered) >= 0.948
    assert poisson_interval(10) == (pytest.approx(4.795, abs=1e-3), pytest.approx(18.390, abs=1e-3))


def test_vehicles_near_an_edge_or_a_limit_are_counted() -> None:
    passed = [
        Passed(59.99, 0.2, 0.01, 20.0, 0.1, 5.21, 0.01),
        Passed(60.5, 30.0, 0.01),
        Passed(61.0, 0.2, 0.01, 20.0, 0.1, 4.0, 0.01),
    ]
    first, second = intervals(passed, 120.0, clock(), 1)
    assert (first.near_edge, second.near_edge) == (1, 0)
    assert [(kind.vehicles, kind.near_limit) for kind in first.classes] == [(0, 0), (1, 1), (0, 0), (0, 0)]
    # beside a standing vehicle another passes: time is occupied once, and how well is not known
    assert second.occupancy_percent.value == pytest.approx(100 * (0.19 + 30.0) / 60)
    assert second.occupancy_percent.u is None and "1 of the vehicles" in str(second.reasons[0])
    assert second.unclassed == 1


def test_of_one_that_could_not_be_measured_the_others_tell_how_well_its_time_is_known() -> None:
    passed = [Passed(10.0, 0.2, 0.01, 20.0, 0.1), Passed(60.01, 0.1, refused=True)]
    assert [one.near_edge for one in intervals(passed, 120.0, clock(), 1)] == [0, 1]
    assert [one.near_edge for one in intervals(passed[1:], 120.0, clock(), 1)] == [0, None]


def test_the_ends_of_a_recording_are_no_edges_of_the_clock() -> None:
    """It begins 100 s into an interval and ends 100 s before another; or 3 s after an edge, which is one."""
    passed = [Passed(5.0, 0.3, 20.0), Passed(395.0, 0.3, 20.0)]
    assert [one.near_edge for one in intervals(passed, 400.0, clock(100.0), 5)] == [0, 0]
    assert [one.near_edge for one in intervals(passed, 400.0, clock(3.0), 5)] == [1, 0]


def test_an_occupancy_is_as_unsure_as_those_who_came_before_and_still_stand() -> None:
    """One that came at 50 s stands until 200 s, alone in the second and third minute."""
    for moving in (True, False):
        motion = (5.0, 0.01, 4.0, 0.02) if moving else ()
        found = intervals([Passed(50.0, 150.0, 0.01, *motion)], 300.0, clock(), 1)
        told = [one.occupancy_percent for one in found]
        values = [pytest.approx(one) for one in (100 / 6, 100.0, 100.0, 100 / 3, 0.0)]
        assert [one.value for one in told] == values
        u = pytest.approx(100 * 0.02 / 5.0 / 60) if moving else None
        assert [one.u for one in told] == [u, u, u, u, 0.0]
        said = [any("1 of the vehicles" in str(reason) for reason in one.reasons) for one in found]
        assert said == [not moving] * 4 + [False]


def test_occupancy_is_not_told_where_nobody_knows_how_long_a_vehicle_stood() -> None:
    """From its front to the next one, or to the end."""
    passed = [Passed(10.0, 6.0), Passed(70.0, None), Passed(130.0, 3.0)]
    shown = [one.occupancy_percent.value for one in intervals(passed, 240.0, clock(), 1)]
    assert shown == [pytest.approx(10.0), None, None, 0.0]
    until_end = intervals(passed[:2], 240.0, clock(), 1)
    assert [one.occupancy_percent.value for one in until_end] == [pytest.approx(10.0), None, None, None]
    assert "rear of a vehicle that stood here was not seen" in str(until_end[3].reasons[1])
    assert [one.vehicles for one in until_end] == [1, 1, 0, 0]


def test_who_passes_beside_one_that_stands_does_not_say_that_it_left() -> None:
    """One that came at 10 s was still there at 70 s, when it was given up: 0 % was told from 20 s on."""
    passed = [Passed(10.0, None), Passed(20.0, 0.3), Passed(135.0, 3.0)]
    shown = [one.occupancy_percent.value for one in intervals(passed, 240.0, clock(), 1)]
    assert shown == [None, None, None, 0.0]


def test_who_was_not_seen_to_leave_may_stand_until_the_end() -> None:
    """0 % was told from the front at 135 s on, which had passed beside it."""
    passed = [Passed(10.0, None, stands=True), Passed(20.0, 0.3), Passed(135.0, 3.0)]
    shown = [one.occupancy_percent.value for one in intervals(passed, 240.0, clock(), 1)]
    assert shown == [None, None, None, None]


def test_who_is_in_view_when_the_recording_begins_or_ends_makes_no_interval_more() -> None:
    found = intervals([Passed(-1e-4, 6.0), Passed(119.0, 3.0)], 120.0, clock(), 1)
    assert [(one.begin_s, one.vehicles) for one in found] == [(0.0, 1), (60.0, 1)]
    shown = [one.occupancy_percent.value for one in found]
    assert shown == [pytest.approx(10.0, abs=1e-3), pytest.approx(100 / 60)]


@pytest.mark.parametrize(
    ("start", "begins"),
    [
        # clocks are put forward from 2:00 to 2:30, and back from 2:00 to 1:30
        ("2026-10-03T14:45:00", ["01:15", "02:30", "03:00", "04:00"]),
        ("2026-04-04T14:15:00", ["01:15", "01:30", "02:00", "03:00"]),
    ],
)
def test_intervals_keep_to_clocks_that_are_put_forward_by_half_an_hour(start: str, begins: list[str]) -> None:
    def shown(since_s: float) -> datetime:
        at = datetime.fromisoformat(start).replace(tzinfo=UTC) + timedelta(seconds=since_s)
        return at.astimezone(ZoneInfo("Australia/Lord_Howe"))

    def into_hour_s(since_s: float) -> float:
        return 60.0 * shown(since_s).minute + shown(since_s).second

    found = intervals([], 9000.0, into_hour_s, 60)
    assert [f"{shown(one.begin_s):%H:%M}" for one in found] == begins
    assert [one.watched_s for one in found] == [2700.0, 1800.0, 3600.0, 900.0]
    assert [one.partial for one in found] == [True, False, False, True]


def test_an_interval_that_is_recorded_whole_is_not_partial() -> None:
    """From 753.552 s past the hour on, 1046.448 - 746.448 came to less than 300 s."""
    found = intervals([], 3600.0, clock(753.552), 5)
    assert [one.partial for one in found] == [True, *[False] * 11, True]


def test_a_partial_interval_is_said() -> None:
    found = intervals([Passed(5.0, 0.2)], 100.0, clock(30.0), 1)
    assert [(one.begin_s, one.watched_s, one.partial) for one in found] == [
        (0.0, 30.0, True),
        (30.0, 60.0, False),
        (90.0, 10.0, True),
    ]
    assert found[0].flow_per_hour == pytest.approx(120.0) and found[1].flow_per_hour == 0.0
    with pytest.raises(ValueError, match="divide an hour"):
        intervals([], 10.0, clock(), 7)
