"""Percentiles of a fleet with other shares: those of the sample where shares are its own, and their cover."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from sightline.statistics.fleet import mixed_fleet
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty


def exact(heights_m: np.ndarray) -> HeightSample:
    """Heights without errors."""
    return HeightSample(heights_m, np.zeros(len(heights_m)))


def test_of_the_samples_own_shares_it_is_nearly_the_plain_percentile() -> None:
    rng = np.random.default_rng(8)
    values, code = rng.normal(1.2, 0.06, 300), rng.integers(0, 3, 300)
    shared = SharedErrors(np.zeros(300, np.int64), np.full(300, 0.006))
    sample = HeightSample(values, np.full(300, 0.015), (shared,))
    for percent in (5.0, 10.0, 50.0, 90.0):
        found = mixed_fleet(sample, code, np.bincount(code) / 300).percentile(percent)
        plain = TotalUncertainty(sample).percentile(percent)
        assert found.value == pytest.approx(plain.value, abs=0.001)
        for end in ("U95_low", "U95_high"):
            half = abs(getattr(plain, end) - plain.value)
            assert abs(getattr(found, end) - found.value) == pytest.approx(half, rel=0.25)
            assert half > 1.96 * 0.006  # what all heights share is in it, whatever the shares


@pytest.mark.parametrize("runs", [90, pytest.param(120, marks=pytest.mark.proof)])
def test_the_interval_holds_the_true_percentile_of_the_other_fleet(runs: int) -> None:
    """Low cars and high vans, measured half and half with errors, asked for a fleet of nine to one."""
    rng = np.random.default_rng(4)
    shares, code = (0.9, 0.1), np.repeat([0, 1], 100)
    centre, spread = np.array([1.20, 1.60]), np.array([0.06, 0.12])
    grid = np.linspace(0.9, 2.2, 20_001)
    mixture = sum(
        share * stats.norm.cdf(grid, c, s) for share, c, s in zip(shares, centre, spread, strict=True)
    )
    true = float(np.interp(0.10, mixture, grid))
    held, values = 0, []
    for _ in range(runs):
        heights = rng.normal(centre[code], spread[code]) + rng.normal(0.0, 0.015, 200)
        shared = SharedErrors(np.zeros(200, np.int64), np.full(200, 0.008))
        sample = HeightSample(heights + rng.normal(0.0, 0.008), np.full(200, 0.015), (shared,))
        found = mixed_fleet(sample, code, shares).percentile(10.0)
        assert found.U95_low is not None and found.U95_high is not None
        held += found.U95_low <= true <= found.U95_high
        values.append(found.value)
    # of 120 at 0.95: less than 1 in 500 outside, either way
    assert 106 / 120 <= held / runs <= 119 / 120, held
    assert np.mean(values) == pytest.approx(true, abs=0.004)


def test_sites_of_a_fleet_are_some_of_many_as_those_of_its_heights() -> None:
    """Five sites that differ by 3 cm: without them the interval was a third as wide as the heights' own."""
    rng = np.random.default_rng(2)
    site = np.repeat(np.arange(5), 80)
    heights = rng.normal(1.15, 0.05, 400) + np.array([-0.03, 0.02, 0.0, 0.04, -0.02])[site]
    sample = HeightSample(heights, np.full(400, 0.01), site=site)
    plain = TotalUncertainty(sample).percentile(10.0)
    found = mixed_fleet(sample, np.zeros(400, np.int64), (1.0,)).percentile(10.0)
    assert found.value == pytest.approx(plain.value, abs=1e-9)
    wide = [one.U95_high - one.U95_low for one in (found, plain)]
    assert wide[0] == pytest.approx(wide[1], rel=0.1) and wide[1] > 0.06


def test_a_fleet_rests_on_the_poses_of_its_own_classes() -> None:
    """Cars are seen by pose 7, lorries by pose 9: what moves a fleet goes by its shares, not the sample's."""
    code = np.repeat([0, 1], 200)
    heights = np.concatenate([np.linspace(1.0, 1.3, 200), np.linspace(1.0, 1.5, 200)])
    poses = SharedErrors(code, np.full(400, 0.01), np.array([7, 9]))
    sample = HeightSample(heights, np.full(400, 0.005), (poses,))
    lorries = mixed_fleet(sample, code, (0.0, 1.0)).named_effects_m(10.0)
    assert lorries == {9: pytest.approx(0.01)}
    even, most = (mixed_fleet(sample, code, (1.0 - of, of)).named_effects_m(10.0) for of in (0.5, 0.9))
    assert sum(most.values()) == pytest.approx(0.01) and most[9] > even[9] + 0.002
    assert mixed_fleet(exact(np.array([1.1, 1.2])), np.array([0, 0]), (1.0,)).named_effects_m(10.0) == {}


def test_what_cannot_be_mixed() -> None:
    with pytest.raises(ValueError, match="no height"):
        mixed_fleet(exact(np.array([1.2])), np.array([0]), (0.5, 0.5))
    few = mixed_fleet(exact(np.array([1.1, 1.2, 1.3])), np.array([0, 0, 0]), (1.0,)).percentile(10)
    assert few.value is None and few.U95_low is None and str(few.reason) == "P10 needs 36; there are 3"
    away = mixed_fleet(exact(np.array([1.1, 9.0])), np.array([0, 1]), (1.0, 0.0)).percentile(50)
    assert away.value is None and str(away.reason) == "P50 needs 6; there is 1"
