"""Statistics of scanned vehicles: what counts, and errors without what is common to all."""

from dataclasses import replace
from datetime import UTC, date, datetime, timedelta
from math import hypot
from typing import Any

import numpy as np
import pytest

from sightline.linescan.parts import CUT, STOOD, STOPPED, Lane, Rig
from sightline.linescan.rig import baseline_of
from sightline.messages.said import Said
from sightline.recordings.filming import FilmedWithin, Filming
from sightline.scans.statistics.service import VehicleMotion, statistics_of_seen, when_passed
from sightline.scans.statistics.traffic import Watched, notes_of_overlaps, seen_in_each, traffic_of_seen

pytestmark = pytest.mark.once


def seen(number: int, state: str = "accepted", **values: float) -> VehicleMotion:
    """A measured vehicle of 4 m, by default."""
    return VehicleMotion(
        vehicle_id=number,
        scan_id=1,
        number=number,
        state=state,
        measured=state != "not_measurable",
        lighting="daytime",
        values={"speed_mps": 10.0 + number, "length_m": 4.04, "u_length_m": 0.041, **values},
        known={"length_m": 4.0, "u_length_m": 0.005},
        rig_baseline_m=0.6,
        rig_errors_m=(0.006, 0.0),
    )


def test_rejected_vehicles_never_count_and_unreviewed_ones_where_asked_for() -> None:
    found = [seen(1), seen(2, "to_review"), seen(3, "rejected"), seen(4, "not_measurable")]
    told = statistics_of_seen(found, accepted_only=True)
    assert told.counted == {
        "vehicles": 4,
        "used": 1,
        "without_time": 0,
        "to_review": 1,
        "accepted": 1,
        "rejected": 1,
        "not_measurable": 1,
    }
    assert [row.number for row in told.table] == [1]
    assert [row.number for row in statistics_of_seen(found, accepted_only=False).table] == [1, 2]
    speed, _, gap = told.spreads[:3]
    assert (speed.n, speed.mean, speed.sd) == (1, 11.0, None) and gap.n == 0 and gap.ecdf is None


def test_a_baseline_is_judged_without_its_own_uncertainty() -> None:
    told = statistics_of_seen([seen(n) for n in range(1, 8)], accepted_only=True)
    assert told.length_errors["overall"].figures["bias_m"] == pytest.approx(0.04)
    ratio = told.length_ratio
    # 1 % of 4.04 m is the baseline's and common; 7 mm, 1 mm and the makers' 5 mm are each vehicle's own
    alone = ((0.041**2 - 0.0404**2 + 1e-6 + (1.01 * 0.005) ** 2) ** 0.5) / 4.0
    assert ratio.value == pytest.approx(1.01) and ratio.u == pytest.approx(alone / 7**0.5, rel=1e-6)
    assert ratio.warning is not None and "1.00 % longer" in str(ratio.warning)


def runs(lengths_m: list[float], rig: Rig, u_own_m: float) -> list[VehicleMotion]:
    """Runs of one car, each with its budget's u: its own and that of its baseline."""
    ratio = np.divide(*reversed(baseline_of(rig)))
    given = when_passed(rig, 0.0, 1000.0, None)
    return [
        VehicleMotion(
            **given,
            vehicle_id=number,
            scan_id=1,
            number=number,
            state="accepted",
            measured=True,
            lighting="daytime",
            values={"speed_mps": 20.0, "length_m": one, "u_length_m": hypot(u_own_m, one * ratio)},
            run_of="ours",
        )
        for number, one in enumerate(lengths_m)
    ]


def test_the_mean_of_runs_lies_among_them_whatever_the_baseline_is_off() -> None:
    lengths_m = np.linspace(4.49, 4.51, 10)
    rig = Rig(0.6, 5000.0, u_baseline_m=0.03)
    (car,) = statistics_of_seen(runs(list(lengths_m), rig, 0.006), accepted_only=True).cars
    told = car.sizes["length"]
    assert told.mean == pytest.approx(4.5, abs=1e-6)
    # the baseline's 5 % of the car, which all runs have in common
    assert told.u_mean == pytest.approx(0.05 * 4.5, rel=1e-3)


