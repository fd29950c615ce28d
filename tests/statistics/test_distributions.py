"""Percentiles, shares, bands and densities against SciPy and by simulation."""

import numpy as np
import pytest
from scipy import stats

from sightline.errors import BadInput
from sightline.messages.said import Said
from sightline.statistics.distributions import (
    density,
    ecdf,
    percentiles,
    share_below,
    sorted_values,
    vehicles_for_interval,
)
from sightline.statistics.sample_size import vehicles_needed


def heights(n: int, seed: int = 1) -> np.ndarray:
    return np.random.default_rng(seed).lognormal(np.log(1.2), 0.08, n)


def test_percentiles_are_those_of_scipy() -> None:
    sample = heights(401)
    for one in percentiles(sorted_values(sample)):
        assert one.value == pytest.approx(np.quantile(sample, one.percent / 100, method="median_unbiased"))
        interval = stats.quantile_test(sample, q=one.value, p=one.percent / 100).confidence_interval(0.95)
        if one.low is not None:
            assert (one.low, one.high) == (interval.low, interval.high)
        else:
            assert np.isnan(interval.low) or np.isnan(interval.high)


@pytest.mark.parametrize("percent", [2.0, 10.0, 50.0, 97.5])
def test_intervals_of_percentiles_hold_at_least_what_they_promise(percent: float) -> None:
    n, runs = 250, 500
    true = float(stats.norm.ppf(percent / 100))
    samples = np.sort(np.random.default_rng(int(10 * percent)).normal(size=(runs, n)), axis=1)
    held = [
        one.low <= true <= one.high
        for one in (percentiles(row, [percent])[0] for row in samples)
        if one.low is not None and one.high is not None
    ]
    assert len(held) == runs
    # at least 0.95; an exact one is at most a few order statistics' weight above it
    assert 0.95 - 3 * np.sqrt(0.05 * 0.95 / runs) <= np.mean(held)


def test_a_small_sample_has_a_percentile_and_a_reason() -> None:
    needed = vehicles_for_interval(2.5)
    assert needed == 146
    small = percentiles(sorted_values(heights(100)), [2.5])[0]
    assert small.low is None and small.reason and "146" in str(small.reason) and "100" in str(small.reason)
    enough = percentiles(sorted_values(heights(needed)), [2.5])[0]
    assert enough.low is not None and enough.low <= enough.value
    assert percentiles(sorted_values([])) == []
    assert len(sorted_values([1.2, np.nan, np.inf, 1.1])) == 2


def test_share_below_is_clopper_and_pearson() -> None:
    sample = sorted_values([1.0, 1.05, 1.08, 1.08, 1.2])
    share = share_below(sample, 1.08)
    assert share is not None and (share.below, share.n) == (2, 5)  # those at the limit are not below it
    assert share.low == pytest.approx(stats.beta.ppf(0.025, 2, 4))
    assert share.high == pytest.approx(stats.beta.ppf(0.975, 3, 3))
    exact = stats.binomtest(2, 5).proportion_ci(0.95, method="exact")
    assert (share.low, share.high) == pytest.approx((exact.low, exact.high))
    ends = [share_below(sample, limit) for limit in (0.9, 1.3)]
    assert [(one.low > 0, one.high < 1) for one in ends if one] == [(False, True), (True, False)]
    assert share_below(sorted_values([]), 1.08) is None
    rng = np.random.default_rng(5)
    held = [
        found.low <= 0.1 <= found.high
        for found in (share_below(np.sort(rng.uniform(size=120)), 0.1) for _ in range(500))
        if found is not None
    ]
    assert np.mean(held) >= 0.95 - 3 * np.sqrt(0.05 * 0.95 / 500)


