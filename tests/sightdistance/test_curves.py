"""Crest, sag and horizontal curves against traced lines of sight, and against the values that AASHTO
prints.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.errors import BadInput
from sightline.sightdistance.curves import (
    crest_constant,
    crest_constants_m,
    crest_distance_m,
    crest_k_m,
    crest_length,
    sag_k_m,
    sag_length,
    sightline_offset_m,
)
from tests.sightdistance.rays import Profile, hidden_inside_curve, lit_in_sag, seen_over_crest, shortest

EYES = st.floats(0.5, 4.0)
OBJECTS = st.floats(0.0, 4.0)
DISTANCES = st.floats(10.0, 1500.0)
GRADES = st.floats(0.1, 20.0)


@pytest.mark.parametrize(
    ("eye_m", "object_m", "distance_m", "difference", "first"),
    [
        (1.08, 0.60, 185.0, 6.0, 0.03),  # S < L
        (1.08, 1.08, 320.0, 4.0, 0.01),
        (1.18, 0.53, 185.0, 9.0, -0.02),
        (2.33, 0.15, 250.0, 3.5, 0.05),
        (1.08, 0.60, 185.0, 3.0, 0.02),  # S > L
        (1.05, 0.26, 120.0, 3.6, 0.00),
        (1.18, 0.53, 65.0, 12.0, 0.06),
    ],
)
def test_a_crest_of_the_computed_length_shows_just_the_distance(
    eye_m: float, object_m: float, distance_m: float, difference: float, first: float
) -> None:
    constant = crest_constant(eye_m, object_m).constant_m
    found = crest_length(distance_m, difference, constant)
    assert found.case == ("S < L" if found.length_m >= distance_m else "S > L")
    profile = Profile(first, first - difference / 100, found.length_m)
    seen = shortest(
        lambda eye: seen_over_crest(profile, eye, eye_m, object_m), -1.5 * distance_m, found.length_m
    )
    assert seen == pytest.approx(distance_m, abs=1e-6)
    if found.case == "S < L":
        assert found.length_m / difference == pytest.approx(crest_k_m(distance_m, constant), rel=1e-12)


def test_a_break_of_grades_that_hides_nothing_needs_no_curve() -> None:
    constant = crest_constant(1.08, 0.60).constant_m
    assert crest_length(85.0, 2.0, constant) == crest_length(85.0, 2.0, constant).__class__(0.0, "none")
    profile = Profile(0.01, -0.01, 0.0)
    seen = shortest(lambda eye: seen_over_crest(profile, eye, 1.08, 0.60), -400.0, -0.1)
    assert seen == pytest.approx(crest_distance_m(0.0, 2.0, constant), abs=1e-6)
    assert seen > 85.0


@pytest.mark.parametrize(
    ("headlight_m", "distance_m", "difference"),
    [(0.60, 185.0, 6.0), (0.65, 105.0, 9.0), (0.60, 85.0, 3.5), (0.87, 130.0, 3.4)],
)
def test_a_sag_of_the_computed_length_is_lit_just_as_far(
    headlight_m: float, distance_m: float, difference: float
) -> None:
    rise = math.radians(1.0)
    found = sag_length(distance_m, difference, headlight_m, rise)
    profile = Profile(-0.03, -0.03 + difference / 100, found.length_m)
    seen = shortest(
        lambda lamp: lit_in_sag(profile, lamp, headlight_m, math.tan(rise)), -distance_m, found.length_m
    )
    assert found.case == ("S < L" if found.length_m >= distance_m else "S > L")
    assert seen == pytest.approx(distance_m, abs=1e-6)


@pytest.mark.parametrize(("radius_m", "distance_m"), [(200.0, 85.0), (500.0, 185.0), (40.0, 90.0)])
def test_the_room_beside_a_curve_is_what_traced_lines_cross(radius_m: float, distance_m: float) -> None:
    offset = sightline_offset_m(radius_m, distance_m)
    assert offset == pytest.approx(hidden_inside_curve(radius_m, distance_m), abs=1e-6)


# Stopping distance in metres with K of crests and sags as printed (AASHTO: calculated values, one decimal).
METRIC_K = [
    (35, 1.9, 5.1),
    (50, 3.8, 8.5),
    (65, 6.4, 12.2),
    (85, 11.0, 17.3),
    (105, 16.8, 22.6),
    (130, 25.7, 29.4),
    (160, 38.9, 37.6),
    (185, 52.0, 44.6),
    (220, 73.6, 54.4),
    (250, 95.0, 62.8),
    (285, 123.4, 72.7),
]
US_K = [(200, 18.5), (250, 29.0), (305, 43.1), (425, 83.7), (570, 150.6), (730, 246.9), (910, 383.7)]


@pytest.mark.parametrize(("distance_m", "crest", "sag"), METRIC_K)
def test_printed_k_values(distance_m: float, crest: float, sag: float) -> None:
    assert round(crest_k_m(distance_m, round(crest_constant(1.08, 0.60).constant_m)), 1) == crest
    assert round(sag_k_m(distance_m, beam_rad=math.atan(3.5 / 200)), 1) == sag  # 200 tan 1 degree as printed
    assert sag_k_m(distance_m) == pytest.approx(sag, rel=0.009)


@pytest.mark.parametrize(("distance_ft", "k_ft"), US_K)
def test_printed_k_values_in_feet(distance_ft: float, k_ft: float) -> None:
    foot = 0.3048
    constant = crest_constant(3.5 * foot, 2.0 * foot).constant_m
    assert round(constant / foot) == 2158
    assert round(crest_k_m(distance_ft * foot, 2158 * foot) / foot, 1) == k_ft


def test_printed_constants_and_the_papers_own_numbers() -> None:
    """The paper's 10th percentile of eyes and 5th of taillights would leave the crests as they are."""
    assert round(crest_constant(1.08, 0.60).constant_m) == 658
    assert round(crest_constant(1.08, 1.08).constant_m) == 864
    assert crest_constant(1.18, 0.53).constant_m == pytest.approx(658.3, abs=0.05)
    assert round(crest_k_m(185.0, crest_constant(1.18, 0.53).constant_m), 1) == 52.0
    assert [round(crest_k_m(s, 864.0)) for s in (120, 180, 320, 440)] == [17, 38, 119, 224]


