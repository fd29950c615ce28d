"""Total intervals of the error table: what heights share counts in every figure, not in the bias alone."""

from __future__ import annotations

import numpy as np
import pytest

from sightline.statistics.error_totals import ErrorTotals
from sightline.statistics.errors import error_group, error_table
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.total_uncertainty import HeightSample

AMOUNTS = ("bias_m", "mae_m", "rmse_m", "mse_m2", "sd_m", "share_within_20_mm")


def drawn(rng: np.random.Generator, n: int, sites: int, shared_m: float, own_m: float) -> HeightSample:
    """Errors (N,), those of a site shared."""
    site = np.arange(n) % sites
    error = rng.normal(0.0, shared_m, sites)[site] + rng.normal(0.0, own_m, n)
    shared = (SharedErrors(site, np.full(n, shared_m)),) if shared_m else ()
    return HeightSample(error, np.zeros(n), shared, site if sites > 1 else None)


@pytest.mark.parametrize(("sites", "shared_m", "own_m"), [(1, 0.015, 0.010), (5, 0.015, 0.010)])
def test_they_hold_what_other_poses_would_give(sites: int, shared_m: float, own_m: float) -> None:
    """160 surveys of 200 vehicles; intervals of sampling alone hold what such surveys have far too seldom."""
    rng = np.random.default_rng(66)
    whole_m = float(np.hypot(shared_m, own_m))
    truth = {"rmse_m": whole_m, "mae_m": whole_m * float(np.sqrt(2.0 / np.pi))}
    held = {(name, total): 0 for name in truth for total in (True, False)}
    for _ in range(160):
        sample = drawn(rng, 200, sites, shared_m, own_m)
        totals = ErrorTotals(sample.height_m, sample.shared, sample.site)
        alone = ErrorTotals(sample.height_m)
        for total, one in ((True, totals), (False, alone)):
            (low, high), mae = np.sqrt(one.mse()), one.mae()
            held["rmse_m", total] += low <= truth["rmse_m"] <= high
            held["mae_m", total] += mae.low <= truth["mae_m"] <= mae.high
    for name in truth:
        assert held[name, True] / 160 == pytest.approx(0.95, abs=0.04), held
        assert held[name, False] / 160 < 0.75, held


def test_an_error_of_all_moves_the_mean_and_not_the_spread() -> None:
    sample = drawn(np.random.default_rng(3), 400, 1, 0.012, 0.010)
    shared, alone = (ErrorTotals(sample.height_m, of) for of in (sample.shared, ()))
    assert shared.sd() == pytest.approx(alone.sd(), rel=1e-12)
    assert shared.mse().high > 2.0 * alone.mse().high
    assert shared.share_within(0.02).low < alone.share_within(0.02).low - 0.1


@pytest.mark.parametrize("sites", [1, 2, 20])
def test_each_holds_its_value_and_does_not_narrow(sites: int) -> None:
    rng = np.random.default_rng(11)
    reference = rng.normal(1.45, 0.08, 120)
    for shared_m in (0.0, 0.005, 0.015):
        sample = drawn(rng, 120, sites, shared_m, 0.012)
        group = error_group(sample.height_m, reference, sample)
        for name in AMOUNTS:
            value, interval = group.figures[name], group.ci95[name]
            assert value is not None and interval is not None
            assert interval.low <= value <= interval.high, (name, shared_m)
        assert group.ci95["share_within_20_mm"].high <= 1.0  # type: ignore[union-attr]


def test_no_errors_in_common_are_intervals_of_sampling() -> None:
    rng = np.random.default_rng(5)
    error, reference = rng.normal(0.0, 0.02, 80), rng.normal(1.45, 0.08, 80)
    plain = error_group(error, reference)
    assert error_group(error, reference, HeightSample(error, np.zeros(80))).ci95 == plain.ci95
    assert plain.holds["mae_m"] == ("sampling", "random_error", "known_heights")