def test_ecdf_is_scipys_and_its_band_holds_everywhere_at_once() -> None:
    sample = np.round(heights(300), 2)  # ties
    found = ecdf(sorted_values(sample))
    assert found is not None
    assert np.allclose(found.share, stats.ecdf(sample).cdf.evaluate(found.value), atol=1e-15)
    thin = ecdf(sorted_values(heights(50_000)))
    assert thin is not None and len(thin.value) <= 600 and np.max(np.diff(thin.share)) < 2 / 600
    assert ecdf(sorted_values([])) is None
    rng = np.random.default_rng(2)
    held = 0
    for _ in range(600):
        one = ecdf(np.sort(rng.uniform(size=60)))
        assert one is not None
        # the true distribution is x itself; the steps' lower corners count as well
        before = np.concatenate([[0.0], one.share[:-1]])
        band = one.high - one.share
        held += bool(
            np.all(np.abs(one.share - one.value) <= band.max())
            and np.all(np.abs(before - one.value) <= band.max())
        )
    assert held / 600 >= 0.95 - 3 * np.sqrt(0.05 * 0.95 / 600)


def test_density_is_scipys_and_its_band_holds_its_mean() -> None:
    sample = sorted_values(heights(500))
    found = density(sample)
    assert not isinstance(found, Said)
    kde = stats.gaussian_kde(sample, found.bandwidth / np.std(sample, ddof=1))
    assert np.allclose(found.density, kde(found.value), atol=0.004 * found.density.max())
    step = found.value[1] - found.value[0]
    assert float(found.density.sum() * step) == pytest.approx(1.0, abs=2e-3)
    assert np.all(found.low <= found.high)
    inside = (found.low <= found.density + 1e-12) & (found.density <= found.high + 1e-12)
    assert inside.mean() > 0.97
    assert "10" in str(density(sorted_values([1.0, 2.0])))
    assert "same" in str(density(np.full(30, 1.2)))


def test_the_band_of_a_density_holds_the_mean_of_the_estimate_as_often_as_it_says() -> None:
    """The mean of a kernel estimate is the density smoothed by the kernel: of a normal, a wider normal."""
    at, runs, rng = np.linspace(-2.0, 2.0, 9), 80, np.random.default_rng(5)
    held = []
    for _ in range(runs):
        found = density(sorted_values(rng.normal(size=200)))
        assert not isinstance(found, Said)
        mean = stats.norm.pdf(at, scale=np.hypot(1.0, found.bandwidth))
        low, high = (np.interp(at, found.value, side) for side in (found.low, found.high))
        held.append((low <= mean) & (mean <= high))
    assert 0.92 <= np.mean(held) <= 0.97


def test_whole_centimetres_do_not_draw_a_comb() -> None:
    rounded = sorted_values(np.rint(np.random.default_rng(2).normal(0.0, 1.8, 3000)) / 100.0)
    comb, smooth = density(rounded), density(rounded, step=0.01)
    assert not isinstance(comb, Said) and not isinstance(smooth, Said)
    assert peaks(comb.density) > 5
    assert peaks(smooth.density) == 1
    assert smooth.bandwidth == pytest.approx(0.005)


def peaks(values: np.ndarray) -> int:
    """How many humps stand out by 5 % of the highest."""
    inner = values[1:-1]
    tops = np.flatnonzero((inner > values[:-2]) & (inner >= values[2:]) & (inner > 0.05 * values.max()))
    return len(tops)


def test_sample_size_gives_the_width_it_says() -> None:
    for percent in (10.0, 50.0, 97.5):
        wanted = vehicles_needed(percent, 0.02, 0.08)
        rng = np.random.default_rng(int(percent))
        widths = []
        for _ in range(60):
            one = percentiles(np.sort(rng.normal(1.2, 0.08, wanted.vehicles)), [percent])[0]
            assert one.low is not None and one.high is not None
            widths.append(one.high - one.low)
        assert np.mean(widths) == pytest.approx(0.02, rel=0.1)
    assert vehicles_needed(2.0, 5.0, 0.08).vehicles == vehicles_for_interval(2.0)
    for wrong in ((0.0, 0.02, 0.08), (10.0, 0.0, 0.08), (10.0, 0.02, float("nan"))):
        with pytest.raises(BadInput):
            vehicles_needed(*wrong)
