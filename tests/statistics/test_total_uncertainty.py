"""Total uncertainty against simulation and closed forms that share no code with it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import optimize, stats

from sightline.arrays import Ints
from sightline.messages.said import Said
from sightline.statistics.deconvolution import noise_of, smooth_density
from sightline.statistics.distributions import PERCENTILES, share_below
from sightline.statistics.drawn import Drawn
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.survey_design import Design
from sightline.statistics.total_uncertainty import (
    HeightSample,
    TotalUncertainty,
    difference,
    sample_of_measurements,
    total_figures,
)

P10 = 10.0


def test_no_share_below_a_higher_limit_is_smaller() -> None:
    """Of few heights a step and the error that is taken out of it may fall together."""
    limits = np.linspace(1.0, 1.3, 61)
    few = sample(9, 4, sites=1, shared_m=0.02, random_m=0.02)
    found = TotalUncertainty(few)
    plain = [found.share_below(float(limit)).value for limit in limits]
    assert plain != sorted(plain), "a sample that needs it"
    told = total_figures(few, [50.0], list(limits))
    assert told is not None
    for name in ("value", "U95_low", "U95_high"):
        parts = [getattr(one, name) for one in told.shares]
        assert parts == sorted(parts), name
    assert sorted(one.value for one in told.shares) == sorted(plain)


def test_a_height_on_a_limit_is_not_below_it() -> None:
    """As in the shares of the plain heights, for whole centimetres meet a standard's."""
    height_m = np.array([1.06, 1.08, 1.08, 1.10])
    told = total_figures(HeightSample(height_m, np.zeros(4)), [50.0], [1.08])
    plain = share_below(height_m, 1.08)
    assert told is not None and plain is not None and told.shares[0].value == plain.share == 0.25
    assert total_figures.__doc__ and "heights below it" in total_figures.__doc__


def sample(
    n: int, seed: int, *, sites: int = 1, shared_m: float = 0.0, random_m: float = 0.0, sd_m: float = 0.06
) -> HeightSample:
    """Normal heights at `sites`, each with an error of its own, and random errors."""
    rng = np.random.default_rng(seed)
    site = np.arange(n) % sites
    error = rng.normal(0, 1, sites)[site] * shared_m + rng.normal(0, 1, n) * random_m
    shared = (SharedErrors(site, np.full(n, shared_m)),) if shared_m else ()
    height = rng.normal(1.16, sd_m, n) + error
    return HeightSample(height, np.full(n, random_m), shared, site if sites > 1 else None)


def held(percent: float, runs: int, n: int, **world: float) -> float:
    """Share of samples whose interval of a percentile holds the truth."""
    truth = stats.norm.ppf(percent / 100, 1.16, 0.06)
    found = [
        TotalUncertainty(sample(n, seed, **world)).percentile(percent)  # type: ignore[arg-type]
        for seed in range(runs)
    ]
    return float(
        np.mean([one.U95_low <= truth <= one.U95_high for one in found if one.U95_low and one.U95_high])
    )


@pytest.mark.parametrize("runs", [30, pytest.param(60, marks=pytest.mark.proof)])
@pytest.mark.parametrize(
    "world",
    [
        {"sites": 1, "shared_m": 0.011, "random_m": 0.02},
        {"sites": 5, "shared_m": 0.011, "random_m": 0.02},
    ],
)
def test_intervals_hold_the_truth_where_sampling_alone_holds_it_seldom(
    world: dict[str, float], runs: int
) -> None:
    assert held(P10, runs, 200, **world) >= 0.95 - 3 * np.sqrt(0.05 * 0.95 / runs)
    truth = stats.norm.ppf(P10 / 100, 1.16, 0.06)
    plain = [
        TotalUncertainty(HeightSample(sample(200, s, **world).height_m, np.zeros(200))) for s in range(40)
    ]  # type: ignore[arg-type]
    alone = [one.percentile(P10) for one in plain]
    assert np.mean([bool(o.U95_low and o.U95_high and o.U95_low <= truth <= o.U95_high) for o in alone]) < 0.9


def test_random_error_is_taken_out_of_the_spread_as_for_a_normal_distribution() -> None:
    n, random_m = 40_000, 0.02
    found = TotalUncertainty(sample(n, 1, random_m=random_m))
    for percent in (2.5, 10.0, 50.0, 97.5):
        one = found.percentile(percent)
        z = float(stats.norm.ppf(percent / 100))
        assert one.value - one.raw == pytest.approx(z * (0.06 - np.hypot(0.06, random_m)), abs=0.0005)
    assert found.sd().value == pytest.approx(0.06, abs=0.001)


