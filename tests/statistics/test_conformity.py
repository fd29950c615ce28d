"""Decisions with guard bands: false no more often than the stated risk, and the same in the mirror."""

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sightline.errors import BadInput
from sightline.statistics.conformity import LEAST_RISK, MOST_RISK, decide

VALUES = st.floats(-100, 100)
US = st.floats(1e-3, 10)
RISKS = st.floats(LEAST_RISK, MOST_RISK)


@given(value=VALUES, u=US, limit=VALUES, risk=RISKS)
def test_an_answer_is_given_only_where_its_chance_to_be_false_is_within_the_risk(
    value: float, u: float, limit: float, risk: float
) -> None:
    found = decide(value, u, limit, "upper", risk)
    # the chance that the true value breaks the limit, by the error function and not by the module's own way
    breaks = 0.5 * math.erfc((limit - value) / (u * math.sqrt(2)))
    assume(abs(breaks - risk) > 1e-9 and abs(1 - breaks - risk) > 1e-9)
    expected = "conforming" if breaks < risk else "not_conforming" if 1 - breaks < risk else "undecided"
    assert found.answer == expected
    assert found.chance_false == pytest.approx(min(breaks, 1 - breaks), abs=1e-12)
    assert found.conforming_to <= limit <= found.not_conforming_from


@given(value=VALUES, u=US, limit=VALUES, risk=RISKS)
def test_a_lower_limit_is_an_upper_one_in_the_mirror(
    value: float, u: float, limit: float, risk: float
) -> None:
    one, other = decide(value, u, limit, "upper", risk), decide(-value, u, -limit, "lower", risk)
    assert (one.answer, one.guard_band, one.chance_false) == (
        other.answer,
        other.guard_band,
        other.chance_false,
    )
    assert (one.conforming_to, one.not_conforming_from) == (-other.conforming_to, -other.not_conforming_from)


@given(value=VALUES, u=US, limit=VALUES, risk=RISKS, more=st.floats(0, 50))
def test_a_faster_vehicle_is_never_judged_better_and_a_smaller_risk_never_decides_more(
    value: float, u: float, limit: float, risk: float, more: float
) -> None:
    order = ["conforming", "undecided", "not_conforming"]
    here = decide(value, u, limit, "upper", risk).answer
    assert order.index(here) <= order.index(decide(value + more, u, limit, "upper", risk).answer)
    assert decide(value, u, limit, "upper", max(LEAST_RISK, risk / 2)).answer in (here, "undecided")


def test_of_many_measurements_no_more_than_the_risk_are_judged_falsely_at_the_limit() -> None:
    rng = np.random.default_rng(51)
    for risk in (0.2, 0.05):
        # the worst case: what is true lies at the limit, where every answer "not conforming" is false
        values = 10.0 + 0.3 * rng.standard_normal(4000)
        answers = [decide(value, 0.3, 10.0, "upper", risk).answer for value in values]
        share = answers.count("not_conforming") / len(answers)
        assert abs(share - risk) < 4 * math.sqrt(risk * (1 - risk) / len(answers))


def test_the_worked_values() -> None:
    found = decide(13.0, 0.1, 12.5, "upper", 0.05)
    assert (found.answer, round(found.factor, 4), round(found.guard_band, 5)) == (
        "not_conforming",
        1.6449,
        0.16449,
    )
    assert decide(12.66, 0.1, 12.5, "upper", 0.05).answer == "undecided"
    assert decide(0.8, 0.02, 0.9, "lower", 0.01).answer == "not_conforming"


@pytest.mark.parametrize("risk", [0.0, -0.1, 0.5, 1.0, math.nan])
def test_no_such_risk(risk: float) -> None:
    with pytest.raises(BadInput, match="is out of range"):
        decide(1.0, 0.1, 1.0, "upper", risk)


@pytest.mark.parametrize(("value", "u"), [(math.nan, 0.1), (1.0, 0.0), (1.0, -1.0), (1.0, math.inf)])
def test_no_decision_without_a_value_and_its_uncertainty(value: float, u: float) -> None:
    with pytest.raises(ValueError, match="standard uncertainty"):
        decide(value, u, 1.0, "upper", 0.05)
