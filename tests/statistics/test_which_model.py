"""Models ranked by what was measured, and those that cannot be it."""

import numpy as np
import pytest
from scipy.stats import norm

from sightline.statistics.which_model import CANNOT_FIT_P, ModelFits, fit_models

NAN = float("nan")
U = [0.02, 0.03]


def fit(measured: list[float], sizes: list[list[float]], same: list[float] | None = None) -> ModelFits:
    found = fit_models(measured, U, sizes, np.zeros_like(sizes), same)
    assert isinstance(found, ModelFits)
    return found


def test_the_nearest_in_units_of_u_comes_first_and_what_strays_cannot_fit() -> None:
    found = fit([1.46, 2.60], [[1.60, 2.60], [1.46, 2.66], [1.47, 2.61]])
    assert found.order == (2, 1, 0)
    assert found.chi_square == pytest.approx([49.0, 4.0, 0.25 + 1 / 9])
    assert list(found.cannot) == [True, False, False]
    one = 2 * norm.sf(2.0)
    assert found.p[1] == pytest.approx(1 - (1 - one) ** 2)


def test_what_was_not_measured_or_is_not_stated_is_left_out() -> None:
    found = fit([1.46, NAN], [[1.46, 9.0], [NAN, 2.6]])
    assert found.order == (0,) and list(found.compared) == [1.0, 0.0]
    assert np.isnan(found.p[1]) and not found.cannot[1]


def test_a_size_that_is_not_stated_is_no_merit() -> None:
    found = fit([1.46, 2.60], [[1.46, NAN], [1.46, 2.60], [1.70, 3.00], [1.60, 2.40]])
    assert found.order[0] == 1


def test_the_class_decides_between_equals_and_does_not_make_a_misfit_fit() -> None:
    found = fit([1.46, 2.60], [[1.46, 2.60], [1.46, 2.60], [1.90, 2.60]], [0.0, 1.0, 1.0])
    assert found.order == (1, 0, 2) and found.cannot[2]


def test_a_size_that_does_not_rank_strikes_out_and_moves_nobody() -> None:
    sizes = [[1.50, 2.66], [1.46, 2.62], [1.70, 2.60]]
    found = fit_models([1.46, 2.60], U, sizes, np.zeros((3, 2)), ranking=[False, True])
    assert isinstance(found, ModelFits)
    assert found.order == (2, 1, 0) and list(found.cannot) == [False, False, True]
    assert list(found.ranks) == [False, True]
    alone = fit_models([1.46, NAN], U, sizes, np.zeros((3, 2)), ranking=[False, True])
    assert isinstance(alone, ModelFits)
    assert alone.order == (0, 1, 2) and list(alone.ranks) == [False, False]


def test_nothing_to_compare_is_a_reason() -> None:
    assert "measured on this vehicle yet" in str(fit_models([NAN], [NAN], [[1.4]], [[0.0]]))
    assert "No model in the catalogue" in str(fit_models([1.4], [0.02], [[NAN]], [[0.0]]))


@pytest.mark.parametrize("common", [0.0, 1.0])
def test_the_right_model_is_rarely_said_not_to_fit_whatever_errors_are_shared(common: float) -> None:
    rng = np.random.default_rng(5)
    flagged = 0
    for _ in range(4000):
        shared = common * rng.normal(0.0, 1.0)
        errors = np.where(common > 0, shared, rng.normal(0.0, 1.0, 2)) * U
        flagged += int(fit(list(np.array([1.46, 2.6]) + errors), [[1.46, 2.6]]).cannot[0])
    assert flagged / 4000 <= 2.5 * CANNOT_FIT_P
