"""Percentiles of a fleet with other shares: those of a plain sample where shares are its own, and their
cover.
"""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from sightline.statistics.distributions import percentiles, sorted_values
from sightline.statistics.fleet import mixed_percentile


@given(
    heights=st.lists(st.tuples(st.floats(0.5, 3), st.integers(0, 2)), min_size=3, max_size=60),
    percent=st.floats(1, 99),
)
def test_of_the_samples_own_shares_it_is_the_plain_percentile(
    heights: list[tuple[float, int]], percent: float
) -> None:
    values, code = np.array([h for h, _ in heights]), np.array([c for _, c in heights])
    found = mixed_percentile(values, code, np.bincount(code, minlength=3) / len(code), percent)
    (plain,) = percentiles(sorted_values(values), [percent])
    assert found.value == pytest.approx(plain.value, abs=1e-9)
    if found.low is not None and found.high is not None:
        assert found.low <= found.value + 1e-9 and found.value <= found.high + 1e-9


def test_the_interval_holds_the_true_percentile_of_the_other_fleet() -> None:
    """Low cars and high vans, measured half and half, asked for a fleet of nine to one."""
    rng = np.random.default_rng(4)
    shares, code = (0.9, 0.1), np.repeat([0, 1], 100)
    centre, spread = np.array([1.20, 1.60]), np.array([0.06, 0.12])
    grid = np.linspace(0.9, 2.2, 20_001)
    mixture = sum(
        share * stats.norm.cdf(grid, c, s) for share, c, s in zip(shares, centre, spread, strict=True)
    )
    for percent in (10.0, 50.0):
        true = float(np.interp(percent / 100, mixture, grid))
        held, values = 0, []
        for _ in range(1000):
            found = mixed_percentile(rng.normal(centre[code], spread[code]), code, shares, percent)
            assert found.low is not None and found.high is not None
            held += found.low <= true <= found.high
            values.append(found.value)
        assert 935 <= held <= 980, (percent, held)
        assert np.mean(values) == pytest.approx(true, abs=0.003)


def test_what_cannot_be_mixed() -> None:
    with pytest.raises(ValueError, match="no height"):
        mixed_percentile(np.array([1.2]), np.array([0]), (0.5, 0.5), 10)
    few = mixed_percentile(np.array([1.1, 1.2, 1.3]), np.array([0, 0, 0]), (1.0,), 10)
    assert few.low is None and few.reason and "3" in few.reason
    away = mixed_percentile(np.array([1.1, 9.0]), np.array([0, 1]), (1.0, 0.0), 50)
    assert away.value == 1.1
