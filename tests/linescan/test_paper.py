"""The paper's chain: blocks found to a fraction of a line, the gate, and motion on simulated traffic."""

import numpy as np
import pytest

from sightline.linescan.equations import travelled_m
from sightline.linescan.finding import STOPPED
from sightline.linescan.matching import match_blocks
from sightline.linescan.paper import measure_paper
from sightline.linescan.parts import Crossings, Motion, Passage, Rig
from sightline.linescan.rig import u_travelled_m
from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import ScanSite, ScanTruth, traffic, truths


def texture(lines: np.ndarray, rows: int, seed: int = 0) -> np.ndarray:
    """(lines, rows) grey values of a sum of waves, at fractional lines."""
    rng = np.random.default_rng(seed)
    waves = rng.uniform(0.02, 0.3, 12)
    phases, tilts = rng.uniform(0, 6.28, 12), rng.uniform(-0.05, 0.05, 12)
    angle = waves * lines[:, None, None] + tilts * np.arange(rows)[:, None] * 6.28 + phases
    return np.asarray(128 + 9 * np.cos(angle).sum(axis=2))


def noisy(picture: np.ndarray, seed: int) -> np.ndarray:
    noise = np.random.default_rng(seed).normal(0, 2, picture.shape)
    return np.clip(picture + noise + 0.5, 0, 255).astype(np.uint8)


@pytest.mark.parametrize("shift", [30.0, 30.3, 30.5, 29.75])
def test_blocks_are_found_to_a_fraction_of_a_line(shift: float) -> None:
    lines = np.arange(400.0)
    first, second = noisy(texture(lines, 64), 1), noisy(texture(lines - shift, 64), 2)
    found = match_blocks(first, second, range(20, 41), 2.0)
    assert found.used.all() and len(found.shift) > 20
    assert found.shift.mean() == pytest.approx(shift, abs=0.03)
    assert np.abs(found.shift - shift).max() < 0.15


def test_a_slow_change_passes_the_gate_over_more_lines_and_noise_never_does() -> None:
    # three times slower: over one line the noise hides it
    lines = np.arange(400.0) / 3
    first, second = noisy(texture(lines, 64), 1), noisy(texture(lines - 10, 64), 2)
    near, far = (match_blocks(first, second, range(20, 41), 2.0, lag=lag) for lag in (1, 4))
    assert near.used.sum() < 0.5 * far.used.sum() and far.used.mean() > 0.9
    assert far.shift[far.used].mean() == pytest.approx(30, abs=0.05)
    flat = noisy(np.full((400, 64), 90.0), 3)
    assert not match_blocks(flat, flat, range(-5, 6), 2.0, lag=4).used.any()


def test_16_bits_match_as_8_do() -> None:
    lines = np.arange(300.0)
    pair = noisy(texture(lines, 64), 1), noisy(texture(lines - 30, 64), 2)
    eight = match_blocks(*pair, range(20, 41), 2.0)
    sixteen = match_blocks(*(one.astype(np.uint16) * 200 for one in pair), range(20, 41), 400.0)
    assert sixteen.shift == pytest.approx(eight.shift) and sixteen.used.all()


def test_a_row_of_misalignment_is_searched_for_and_an_empty_block_is_passed_over() -> None:
    lines = np.arange(400.0)
    picture = texture(lines - 25, 65)
    first, second = noisy(texture(lines, 65)[:, 1:], 1), noisy(picture[:, :-1], 2)
    found = match_blocks(first, second, range(15, 36), 2.0)
    assert set(found.vertical.tolist()) == {1} and found.shift.mean() == pytest.approx(25, abs=0.05)
    flat = noisy(np.full((400, 64), 90.0), 3)
    assert not match_blocks(flat, flat, range(-5, 6), 2.0).used.any()
    assert len(match_blocks(first[:40], second, range(15, 36), 2.0).middle) == 0


