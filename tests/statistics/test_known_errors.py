"""Errors against known heights: figures by hand, and the share inside the uncertainty of honest pairs."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.statistics.errors import error_table
from sightline.statistics.known_errors import (
    Compared,
    Inside,
    inside_uncertainty,
    known_errors,
    shown_groups,
)
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.total_uncertainty import HeightSample

heights = st.floats(0.3, 4.0)


def test_figures_of_three_lamps_by_hand() -> None:
    measured, known = np.array([0.71, 0.80, 0.93]), np.array([0.70, 0.82, 0.90])
    u = np.array([0.004, 0.02, 0.005])
    pose = SharedErrors(np.zeros(3, dtype=np.int64), np.full(3, 0.05))
    sample = HeightSample(measured, u, (pose,))
    lit, classes = ["daytime", "low_light", ""], ["van", "van", "saloon"]
    compared = Compared(sample, u, known, np.array([0.003, 0.001, np.nan]), lit, classes)
    found = known_errors("taillight", True, compared)
    assert (found.target, found.check_target) == ("taillight", True)
    overall = found.overall
    assert overall.n == 3
    assert overall.figures["bias_m"] == pytest.approx(0.02 / 3)
    assert overall.figures["mae_m"] == pytest.approx(0.06 / 3)
    assert [(one.grouping, one.group, one.errors.n) for one in found.groups] == [
        ("all", "all", 3),
        ("lighting", "daytime", 1),
        ("lighting", "low_light", 1),
        ("category", "saloon", 1),
        ("category", "van", 2),
    ]
    assert found.groups[-1].errors.figures["bias_m"] == pytest.approx((0.01 - 0.02) / 2)
    # the error of the pose, which all three share, is in the interval of the bias, and alone is 98 mm wide
    interval = overall.ci95["bias_m"]
    assert interval is not None and interval.high - interval.low > 2 * 1.96 * 0.05
    assert "errors that heights share" in str(overall.words) and "shared_errors" in overall.holds["bias_m"]
    assert overall.ci95["mae_m"] is None and "of MAE, RMSE and SD; 5 are needed" in str(overall.reason)
    # 10 mm is more than 1.96 x 5 mm = 9.8 mm; 20 mm is less than 1.96 x 20.02 mm; the third has no u
    assert isinstance(found.inside, Inside)
    assert (found.inside.inside, found.inside.n) == (1, 2)


def test_its_figures_are_those_of_the_error_table() -> None:
    rng = np.random.default_rng(7)
    known = rng.uniform(1.4, 1.9, 40)
    measured = known + rng.normal(0.01, 0.02, 40)
    lit, none = ["daytime", "low_light"] * 20, np.full(40, np.nan)
    for shared in ((), (SharedErrors(np.zeros(40, dtype=np.int64), np.full(40, 0.01)),)):
        sample = HeightSample(measured, np.full(40, 0.01), shared)
        found = known_errors("roof", False, Compared(sample, none, known, none, lit, ["suv"] * 40))
        table = error_table(measured, known, lit, "none", sample)
        for name, one in (("overall", found.overall), ("daytime", found.groups[1].errors)):
            assert set(one.figures) == {"bias_m", "mae_m", "rmse_m", "sd_m"}
            for figure, value in one.figures.items():
                assert (value, one.ci95[figure]) == (table[name].figures[figure], table[name].ci95[figure])
        # of one class alone, so a row for it would say nothing more
        assert [one.group for one in shown_groups(found.groups)] == ["all", "daytime", "low_light"]


def test_without_an_uncertainty_there_is_a_reason() -> None:
    found = inside_uncertainty([0.01], [0.01], [np.nan])
    assert str(found) == "no known height has an uncertainty to be compared with"


def test_honest_uncertainties_hold_95_percent() -> None:
    rng = np.random.default_rng(12)
    u, u_known = rng.uniform(0.002, 0.03, 20_000), rng.uniform(0.0, 0.02, 20_000)
    error = rng.normal(0.0, u) - rng.normal(0.0, u_known)
    found = inside_uncertainty(error, u, u_known)
    assert isinstance(found, Inside)
    assert found.low < 0.95 < found.high
    halved = inside_uncertainty(error, u / 2, u_known / 2)
    assert isinstance(halved, Inside) and halved.high < 0.7


@given(st.lists(st.tuples(heights, heights, st.floats(0.0, 0.1)), min_size=1, max_size=30))
def test_order_does_not_matter_and_wider_u_never_holds_less(rows: list[tuple[float, float, float]]) -> None:
    measured, known, u = (np.array(column) for column in zip(*rows, strict=True))
    found = inside_uncertainty(measured - known, u, u)
    back = inside_uncertainty((measured - known)[::-1], u[::-1], u[::-1])
    wider = inside_uncertainty(measured - known, 2 * u, u)
    assert isinstance(found, Inside) and isinstance(wider, Inside)
    assert found == back
    assert wider.inside >= found.inside
