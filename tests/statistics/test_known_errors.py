"""Errors against known heights: figures by hand, and the share inside the uncertainty of honest pairs."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.statistics.known_errors import Compared, Inside, inside_uncertainty, known_errors
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.total_uncertainty import HeightSample

heights = st.floats(0.3, 4.0)


def test_figures_of_three_lamps_by_hand() -> None:
    measured, known = np.array([0.71, 0.80, 0.93]), np.array([0.70, 0.82, 0.90])
    u = np.array([0.004, 0.02, 0.005])
    pose = SharedErrors(np.zeros(3, dtype=np.int64), np.full(3, 0.05))
    sample = HeightSample(measured, u, (pose,))
    compared = Compared(sample, u, known, np.array([0.003, 0.001, np.nan]), ["daytime", "low_light", ""])
    found = known_errors("taillight", True, compared, "none")
    assert (found.target, found.check_target) == ("taillight", True)
    overall = found.groups["overall"]
    assert overall.n == 3
    assert overall.figures["bias_m"] == pytest.approx(0.02 / 3)
    assert overall.figures["mae_m"] == pytest.approx(0.06 / 3)
    assert (found.groups["daytime"].n, found.groups["low_light"].n) == (1, 1)
    # the error of the pose, which all three share, is in the interval of the bias, and alone is 98 mm wide
    assert found.bias.value == pytest.approx(0.02 / 3)
    assert found.bias.U95_low is not None and found.bias.U95_high is not None
    assert found.bias.U95_high - found.bias.U95_low > 2 * 1.96 * 0.05
    assert "errors that heights share" in found.words
    # 10 mm is more than 1.96 x 5 mm = 9.8 mm; 20 mm is less than 1.96 x 20.02 mm; the third has no u
    assert isinstance(found.inside, Inside)
    assert (found.inside.inside, found.inside.n) == (1, 2)


def test_without_an_uncertainty_there_is_a_reason() -> None:
    found = inside_uncertainty([0.01], [0.01], [np.nan])
    assert found == "no known height has an uncertainty to be compared with"


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
