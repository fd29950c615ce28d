"""Intervals of crests from intervals of heights, and what a survey says of a standard."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.errors import BadInput
from sightline.messages.said import Said
from sightline.sightdistance.curves import crest_constants_m
from sightline.sightdistance.workbench import (
    Bounded,
    compare,
    constant_of,
    crest_of,
    shares_of_fleet,
    sight_distance,
)
from sightline.statistics.shared_errors import SharedErrors, correlation_of
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty

AASHTO_M = 657.9937888469


def test_the_interval_covers_as_those_of_the_heights_do() -> None:
    """Percentiles of drawn samples with their own intervals; the constant of the true heights lies within."""
    rng = np.random.default_rng(8)
    u_eye, u_object = 0.008, 0.02
    eyes, objects = rng.normal(1.18, u_eye, 4000), rng.normal(0.53, u_object, 4000)
    true = float(crest_constants_m(1.18, 0.53))
    found = [
        constant_of(
            Bounded(e, e - 1.96 * u_eye, e + 1.96 * u_eye),
            Bounded(o, o - 1.96 * u_object, o + 1.96 * u_object),
        )
        for e, o in zip(eyes, objects, strict=True)
    ]
    held = np.mean([one.low <= true <= one.high for one in found if one.low and one.high])
    assert held == pytest.approx(0.95, abs=0.012)


@pytest.mark.parametrize("surveys", [100, pytest.param(300, marks=pytest.mark.proof)])
def test_errors_of_one_pose_count_together(surveys: int) -> None:
    """Eyes and lamps of the same pose err alike; left out, the interval of their constant is too short."""
    rng = np.random.default_rng(31)
    n, u_pose, true = 150, 0.010, float(crest_constants_m(1.18, 0.62))
    pose = SharedErrors(np.zeros(n, np.int64), np.full(n, u_pose), np.array([7]))
    held, correlations = {True: 0, False: 0}, []
    for _ in range(surveys):
        error = rng.normal(0.0, u_pose)
        found = []
        for middle, spread in ((1.18, 0.05), (0.62, 0.04)):
            sample = HeightSample(rng.normal(middle, spread, n) + error, np.zeros(n), (pose,))
            total = TotalUncertainty(sample)
            one = total.percentile(50.0)
            assert one.U95_low is not None and one.U95_high is not None
            bounded = Bounded(one.value, one.U95_low, one.U95_high)
            found.append((bounded, total.named_effects_m(50.0), (one.U95_high - one.U95_low) / 3.92))
        (eye, of_eye, u_eye), (thing, of_thing, u_thing) = found
        correlations.append(correlation_of(of_eye, of_thing, u_eye, u_thing))
        for counted in held:
            constant = constant_of(eye, thing, correlations[-1] if counted else 0.0)
            assert constant.low is not None and constant.high is not None
            held[counted] += constant.low <= true <= constant.high
    assert np.mean(correlations) == pytest.approx(u_pose**2 / (0.01129 * 0.01082), abs=0.03)
    assert held[True] / surveys == pytest.approx(0.95, abs=0.03)
    assert held[False] / surveys < 0.90


def test_other_poses_share_nothing() -> None:
    assert correlation_of({1: 0.01, 2: 0.02}, {3: 0.01}, 0.03, 0.03) == 0.0
    assert correlation_of({1: 0.01, 2: 0.02}, {2: 0.01}, 0.03, 0.02) == pytest.approx(0.0002 / 0.0006)
    assert correlation_of({1: 0.01}, {1: 0.01}, 0.0, 0.01) == 0.0


@given(
    eye=st.floats(0.8, 2.5),
    thing=st.floats(0.1, 2.0),
    gaps=st.tuples(*[st.floats(0.0, 0.09)] * 4),
    distance=st.floats(30, 600),
    difference=st.floats(0.5, 12),
)
def test_intervals_hold_their_values_and_turn_round_where_a_curve_shortens(
    eye: float, thing: float, gaps: tuple[float, ...], distance: float, difference: float
) -> None:
    crest = crest_of(
        Bounded(eye, eye - gaps[0], eye + gaps[1]),
        Bounded(thing, thing - gaps[2], thing + gaps[3]),
        distance,
        difference,
        AASHTO_M,
    )
    for one in (crest.constant_m, crest.k_m, crest.length_m, crest.seen_m):
        assert one.low is not None and one.high is not None
        assert one.low <= one.value * (1 + 1e-9) and one.value <= one.high * (1 + 1e-9)
    assert crest.k_m.low == pytest.approx(distance**2 / crest.constant_m.high)  # type: ignore[operator]


def test_on_a_crest_built_by_the_standard_its_own_heights_see_the_distance() -> None:
    crest = crest_of(Bounded(1.08), Bounded(0.60), 185.0, 6.0, AASHTO_M)
    assert crest.seen_m == Bounded(pytest.approx(185.0))  # type: ignore[arg-type]
    assert crest.length_m.value == pytest.approx(6 * crest.k_m.value)
    assert crest.k_m.value == pytest.approx(52.0, abs=0.05)


def test_the_papers_percentiles_change_nothing() -> None:
    """P1: 1.18 m (10th percentile of eyes) and 0.53 m (5th of taillights) against 1.08 and 0.60 m."""
    constant = constant_of(Bounded(1.18, 1.17, 1.19), Bounded(0.53, 0.49, 0.56))
    found = compare(AASHTO_M, constant)
    assert found.verdict == "alike" and abs(found.k_change) < 0.001


@pytest.mark.parametrize(
    ("eye", "verdict"),
    [
        (Bounded(1.18, 1.17, 1.19), "shorter"),
        (Bounded(1.00, 0.99, 1.01), "longer"),
        (Bounded(1.09, 1.06, 1.12), "alike"),
        (Bounded(1.18, reason=Said("stat-trend-needs", least=4, count=1)), "unknown"),
        (Bounded(1.18), "unknown"),
    ],
)
def test_verdicts(eye: Bounded, verdict: str) -> None:
    assert compare(AASHTO_M, constant_of(eye, Bounded(0.60))).verdict == verdict


def test_a_missing_interval_keeps_its_reason() -> None:
    few = Said("stat-heights-needed", needed=36, count=3)
    crest = crest_of(Bounded(1.18, reason=few), Bounded(0.6, 0.5, 0.7), 185.0, 6.0, AASHTO_M)
    assert {one.reason for one in (crest.constant_m, crest.k_m, crest.length_m, crest.seen_m)} == {few}


def test_every_kind_has_a_distance() -> None:
    speed = 100 / 3.6
    found = {
        kind: round(sight_distance(kind, speed).distance_m)  # type: ignore[arg-type]
        for kind in ("stopping", "decision_a", "decision_b", "decision_e", "passing", "intersection_right")
    }
    assert found == {
        "stopping": 184,
        "decision_a": 198,
        "decision_b": 368,
        "decision_e": 403,
        "passing": 320,
        "intersection_right": 181,
    }


def test_shares_of_a_fleet_sum_to_one() -> None:
    assert sum(shares_of_fleet([0.6, 0.395])) == pytest.approx(1)
    for wrong in ([0.6, 0.3], [1.2, -0.2], [float("nan"), 1.0]):
        with pytest.raises(BadInput, match="sum"):
            shares_of_fleet(wrong)
