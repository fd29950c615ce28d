"""Figures of designed samples: of one place as those of a survey; intervals hold a nation's truth."""

import numpy as np
import pytest

from sightline.statistics.drawn import Drawn, lonely_strata, share_of
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.study_plan import Components, U95_of, plan, vehicles_needed
from sightline.statistics.survey_design import Design
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
