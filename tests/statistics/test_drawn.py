"""Figures of designed samples: of one place as those of a survey; intervals hold a nation's truth."""

import numpy as np
import pytest

from sightline.statistics.drawn import Drawn, lonely_strata, share_of
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.study_plan import Components, U95_of, plan, vehicles_needed
from sightline.statistics.survey_design import Design
from sightline.statistics.survey_weights import Margin
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty
from tests.bench.bench_nations import Nation, coverage


def sampled_sites(sites: int, each: int, seed: int = 5) -> tuple[HeightSample, Design]:
    rng = np.random.default_rng(seed)
    site = np.repeat(np.arange(sites), each)
    true = rng.normal(1.16, 0.06, sites * each) + rng.normal(0.0, 0.015, sites)[site]
    height = true + rng.normal(0.0, 0.005, sites)[site] + rng.normal(0.0, 0.01, sites * each)
    shared = (SharedErrors(site, np.full(len(site), 0.005)),)
    sample = HeightSample(height, np.full(len(site), 0.01), shared, site)
    design = Design(np.full(len(site), 3.0), np.zeros(len(site), np.int64), site, np.array([np.inf]))
    return sample, design


def test_a_weight_of_two_is_two_vehicles_of_one_height() -> None:
    sample, design = sampled_sites(10, 40)
    weight = np.where(np.arange(400) % 4 == 0, 2.0, 1.0)
    weighted = TotalUncertainty(sample, Design(weight, design.stratum, design.site, design.sites_there))
    twice = np.repeat(np.arange(400), weight.astype(int))
    plain = TotalUncertainty(sample.where(twice))
    assert weighted.mean().value == pytest.approx(plain.mean().value, abs=1e-12)
    assert weighted.percentile(10.0).raw == pytest.approx(plain.percentile(10.0).raw, abs=2e-3)


HALF = Nation((16,), (8,), 60)


@pytest.mark.parametrize(
    ("nation", "draws"),
    [
        pytest.param(HALF, 60, id="half of all sites"),
        pytest.param(HALF, 120, id="half of all sites, more often", marks=pytest.mark.proof),
        pytest.param(Nation((900, 300), (10, 8), 40), 120, id="two strata", marks=pytest.mark.proof),
    ],
)
def test_intervals_hold_the_truth_of_a_nation(nation: Nation, draws: int) -> None:
    """The bench does it for nine nations: 0.951 on the average of them."""
    held, _ = coverage(nation, draws, seed=3)
    assert 0.92 <= held[:6].mean() <= 0.985 and held[:6].min() >= 0.89


def test_all_sites_of_a_stratum_leave_sampling_within_them_alone() -> None:
    sample, design = sampled_sites(10, 40)
    all_seen = Design(design.weight, design.stratum, design.site, np.array([10.0]))
    few, every = TotalUncertainty(sample, design).mean(), TotalUncertainty(sample, all_seen).mean()
    assert every.U95_high is not None and few.U95_high is not None
    half = every.U95_high - every.value
    # sampling within sites and the sites' own poses are left: 61 mm / sqrt(400), 5 mm / sqrt(10)
    assert half == pytest.approx(1.96 * np.hypot(0.061 / 20.0, 0.005 / np.sqrt(10.0)), rel=0.05)
    assert half < 0.6 * (few.U95_high - few.value)


def held(design: Design, draws: int = 400) -> float:
    """The share of samples of normal heights around 3.5 m whose interval of the mean holds it."""
    rng, drawn = np.random.default_rng(11), Drawn(design)
    within = 0
    for _ in range(draws):
        height = rng.normal(3.5, 0.3, len(design.weight))
        mean = float(np.average(height, weights=design.weight))
        found = drawn.figure(mean, height - mean)
        assert found.U95_low is not None and found.U95_high is not None
        within += found.U95_low <= 3.5 <= found.U95_high
    return within / draws


@pytest.mark.parametrize(
    ("count", "part"),
    [((1, 20), (9.0, 1.0)), ((2, 20), (9.0, 1.0)), ((5, 60), (9.0, 1.0)), ((3, 60), (1.0, 1.0))],
)
@pytest.mark.parametrize("by_class", [False, True], ids=["all sites seen", "classes of a fleet"])
def test_few_heights_that_weigh_much_widen_the_interval(
    count: tuple[int, int], part: tuple[float, float], by_class: bool
) -> None:
    """Of a site, or of a class of the fleet, that is seen by one height or a few (before: 0.05 to 0.84)."""
    group = np.repeat([0, 1], count)
    weight = np.repeat(np.array(part) / np.array(count), count)
    one = np.zeros(len(group), np.int64)
    share = np.array(part) / sum(part)
    if by_class:
        design = Design(weight, one, one, np.array([1.0]), (Margin(group, share),), np.ones(len(group)))
    else:
        design = Design(weight, one, group, np.array([2.0]))
    assert 0.9 <= held(design) <= 0.99


@pytest.mark.parametrize("there", [6.0, 9.0, np.inf])
def test_sites_of_one_height_each_say_by_their_differences_how_far_heights_lie_apart(there: float) -> None:
    height, site = np.array([3.2, 4.0, 3.1, 3.9, 3.0, 4.1]), np.arange(6)
    design = Design(np.ones(6), np.zeros(6, np.int64), site, np.array([there]))
    found = TotalUncertainty(HeightSample(height, np.zeros(6)), design).mean()
    half = 2.571 * height.std(ddof=1) / np.sqrt(6.0)  # Student, 5 degrees of freedom
    assert found.U95_high is not None and found.U95_high - found.value == pytest.approx(half, rel=0.01)