def test_each_says_what_it_holds() -> None:
    sample = drawn(np.random.default_rng(8), 60, 3, 0.01, 0.01)
    known = np.full(60, 1.4) + np.arange(60) / 1000
    lighting = ["daytime"] * 40 + [""] * 20
    table = error_table(known + sample.height_m, known, lighting, "none", sample)
    whole = table["overall"]
    assert whole.holds["rmse_m"] == ("sampling", "sites", "shared_errors", "random_error", "known_heights")
    assert whole.holds["pearson_error_vs_height"] == ("sampling", "random_error", "known_heights")
    assert str(whole.words) == (
        "sampling, differences between 3 sites, errors that heights share, random errors of heights and "
        "errors of the known heights (both left in the values); they apply to roads like those of these sites"
    )
    assert table["daytime"].n == 40 and "sites" in table["daytime"].holds["bias_m"]
    assert table["low_light"].words is None and table["low_light"].holds == {}


def test_many_cells_of_a_study_take_no_time() -> None:
    """Weighted, a pose for each of 400 sites."""
    rng = np.random.default_rng(2)
    site = np.arange(8000) % 400
    error = rng.normal(0.0, 0.008, 400)[site] + rng.normal(0.0, 0.015, 8000)
    shared = (SharedErrors(site, np.full(8000, 0.008)),)
    totals = ErrorTotals(error, shared, site, np.where(site < 200, 1.0, 3.0))
    low, high = np.sqrt(totals.mse())
    assert low < 0.017 < high < 0.0185
    low, high = totals.sd()
    assert low < 0.017 < high


def test_how_groups_are_numbered_and_rows_are_ordered_changes_nothing() -> None:
    rng = np.random.default_rng(3)
    group, site = np.repeat(np.arange(6), [10, 20, 15, 25, 20, 30]), rng.integers(0, 3, 120)
    error = rng.normal(0.0, 0.012, 120) + rng.normal(0.0, 0.008, 6)[group]
    seen = []
    for numbered, order in ((np.arange(6), np.arange(120)), (rng.permutation(6), rng.permutation(120))):
        shared = (SharedErrors(numbered[group][order], np.full(120, 0.008)),)
        totals = ErrorTotals(error[order], shared, (site[order] + 1) % 3)
        seen.append([*totals.mae(), *totals.mse(), *totals.sd(), *totals.share_within(0.01)])
    assert seen[1] == pytest.approx(seen[0], rel=1e-9)


@pytest.mark.parametrize("of_third", [0, 2], ids=["one_inset_holds_two_poses", "an_inset_each"])
def test_poses_of_equal_errors_may_be_numbered_either_way(of_third: int) -> None:
    """Two poses whose errors are alike, with an inset each; the third moves with one, or none."""
    error = np.random.default_rng(5).normal(0.0, 0.01, 20)
    errors, pose = np.concatenate([error, error, 1.5 * error + 0.004]), np.repeat([0, 1, 2], 20)
    inset = SharedErrors(np.repeat([0, 1, of_third], 20), np.full(60, 0.006))
    seen = []
    for numbered in ([0, 1, 2], [1, 0, 2]):
        totals = ErrorTotals(errors, (SharedErrors(np.array(numbered)[pose], np.full(60, 0.008)), inset))
        seen.append([*totals.mae(), *totals.mse(), *totals.sd(), *totals.share_within(0.01)])
    assert seen[1] == pytest.approx(seen[0], rel=1e-9)


def test_rows_that_share_nothing_are_as_if_no_others_did() -> None:
    """Low light has a pose that is told, daytime has none."""
    rng = np.random.default_rng(4)
    error, reference = rng.normal(0.0, 0.012, 40), rng.uniform(1.4, 1.8, 40)
    measured, lighting = reference + error, ["daytime"] * 20 + ["low_light"] * 20
    group = np.repeat([-1, 0], 20)
    shared = (SharedErrors(group, np.where(group < 0, 0.0, 0.01)),)
    sample = HeightSample(measured, np.full(40, 0.01), shared)
    found = error_table(measured, reference, lighting, "none", sample)
    alone = error_table(measured[:20], reference[:20], lighting[:20], "none")
    assert found["daytime"] == alone["daytime"]
    assert "shared_errors" in found["low_light"].holds["mae_m"]
