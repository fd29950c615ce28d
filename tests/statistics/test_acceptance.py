"""Sampling plans: both risks are kept and no smaller sample keeps them; limits hold as often as they say."""

from itertools import combinations
from math import comb

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.errors import BadInput
from sightline.statistics.acceptance import (
    USUAL_RISKS,
    RiskPoints,
    accepted_with,
    best_bad,
    estimate_outgoing,
    operating_curve,
    outgoing_of_lots,
    require_risks,
    single_plan,
    worst_good,
)

SIZES = st.integers(1, 400)
QUALITIES = st.tuples(st.floats(0.0, 0.3), st.floats(0.0, 0.6)).filter(lambda q: q[0] < q[1])
CHANCES = st.tuples(st.floats(0.01, 0.3), st.floats(0.01, 0.3))


def by_counting(size: int, bad: int, sample: int, number: int) -> float:
    """P(X <= c) by binomial coefficients, whole numbers to the last division."""
    ways = sum(comb(bad, k) * comb(size - bad, sample - k) for k in range(number + 1) if sample - k >= 0)
    return ways / comb(size, sample)


def test_a_lot_of_six_counted_by_hand() -> None:
    accepted = sum(len({0, 1} & set(drawn)) <= 1 for drawn in combinations(range(6), 3))
    assert accepted_with(6, 2, 3, 1) == pytest.approx(accepted / comb(6, 3), abs=1e-12)


@given(SIZES, st.data())
def test_the_distribution_is_the_counted_one(size: int, data: st.DataObject) -> None:
    bad, sample = data.draw(st.integers(0, size)), data.draw(st.integers(0, size))
    number = data.draw(st.integers(0, sample))
    assert accepted_with(size, bad, sample, number) == pytest.approx(
        by_counting(size, bad, sample, number), abs=1e-9
    )


@given(st.integers(1, 90), QUALITIES, CHANCES)
def test_both_risks_are_kept_by_no_smaller_sample(
    size: int, qualities: tuple[float, float], chances: tuple[float, float]
) -> None:
    risks = RiskPoints(qualities[0], chances[0], qualities[1], chances[1])
    plan = single_plan(size, risks)
    good, bad = worst_good(size, risks), best_bad(size, risks)
    assert good < bad and 0 <= plan.acceptance_number < plan.sample_size <= size
    assert 1 - by_counting(size, good, plan.sample_size, plan.acceptance_number) <= chances[0] + 1e-8
    assert by_counting(size, bad, plan.sample_size, plan.acceptance_number) <= chances[1] + 1e-8
    for sample in range(1, plan.sample_size):
        for number in range(sample):
            keeps = by_counting(size, bad, sample, number) <= chances[1] - 1e-8
            assert not (keeps and 1 - by_counting(size, good, sample, number) <= chances[0] - 1e-8)


def test_a_large_lot_comes_to_the_plan_of_the_binomial_distribution() -> None:
    """A textbook's: producer's point (1 %, 5 %), consumer's (8 %, 10 %) want 1 of 48 (binomial: 0.0907)."""
    plan = single_plan(1_000_000, RiskPoints(0.01, 0.09, 0.08, 0.10))
    assert (plan.sample_size, plan.acceptance_number) == (48, 1)
    assert plan.consumer_risk == pytest.approx(0.92**48 + 48 * 0.08 * 0.92**47, abs=1e-4)


@given(SIZES)
def test_the_curve_falls_from_one_through_both_points(size: int) -> None:
    plan = single_plan(size, USUAL_RISKS)
    curve = operating_curve(plan)
    assert curve.accepted[0] == 1.0 and curve.fraction[-1] == 1.0
    assert np.all(np.diff(curve.accepted) <= 1e-12)
    bad = best_bad(size, USUAL_RISKS) / size
    assert np.interp(bad, curve.fraction, curve.accepted) <= USUAL_RISKS.consumer_risk + 0.2


def test_a_small_lot_is_its_own_sample() -> None:
    assert not single_plan(3, USUAL_RISKS).saves
    assert single_plan(200, USUAL_RISKS).saves


@pytest.mark.parametrize(("size", "sample", "nonconforming"), [(60, 18, 0), (200, 40, 1), (200, 40, 4)])
def test_the_limit_is_missed_in_one_lot_of_twenty_at_most(size: int, sample: int, nonconforming: int) -> None:
    """Whatever the lot holds: of all samples, those whose limit lies below it are 5 % at most."""
    limits = [estimate_outgoing(size, sample, found).at_most + found for found in range(sample + 1)]
    for bad in range(size - sample + 1):
        missed = sum(
            comb(bad, k) * comb(size - bad, sample - k)
            for k in range(min(bad, sample) + 1)
            if limits[k] < bad
        )
        assert missed / comb(size, sample) <= 0.05
    found = estimate_outgoing(size, sample, nonconforming)
    assert found.estimate == pytest.approx((size - sample) * nonconforming / sample)
    assert found.estimate <= found.at_most <= found.count == size - sample


def test_limits_of_several_lots_hold_together() -> None:
    """Simulated: three lots with 4, 0 and 7 nonconforming heights of 100 each."""
    rng = np.random.default_rng(5)
    bad = np.array([4, 0, 7])
    hits = 0
    cache = {}
    for _ in range(2000):
        found = tuple(int(one) for one in rng.hypergeometric(bad, 100 - bad, 25))
        if found not in cache:
            cache[found] = outgoing_of_lots((100, 25, one, 75) for one in found).at_most
        hits += cache[found] >= bad.sum() - sum(found)
    assert hits / 2000 >= 0.95
    assert outgoing_of_lots([]).at_most == 0


@pytest.mark.parametrize(
    ("risks", "key"),
    [
        (RiskPoints(0.1, 0.05, 0.1, 0.1), "lots-fractions-in-order"),
        (RiskPoints(0.01, 0.0, 0.1, 0.1), "lots-risk-between"),
        (RiskPoints(-0.01, 0.05, 0.1, 0.1), "lots-fraction-between"),
        (RiskPoints(0.01, 0.05, float("nan"), 0.1), "lots-fraction-between"),
    ],
)
def test_what_is_no_pair_of_risk_points_is_refused(risks: RiskPoints, key: str) -> None:
    with pytest.raises(BadInput) as refused:
        require_risks(risks)
    assert refused.value.code == key
    require_risks(USUAL_RISKS)