def test_heights_that_are_each_all_of_their_class_have_no_interval() -> None:
    one = np.zeros(2, np.int64)
    margin = Margin(np.array([0, 1]), np.array([0.5, 0.5]))
    design = Design(np.ones(2), one, one, np.array([1.0]), (margin,), np.ones(2))
    figures = TotalUncertainty(HeightSample(np.array([3.2, 4.0]), np.zeros(2)), design)
    for found in (figures.mean(), share_of(Drawn(design), np.array([True, False]))):
        assert found.U95_low is found.U95_high is None and found.reason is not None


def test_random_errors_are_taken_out_as_heights_weigh() -> None:
    rng, n = np.random.default_rng(4), 4000
    weight, u_m = np.repeat([9.0, 1.0], n // 2), np.repeat([0.03, 0.006], n // 2)
    height = rng.normal(1.2, 0.05, n) + rng.normal(0.0, u_m)
    one = np.zeros(n, np.int64)
    for heavy in (weight, weight[::-1]):
        figures = TotalUncertainty(HeightSample(height, u_m), Design(heavy, one, one, np.array([np.inf])))
        sd, low = figures.sd(), figures.percentile(10.0)
        assert sd.U95_low is not None and sd.U95_high is not None and sd.U95_low < 0.05 < sd.U95_high
        assert low.U95_low is not None and low.U95_high is not None
        assert low.U95_low < 1.2 - 1.2816 * 0.05 < low.U95_high


def test_a_spread_of_few_unequal_weights_is_not_too_small() -> None:
    rng, weight, one = np.random.default_rng(1), np.repeat([9.0, 1.0], 5), np.zeros(10, np.int64)
    design = Design(weight, one, one, np.array([np.inf]))
    squares = [
        TotalUncertainty(HeightSample(rng.normal(1.5, 0.1, 10), np.zeros(10)), design).sd().value ** 2
        for _ in range(400)
    ]
    assert np.mean(squares) == pytest.approx(0.01, abs=3 * float(np.std(squares)) / 20.0)


def test_a_share_of_a_part_keeps_the_weights_of_the_whole() -> None:
    """Two sites of equal traffic, of whose 100 vehicles each 10 and 50 pass at night."""
    site, night = np.repeat([0, 1], 100), np.r_[np.arange(100) < 10, np.arange(100) < 50]
    chosen = np.r_[np.arange(100) < 9, np.arange(100) < 1]
    drawn = Drawn(Design(np.full(200, 10.0), np.zeros(200, np.int64), site, np.array([2.0])))
    found = share_of(drawn, chosen, night)
    assert found.value == pytest.approx(10 / 60)
    assert found.U95_low is not None and found.U95_high is not None
    assert 0.05 < found.U95_low < 10 / 60 < found.U95_high < 0.35


def test_a_share_that_the_weights_were_made_to_meet_is_known() -> None:
    site = np.repeat(np.arange(5), 20)
    chosen = np.arange(100) % 5 == 0
    free = Design(np.ones(100), np.zeros(100, np.int64), site, np.array([np.inf]))
    found = share_of(Drawn(free), chosen)
    assert found.value == pytest.approx(0.2)
    assert found.U95_low is not None and found.U95_high is not None
    assert 0.0 < found.U95_low < 0.2 < found.U95_high < 0.5


def test_a_stratum_of_one_site_is_lonely_unless_there_is_no_other() -> None:
    site = np.array([0, 0, 1, 1, 2, 2])
    stratum = np.array([0, 0, 0, 0, 1, 1])
    assert lonely_strata(Design(np.ones(6), stratum, site, np.array([np.inf, np.inf]))) == [1]
    assert lonely_strata(Design(np.ones(6), stratum, site, np.array([np.inf, 1.0]))) == []


def test_a_plan_s_interval_is_that_of_the_samples_it_plans() -> None:
    """Means of so many sites and vehicles, drawn: their spread is the plan's, Student's factor aside."""
    rng = np.random.default_rng(8)
    told = Components(sampling_m=0.06, between_m=0.02, common_m=0.0)
    drawn = rng.normal(0.0, 0.02, (20_000, 6)) + rng.normal(0.0, 0.06 / np.sqrt(25), (20_000, 6))
    half = 2.5706 * drawn.mean(axis=1).std()  # Student's t of 5 degrees of freedom
    assert U95_of(told, 6, 25) == pytest.approx(half, rel=0.02)
    finite = Components(0.06, 0.02, 0.003, sites_there=6.0)
    assert U95_of(finite, 6, 25) == pytest.approx(1.96 * np.hypot(0.06 / np.sqrt(150), 0.003), rel=1e-3)


def test_a_plan_is_the_least_that_meets_the_goal() -> None:
    told = Components(sampling_m=0.09, between_m=0.01)
    needed = vehicles_needed(told, 20, 0.010)
    assert needed is not None
    assert U95_of(told, 20, needed) <= 0.010 < U95_of(told, 20, needed - 1)
    assert vehicles_needed(told, 3, 0.010) is None  # sites alone differ by more
    assert plan(Components(0.09, 0.01, sites_there=8.0), (4, 8, 20), 0.02)[-1][0] == 8
