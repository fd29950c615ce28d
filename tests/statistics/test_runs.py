"""Runs of one car: the chi-square's rate of false alarms by simulation, and what all runs share."""

from math import sqrt

import numpy as np
import pytest

from sightline.statistics.runs import Run, runs_together

pytestmark = pytest.mark.once


def test_runs_without_anything_shared_have_the_weighted_mean() -> None:
    told = runs_together([Run(4.63, 0.01), Run(4.60, 0.02), Run(4.65, 0.02)])
    assert told is not None
    weight = np.array([1e4, 2500.0, 2500.0])
    mean = float(weight @ [4.63, 4.60, 4.65] / weight.sum())
    assert told.mean == pytest.approx(mean) and told.u_mean == pytest.approx(1 / sqrt(15000))
    assert told.chi_square == pytest.approx(float(weight @ (np.array([4.63, 4.60, 4.65]) - mean) ** 2))
    assert (told.degrees, told.verdict) == (2, "agree") and told.sd == pytest.approx(0.02517, abs=1e-5)


def test_an_error_that_all_runs_share_moves_the_mean_and_spreads_nothing() -> None:
    apart = [Run(4.63, 0.01, (0.05,), "rig"), Run(4.64, 0.01, (0.05,), "rig")]
    together, alone = runs_together(apart), runs_together([Run(one.value, one.u_own) for one in apart])
    assert together is not None and alone is not None
    assert together.chi_square == pytest.approx(alone.chi_square) == pytest.approx(0.5)
    assert together.u_mean == pytest.approx(sqrt(0.05**2 + 0.01**2 / 2))
    other = runs_together([Run(4.63, 0.01, (0.05,), "rig"), Run(4.64, 0.01, (0.05,), "another")])
    assert other is not None and other.chi_square == pytest.approx(1e-4 / (2 * (0.01**2 + 0.05**2)))


def test_one_run_tells_nothing_of_agreement() -> None:
    told = runs_together([Run(4.6, 0.01)])
    assert told is not None and (told.verdict, told.chi_square, told.p, told.sd) == (
        "too_few",
        None,
        None,
        None,
    )
    assert runs_together([]) is None


def test_one_in_twenty_is_called_so_by_chance_and_wrong_uncertainties_are_found() -> None:
    rng = np.random.default_rng(15)
    verdicts = {"agree": 0, "too_far_apart": 0, "too_alike": 0, "too_few": 0}
    found = dict.fromkeys((0.3, 3.0), "")
    for _ in range(4000):
        rigs = rng.normal(0.0, 0.02, 2)
        runs = [Run(4.39 + rigs[k % 2] + rng.normal(0, 0.008), 0.008, (0.02,), k % 2) for k in range(6)]
        told = runs_together(runs)
        assert told is not None
        verdicts[told.verdict] += 1
    assert verdicts["too_far_apart"] / 4000 == pytest.approx(0.025, abs=0.008)
    assert verdicts["too_alike"] / 4000 == pytest.approx(0.025, abs=0.008)
    for factor in found:
        runs = [Run(4.39 + rng.normal(0, 0.008 * factor), 0.008) for _ in range(20)]
        told = runs_together(runs)
        assert told is not None
        found[factor] = told.verdict
    assert found == {0.3: "too_alike", 3.0: "too_far_apart"}
