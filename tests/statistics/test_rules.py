"""A standard's rule on heights of a known fleet: what the verdict says, and how often it is wrong."""

from __future__ import annotations

import numpy as np
import pytest
from scipy import stats

from sightline.statistics.rules import MOST_RISK, rule_today
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.standards import Standard
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty

TRUE_P10 = float(stats.norm.ppf(0.1, 1.16, 0.06))


def standard(height_m: float, percent: float | None = 10.0) -> Standard:
    return Standard(name="A road", what="eye_car", height_m=height_m, source="own", percent=percent)


def sample(seed: int, n: int = 300) -> HeightSample:
    rng = np.random.default_rng(seed)
    error = rng.normal(0.0, 0.008) + rng.normal(0.0, 0.012, n)
    shared = SharedErrors(np.zeros(n, np.int64), np.full(n, 0.008))
    return HeightSample(rng.normal(1.16, 0.06, n) + error, np.full(n, 0.012), (shared,))


@pytest.mark.parametrize(("away_m", "verdict"), [(0.08, "lower"), (-0.08, "higher")])
def test_what_lies_far_apart_is_told_apart(away_m: float, verdict: str) -> None:
    found = rule_today(standard(TRUE_P10 + away_m), TotalUncertainty(sample(1)), by_class=True)
    assert found is not None and found.verdict == verdict
    assert found.risk is not None and found.risk < 0.001
    assert found.difference_m == pytest.approx(-away_m, abs=0.03)


@pytest.mark.parametrize("runs", [40, pytest.param(80, marks=pytest.mark.proof)])
def test_a_standard_that_is_right_is_seldom_called_wrong(runs: int) -> None:
    told = [
        rule_today(standard(TRUE_P10), TotalUncertainty(sample(seed)), by_class=True) for seed in range(runs)
    ]
    wrong = sum(one is not None and one.verdict != "alike" for one in told)
    # either verdict with a risk of 2.5 %
    assert wrong <= stats.binom.ppf(0.999, runs, 2 * MOST_RISK)
    lower = [one.lower for one in told if one is not None and one.lower is not None]
    assert len(lower) == runs and 0.4 < np.mean(lower) < 0.6


def test_the_verdict_agrees_with_the_interval() -> None:
    found = rule_today(standard(TRUE_P10), TotalUncertainty(sample(3)), by_class=True)
    assert found is not None and found.U95_low_m is not None
    at_the_end = rule_today(standard(found.U95_low_m), TotalUncertainty(sample(3)), by_class=True)
    assert at_the_end is not None and at_the_end.lower == pytest.approx(MOST_RISK, abs=0.001)


def test_no_rule_no_row_and_few_heights_no_verdict() -> None:
    assert rule_today(standard(1.08, None), TotalUncertainty(sample(1)), by_class=True) is None
    few = rule_today(standard(1.08, 2.5), TotalUncertainty(sample(1, 20)), by_class=False)
    assert few is not None and few.verdict == "unknown" and few.lower is None
    assert few.value_m is None and str(few.reason) == "P2.5 needs 146; there are 20"
    none = rule_today(standard(1.08), None, by_class=True)
    assert none is not None and none.verdict == "unknown" and none.value_m is None
