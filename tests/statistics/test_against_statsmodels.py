"""The same estimates by statsmodels, where it has them: variance components, regression, bands, shares.

It is imported by the tests: half a second that a process which runs none of them need not spend.
"""

import numpy as np
import pytest

from sightline.messages.said import Said
from sightline.statistics.agreement import trend
from sightline.statistics.distributions import ecdf, share_below, sorted_values
from sightline.statistics.repeatability import gauge


def test_regression_and_its_band_are_those_of_least_squares() -> None:
    rng = np.random.default_rng(21)
    height = rng.normal(1.5, 0.12, 60)
    error = 0.01 - 0.05 * (height - 1.5) + rng.normal(0, 0.02, 60)
    found = trend(height, error)
    assert not isinstance(found, Said)
    import statsmodels.api as sm

    fit = sm.OLS(error, sm.add_constant(height)).fit()
    assert (found.intercept, found.slope) == pytest.approx(tuple(fit.params))
    assert (found.slope_ci95.low, found.slope_ci95.high) == pytest.approx(tuple(fit.conf_int()[1]))
    band = fit.get_prediction(sm.add_constant(found.at)).conf_int()
    assert np.allclose(np.column_stack([found.low, found.high]), band, atol=1e-12)


def test_cumulative_distribution_has_the_same_band() -> None:
    sample = np.random.default_rng(23).normal(1.2, 0.08, 80)
    found = ecdf(sorted_values(sample))
    assert found is not None
    from statsmodels.distributions.empirical_distribution import ECDF, _conf_set

    share = ECDF(sample)(found.value)
    low, high = _conf_set(share)
    assert np.allclose(found.share, share) and np.allclose(found.low, low) and np.allclose(found.high, high)


@pytest.mark.parametrize("limit", [1.05, 1.2, 1.5])
def test_shares_have_the_same_interval(limit: float) -> None:
    found = share_below(sorted_values(np.random.default_rng(24).normal(1.2, 0.08, 90)), limit)
    assert found is not None
    from statsmodels.stats.proportion import proportion_confint

    theirs = proportion_confint(found.below, found.n, alpha=0.05, method="beta")
    assert (found.low, found.high) == pytest.approx(theirs, abs=1e-12)


def test_variance_components_of_balanced_repeats_are_those_of_reml() -> None:
    """Every person repeats every item: the unbiased estimates are then those of restricted likelihood."""
    rng = np.random.default_rng(25)
    items, persons, times = 12, 8, 2
    item, person, _ = (part.ravel() for part in np.indices((items, persons, times)))
    leaning = rng.normal(0, 0.006, persons)
    value = rng.normal(1.4, 0.1, items)[item] + leaning[person] + rng.normal(0, 0.004, item.size)
    found = gauge(value, item, person)
    exog = (item[:, None] == np.arange(items)).astype(float)
    # in millimetres, for its optimiser knows no scale
    from statsmodels.regression.mixed_linear_model import MixedLM

    fit = MixedLM(1000 * value, exog, groups=person).fit(reml=True)
    assert found.repeatability.sd is not None and found.person_variance is not None
    assert 1000 * found.repeatability.sd == pytest.approx(np.sqrt(fit.scale), rel=1e-3)
    assert 1e6 * found.person_variance == pytest.approx(float(np.ravel(fit.cov_re)[0]), rel=1e-3)