def test_two_kinds_of_vehicles_keep_their_shapes() -> None:
    rng = np.random.default_rng(2)
    n = 20_000
    true = np.where(rng.random(n) < 0.9, rng.normal(1.14, 0.05, n), rng.normal(2.3, 0.12, n))
    measured = true + rng.normal(0, 0.02, n)
    found = TotalUncertainty(HeightSample(measured, np.full(n, 0.02)))
    for percent in (2.5, 10.0, 50.0):
        value, raw = found.percentile(percent).value, float(np.quantile(measured, percent / 100))
        best = float(np.quantile(true, percent / 100))
        # one factor for all heights, the variance's, would move the 2.5th percentile 0.6 mm of the 7 needed
        assert abs(value - best) < max(0.35 * abs(raw - best), 0.0012)


def test_the_influence_of_a_height_on_the_correction_is_its_derivative() -> None:
    heights = np.sort(sample(400, 3, random_m=0.02).height_m)
    noise = noise_of(np.full(400, 0.02), 0.0)
    density = smooth_density(heights, noise)
    assert density is not None
    influence = density.correction_influence_m(0.1)[density.cell_of(heights)]
    assert abs(influence.mean()) < 0.05 * influence.std()
    scatter = influence.std() / np.sqrt(400)
    found = []
    for seed in range(60):
        again = smooth_density(np.sort(sample(400, 100 + seed, random_m=0.02).height_m), noise)
        assert again is not None
        found.append(again.correction_m(0.1))
    assert np.std(found) == pytest.approx(scatter, rel=0.6)


def test_balanced_sites_give_the_students_interval_of_their_means() -> None:
    heights = sample(600, 4, sites=6, shared_m=0.015)
    means = np.array([heights.height_m[heights.site == code].mean() for code in range(6)])
    expected = stats.t.interval(0.95, 5, means.mean(), stats.sem(means))
    found = TotalUncertainty(heights).mean()
    # draws in 4000 parts of the distribution: 0.2 % of the half width
    assert (found.U95_low, found.U95_high) == pytest.approx(expected, abs=4e-5)


def of_sites(site: Ints, *shared: SharedErrors) -> Drawn:
    """Heights (N,) that weigh alike, of some of many sites."""
    stratum = np.zeros(len(site), np.int64)
    return Drawn(Design(np.ones(len(site)), stratum, site, np.array([np.inf])), shared)


def test_shared_errors_within_sites_are_not_counted_twice_and_across_sites_are_counted() -> None:
    n, u = 600, 0.01
    site = np.arange(n) % 6
    influence = sample(n, 5).height_m - 1.16
    within = of_sites(site, SharedErrors(site, np.full(n, u))).sampled(influence)
    across = of_sites(site, SharedErrors(np.zeros(n, np.int64), np.full(n, u))).sampled(influence)
    assert within.unseen == pytest.approx(0.0, abs=1e-12)
    assert across.unseen == pytest.approx(u**2)
    assert within.freedom == pytest.approx(5.0) or within.freedom > 5.0


def test_sites_of_unequal_size_have_fewer_degrees_of_freedom() -> None:
    site = np.repeat([0, 1, 2, 3], [500, 40, 30, 30])
    influence = np.random.default_rng(6).normal(0, 1, 600) + np.array([0.0, 3.0, -3.0, 1.0])[site]
    assert of_sites(site).sampled(influence).freedom < 2.0


def test_a_share_moves_with_its_limit_and_holds_the_truth() -> None:
    found = TotalUncertainty(sample(800, 7, shared_m=0.008, random_m=0.015))
    shares = [found.share_below(limit) for limit in (1.0, 1.08, 1.16, 1.3)]
    assert [one.value for one in shares] == sorted(one.value for one in shares)
    for limit, one in zip((1.0, 1.08, 1.16, 1.3), shares, strict=True):
        assert one.U95_low is not None and one.U95_high is not None
        assert 0.0 <= one.U95_low <= one.value <= one.U95_high <= 1.0
        assert one.U95_low - 0.02 <= stats.norm.cdf(limit, 1.16, 0.06) <= one.U95_high + 0.02


