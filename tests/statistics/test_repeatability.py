"""Gauge R&R: closed forms of balanced data, unbiased and covering in simulation, reasons for too few."""

import numpy as np
import pytest
from scipy import stats

from sightline.statistics.repeatability import Codes, codes_of, gauge, uncertainty_check, within_cells


def balanced(items: int, persons: int, repeats: int, seed: int) -> tuple[np.ndarray, Codes, Codes]:
    rng = np.random.default_rng(seed)
    shape = (items, persons, repeats)
    leaning = rng.normal(0, 0.006, (1, persons, 1))
    y = 1.2 + rng.normal(0, 0.2, (items, 1, 1)) + leaning + rng.normal(0, 0.004, shape)
    item, person, _ = (part.ravel() for part in np.indices(shape))
    return y.ravel(), item.astype(np.intp), person.astype(np.intp)


def test_balanced_data_give_the_anova_of_the_textbook() -> None:
    """Two-way crossed design without interaction: MS_person and MS_error from the sums of squares."""
    items, persons, repeats = 8, 3, 2
    y, item, person = balanced(items, persons, repeats, 1)
    found = gauge(y, item, person)
    cube = y.reshape(items, persons, repeats)
    grand = cube.mean()
    ss_items = persons * repeats * np.square(cube.mean(axis=(1, 2)) - grand).sum()
    ss_persons = items * repeats * np.square(cube.mean(axis=(0, 2)) - grand).sum()
    ss_error = np.square(cube - grand).sum() - ss_items - ss_persons
    freedom = items * persons * repeats - items - persons + 1
    ms_error = ss_error / freedom
    assert found.repeatability.freedom == freedom and found.reproducibility.freedom == persons - 1
    assert found.repeatability.sd == pytest.approx(np.sqrt(ms_error), rel=1e-9)
    expected = (ss_persons / (persons - 1) - ms_error) / (items * repeats)
    assert found.person_variance == pytest.approx(expected, rel=1e-9)
    low = np.sqrt(ss_error / stats.chi2.ppf(0.975, freedom))
    assert found.repeatability.low == pytest.approx(low, rel=1e-9)
    assert (found.n, found.items, found.persons) == (48, 8, 3)
    assert found.interaction_p is not None and found.interaction_p > 0.001


def test_the_order_of_rows_and_single_values_change_nothing() -> None:
    y, item, person = balanced(9, 3, 2, 2)
    keep = np.random.default_rng(3).permutation(len(y))[:40]
    before = gauge(y[keep], item[keep], person[keep])
    more = np.append(y[keep], 1.7), np.append(item[keep], 99), np.append(person[keep], 0)
    after = gauge(*more)
    assert after.repeatability.sd == pytest.approx(before.repeatability.sd, rel=1e-9)
    assert after.reproducibility.high == pytest.approx(before.reproducibility.high, rel=1e-6)


@pytest.mark.parametrize(
    ("persons", "items", "s_person"),
    [
        (2, 20, 0.004),
        *(pytest.param(*one, marks=pytest.mark.proof) for one in ((4, 14, 0.002), (3, 16, 0.02))),
    ],
)
def test_unbalanced_data_unbiased_and_the_intervals_cover(persons: int, items: int, s_person: float) -> None:
    s_click, sims = 0.005, 600
    rng = np.random.default_rng(persons)
    item = np.repeat(np.arange(items), rng.integers(2, 5, items)).astype(np.intp)
    person = rng.integers(0, persons, len(item)).astype(np.intp)
    covered = np.zeros(2)
    variances = np.empty((sims, 2))
    for row in range(sims):
        y = rng.normal(1.3, 0.2, items)[item] + rng.normal(0, s_person, persons)[person]
        found = gauge(y + rng.normal(0, s_click, len(item)), item, person)
        same, between = found.repeatability, found.reproducibility
        assert same.sd and same.low and same.high
        told = between.low is not None and between.high is not None
        covered[0] += same.low <= s_click <= same.high
        covered[1] += told and between.low <= s_person <= between.high
        variances[row] = same.sd**2, found.person_variance
    off = variances.mean(axis=0) - np.square([s_click, s_person])
    assert (np.abs(off) < 3 * variances.std(axis=0) / np.sqrt(sims)).all()
    # 600 trials know a share of 0.95 to 0.009 (1 sd).
    assert (np.abs(covered / sims - 0.95) < 0.02).all(), covered / sims


