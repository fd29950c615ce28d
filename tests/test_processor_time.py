"""The budget in processor seconds grows with what a machine takes for the same work, and never shrinks."""

import pytest

from tests.support.processor_time import LOOP_S, over, scaled, slower_than_budgeted

BUDGET = {"export": 100.0, "media": 50.0}


def test_a_slower_machine_has_more_and_a_faster_one_no_less() -> None:
    assert slower_than_budgeted(LOOP_S / 2) == slower_than_budgeted(LOOP_S) == 1.0
    assert slower_than_budgeted(2.5 * LOOP_S) == pytest.approx(2.5)
    assert scaled(BUDGET, 2.5) == {"export": 250.0, "media": 125.0}


def test_who_is_over_is_told_by_the_machine_at_hand() -> None:
    took = {"export": 250.0, "media": 150.0, "unknown": 900.0}
    assert over(took, BUDGET) == ["export", "media"]
    assert over(took, scaled(BUDGET, 2.5)) == ["media"]
    assert over(took, scaled(BUDGET, 3.0)) == []
