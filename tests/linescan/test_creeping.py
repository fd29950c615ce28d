"""A long vehicle that stands in view, moves on a little and rests again is one, and is told as several."""

from functools import lru_cache

import cv2
import numpy as np
import pytest

from sightline.linescan.faults import notes_of
from sightline.linescan.passing import measure_passages
from tests.linescan.scenes import SLOW_RIG, at, cars, creeping, found, standing
from tests.simulation.scan_traffic import Halt, Photograph
from tests.support.proofs import every

pytestmark = pytest.mark.once

SEVERAL = "each place in which it rests for 3 s looks like another vehicle before the one that stands"


def painted(path, seed):
    """A picture with greys as uneven as a photograph's, at all scales."""
    rng, picture = np.random.default_rng(seed), np.zeros((600, 3000))
    for size in (4, 16, 64, 256):
        knots = rng.standard_normal((600 // size + 2, 3000 // size + 2))
        picture += size**0.35 * cv2.resize(knots, (3000, 600), interpolation=cv2.INTER_CUBIC)
    cv2.imwrite(str(path), np.clip(120 + 38 * picture / picture.std(), 5, 250).astype(np.uint8))
    return Photograph(str(path), 0, 0, 150.0)


def under_cloud(pair, from_s, to_s):
    """A cloud takes a quarter of the light meanwhile, within half a second each way."""
    time_s = np.arange(len(pair[0])) / SLOW_RIG.line_rate_hz
    gain = 1 - 0.25 * np.interp(time_s, [from_s, from_s + 0.5, to_s, to_s + 0.5], [0, 1, 1, 0])
    return tuple(np.rint(strip * gain[:, None]).astype(np.uint8) for strip in pair)


@lru_cache(maxsize=2)
def told(case):
    """The fronts of what is told, seconds, that of the vehicle that comes after, and the notes.

    `case`: the scene's seed, how far it goes back after each creep, whether its side is painted unevenly
    (a picture's file) or as it is drawn, and whether a cloud comes and goes meanwhile.
    """
    seed, back_m, skin, cloud = case
    pair, (rear_s, next_s) = creeping(seed, back_m=back_m, skin=skin)
    passages, finder = found(under_cloud(pair, 8.0, rear_s - 3.0) if cloud else pair, SLOW_RIG)
    vehicles = measure_passages(passages, SLOW_RIG, "direct")
    return [one.front_s for one in vehicles], next_s, " ".join(map(str, notes_of(finder)))


def test_a_halt_creeps_as_far_as_it_says():
    halt = Halt(1.6, 2.0, creeps=((4.0, 3.0), (-0.5, 3.0)))
    car = at(cars()[0], 1.0, 7.0, halt=halt)
    time_s = np.arange(0.0, 16.0, 0.001)
    place_m = car.travelled_m(time_s)
    rests = np.flatnonzero(np.abs(np.diff(place_m)) < 1e-9)
    assert sorted({round(float(place_m[at]), 3) for at in rests}) == [1.6, 5.1, 5.6]
    assert np.abs(np.diff(place_m)).max() < 0.0071  # and jumps nowhere


@pytest.mark.xfail(strict=True, raises=AssertionError, reason=SEVERAL)
@pytest.mark.parametrize(
    "case",
    every(
        99,
        [
            (1, 0.0, False, False),
            (2, 0.0, False, False),
            (1, 0.3, False, False),
            (1, 0.0, False, True),
            (1, 0.0, True, False),
            (2, 0.0, True, False),
            (1, 0.3, True, False),
            (1, 0.0, True, True),
        ],
    ),
)
def test_one_that_creeps_on_is_one(tmp_path, case):
    seed, back_m, uneven, cloud = case
    skin = painted(tmp_path / "side.png", seed) if uneven else None
    fronts_s, next_s, _ = told((seed, back_m, skin, cloud))
    assert fronts_s[1:] == pytest.approx([next_s], abs=0.02)


def test_who_counts_is_told_that_it_may_be_one():
    """Nothing was said; the one after it is found all the same."""
    fronts_s, next_s, said = told((1, 0.0, None, False))
    assert fronts_s[-1] == pytest.approx(next_s, abs=0.02)
    assert "may be the same one that moved on a little" in said


def test_nothing_is_said_of_one_that_stands_and_leaves():
    _, finder = found(standing(1.6)[0], SLOW_RIG)
    assert [watcher.rests_again for watcher in finder.watchers] == [0, 0]