def test_where_each_run_drove_is_its_own_error() -> None:
    """The planes open by 10 mrad; a car drives 0.3 m nearer or farther each time, 0.4 % of its length."""
    rig = Rig(
        0.6, 5000.0, 0.003, divergence_rad=0.01, u_divergence_rad=1e-4, distance_m=5.0, u_distance_m=0.3
    )
    rng, verdicts = np.random.default_rng(12), []
    for _ in range(40):
        b, q = 0.6 + rng.normal(0, 0.003), 0.01 + rng.normal(0, 1e-4)
        true = b + q * (5.0 + rng.normal(0, 0.3, 10))
        lengths_m = 4.5 * baseline_of(rig)[0] / true + rng.normal(0, 0.004, 10)
        (car,) = statistics_of_seen(runs(list(lengths_m), rig, 0.004), accepted_only=True).cars
        verdicts.append(car.sizes["length"].verdict)
    assert verdicts.count("agree") >= 35


@pytest.mark.parametrize("correlation", [0.0, -0.9])
def test_runs_in_two_lanes_share_the_errors_of_one_rig(correlation: float) -> None:
    """Against the covariance of b + q D at both distances, by draws of b and q."""
    near, far = (
        Rig(0.6, 5000.0, 0.006, 0.0, 0.01, 1e-3, distance_m, baseline_correlation=correlation)
        for distance_m in (4.0, 8.0)
    )
    u_own_m = 0.02
    seen = [*runs([4.5] * 2, near, u_own_m), *runs([4.5], far, u_own_m)]
    (car,) = statistics_of_seen(seen, accepted_only=True).cars
    u_b, u_q = 0.006, 1e-3
    spread = [[u_b**2, correlation * u_b * u_q], [correlation * u_b * u_q, u_q**2]]
    off = np.random.default_rng(3).multivariate_normal([0.0, 0.0], spread, 40_000)
    away, own = np.array([4.0, 4.0, 8.0]), np.random.default_rng(4).normal(0, u_own_m, (40_000, 3))
    lengths_m = 4.5 * (off[:, :1] + off[:, 1:] * away) / (0.6 + 0.01 * away) + own
    weight = np.linalg.inv(np.cov(lengths_m.T))
    assert car.sizes["length"].u_mean == pytest.approx(weight.sum() ** -0.5, rel=0.02)


def test_the_front_of_one_that_was_in_view_when_the_recording_began_was_not_seen() -> None:
    rig = Rig(0.4, 8000.0)
    told = [
        when_passed(rig, *one)["front_seen"]
        for one in ((0.0, 900.0, CUT), (9.0, 900.0, CUT), (0.0, 900.0, None))
    ]
    assert told == [False, True, True]


@pytest.mark.parametrize(("away_s", "told"), [(3599.96, None), (3650.0, None), (3700.0, 0.0), (-3600.0, 0.0)])
def test_the_recording_after_one_in_which_a_vehicle_still_stood_tells_no_occupancy(
    away_s: float, told: float | None
) -> None:
    """It took the vehicle for the road, or, live, knows that it was told; 0 % was shown."""
    start = datetime(2026, 5, 4, 12, tzinfo=UTC)
    stands = VehicleMotion(1, 1, 1, "not_measurable", False, "daytime", reason=STOOD, since_s=100.0)
    watched = [
        Watched(number, str(number), Filming(start + timedelta(seconds=at_s), "UTC"), 3600.0)
        for number, at_s in ((2, away_s), (1, 0.0))
    ]
    found = traffic_of_seen(seen_in_each(watched, [stands]), 60, accepted_only=True)
    shown = {scan.name: [one.occupancy_percent.value for one in scan.intervals] for scan in found}
    assert set(shown["2"]) == {told} and shown["1"] == [None]