def test_persons_who_lean_differently_from_item_to_item_are_told() -> None:
    rng = np.random.default_rng(5)
    shape = (12, 2, 2)
    y = rng.normal(0, 0.02, (12, 2, 1)) + rng.normal(0, 0.002, shape)
    item, person, _ = (part.ravel().astype(np.intp) for part in np.indices(shape))
    found = gauge(y.ravel(), item, person)
    assert found.interaction_p is not None and found.interaction_p < 1e-6


def test_too_few_repeats_have_a_reason_and_no_number() -> None:
    nothing = gauge([], codes_of([]), codes_of([]))
    assert nothing.repeatability.reason and nothing.repeatability.sd is None
    three = gauge([1.0, 1.1, 1.2, 1.25, 1.3, 1.31], codes_of("aabbcc"), codes_of("xyxyxy"))
    assert three.repeatability.sd is None and "Too few" in str(three.repeatability.reason)
    y, item, _ = balanced(9, 1, 2, 4)
    alone = gauge(y, item, np.zeros(len(y), dtype=np.intp))
    assert alone.repeatability.sd is not None and alone.reproducibility.sd is None
    assert "another operator" in str(alone.reproducibility.reason)
    few = gauge([1.0, 1.1, 1.2, 1.25], codes_of("aabb"), codes_of("xxxx"))
    assert "Too few" in str(few.repeatability.reason) and "another operator" in str(
        few.reproducibility.reason
    )


def test_clicks_of_two_coordinates_pool_within_their_cells() -> None:
    rng = np.random.default_rng(6)
    cells = np.repeat(np.arange(400), 2).astype(np.intp)
    clicks = rng.uniform(0, 600, (400, 2)).repeat(2, axis=0) + rng.normal(0, 0.6, (800, 2))
    total, freedom = within_cells(clicks, cells)
    assert freedom == 800
    assert np.sqrt(total / freedom) == pytest.approx(0.6, abs=3 * 0.6 / np.sqrt(2 * freedom))
    differences = clicks[::2] - clicks[1::2]
    assert total / freedom == pytest.approx(np.square(differences).mean() / 2, rel=1e-9)
    assert within_cells(np.zeros((0, 2)), codes_of([])) == (0.0, 0)


def test_budgets_are_compared_with_what_repeats_show() -> None:
    rng = np.random.default_rng(7)
    item = np.repeat(np.arange(300), 2).astype(np.intp)
    u = rng.uniform(0.003, 0.012, 300).repeat(2)
    common = rng.normal(1.2, 0.3, 300).repeat(2)  # true height, lens, pose: the same for both
    honest = uncertainty_check(common + rng.normal(0, 1, 600) * u, u, item)
    assert honest.low is not None and honest.high is not None and honest.low < 1 < honest.high
    assert honest.freedom == 300
    worse = uncertainty_check(common + 1.6 * rng.normal(0, 1, 600) * u, u, item)
    assert worse.ratio == pytest.approx(1.6, rel=0.1) and worse.low is not None and worse.low > 1
    assert uncertainty_check([1.0, 1.1], [0.01, 0.01], codes_of("aa")).reason


def test_what_is_called_observed_is_the_scatter_of_the_values() -> None:
    rng = np.random.default_rng(5)
    sure, unsure = np.repeat([[0.001, 0.010], [0.005, 0.010]], 400, axis=1)  # claimed, real
    item = np.repeat(np.arange(400), 2)
    found = uncertainty_check(1.5 + rng.normal(0, 1, 800) * unsure, sure, item)
    assert found.observed == pytest.approx(np.sqrt(np.mean(unsure**2)), rel=0.1)
    assert found.ratio == pytest.approx(np.sqrt(np.mean((unsure / sure) ** 2)), rel=0.1)