@given(eye_m=EYES, object_m=OBJECTS, distance_m=DISTANCES, difference=GRADES)
def test_length_and_distance_undo_each_other(
    eye_m: float, object_m: float, distance_m: float, difference: float
) -> None:
    constant = crest_constant(eye_m, object_m).constant_m
    found = crest_length(distance_m, difference, constant)
    seen = crest_distance_m(found.length_m, difference, constant)
    if found.case == "none":
        assert seen >= distance_m * (1 - 1e-12)
    else:
        assert seen == pytest.approx(distance_m, rel=1e-9)


@given(eye_m=EYES, object_m=OBJECTS, more=st.floats(1.0, 2.0))
def test_a_higher_eye_needs_no_longer_crest(eye_m: float, object_m: float, more: float) -> None:
    low, high = crest_constants_m([eye_m, more * eye_m], [object_m, object_m])
    assert low <= high
    assert crest_constants_m(more * eye_m, more * object_m) == pytest.approx(more * low)
    assert crest_constants_m(object_m + 0.1, eye_m) == pytest.approx(
        crest_constants_m(eye_m, object_m + 0.1), rel=1e-12
    )


def test_the_uncertainty_is_that_of_drawn_heights() -> None:
    rng = np.random.default_rng(5)
    eyes, objects = rng.normal(1.08, 0.01, 40_000), rng.normal(0.60, 0.02, 40_000)
    found = crest_constant(1.08, 0.60, 0.01, 0.02)
    assert found.u_constant_m == pytest.approx(float(np.std(crest_constants_m(eyes, objects))), rel=0.02)
    assert crest_constant(1.08, 0.60, 0.01).u_constant_m == crest_constant(1.08, 0.60, 0.01, 0.0).u_constant_m
    assert crest_constant(1.08, 0.0, 0.01, 0.0).u_constant_m is not None


@pytest.mark.parametrize(
    "call",
    [
        lambda: crest_constant(0.0, 0.6),
        lambda: crest_constant(108.0, 0.6),
        lambda: crest_constant(1.08, -0.1),
        lambda: crest_constant(1.08, math.nan),
        lambda: crest_constant(1.08, 0.6, -0.1),
        lambda: crest_constant(1.08, 0.0, None, 0.01),
        lambda: crest_k_m(0.0, 658.0),
        lambda: crest_k_m(185.0, 0.0),
        lambda: crest_length(185.0, 0.0, 658.0),
        lambda: crest_distance_m(-1.0, 5.0, 658.0),
        lambda: sag_k_m(185.0, -0.1),
        lambda: sightline_offset_m(10.0, 100.0),
    ],
)
def test_what_cannot_be_is_refused(call: object) -> None:
    assert callable(call)
    with pytest.raises(BadInput):
        call()