def test_a_difference_of_two_surveys_has_the_uncertainty_of_both() -> None:
    first, second = (TotalUncertainty(sample(400, seed, shared_m=0.006)) for seed in (8, 9))
    moved = TotalUncertainty(HeightSample(sample(400, 9, shared_m=0.006).height_m + 0.1, np.zeros(400)))
    found = difference(first, second, P10)
    assert not isinstance(found, Said)
    one, other = first.percentile(P10), second.percentile(P10)
    assert found.value == pytest.approx(other.value - one.value)
    assert found.U95_low is not None and found.U95_high is not None
    halves = [(p.U95_high or 0) - (p.U95_low or 0) for p in (one, other)]
    assert found.U95_high - found.U95_low == pytest.approx(np.hypot(*halves), rel=0.05)
    apart = difference(first, moved, P10)
    assert not isinstance(apart, Said) and apart.U95_low is not None and apart.U95_low > 0.05


def test_what_is_too_small_says_so() -> None:
    few = TotalUncertainty(sample(30, 1))
    assert few.percentile(50.0).U95_low is not None
    outer = few.percentile(2.5)
    assert outer.value is None and outer.U95_low is None and outer.needs == 146
    assert str(outer.reason) == "P2.5 needs 146; there are 30"
    assert outer.raw == pytest.approx(float(np.quantile(sample(30, 1).height_m, 0.025)), abs=1e-12)
    same = TotalUncertainty(HeightSample(np.full(50, 1.2), np.zeros(50)))
    assert str(same.percentile(50.0).reason) == "the heights are all the same"
    assert TotalUncertainty(HeightSample(np.array([1.2]), np.zeros(1))).mean().U95_low is None


@pytest.mark.parametrize("sites", [1, 4])
@pytest.mark.parametrize("scatter_m", [0.0, 0.0001, 0.004])
def test_a_mean_is_no_surer_than_its_heights_and_a_spread_below_their_errors_has_a_reason(
    scatter_m: float, sites: int
) -> None:
    """40 heights of u = 10 mm each cannot tell a mean better than 10 mm / sqrt(40), 10 mm that all share not
    at all, and 10 mm of each of 4 poses by 10 mm / sqrt(4), however close together they lie.
    """
    height_m = 1.15 + scatter_m * np.random.default_rng(1).standard_normal(40)
    u_m, site = np.full(40, 0.01), np.arange(40) % sites
    own = HeightSample(height_m, u_m, (), site)
    shared = HeightSample(height_m, 0.0 * u_m, (SharedErrors(np.zeros(40, np.int64), u_m),), site)
    of_site = HeightSample(height_m, 0.0 * u_m, (SharedErrors(site, u_m),), site)
    for heights, groups in ((own, 40), (shared, 1), (of_site, sites)):
        found = TotalUncertainty(heights).mean()
        assert found.U95_low is not None and found.U95_high is not None
        assert found.U95_high - found.U95_low > 0.99 * 2 * 1.96 * 0.01 / np.sqrt(groups)
    total = TotalUncertainty(own)
    why = "lie closer together than their uncertainties allow" if scatter_m else "are all the same"
    for one in (total.sd(), total.percentile(50.0), total.share_below(1.15)):
        assert str(one.reason) == f"the heights {why}" and one.U95_low is one.U95_high is None
    assert total.sd().value is None and total.components(50.0) is None


def test_equal_heights_without_an_uncertainty_have_a_mean_and_no_interval() -> None:
    found = TotalUncertainty(HeightSample(np.full(40, 1.15), np.zeros(40))).mean()
    assert found.value == 1.15 and found.U95_low is None
    assert str(found.reason) == "the heights are all the same"


@settings(max_examples=25, deadline=None)
@given(
    n=st.integers(146, 250),
    seed=st.integers(0, 1000),
    shift=st.floats(-0.5, 2.0),
    random_m=st.floats(0.0, 0.03),
    sites=st.integers(1, 5),
)
def test_figures_move_with_the_heights_and_do_not_know_their_order(
    n: int, seed: int, shift: float, random_m: float, sites: int
) -> None:
    plain = sample(n, seed, sites=sites, shared_m=0.01, random_m=random_m)
    order = np.random.default_rng(seed).permutation(n)
    mixed = plain.where(order)
    moved = HeightSample(mixed.height_m + shift, mixed.u_random_m, mixed.shared, mixed.site)
    before, after = TotalUncertainty(plain), TotalUncertainty(moved)
    for percent in (2.5, 50.0):
        one, other = before.percentile(percent), after.percentile(percent)
        assert one.U95_low is not None and one.U95_high is not None
        assert one.U95_low <= one.value <= one.U95_high
        for name in ("value", "U95_low", "U95_high", "raw"):
            assert getattr(other, name) - shift == pytest.approx(getattr(one, name), abs=2e-4)
    assert after.sd().value == pytest.approx(before.sd().value, abs=1e-9)
    assert after.mean().value - shift == pytest.approx(before.mean().value, abs=1e-9)