@pytest.mark.parametrize(("away_s", "counted"), [(3599.96, 1), (3620.0, 2)])
def test_who_stands_from_one_segment_to_the_next_is_counted_once(away_s: float, counted: int) -> None:
    """20 s later it may be another one."""
    start = datetime(2026, 5, 4, 12, tzinfo=UTC)
    stands = VehicleMotion(1, 1, 1, "not_measurable", False, "daytime", reason=STOOD, since_s=100.0)
    in_view = replace(stands, scan_id=2, since_s=0.0, occupied_s=50.0, front_seen=False, reason=STOPPED)
    watched = [
        Watched(number, str(number), Filming(start + timedelta(seconds=at_s), "UTC"), 3600.0)
        for number, at_s in ((1, 0.0), (2, away_s))
    ]
    found = traffic_of_seen(seen_in_each(watched, [stands, in_view]), 60, accepted_only=True)
    assert sum(one.vehicles for scan in found for one in scan.intervals) == counted


def test_one_of_unknown_lane_that_stands_may_stand_in_any() -> None:
    """Of a rig with lanes, one whose picture was not kept told 0 % for both."""
    start = Filming(datetime(2026, 5, 4, 12, tzinfo=UTC), "UTC")
    cars = [
        replace(seen(number), direction="camera_1_first", lane=lane, since_s=100.0 * number, occupied_s=0.5)
        for number, lane in ((1, "near"), (2, "far"))
    ]
    stands = replace(cars[0], state="not_measurable", measured=False, lane=None, since_s=1000.0)
    stands = replace(stands, vehicle_id=3, number=3, reason=STOOD, occupied_s=None)
    after = Filming(datetime(2026, 5, 4, 12, 30, tzinfo=UTC), "UTC")
    watched = [Watched(1, "Hill", start, 1800.0), Watched(2, "next", after, 1800.0)]
    later = [replace(one, scan_id=2) for one in cars]
    found = traffic_of_seen(seen_in_each(watched, [*cars, stands, *later]), 15, accepted_only=True)
    told = {(scan.name, scan.lane): [one.occupancy_percent.value for one in scan.intervals] for scan in found}
    share = pytest.approx(100 * 0.5 / 900)
    assert told == {
        ("Hill", "far"): [share, None],
        ("Hill", "near"): [share, None],
        ("Hill", None): [0.0, None],
        ("next", "far"): [None, None],
        ("next", "near"): [None, None],
    }


_TAPED, _NEAR, _OTHER = Rig(0.5, 8000.0, 0.002), Rig(0.503, 4000.0, 0.001), Rig(0.6, 8000.0, 0.002)
_OPENING = Rig(0.5, 8000.0, 0.0005, divergence_rad=0.02, distance_m=5.0)
_OF_LANES = Rig(0.5, 8000.0, 0.0005, divergence_rad=0.02, lanes=(Lane("near", 4.0), Lane("far", 6.0)))


@pytest.mark.parametrize(
    ("first", "second", "said"),
    [
        ({}, {}, True),
        ({"rig": _TAPED}, {"rig": _NEAR}, True),  # as calibrated since, at another line rate
        ({"rig": _TAPED}, {}, True),
        ({"rig": Rig(0.5, 8000.0)}, {"rig": Rig(0.501, 8000.0)}, True),  # no u is told of either
        ({"rig": Rig(0.5, 8000.0)}, {"rig": Rig(0.53, 8000.0)}, False),
        ({"rig": Rig(0.5, 8000.0, 0.06)}, {"rig": _OTHER}, True),
        ({"rig": _OPENING}, {"rig": Rig(0.6, 8000.0, 0.0005)}, True),  # of 0.6 m at the vehicles
        ({"rig": _OPENING}, {"rig": Rig(0.5, 8000.0, 0.0005)}, False),
        ({"rig": _OF_LANES}, {"rig": Rig(0.6, 8000.0, 0.0005)}, True),
        ({"rig": _TAPED}, {"rig": _OTHER}, False),
        ({"rig": _TAPED, "video": "7"}, {"rig": _OTHER, "video": "7"}, True),  # two cuts of one video
        ({"site": "Hill", "video": "7"}, {"site": "Dale", "video": "7"}, False),
        ({"site": "one.zip", "strip_sha256": "aa"}, {"site": "two.zip", "strip_sha256": "aa"}, True),
    ],
)
def test_recordings_of_two_places_do_not_overlap(
    first: dict[str, Any], second: dict[str, Any], said: bool
) -> None:
    """Nor does one go on from the other: who is in view of another rig is another vehicle."""
    start = datetime(2026, 5, 4, 12, tzinfo=UTC)
    stands = replace(seen(1), state="not_measurable", measured=False, reason=STOOD, since_s=100.0)
    in_view = replace(stands, scan_id=2, since_s=0.0, occupied_s=5.0, front_seen=False, reason=STOPPED)

    def notes_and_told(away_s: float) -> tuple[list[Said], list[bool]]:
        starts = [Filming(start + timedelta(seconds=at_s), "UTC") for at_s in (0.0, away_s)]
        watched = [
            Watched(number, name, clock, 3600.0, **more)
            for number, name, clock, more in zip((1, 2), "ab", starts, (first, second), strict=True)
        ]
        found = seen_in_each(watched, [stands, in_view])
        return notes_of_overlaps(found), [car.told_before for each in found for car in each.vehicles]

    note = Said("scans-traffic-overlap", earlier="a", later="b", seconds=600, others=0)
    assert notes_and_told(3000.0) == ([note] if said else [], [False, False])
    assert notes_and_told(3600.0) == ([], [False, said])


