"""Percentiles, shares and steps of any sample keep their order and move with it."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.statistics.distributions import ecdf, percentiles, share_below, sorted_values

SAMPLES = st.lists(st.floats(0.3, 4.5), min_size=1, max_size=120)


@given(sample=SAMPLES)
def test_percentiles_rise_and_lie_within_the_sample_and_their_intervals(sample: list[float]) -> None:
    found = percentiles(sorted_values(sample))
    values = [percentile.value for percentile in found if percentile.value is not None]
    assert values == sorted(values)
    assert all(min(sample) <= value <= max(sample) for value in values)
    for percentile in found:
        assert (percentile.value is None) == (percentile.needs > len(sample))
        assert (percentile.value is None) == (percentile.low is None) == (percentile.reason is not None)
        if percentile.value is not None and percentile.low is not None and percentile.high is not None:
            assert percentile.low <= percentile.value <= percentile.high


@given(sample=SAMPLES, shift=st.floats(-0.3, 2), seed=st.integers(0, 1000))
def test_they_move_with_the_sample_and_do_not_know_its_order(
    sample: list[float], shift: float, seed: int
) -> None:
    moved = np.random.default_rng(seed).permutation(np.array(sample) + shift)
    before, after = percentiles(sorted_values(sample)), percentiles(sorted_values(moved))
    expected = [None if p.value is None else p.value + shift for p in before]
    assert [p.value for p in after] == pytest.approx(expected, abs=1e-9)


@given(sample=SAMPLES, limit=st.floats(0, 5))
def test_a_share_counts_and_holds_itself(sample: list[float], limit: float) -> None:
    found = share_below(sorted_values(sample), limit)
    assert found is not None
    assert found.below == sum(value < limit for value in sample)
    assert 0 <= found.low <= found.share <= found.high <= 1


@given(sample=SAMPLES)
def test_cumulative_shares_climb_to_one(sample: list[float]) -> None:
    steps = ecdf(sorted_values(sample))
    assert steps is not None
    assert np.all(np.diff(steps.share) >= 0) and steps.share[-1] == pytest.approx(1)
    assert np.all(steps.low <= steps.share + 1e-12) and np.all(steps.share <= steps.high + 1e-12)