def test_a_budget_is_divided_into_random_and_shared_parts() -> None:
    n = 90
    rng = np.random.default_rng(11)
    clicks, by_inset, by_pose = 0.007, 0.010, 0.005
    pose, inset = np.arange(n) % 2, np.arange(n) % 3
    found = sample_of_measurements(
        height_m=rng.normal(1.16, 0.06, n),
        u_height_m=np.full(n, np.sqrt(clicks**2 + by_inset**2 + by_pose**2)),
        u_clicks_m=np.full(n, clicks),
        u_by_inset_m=np.full(n, by_inset),
        pose=pose,
        inset=inset,
    )
    assert found.u_random_m == pytest.approx(np.full(n, np.sqrt(clicks**2 + by_inset**2 / 2)))
    of_pose, of_inset = found.shared
    assert of_pose.u_m == pytest.approx(np.full(n, by_pose))
    assert of_inset.u_m == pytest.approx(np.full(n, by_inset / np.sqrt(2)))
    # two poses and three insets of equal number: a half and a third of their variances are left in a mean
    assert of_pose.variance_of_mean_m2() == pytest.approx(by_pose**2 / 2, rel=0.03)
    assert of_inset.variance_of_mean_m2() == pytest.approx(by_inset**2 / 2 / 3, rel=0.06)
    unknown = sample_of_measurements(
        height_m=found.height_m,
        u_height_m=np.full(n, 0.012),
        u_clicks_m=np.full(n, np.nan),
        u_by_inset_m=np.full(n, np.nan),
        pose=pose,
        inset=inset,
    )
    assert [one.u_m[0] for one in unknown.shared] == [0.012] and not unknown.u_random_m.any()


@pytest.mark.parametrize("seeds", [20, pytest.param(60, marks=pytest.mark.proof)])
def test_percentiles_and_their_ends_never_run_backwards(seeds: int) -> None:
    """The demonstration's taillights had P97.5 below P95: a few heights far out, and much random error."""
    backwards = 0
    for seed in range(seeds):
        rng = np.random.default_rng(seed)
        height = rng.choice([0.70, 0.72, 0.90], 200, p=[0.5, 0.4, 0.1]) + rng.normal(0.0, 0.02, 200)
        found = TotalUncertainty(HeightSample(height, np.full(200, 0.02)))
        told = [found.percentile(one) for one in PERCENTILES]
        alone = [found._confidence(one / 100.0) for one in PERCENTILES if found._supported(one)]
        backwards += int(np.any(np.diff([one.value_m for one in alone]) < 0.0))
        for name in ("value", "U95_low", "U95_high"):
            values = [getattr(one, name) for one in told if one.value is not None]
            assert values == sorted(values), (seed, name)
        # a percentile that is not one of the named ones lies between its neighbours, and moves none of them
        between = found.percentile(96.0)
        assert found.percentile(95.0) == told[PERCENTILES.index(95.0)]
        assert told[PERCENTILES.index(95.0)].value <= between.value <= told[PERCENTILES.index(97.5)].value  # type: ignore[operator]
    assert backwards > 0  # else nothing was put in order


def test_a_percentile_between_two_kinds_of_vehicles_has_an_interval_and_moves_no_other() -> None:
    site = np.arange(100) % 20
    for seed in range(12):
        rng = np.random.default_rng(seed)
        height_m = np.where(np.arange(100) < 5, rng.normal(2.3, 0.12, 100), rng.normal(1.14, 0.05, 100))
        height_m += 0.015 * rng.normal(size=20)[site]
        shared = (SharedErrors(site, np.full(100, 0.015)),)
        found = TotalUncertainty(HeightSample(height_m, np.zeros(100), shared, site))
        low, high = found.percentile(5.0), found.percentile(95.0)
        assert low.U95_low is not None and high.U95_low is not None and high.U95_high is not None
        assert low.U95_low > 0.9 and 1.1 < high.U95_low < 1.3 and 2.0 < high.U95_high < 8.0
        outermost_car_m, first_lorry_m = np.sort(height_m)[94:96]
        assert high.value is not None and outermost_car_m - 0.03 < high.value < first_lorry_m + 0.03