@pytest.mark.parametrize(
    ("filmed", "seconds"),
    [
        (FilmedWithin(), 7200),
        (FilmedWithin(hour_from=7), 5400),  # from 06:30 to 08:30 by the clocks of the place
        (FilmedWithin(hour_from=22, hour_to=7), 1800),
        (FilmedWithin(filmed_from=date(2026, 5, 4), hour_to=8), 5400),
        (FilmedWithin(hour_from=9), 0),
        (FilmedWithin(filmed_from=date(2026, 5, 5)), 0),
    ],
)
def test_an_overlap_is_of_the_days_and_hours_asked_for(filmed: FilmedWithin, seconds: int) -> None:
    starts = [datetime(2026, 5, 4, hour, 30, tzinfo=UTC) for hour in (3, 4)]
    watched = [
        Watched(number, str(number), Filming(at, "Europe/Paris"), 3600.0 * (4 - number))
        for number, at in enumerate(starts, 1)
    ]
    cars = [
        replace(seen(1), scan_id=number, since_s=60.0 * minute) for number in (1, 2) for minute in range(120)
    ]
    notes = notes_of_overlaps(seen_in_each(watched, cars, filmed))
    assert [one.values["seconds"] for one in notes] == ([seconds] if seconds else [])


@pytest.mark.parametrize(
    ("first_s", "second_s", "said"), [(10.0, 3700.0, 0), (3700.0, 1900.0, 1), (3700.0, 6000.0, 0)]
)
def test_an_overlap_is_noted_where_both_count_a_vehicle_within_the_shared_time_and_the_hours(
    first_s: float, second_s: float, said: int
) -> None:
    """From 13:00 on; of two recordings from 12:00 to 14:00 and from 12:30 to 14:30."""
    start = datetime(2026, 5, 4, 12, tzinfo=UTC)
    clocks = [Filming(start + timedelta(seconds=at_s), "UTC") for at_s in (0.0, 1800.0)]
    watched = [Watched(number, str(number), clock, 7200.0) for number, clock in enumerate(clocks, 1)]
    cars = [replace(seen(1), scan_id=number, since_s=at_s) for number, at_s in ((1, first_s), (2, second_s))]
    assert len(notes_of_overlaps(seen_in_each(watched, cars, FilmedWithin(hour_from=13)))) == said


def test_of_several_that_overlap_at_once_each_pair_is_said() -> None:
    """The second and the third went without a note."""
    start = Filming(datetime(2026, 5, 4, 12, tzinfo=UTC), "UTC")
    watched = [Watched(number, "Gate", start, 600.0 + number) for number in (1, 2, 3)]
    cars = [replace(seen(1), scan_id=number, since_s=10.0) for number in (1, 2, 3)]
    first, second = map(str, notes_of_overlaps(seen_in_each(watched, cars)))
    gate = "Gate (2026-05-04T12:00:00.000+00:00)"
    assert first == f"{gate} and {gate} overlap for 601 s: a vehicle that both contain counts in each."
    assert second.startswith(
        f"{gate} overlaps {gate} for 602 s and another earlier one: a vehicle that several"
    )


