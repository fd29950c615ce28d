"""Values against references: E_n by hand, the table by hand, and how often honest differences are within."""

from math import sqrt

import numpy as np
import pytest

from sightline.coverage import COVERAGE_95
from sightline.statistics.references import agreement, reference_errors

pytestmark = pytest.mark.once


def test_a_difference_is_held_against_both_uncertainties() -> None:
    found = agreement(19.0, 0.03, 19.44, 0.04)
    assert found.difference == pytest.approx(-0.44) and found.u_difference == pytest.approx(0.05)
    assert found.E_n == pytest.approx(-0.44 / (COVERAGE_95 * 0.05)) and not found.within
    assert agreement(19.0, 0.03, 19.097, 0.04).within and not agreement(19.0, 0.03, 19.099, 0.04).within


def test_the_table_is_that_of_the_differences() -> None:
    told = reference_errors([agreement(10.0 + apart, 0.1, 10.0, 0.1) for apart in (0.1, -0.1, 0.6)])
    assert told is not None
    assert (told.n, told.within) == (3, 2) and told.mean == pytest.approx(0.2)
    assert told.sd == pytest.approx(sqrt((0.01 + 0.09 + 0.16) / 2))
    assert told.rmse == pytest.approx(sqrt((0.01 + 0.01 + 0.36) / 3))
    # Clopper and Pearson's interval of 2 of 3
    assert told.share_low == pytest.approx(0.0943, abs=1e-4)
    assert told.share_high == pytest.approx(0.9916, abs=1e-4)
    alone = reference_errors([agreement(10.1, 0.1, 10.0, 0.1)])
    assert alone is not None and alone.sd is None and reference_errors([]) is None


def test_honest_uncertainties_keep_nineteen_in_twenty_within() -> None:
    rng = np.random.default_rng(14)
    ours, theirs = rng.normal(20.0, 0.03, 20_000), rng.normal(20.0, 0.2, 20_000)
    told = reference_errors([agreement(a, 0.03, b, 0.2) for a, b in zip(ours, theirs, strict=True)])
    assert told is not None and told.share_within == pytest.approx(0.95, abs=0.005)
    assert told.share_low < 0.95 < told.share_high
