"""Sight distances against the values that AASHTO prints, in metric and in US customary units."""

from __future__ import annotations

import math
import re

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.errors import BadInput
from sightline.sightdistance import distances
from sightline.sightdistance.distances import (
    METRIC,
    US_CUSTOMARY,
    Manoeuvre,
    decision_distance,
    intersection_distance,
    passing_distance,
    stopping_distance,
)

KMH = 1 / 3.6
MPH = 0.44704
FOOT = 0.3048


def test_stopping_distances_as_printed() -> None:
    metric = [stopping_distance(v * KMH).design_m for v in range(30, 140, 10)]
    assert metric == [35, 50, 65, 85, 105, 130, 160, 185, 220, 250, 285]
    assert round(stopping_distance(100 * KMH).distance_m, 1) == 184.2
    feet = [stopping_distance(v * MPH, US_CUSTOMARY).design_m / FOOT for v in range(30, 85, 10)]
    assert [round(one) for one in feet] == [200, 305, 425, 570, 730, 910]


def test_stopping_distances_on_gradients_as_printed() -> None:
    down = [math.ceil(stopping_distance(v * KMH, gradient=-0.03).distance_m) for v in (50, 80, 100, 120)]
    assert down == [66, 136, 194, 263]
    assert stopping_distance(100 * KMH, gradient=0.06).distance_m < 184.2


# US design speed, distances in feet for the manoeuvres A to E.
DECISION = [
    (30, (220, 490, 450, 535, 620)),
    (50, (465, 910, 750, 890, 1030)),
    (60, (610, 1150, 990, 1125, 1280)),
    (70, (780, 1410, 1105, 1275, 1445)),
    (80, (970, 1685, 1260, 1455, 1650)),
]
ENDS_S: dict[Manoeuvre, tuple[float, float]] = {"C": (10.2, 11.2), "D": (12.1, 12.9), "E": (14.0, 14.5)}


@pytest.mark.parametrize(("speed_mph", "printed"), DECISION)
def test_decision_distances_as_printed(speed_mph: float, printed: tuple[int, ...]) -> None:
    for manoeuvre, feet in zip(("A", "B"), printed, strict=False):
        found = decision_distance(speed_mph * MPH, manoeuvre, US_CUSTOMARY)  # type: ignore[arg-type]
        assert -0.5 < feet - found.distance_m / FOOT < 5  # rounded up, once after whole feet
    for (manoeuvre, ends), feet in zip(ENDS_S.items(), printed[2:], strict=True):
        least, most = (1.47 * speed_mph * end for end in ends)
        assert least - 5 <= feet <= most + 5
        longest = decision_distance(speed_mph * MPH, manoeuvre, US_CUSTOMARY).distance_m / FOOT
        assert longest == pytest.approx(most) and feet >= 0.9 * most


def test_passing_distances_run_through_their_table() -> None:
    assert [passing_distance(v * KMH).distance_m for v in (30, 70, 100, 130)] == [120, 210, 320, 440]
    assert passing_distance(95 * KMH).distance_m == pytest.approx(300.0)
    for speed in (20, 140):
        with pytest.raises(BadInput, match="30 to 130"):
            passing_distance(speed * KMH)


def test_intersection_distances_as_printed() -> None:
    """Left turns from a stop: 105, 210 m; in feet and beside right turns, 555 and 480 at 50 mph."""
    assert [intersection_distance(v * KMH, "left_from_stop").design_m for v in (50, 100)] == [105, 210]
    left = intersection_distance(50 * MPH, "left_from_stop", US_CUSTOMARY)
    right = intersection_distance(50 * MPH, "right_from_stop", US_CUSTOMARY)
    assert [round(one.design_m / FOOT) for one in (left, right)] == [555, 480]


@given(speed_kmh=st.floats(1, 290), more=st.floats(1.001, 1.03))
def test_who_drives_faster_has_to_see_further(speed_kmh: float, more: float) -> None:
    for units in (METRIC, US_CUSTOMARY):
        slow, fast = (stopping_distance(v * KMH, units) for v in (speed_kmh, more * speed_kmh))
        assert slow.distance_m < fast.distance_m and slow.design_m <= fast.design_m
        assert slow.distance_m <= slow.design_m * (1 + 1e-9)
        first_principles = speed_kmh * KMH * 2.5 + (speed_kmh * KMH) ** 2 / (2 * 3.4)
        assert slow.distance_m == pytest.approx(first_principles, rel=0.012)


def test_the_systems_differ_by_no_more_than_is_said() -> None:
    asked: list[dict[str, float]] = [
        {"gradient": gradient, "reaction_s": reaction_s} | given
        for gradient in (-0.25, -0.06, 0.0, 0.06, 0.25)
        for reaction_s in (0.0, 2.5, 9.1)
        for given in ({}, {"deceleration_mps2": 3.4})
    ]
    furthest = 0.0
    for speed_kmh in (1, 30, 60, 130, 300):
        for one in asked:
            v, braking = speed_kmh * KMH, 3.4 + 9.81 * one["gradient"]
            found = [stopping_distance(v, units, **one).distance_m for units in (METRIC, US_CUSTOMARY)]
            found.append(v * one["reaction_s"] + v**2 / (2 * braking))
            furthest = max(furthest, max(found) / min(found) - 1)
    (said,) = re.findall(r"by up to (\S+) %", distances.__doc__ or "")
    assert 100 * furthest == pytest.approx(float(said), abs=0.05)


@pytest.mark.parametrize(
    "call",
    [
        lambda: stopping_distance(0.0),
        lambda: stopping_distance(float("nan")),
        lambda: stopping_distance(301 * KMH),
        lambda: stopping_distance(20.0, gradient=-0.36),
        lambda: stopping_distance(20.0, reaction_s=-1.0),
        lambda: stopping_distance(20.0, deceleration_mps2=0.0),
    ],
)
def test_what_cannot_be_is_refused(call: object) -> None:
    assert callable(call)
    with pytest.raises(BadInput):
        call()
