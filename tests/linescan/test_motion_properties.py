"""Whatever constant acceleration made four crossings is what the exact equations give back."""

from __future__ import annotations

import math

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sightline.linescan.equations import solve_crossings
from sightline.linescan.parts import Crossings
from tests.linescan.test_equations import solve_corrected

SPEEDS = st.floats(2.5, 40)
ACCELERATIONS = st.floats(-3, 3)
LENGTHS = st.floats(1.5, 20)
BASELINES = st.floats(0.2, 5)
RATES = st.floats(200, 50_000)


def crossed_at(distance_m: float, speed: float, acceleration: float) -> float:
    """Seconds until a point so far behind the front gets to camera 1: the stable root."""
    root = math.sqrt(speed**2 + 2 * acceleration * distance_m)
    return 2 * distance_m / (speed + root)


def crossings_of(speed: float, acceleration: float, length: float, baseline: float, rate: float) -> Crossings:
    assume(speed**2 + 2 * acceleration * (length + baseline) > 1)
    at = [crossed_at(d, speed, acceleration) * rate for d in (0.0, length, baseline, length + baseline)]
    return Crossings(front_line_1=at[0], rear_line_1=at[1], front_line_2=at[2], rear_line_2=at[3])


@given(speed=SPEEDS, acceleration=ACCELERATIONS, length=LENGTHS, baseline=BASELINES, rate=RATES)
def test_exact_gives_back_the_motion(
    speed: float, acceleration: float, length: float, baseline: float, rate: float
) -> None:
    found = solve_crossings(crossings_of(speed, acceleration, length, baseline, rate), baseline, rate)
    assert found.speed_mps == pytest.approx(speed, rel=1e-6)
    assert found.acceleration_mps2 == pytest.approx(acceleration, abs=1e-4)
    assert found.length_m == pytest.approx(length, rel=1e-6)


@given(speed=SPEEDS, acceleration=ACCELERATIONS, length=LENGTHS, baseline=BASELINES, rate=RATES)
def test_the_corrected_equation_4_has_no_error_for_a_constant_acceleration(
    speed: float, acceleration: float, length: float, baseline: float, rate: float
) -> None:
    found = solve_corrected(crossings_of(speed, acceleration, length, baseline, rate), baseline, rate)
    assert found.acceleration_mps2 == pytest.approx(acceleration, abs=1e-4)


@given(speed=SPEEDS, acceleration=ACCELERATIONS, length=LENGTHS, rate=RATES, later=st.floats(0, 1e5))
def test_when_the_recording_began_changes_nothing(
    speed: float, acceleration: float, length: float, rate: float, later: float
) -> None:
    now = crossings_of(speed, acceleration, length, 0.6, rate)
    then = Crossings(*(line + later for line in vars(now).values()))
    assert solve_crossings(then, 0.6, rate).speed_mps == pytest.approx(
        solve_crossings(now, 0.6, rate).speed_mps, rel=1e-6
    )