def passage_of(truth: ScanTruth, first: np.ndarray, second: np.ndarray, **more: object) -> Passage:
    seen = Crossings(truth.front_line_1, truth.rear_line_1, truth.front_line_2, truth.rear_line_2)
    at = [max(0, int(line) - 200) for line in (seen.front_line_1, seen.front_line_2)]
    cut = first[at[0] : int(seen.rear_line_1) + 200], second[at[1] : int(seen.rear_line_2) + 200]
    roads = (one[:200].mean(axis=0).astype(np.float32) for one in (first, second))
    return Passage(seen, *cut, *at, *roads, 2.0, **more)  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def measured() -> list[tuple[ScanTruth, Motion]]:
    site = ScanSite(rows=96)
    cars = traffic(5, 3, speeds_mps=(16.0, 34.0))
    first, second = strips(site, cars)
    rig = Rig(site.baseline_m, site.line_rate_hz, u_baseline_m=0.001, u_line_rate_ratio=1e-5)
    return [(one, measure_paper(passage_of(one, first, second), rig)) for one in truths(site, cars)]


def test_motion_is_as_good_as_the_paper_says(measured: list[tuple[ScanTruth, Motion]]) -> None:
    """The paper: speed within 1 % (its rigs' vehicles fitted to 0.2 to 0.8 %); length within 1.8 %."""
    off = [one.speed_mps / truth.vehicle.speed_mps - 1 for truth, one in measured if one.speed_mps]
    lengths = [one.length_m / truth.vehicle.length_m - 1 for truth, one in measured if one.length_m]
    assert len(off) == len(measured)
    assert np.sqrt(np.mean(np.square(off))) < 0.01 and max(map(abs, lengths)) < 0.018


def test_profile_and_budget_say_what_was_used(measured: list[tuple[ScanTruth, Motion]]) -> None:
    truth, one = measured[0]
    assert one.profile is not None and one.u_speed_mps is not None and one.fit_error_percent is not None
    inside = (one.profile.line_1 > truth.front_line_1) & (one.profile.line_1 < truth.rear_line_1)
    assert inside.all() and len(one.profile.used) == len(inside) and one.profile.used.any()
    assert [entry.source for entry in one.budget] == ["baseline", "clock", "regression", "front", "rear"]
    assert np.hypot.reduce([entry.u_speed_mps for entry in one.budget]) == pytest.approx(one.u_speed_mps)
    assert one.budget[0].u_speed_mps == pytest.approx(one.speed_mps * 0.001 / 0.593)
    assert 0 < one.fit_error_percent < 3


def test_baseline_and_clock_carry_a_gap_on_as_they_scale_the_motion() -> None:
    """A baseline of 5 % makes any way 5 % uncertain beside the fit, a clock of 5 % none."""
    site = ScanSite(rows=96)
    cars = traffic(5, 1, speeds_mps=(16.0, 34.0))
    (truth,) = truths(site, cars)
    passage = passage_of(truth, *strips(site, cars))
    rigs = [Rig(site.baseline_m, site.line_rate_hz, *u) for u in ((0.0, 0.0), (0.05 * site.baseline_m, 0.05))]
    exact, loose = (measure_paper(passage, rig) for rig in rigs)
    begin_s, end_s = 0.3, 0.8
    way_m = np.diff(travelled_m(exact.speed_mps, exact.acceleration_mps2, np.array([begin_s, end_s])))[0]
    u_m = [u_travelled_m(one, begin_s, end_s, clock) for one, clock in ((exact, 0.0), (loose, 0.05))]
    assert u_m[1] == pytest.approx(np.hypot(u_m[0], 0.05 * way_m), rel=1e-6)
    assert u_m[0] < 0.05 * way_m


def test_what_cannot_be_measured_has_a_reason(measured: list[tuple[ScanTruth, Motion]]) -> None:
    truth, _ = measured[0]
    rig = Rig(0.593, 4882.8)
    flat = np.full((int(truth.rear_line_2) + 300, 64), 100, np.uint8)
    empty = measure_paper(passage_of(truth, flat, flat), rig)
    assert empty.status == "not_measurable" and "Too few blocks" in str(empty.reason)
    told = measure_paper(passage_of(truth, flat, flat, reason=STOPPED), rig)
    assert told.reason == STOPPED and told.speed_mps is None