@pytest.mark.parametrize("runs", [20, pytest.param(160, marks=pytest.mark.proof)])
def test_intervals_hold_a_percentile_that_lies_in_a_gap(runs: int) -> None:
    """5 % lorries, more at some sites than at others: P95 is where there is no vehicle."""
    truth = optimize.brentq(
        lambda x: 0.95 * stats.norm.cdf(x, 1.14, 0.05) + 0.05 * stats.norm.cdf(x, 2.3, 0.12) - 0.95, 1.1, 2.3
    )
    site, held = np.arange(2000) % 5, []
    for seed in range(runs):
        rng = np.random.default_rng([9521, seed])
        lorry = rng.random(2000) < rng.beta(5.9, 112.1, 5)[site]  # 5 % with an SD of 2 %
        height_m = np.where(lorry, rng.normal(2.3, 0.12, 2000), rng.normal(1.14, 0.05, 2000))
        found = TotalUncertainty(HeightSample(height_m, np.zeros(2000), (), site)).percentile(95.0)
        assert found.U95_low is not None and found.U95_high is not None
        held.append(found.U95_low <= truth <= found.U95_high)
    assert np.mean(held) >= 0.95 - 3.0 * np.sqrt(0.05 * 0.95 / runs)


def test_sites_that_differ_by_more_than_their_vehicles_leave_a_percentile_uncertain() -> None:
    """The highest heights come of one site alone: its own say little of what other sites might have."""
    site = np.repeat(np.arange(3), 200)
    within_m = np.random.default_rng(9522).normal(0.0, 0.004, 600)
    height_m = np.round(np.array([1.4, 1.5, 1.6])[site] + within_m, 2)
    found = TotalUncertainty(HeightSample(height_m, np.zeros(600), (), site)).percentile(95.0)
    assert found.U95_low is not None and found.value is not None and found.U95_high is not None
    assert found.U95_low < 1.55 and found.value == pytest.approx(1.6, abs=0.01) and found.U95_high > 1.65


def test_sites_that_differ_as_much_as_their_vehicles_are_said() -> None:
    """P95 of five such sites is held 0.8 times: docs/proofs.md."""
    said = "differ by more than half of what their vehicles do"
    for between_m, unlike in ((0.0, False), (0.02, False), (0.1, True)):
        alike = sample(600, 5, sites=5)
        assert alike.site is not None
        apart_m = between_m * np.array([-1.0, 0.5, 1.0, -0.7, 0.2])[alike.site]
        found = TotalUncertainty(replace(alike, height_m=alike.height_m + apart_m))
        assert (said in str(found.holds_in_words)) == unlike == found.sites_are_unlike
    assert not TotalUncertainty(sample(600, 5)).sites_are_unlike


def test_heights_that_weigh_nothing_leave_an_interval_of_numbers() -> None:
    for seed in range(20):
        rng = np.random.default_rng([9523, seed])
        height_m = np.sort(rng.normal(1.5, 0.07, 60))
        weight = np.where(np.arange(60) < 58, rng.uniform(0.5, 2.0, 60), 0.0)
        design = Design(weight, np.zeros(60, np.int64), np.arange(60) % 4, np.array([np.inf]))
        sample = HeightSample(height_m, np.zeros(60), (), np.arange(60) % 4)
        found = TotalUncertainty(sample, design).percentile(50.0)
        assert found.U95_low is not None and found.U95_high is not None
        assert 1.3 < found.U95_low < found.U95_high < 1.7


def test_the_same_design_said_as_weights_gives_the_same_digits() -> None:
    heights = sample(300, 3, sites=6, shared_m=0.01, random_m=0.015)
    assert heights.site is not None
    design = Design(np.full(300, 2.5), np.zeros(300, np.int64), heights.site, np.array([np.inf]))
    plain, designed = TotalUncertainty(heights), TotalUncertainty(heights, design)
    for percent in (2.5, 10.0, 50.0, 97.5):
        one, other = plain.percentile(percent), designed.percentile(percent)
        for name in ("value", "U95_low", "U95_high", "raw"):
            assert getattr(one, name) == pytest.approx(getattr(other, name), abs=1e-12)