def test_who_stood_where_traffic_is_not_counted_counts_in_the_next() -> None:
    """Vehicles of another line rate left the first out, and the second had told its own before."""
    start = datetime(2026, 5, 4, 12, tzinfo=UTC)
    stands = replace(seen(1), state="not_measurable", measured=False, reason=STOOD, since_s=100.0)
    in_view = replace(stands, scan_id=2, since_s=0.0, occupied_s=5.0, front_seen=False, reason=STOPPED)
    watched = [
        Watched(
            number, str(number), Filming(start + timedelta(seconds=at_s), "UTC"), 3600.0, Rig(0.5, 4000.0)
        )
        for number, at_s in ((1, 0.0), (2, 3600.0))
    ]
    counts = []
    for rate_hz in (4000.0, 8000.0):
        drives = replace(seen(2), since_s=50.0, line_rate_hz=rate_hz)
        found = traffic_of_seen(seen_in_each(watched, [drives, stands, in_view]), 60, accepted_only=True)
        counts.append([sum(one.vehicles for one in scan.intervals) for scan in found])
        assert found[1].intervals[0].occupancy_percent.value is None
    assert counts == [[2, 0], [0, 1]]


@pytest.mark.parametrize(("leaves", "counted"), [(False, [2, 0, 0]), (True, [2, 0, 1])])
def test_who_stands_through_a_recording_that_is_left_out_counts_once(
    leaves: bool, counted: list[int]
) -> None:
    """The one between two has another line rate: who stood in all three counted in the first and in the last.
    Who came in it counts in the last.
    """
    start = datetime(2026, 5, 4, 12, tzinfo=UTC)
    clocks = [Filming(start + timedelta(hours=number), "UTC") for number in range(3)]
    watched = [Watched(at, str(at), clock, 3600.0, Rig(0.5, 4000.0)) for at, clock in enumerate(clocks, 1)]
    stands = replace(seen(1), state="not_measurable", measured=False, reason=STOOD, since_s=100.0)
    in_view = replace(stands, since_s=0.0, front_seen=False)
    left = replace(in_view, vehicle_id=3, occupied_s=5.0, reason=STOPPED)
    drives = replace(seen(2), since_s=50.0, line_rate_hz=4000.0)
    between = [replace(drives, line_rate_hz=8000.0), *([left, stands] if leaves else [in_view])]
    cars = [drives, stands, *(replace(one, scan_id=2) for one in between), replace(left, scan_id=3)]
    found = traffic_of_seen(seen_in_each(watched, cars), 60, accepted_only=True)
    assert [sum(one.vehicles for one in scan.intervals) for scan in found] == counted


def test_clocks_put_back_within_an_overlap_show_one_hour_twice() -> None:
    """02:00 to 03:00 of 25 October 2026 came twice in Paris, and both are of those hours."""
    clock = Filming(datetime(2026, 10, 24, 23, 20, tzinfo=UTC), "Europe/Paris")
    watched = [Watched(number, str(number), clock, 4 * 3600.0) for number in (1, 2)]
    cars = [replace(seen(1), scan_id=number, since_s=3600.0) for number in (1, 2)]
    asked = FilmedWithin(hour_from=2, hour_to=3)
    (note,) = notes_of_overlaps(seen_in_each(watched, cars, asked))
    assert note.values["seconds"] == 7200


def test_vehicles_of_another_line_rate_have_no_traffic() -> None:
    """A rate that was corrected to half of it made the second half of the recording one without traffic."""
    start = Filming(datetime(2026, 5, 4, 12, tzinfo=UTC), "UTC")
    cars = [replace(seen(number), line_rate_hz=8000.0, since_s=900.0 * number) for number in (1, 2, 3)]
    for rate_hz, intervals in ((8000.0, 4), (4000.0, 0)):
        watched = [Watched(1, "Hill", start, 3600.0 * 8000.0 / rate_hz, Rig(0.6, rate_hz))]
        (scan,) = traffic_of_seen(seen_in_each(watched, cars), 15, accepted_only=True)
        assert len(scan.intervals) == intervals and (scan.reason is None) == (intervals > 0)
