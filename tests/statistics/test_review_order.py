"""Which measurements are reviewed first."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from sightline.statistics.review_order import SIGNS, review_order

NAN = float("nan")


def _order(heights: list[float], u: list[float], operators: list[int], errors: list[float] | None = None):  # type: ignore[no-untyped-def]
    n = len(heights)
    known = np.full(n, NAN) if errors is None else np.array(errors)
    return review_order(
        np.array(heights), np.array(u), np.zeros(n, int), np.array(operators), known, np.full(n, 0.01)
    )


def test_each_sign_is_seen_where_it_was_put_and_nowhere_else() -> None:
    rng = np.random.default_rng(7)
    heights = list(1.5 + 0.02 * rng.standard_normal(60))
    heights[5] = 1.9
    u = [0.010] * 60
    u[9] = 0.016
    errors = [NAN] * 60
    errors[12], errors[13] = 0.03, 0.01
    operators = [1] * 50 + [2] * 10
    found = _order(heights, u, operators, errors)
    there = {sign: set(np.flatnonzero(found.signs[:, at])) for at, sign in enumerate(SIGNS)}
    assert there["large_u"] == {9} and there["far_from_maker"] == {12}
    assert there["unusual"] == {5} and there["new_operator"] == set(range(50, 60))
    assert int(np.argmax(found.risk)) == 5


def test_a_height_that_is_missing_and_heights_without_spread_have_no_sign() -> None:
    found = _order([1.5] * 11 + [NAN], [0.01] * 11 + [NAN], [1] * 12)
    assert not found.signs[:, :3].any()
    assert _order([], [], []).risk.size == 0


@given(
    st.lists(
        st.tuples(st.floats(0.1, 4.0), st.floats(0.001, 0.5), st.integers(1, 3)), min_size=1, max_size=30
    ),
    st.randoms(use_true_random=False),
)
def test_the_risk_is_of_the_measurement_and_not_of_its_place(rows, random) -> None:  # type: ignore[no-untyped-def]
    order = list(range(len(rows)))
    random.shuffle(order)
    straight = _order(*map(list, zip(*rows, strict=True)))
    shuffled = _order(*map(list, zip(*(rows[at] for at in order), strict=True)))
    np.testing.assert_allclose(straight.risk[order], shuffled.risk, rtol=1e-12)
    assert (straight.risk >= 0.0).all()
