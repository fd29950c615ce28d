"""Which passes are taken, how far behind each other they go, and the response that follows, by hand."""

from dataclasses import replace
from itertools import pairwise

import pytest
from scipy import stats

from sightline.statistics.sampling import (
    PassAnswers,
    PassTime,
    Sampling,
    headways,
    is_in_sample,
    response,
)


def test_every_nth_from_a_start() -> None:
    rule = Sampling("nth", step=4, start=3)
    assert [n for n in range(1, 16) if is_in_sample(rule, n, None)] == [3, 7, 11, 15]
    assert all(is_in_sample(Sampling(), n, None) for n in range(1, 16))


@pytest.mark.parametrize("percent", [5.0, 25.0, 60.0])
def test_a_share_is_drawn_evenly_and_again_the_same(percent: float) -> None:
    """Of many numbers the share is taken as by a fair draw; neighbours and seeds are independent."""
    rule, count = Sampling("share", share_percent=percent, seed=7), 20_000
    taken = [is_in_sample(rule, n, None) for n in range(1, count + 1)]
    assert taken == [is_in_sample(rule, n, None) for n in range(1, count + 1)]
    assert stats.binomtest(sum(taken), count, percent / 100).pvalue > 0.001
    both = sum(a and b for a, b in pairwise(taken))
    assert stats.binomtest(both, count - 1, (percent / 100) ** 2).pvalue > 0.001
    other = [is_in_sample(replace(rule, seed=8), n, None) for n in range(1, count + 1)]
    assert (
        stats.binomtest(sum(map(lambda a, b: a and b, taken, other)), count, (percent / 100) ** 2).pvalue
        > 0.001
    )


def test_the_mixing_is_the_published_one() -> None:
    """SplitMix64 from state 0 gives 0xE220A8397B1DCDAF first: a share just above it takes the pass."""
    drawn = 100 * 0xE220A8397B1DCDAF / 2**64
    assert is_in_sample(Sampling("share", share_percent=drawn + 1e-9, seed=0), 0, None)
    assert not is_in_sample(Sampling("share", share_percent=drawn - 1e-9, seed=0), 0, None)


def test_free_flowing_is_by_direction_and_recording_and_no_discarded_pass_is_followed() -> None:
    passes = [
        PassTime(1, 1, "right", 0.0, True),
        PassTime(2, 1, "left", 1.0, True),
        PassTime(3, 1, "right", 4.0, True),
        PassTime(4, 1, "right", 6.0, False),
        PassTime(5, 1, "right", 10.0, True),
        PassTime(6, 2, "right", 10.5, True),
    ]
    behind = headways(reversed(passes))
    assert behind == {3: 4.0, 4: 2.0, 5: 6.0}
    rule = Sampling(free_flowing_s=5.0)
    taken = [
        one.vehicle_id for one in passes if is_in_sample(rule, one.vehicle_id, behind.get(one.vehicle_id))
    ]
    assert taken == [1, 2, 5, 6]


EYES = PassAnswers("daytime", "passenger_cars", True, False, ("roof", "driver_eye"), frozenset(), frozenset())


def test_every_pass_ends_once_and_rates_are_of_the_sample() -> None:
    passes = [
        *[replace(EYES, measured=frozenset({"roof", "driver_eye"}))] * 6,
        *[replace(EYES, measured=frozenset({"roof"}), not_visible=frozenset({"driver_eye"}))] * 2,
        replace(EYES, not_visible=frozenset({"roof", "driver_eye"})),
        replace(EYES, measured=frozenset({"roof"})),
        replace(EYES, class_set="heavy"),
        replace(EYES, in_sample=False, measured=frozenset({"roof", "driver_eye"})),
        replace(EYES, in_sample=False),
        replace(EYES, discarded=True, in_sample=False),
        replace(EYES, lighting=None, class_set=None, asked=("roof",), measured=frozenset({"roof"})),
    ]
    found = {(row.lighting, row.class_set, row.target): row for row in response(passes)}
    cars = found["daytime", "passenger_cars", None]
    assert (cars.passes, cars.discarded, cars.out_of_sample, cars.in_sample) == (13, 1, 2, 10)
    assert (cars.measured, cars.not_visible, cars.open, cars.outside) == (8, 1, 1, 1)
    assert cars.rate == pytest.approx(0.8)
    # Clopper and Pearson for 8 of 10, from the beta distribution
    assert (cars.low, cars.high) == pytest.approx((stats.beta.ppf(0.025, 8, 3), stats.beta.ppf(0.975, 9, 2)))
    eyes = found["daytime", "passenger_cars", "driver_eye"]
    assert (eyes.in_sample, eyes.measured, eyes.not_visible, eyes.open) == (10, 6, 3, 1)
    assert found["daytime", "heavy", None].rate == 0.0
    assert found["unknown", "none", None].measured == 1
    assert ("unknown", "none", "driver_eye") not in found
    for row in found.values():
        assert row.passes == row.in_sample + row.discarded + row.out_of_sample
        assert row.in_sample == row.measured + row.not_visible + row.open
    assert found["all", "all", None].passes == len(passes)


def test_a_group_without_a_sample_has_no_rate() -> None:
    (row, *_) = response([replace(EYES, discarded=True)])
    assert (row.in_sample, row.rate, row.low, row.high) == (0, None, None, None)
    assert response([]) == []
