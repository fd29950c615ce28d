"""Vehicles that reach camera 2 first: measured with exchanged roles, told as camera 1 sees them."""

from dataclasses import replace
from functools import lru_cache
from math import hypot, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.enums import ScanMethod
from sightline.linescan.either_way import exact_at_camera_1, exchange_cameras, seen_from_camera_1
from sightline.linescan.gaps import NONE_BEFORE, gaps
from sightline.linescan.methods import MEASURE
from sightline.linescan.parts import Crossings, Entry, Motion, Passage
from sightline.linescan.passing import measure_passages
from tests.linescan.scenes import RIG, SITE, found, plain_found
from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import ScanTruth, traffic, truths

OF_RIG = replace(RIG, u_baseline_m=0.0003, u_line_rate_ratio=1e-4)


@lru_cache(maxsize=1)
def both_ways() -> tuple[list[Passage], tuple[ScanTruth, ...]]:
    """Every other of four vehicles drives the other way."""
    drawn = traffic(21, 4, speeds_mps=(11.0, 24.0), gaps_s=(0.3, 0.5))
    cars = tuple(replace(car, against=number % 2 == 1) for number, car in enumerate(drawn))
    return found(strips(SITE, cars), OF_RIG)[0], truths(SITE, cars)


@lru_cache(maxsize=1)
def motions() -> list[Motion]:
    return [MEASURE["direct"](passage, OF_RIG) for passage in both_ways()[0]]


def at_camera_1(true: ScanTruth) -> float:
    """The true speed when the front reaches camera 1."""
    car = true.vehicle
    onward_m = SITE.baseline_m if car.against else 0.0
    return sqrt(car.speed_mps**2 + 2 * car.acceleration_mps2 * onward_m)


def test_both_directions_are_measured_with_uncertainties_that_hold() -> None:
    passages, truth = both_ways()
    ways = [passage.crossings.direction for passage in passages]
    assert ways == ["camera_1_first", "camera_2_first"] * 2
    for passage, motion, true in zip(passages, motions(), truth, strict=True):
        assert motion.status == "ok" and motion.crossings == passage.crossings
        assert motion.speed_mps is not None and motion.u_speed_mps is not None
        assert motion.length_m is not None and motion.u_length_m is not None
        assert abs(motion.speed_mps - at_camera_1(true)) < 4 * motion.u_speed_mps
        assert abs(motion.length_m - true.vehicle.length_m) < 4 * motion.u_length_m
        assert motion.misalignment_px == pytest.approx(SITE.misalignment_px, abs=0.05)
        assert motion.gain == pytest.approx(SITE.gain_2, abs=0.01)
        assert motion.profile is not None
        lines = motion.profile.line_1
        assert true.front_line_1 - 30 < lines.min() and lines.max() < true.rear_line_1 + 30


@pytest.mark.parametrize("method", ["direct", "paper"])
def test_swapped_strips_give_the_same_motion_seen_from_the_other_camera(method: ScanMethod) -> None:
    given_, swapped = plain_found()[0][0], exchange_cameras(plain_found()[0][0])
    one, other = MEASURE[method](given_, OF_RIG), MEASURE[method](swapped, OF_RIG)
    assert one.speed_mps and one.acceleration_mps2 is not None and other.speed_mps
    there = sqrt(one.speed_mps**2 + 2 * one.acceleration_mps2 * OF_RIG.baseline_m)
    assert other.speed_mps == pytest.approx(there, rel=1e-12)
    assert other.acceleration_mps2 == one.acceleration_mps2 and other.length_m == one.length_m
    assert hypot(*(entry.u_speed_mps for entry in other.budget)) == pytest.approx(
        other.u_speed_mps, rel=1e-12
    )


