"""Wheels found in the pictures of simulated vehicles, and in one with an axle more."""

from dataclasses import replace

import numpy as np
import pytest

from sightline.linescan import wheels
from sightline.linescan.parts import Crossings, Motion
from sightline.linescan.wheels import NO_MOTION, NONE_FOUND, wheels_in
from tests.linescan.scenes import RIG, plain, plain_truth
from tests.simulation.scan_traffic import ScanTruth

BESIDE = 100


def seen(true: ScanTruth) -> tuple[np.ndarray, int, Motion]:
    """A vehicle's picture, its first line, and its true motion."""
    car = true.vehicle
    lines = Crossings(true.front_line_1, true.rear_line_1, true.front_line_2, true.rear_line_2)
    motion = Motion(
        method="direct",
        crossings=lines,
        status="ok",
        speed_mps=car.speed_mps,
        acceleration_mps2=car.acceleration_mps2,
        length_m=car.length_m,
    )
    start = int(true.front_line_1) - BESIDE
    return plain()[0][start : int(true.rear_line_1) + BESIDE], start, motion


@pytest.mark.parametrize("noise_dn", [0.0, 8.0])
def test_both_wheels_are_found_to_a_centimetre(noise_dn: float) -> None:
    for true in plain_truth():
        picture, start, motion = seen(true)
        noisy = picture + np.random.default_rng(9).normal(0, noise_dn, picture.shape)
        found = wheels_in(np.clip(noisy, 0, 255).astype(np.uint8), start, motion, RIG)
        assert found.reason is None and len(found.lines) == 2
        apart_m = (np.array(found.lines) - true.wheel_lines_1) * true.vehicle.speed_mps / RIG.line_rate_hz
        assert np.abs(apart_m).max() < 0.01


@pytest.mark.parametrize("noise_dn", [0.0, 20.0])
def test_the_likely_sizes_hold_the_best_one(monkeypatch: pytest.MonkeyPatch, noise_dn: float) -> None:
    """What all sizes tried in full find, digit for digit."""
    for true in plain_truth():
        picture, start, motion = seen(true)
        noisy = picture + np.random.default_rng(9).normal(0, noise_dn, picture.shape)
        searched = np.clip(noisy, 0, 255).astype(np.uint8), start, motion, RIG
        found = wheels_in(*searched)
        with monkeypatch.context() as all_sizes:
            all_sizes.setattr(wheels, "LIKELY", 1000)
            assert wheels_in(*searched) == found


@pytest.mark.parametrize("rows", [48, 96])
def test_the_rows_may_be_of_any_size(rows: int) -> None:
    """A camera that sees less of the height beside each pixel, or more: only the lower part is needed."""
    true = plain_truth()[0]
    picture, start, motion = seen(true)
    found = wheels_in(picture[:, -rows:] if rows > 64 else picture[:, 32:], start, motion, RIG)
    assert len(found.lines) == 2 and found.lines == pytest.approx(true.wheel_lines_1, abs=8)


def test_a_third_axle_counts() -> None:
    """The rear wheel once more, 1.1 m before itself."""
    true = plain_truth()[0]
    picture, start, motion = seen(true)
    per_m = RIG.line_rate_hz / true.vehicle.speed_mps
    rear, half = round(true.wheel_lines_1[1]) - start, round(0.42 * per_m)
    at = rear - round(1.1 * per_m)
    more = picture.copy()
    more[at - half : at + half] = picture[rear - half : rear + half]
    found = wheels_in(more, start, motion, RIG)
    assert len(found.lines) == 3
    assert min(abs(line - start - at) for line in found.lines) < 0.02 * per_m


def test_where_there_is_none_it_says_so() -> None:
    picture, start, motion = seen(plain_truth()[0])
    rng = np.random.default_rng(3)
    noise = rng.normal(100, 8, picture.shape).astype(np.uint8)
    assert wheels_in(noise, start, motion, RIG).reason == NONE_FOUND
    assert wheels_in(np.full_like(picture, 90), start, motion, RIG).lines == ()
    unmeasured = replace(motion, speed_mps=None)
    assert wheels_in(picture, start, unmeasured, RIG).reason == NO_MOTION
