"""A long vehicle that stands in view, moves on a little and rests again is one."""

from functools import lru_cache

import cv2
import numpy as np
import pytest

from sightline.linescan.background import Grid, road_from
from sightline.linescan.creeping import ALIKE, MOST_STEPS, Shown, share_alike
from sightline.linescan.faults import notes_of
from sightline.linescan.passing import measure_passages
from tests.linescan.scenes import SLOW_RIG, at, cars, creeping, found, standing, two_standing
from tests.simulation.scan_traffic import Halt, Photograph
from tests.support.proofs import every

pytestmark = pytest.mark.once

PLAIN = "where a side looks the same all along, neither camera tells a creep from an arrival"


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


@pytest.mark.parametrize(
    "case",
    every(
        99,
        [
            (1, 0.0, False, False),
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
    fronts_s, next_s, said = told((seed, back_m, skin, cloud))
    assert fronts_s[1:] == pytest.approx([next_s], abs=0.02)
    assert "may be another that stopped in front of it" in said


@pytest.mark.xfail(strict=True, raises=AssertionError, reason=PLAIN)
@pytest.mark.parametrize("case", every(99, [(2, 0.0, False, False), (1, 0.3, False, False)]))
def test_one_without_marks_on_its_side_is_one(case):
    fronts_s, next_s, _ = told((case[0], case[1], None, case[3]))
    assert fronts_s[1:] == pytest.approx([next_s], abs=0.02)


def test_one_that_stops_before_another_counts_and_is_said_to_be_unsure():
    """Neither camera shows that it is the one that stood."""
    passages, finder = found(two_standing(8.0)[0], SLOW_RIG)
    assert len(list(measure_passages(passages, SLOW_RIG, "direct"))) == 3
    assert "may be the same one that moved on a little" in " ".join(map(str, notes_of(finder)))


def test_what_was_shown_is_bounded_and_rests_count_once():
    grid, rng, shown = Grid(64, 1, 1), np.random.default_rng(34), Shown()
    calm = rng.normal(100.0, 1.0, (200, 64)).astype(np.float32)
    road = road_from(np.rint(calm).astype(np.uint8), grid)
    for block in range(400):
        shown.add(200 * block, calm, road)
    assert [len(part) for part in shown.steps(0, 80_000, 1)] == [1, 1]
    for block in range(400, 800):
        shown.add(200 * block, rng.uniform(0, 255, (200, 64)).astype(np.float32), road)
    lines, cells = shown.steps(0, 160_000, 1)
    assert len(cells) == len(lines) == MOST_STEPS and lines[-1] == 160_000 - 1


def test_a_body_is_known_again_by_another_camera_under_another_light_and_no_other_is():
    grid, rng = Grid(64, 1, 1), np.random.default_rng(35)
    roads = [
        road_from(np.rint(rng.normal(grey, 1.0, (200, 64))).astype(np.uint8), grid) for grey in (90, 110)
    ]
    body = np.repeat(rng.uniform(20, 200, 20), 2).astype(np.float32)
    line, same = (np.concatenate([road.pooled[:14], body, road.pooled[54:]]) for road in roads)
    other = np.concatenate([roads[1].pooled[:14], np.roll(body, 6), roads[1].pooled[54:]])
    taller = np.concatenate([roads[1].pooled[:6], body[:8], body, roads[1].pooled[54:]])
    lower = np.roll(same, 1)
    seen = np.stack([same, 0.85 * same, lower, other, taller]).astype(np.float32)
    parts = share_alike(line.astype(np.float32), roads[0], seen, roads[1], grid)
    assert (parts[:3] >= ALIKE).all() and (parts[3:] < ALIKE).all()


def test_nothing_is_said_of_one_that_stands_and_leaves():
    _, finder = found(standing(1.6)[0], SLOW_RIG)
    assert [watcher.rests_again for watcher in finder.watchers] == [0, 0]