@given(
    v=st.floats(3.0, 40.0),
    a=st.floats(-2.0, 2.0),
    of_fit=st.tuples(st.floats(1e-3, 0.1), st.floats(1e-3, 0.3), st.floats(-0.95, 0.95)),
    u_baseline_m=st.floats(0.0, 0.003),
)
def test_the_covariance_is_that_of_the_three_errors(
    v: float, a: float, of_fit: tuple[float, float, float], u_baseline_m: float
) -> None:
    """Fit and baseline carried through v1 = sqrt(v^2 + 2 a b), in which both v and a grow with b."""
    u_v, u_a, r = of_fit
    b, ratio = RIG.baseline_m, u_baseline_m / RIG.baseline_m
    fit = np.array([[u_v**2, r * u_v * u_a], [r * u_v * u_a, u_a**2]])
    whole = fit + ratio**2 * np.array([[v * v, v * a], [v * a, a * a]])
    u = np.sqrt(np.diag(whole))
    motion = Motion(
        method="direct",
        crossings=Crossings(0.0, 1000.0, 100.0, 1100.0),
        status="ok",
        speed_mps=v,
        u_speed_mps=float(u[0]),
        acceleration_mps2=a,
        u_acceleration_mps2=float(u[1]),
        budget=(Entry("baseline", v * ratio, abs(a) * ratio, 0.0), Entry("fit", u_v, u_a, 0.0)),
        correlation=float(whole[0, 1] / (u[0] * u[1])),
    )
    told = seen_from_camera_1(motion, replace(RIG, u_baseline_m=u_baseline_m))
    there = sqrt(v * v + 2 * a * b)
    onward = np.array([[v / there, b / there], [0.0, 1.0]])
    expected = onward @ fit @ onward.T + ratio**2 * np.array([[there**2, there * a], [there * a, a * a]])
    assert told.speed_mps == pytest.approx(there)
    assert told.u_speed_mps == pytest.approx(sqrt(expected[0, 0]), rel=1e-6)
    assert told.correlation == pytest.approx(
        expected[0, 1] / sqrt(expected[0, 0] * expected[1, 1]), rel=1e-6, abs=1e-9
    )


def test_a_vehicle_that_would_stop_between_the_cameras_has_its_reason() -> None:
    slow = Motion("paper", Crossings(0, 1, 2, 3), "ok", speed_mps=2.0, acceleration_mps2=-8.0)
    told = seen_from_camera_1(slow, RIG)
    assert told.status == "not_measurable" and "stopped in view" in str(told.reason)
    assert told.crossings == Crossings(2, 3, 0, 1)


def test_gaps_are_those_to_the_vehicle_of_the_same_direction() -> None:
    passages, truth = both_ways()
    told = gaps([(motion.crossings, motion) for motion in motions()], OF_RIG)
    assert [gap.reason for gap in told[:2]] == [NONE_BEFORE] * 2
    for gap, this, before in zip(told[2:], truth[2:], truth, strict=False):
        expected = (this.front_line_1 - before.rear_line_1) / OF_RIG.line_rate_hz
        assert gap.time_gap_s == pytest.approx(expected, abs=1e-3)
        ahead = before.vehicle
        at_s = this.front_line_1 / OF_RIG.line_rate_hz
        onward_m = SITE.baseline_m if ahead.against else 0.0
        true_m = float(ahead.travelled_m(np.array(at_s))) - onward_m - ahead.length_m
        assert gap.distance_gap_m == pytest.approx(true_m, abs=0.1)
    assert [one.gap for one in measure_passages(passages, OF_RIG, "direct")] == told


def test_four_lines_alone_give_the_motion_either_way() -> None:
    for true in both_ways()[1]:
        lines = Crossings(true.front_line_1, true.rear_line_1, true.front_line_2, true.rear_line_2)
        motion = exact_at_camera_1(lines, SITE.baseline_m, SITE.line_rate_hz)
        assert motion.speed_mps == pytest.approx(at_camera_1(true), rel=1e-9)
        assert motion.length_m == pytest.approx(true.vehicle.length_m, rel=1e-9)
