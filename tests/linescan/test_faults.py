"""Recordings with something wrong: a sentence that names it, and no vehicle measured wrongly without one."""

from dataclasses import replace

import numpy as np
import pytest

from sightline.linescan.direct import measure_direct
from sightline.linescan.faults import notes_of
from sightline.linescan.finding import Finder
from tests.linescan.scenes import RIG, SITE, cars, found, plain, plain_truth
from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import traffic

pytestmark = pytest.mark.once


def _notes(pair):
    passages, finder = found(pair)
    return " ".join(map(str, notes_of(finder))), passages


def test_a_good_recording_says_nothing():
    said, passages = _notes(plain())
    assert said == "" and len(passages) == 3


def test_empty_road_and_swapped_strips():
    assert "No vehicle was found" in _notes(strips(SITE, (), 2.5))[0]
    first, second = plain()
    assert "swapped" in _notes((second, first))[0]


FRONT_LOST = "under flicker its front at camera 2 is found 35 mm off, and it is refused for an untrue reason"


@pytest.mark.parametrize(
    "seed", [7301, 7302, pytest.param(7303, marks=pytest.mark.xfail(strict=True, reason=FRONT_LOST))]
)
def test_flicker_is_named_and_the_vehicle_still_found(seed):
    """Vehicles and roads that `LIGHT_TIMES` was not set on: that was the first of `cars()` before SITE."""
    (car,) = traffic(seed, 1, speeds_mps=(11.0, 24.0))
    said, passages = _notes(strips(replace(SITE, flicker=0.1, seed=seed), (car,)))
    assert said.count("flickers by") == 2
    motion = measure_direct(passages[0], RIG)
    assert motion.speed_mps == pytest.approx(car.speed_mps, rel=0.004)


def test_rain_is_named_and_the_vehicle_still_found():
    said, passages = _notes(strips(replace(SITE, rain_per_s=200.0), cars()[:1]))
    assert "rain" in said
    motion = measure_direct(passages[0], RIG)
    assert motion.speed_mps == pytest.approx(cars()[0].speed_mps, rel=0.0015)


def test_saturation_is_named():
    pair = tuple(np.clip(strip.astype(float) * 2.2, 0, 255).astype(np.uint8) for strip in plain())
    said, passages = _notes(pair)
    assert "saturated" in said
    motion = measure_direct(passages[0], RIG)
    assert motion.reason or any("saturated" in str(warning) for warning in motion.warnings)


@pytest.mark.parametrize("bits", [8, 10, 12, 16])
def test_saturation_is_that_of_the_cameras_bits(bits):
    """Cameras of 10 and 12 bits, whose largest value is none of the file's, were never named."""
    top = (1 << bits) - 1
    lines = np.full((6000, 64), top // 3, np.uint8 if bits == 8 else np.uint16)
    lines[:, :5] = top
    finder = Finder(64, RIG, bits)
    finder.push(lines, lines)
    finder.finish()
    assert all(one.saturated_lines / one.lines == pytest.approx(5 / 64) for one in finder.watchers)


def test_a_light_that_jumps_is_counted():
    pair = [strip.astype(float) for strip in plain()]
    for strip in pair:
        strip[int(plain_truth()[1].rear_line_2) + 120 :] *= 1.3
    said, _ = _notes(tuple(np.clip(strip, 0, 255).astype(np.uint8) for strip in pair))
    assert "The brightness changed suddenly once" in said


def test_lines_lost_while_a_vehicle_passes_are_not_measured_over():
    first, second = plain()
    at = int(plain_truth()[1].front_line_2) + 500
    second = np.delete(second, slice(at, at + 25), 0)
    _, passages = _notes((first[: len(second)], second))
    assert measure_direct(passages[0], RIG).status == "ok"
    motion = measure_direct(passages[1], RIG)
    assert motion.status == "not_measurable" and "lost lines" in str(motion.reason)


def test_cameras_that_look_at_different_lanes_are_told():
    first, second = plain()
    said, passages = _notes((first, np.roll(second, 4000, axis=0)))
    assert "only one camera" in said
    assert not [passage for passage in passages if passage.reason is None]
