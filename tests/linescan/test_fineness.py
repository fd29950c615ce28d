"""Lines too slow for the scene are told from the strips, and refused with what to do."""

from dataclasses import replace

import numpy as np
import pytest

from sightline.linescan.fineness import GOOD_LINE_M, carried_on, too_coarse
from sightline.linescan.methods import MEASURE
from sightline.linescan.parts import Crossings, Passage, Rig
from sightline.messages.said import Said
from tests.linescan.scenes import RIG, SITE, found, plain, plain_found, plain_truth

pytestmark = pytest.mark.once


def every(nth: int) -> tuple[np.ndarray, np.ndarray]:
    """The three cars as cameras with so much slower lines, but exposures as short, take them."""
    first, second = plain()
    return np.ascontiguousarray(first[::nth]), np.ascontiguousarray(second[::nth])


def test_lines_close_enough_are_measured_and_slow_ones_refused_with_what_to_do() -> None:
    speeds = [true.vehicle.speed_mps for true in plain_truth()]
    for nth, fine in ((1, True), (2, True), (16, False), (32, False)):
        rig = Rig(RIG.baseline_m, RIG.line_rate_hz / nth)
        passages = [one for one in found(every(nth), rig)[0] if one.reason is None]
        assert len(passages) == 3
        for passage, speed_mps in zip(passages, speeds, strict=True):
            said = [MEASURE[method](passage, rig) for method in ("direct", "paper")]
            if fine:
                assert [one.status for one in said] == ["ok", "ok"], nth
                continue
            line_mm = 1000 * speed_mps / rig.line_rate_hz
            for one in said:
                assert one.status == "not_measurable" and one.speed_mps is None and one.reason
                assert "Raise the line rate" in str(one.reason)
                told_mm = one.reason.values["line_mm"]
                assert told_mm == pytest.approx(line_mm, rel=0.05)


def test_planes_that_open_are_as_far_apart_as_at_the_vehicles() -> None:
    """A rig of 0.393 m at the cameras that is 0.593 m at 5 m finds, bounds and refuses as one of 0.593 m."""
    opening = replace(RIG, baseline_m=RIG.baseline_m - 5.0 * 0.04, divergence_rad=0.04, distance_m=5.0)
    again = found(plain(), opening)[0]
    for one, same in zip(plain_found()[0], again, strict=True):
        assert vars(same.crossings) == pytest.approx(vars(one.crossings), abs=1e-6)
        assert same.u_ends_m == pytest.approx(one.u_ends_m, rel=1e-6)
    rig, slow = (replace(one, line_rate_hz=RIG.line_rate_hz / 32) for one in (RIG, opening))
    (passage, *_) = found(every(32), rig)[0]
    said = too_coarse(passage, rig)
    assert said is not None and too_coarse(passage, slow) == said


def test_boundaries_that_are_a_line_off_change_neither_the_distance_of_lines_nor_the_rate_to_ask_for() -> (
    None
):
    """One more of few lines from camera to camera is a third; the pictures tell how many there are."""
    nth = 32
    rig = Rig(RIG.baseline_m, RIG.line_rate_hz / nth)
    for passage, true in zip(found(every(nth), rig)[0], plain_truth(), strict=True):
        line_m, c = true.vehicle.speed_mps / rig.line_rate_hz, passage.crossings
        for by in (-1.0, 0.0, 1.0):
            moved = replace(c, front_line_2=c.front_line_2 + by, rear_line_2=c.rear_line_2 + by)
            said = too_coarse(replace(passage, crossings=moved), rig)
            lines = RIG.baseline_m / line_m
            assert said and said.values["line_mm"] == pytest.approx(1000 * line_m, rel=0.2 / lines)
            needed_hz = true.vehicle.speed_mps / GOOD_LINE_M
            assert 0.98 * needed_hz < said.values["rate_hz"] < 1.15 * needed_hz


def test_what_is_carried_on_does_not_mind_noise() -> None:
    """A wave of 40 lines goes on, single lines do not; noise alone is nothing to judge by."""
    rng = np.random.default_rng(4)
    wave = 100 + 20 * np.sin(2 * np.pi * (np.arange(2000)[:, None] + np.arange(64) / 8) / 40)
    single = np.repeat(100 + 20 * rng.standard_normal((2000, 16)), 4, axis=1)
    for noise in (0.0, 8.0):
        grain = noise * rng.standard_normal(wave.shape)
        smooth, rough = (carried_on((one + grain).astype(np.float32), noise) for one in (wave, single))
        assert smooth == pytest.approx(np.cos(2 * np.pi / 40), abs=0.1)
        assert rough == pytest.approx(-0.5, abs=0.1)
    empty = (100 + 8 * rng.standard_normal(wave.shape)).astype(np.float32)
    assert carried_on(empty, 8.0) is None and carried_on(empty[:4], 8.0) is None


def test_a_picture_that_shows_nothing_is_not_called_too_coarse() -> None:
    passage = plain_found()[0][0]
    flat = np.full_like(passage.first, 90)
    assert too_coarse(passage, RIG) is None
    assert too_coarse(replace(passage, first=flat, second=flat[: len(passage.second)]), RIG) is None
    assert SITE.line_rate_hz == RIG.line_rate_hz


@pytest.mark.parametrize("period", [3, 5])
def test_a_side_that_repeats_itself_is_told_no_rate_by_the_match_that_noise_made_the_best(
    period: int,
) -> None:
    """Of a vehicle in few lines, which has no boundaries to go by; a side that does not repeat itself is."""
    rng = np.random.default_rng(period)
    by, lines, shape = 4, 90, (130, 64)
    once = np.repeat(rng.normal(120, 25, (shape[0], 16)), 4, axis=1)
    road = np.full(64, 120, np.float32)
    few = Said("scan-motion-few-lines", lines=0)
    for side, repeats in ((once, False), (np.resize(once[:period], shape), True)):
        seen = [
            np.clip(one + rng.normal(0, 3, one.shape), 0, 255).astype(np.uint8)
            for one in (side[by:], side[:-by])
        ]
        at = Crossings(20.0, 20.0 + lines, 20.0, 20.0 + lines)
        passage = Passage(at, seen[0], seen[1], 0, 0, road, road, 3.0, few)
        said = too_coarse(passage, Rig(0.6, 60.0))
        assert (said is None) == repeats
        if said is not None:
            assert said.values["line_mm"] == pytest.approx(600 / by, rel=0.05)
