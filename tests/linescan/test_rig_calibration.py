"""Baseline and divergence against planes, staffs and boards simulated by points, normals and roots."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import sqrt, tan

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.errors import BadInput
from sightline.linescan.rig_calibration import (
    Common,
    RigCalibration,
    RigPass,
    RigPassError,
    baseline_at,
    calibrate_rig,
    kind_of,
    lane_baseline,
    span_of,
)

pytestmark = pytest.mark.once
RATE_HZ = 4882.8
LANE_M = 5.5
STANDS_M = (3.0, 3.0, 6.5, 6.5, 9.5, 9.5)
U_TAPE, U_RATE, U_SPEED = 4e-4, 2e-4, 1e-3
COMMON = Common(line_rate_hz=RATE_HZ, u_line_rate_ratio=U_RATE, u_tape_ratio=U_TAPE, u_speed_ratio=U_SPEED)


@dataclass(frozen=True)
class Planes:
    """Two upright planes by a point and a normal each, (2,): along the traffic, away from the cameras."""

    first: tuple[np.ndarray, np.ndarray]
    second: tuple[np.ndarray, np.ndarray]

    def along(self, distance_m: float) -> tuple[float, float]:
        """Where each plane stands at this distance: (point - p) . normal = 0."""
        x1, x2 = (float(p[0] - (distance_m - p[1]) * n[1] / n[0]) for p, n in (self.first, self.second))
        return x1, x2

    def between(self, distance_m: float) -> float:
        first, second = self.along(distance_m)
        return second - first


def planes(baseline: float = 0.593, turned: float = 0.02, opening: float = 0.0021) -> Planes:
    """Both turned together, one by a little more; the cameras stand at the distance 0."""

    def plane(x: float, angle: float) -> tuple[np.ndarray, np.ndarray]:
        return np.array([x, 0.0]), np.array([np.cos(angle), -np.sin(angle)])

    return Planes(plane(-0.2, turned), plane(baseline - 0.2, turned + opening))


def crossed_s(x: float, speed: float, acceleration: float) -> float:
    """When a point that was at -1 m at the time 0 gets to x: the first root ahead."""
    gone = 1.0 + x
    return 2 * gone / (speed + sqrt(speed**2 + 2 * acceleration * gone))


class Errors:
    """Draws of one calibration: what is shared is drawn once; `size` 0 for none."""

    def __init__(self, rng: np.random.Generator | None) -> None:
        self.rng = rng
        self.tape, self.rate, self.speed = (self.draw(u) for u in (U_TAPE, U_RATE, U_SPEED))
        self.width = self.draw(0.0008)
        self.stands = {one: self.draw(0.02) for one in set(STANDS_M)}

    def draw(self, u: float) -> float:
        return 0.0 if self.rng is None else float(self.rng.normal(0.0, u))

    def true_distance(self, told: float) -> float:
        """Where the staff is, when the tape says `told`: a tape that is too long by e reads too little."""
        return told * (1 + self.tape) - self.stands[told]


def by_positions(rig: Planes, told: float, errors: Errors) -> RigPass:
    first, second = rig.along(errors.true_distance(told))
    u = 0.0015
    return RigPass(
        name="p",
        distance_m=told,
        u_distance_m=0.02,
        position_1_m=(first + 4.0) / (1 + errors.tape) + errors.draw(u),
        position_2_m=(second + 4.0) / (1 + errors.tape) + errors.draw(u),
        u_position_m=u,
    )


def by_speed(rig: Planes, told: float, errors: Errors) -> RigPass:
    first, second = rig.along(errors.true_distance(told))
    speed = 2.0
    rate = RATE_HZ * (1 + errors.rate)
    lines = [crossed_s(x, speed, 0.0) * rate + errors.draw(3.0) for x in (first, second)]
    told_speed = speed * (1 + errors.speed) + errors.draw(0.004)
    return RigPass(
        name="s",
        distance_m=told,
        u_distance_m=0.02,
        u_line=3.0,
        speed_mps=told_speed,
        u_speed_mps=0.004,
        line_1=lines[0],
        line_2=lines[1],
    )


def by_board(rig: Planes, told: float, errors: Errors, acceleration: float = 0.25) -> RigPass:
    first, second = rig.along(errors.true_distance(told))
    width = 0.8 + errors.width
    at = [
        crossed_s(x + behind, 1.6, acceleration) * RATE_HZ + errors.draw(3.0)
        for x in (first, second)
        for behind in (0.0, width)
    ]
    return RigPass(
        name="b",
        distance_m=told,
        u_distance_m=0.02,
        u_line=3.0,
        width_m=0.8,
        u_width_m=0.0008,
        front_line_1=at[0],
        rear_line_1=at[1],
        front_line_2=at[2],
        rear_line_2=at[3],
    )


def mixed(rig: Planes, told: float, errors: Errors) -> RigPass:
    ways = (by_positions, by_board)
    return ways[int(told) % 2](rig, told, errors)


Way = Callable[[Planes, float, Errors], RigPass]
WAYS = [by_positions, by_speed, by_board, mixed]


def calibrated(rig: Planes, way: Way, errors: Errors) -> RigCalibration:
    return calibrate_rig([way(rig, told, errors) for told in STANDS_M], COMMON)


@pytest.mark.parametrize("way", WAYS)
def test_without_errors_the_planes_come_back(way: Way) -> None:
    rig = planes()
    found = calibrated(rig, way, Errors(None))
    assert found.baseline_m == pytest.approx(rig.between(0.0), abs=1e-9)
    assert found.baseline_m + 4 * found.divergence_rad == pytest.approx(rig.between(4.0), abs=1e-9)
    assert lane_baseline(found, LANE_M).baseline_m == pytest.approx(rig.between(LANE_M), abs=1e-9)


@pytest.mark.parametrize(
    "way",
    [mixed, *(pytest.param(way, marks=pytest.mark.proof) for way in (by_speed, by_positions, by_board))],
)
def test_the_stated_uncertainties_hold_in_simulated_calibrations(way: Way) -> None:
    """1,200 calibrations: U95 of baseline, divergence and a lane's baseline cover 0.93 to 0.97, without bias,
    with the correlation that is stated; the chance of chi-square is spread evenly."""
    rig, rng = planes(), np.random.default_rng(14007)
    truth = np.array([rig.between(0.0), (rig.between(8.0) - rig.between(2.0)) / 6, rig.between(LANE_M)])
    found = [calibrated(rig, way, Errors(rng)) for _ in range(1200)]
    lanes = [lane_baseline(one, LANE_M) for one in found]
    values = np.array(
        [(c.baseline_m, c.divergence_rad, one.baseline_m) for c, one in zip(found, lanes, strict=True)]
    )
    u = np.array(
        [(c.u_baseline_m, c.u_divergence_rad, one.u_baseline_m) for c, one in zip(found, lanes, strict=True)]
    )
    errors = values - truth
    covered = np.mean(np.abs(errors) <= 1.959964 * u, axis=0)
    assert np.all((covered > 0.93) & (covered < 0.97)), covered
    assert np.all(np.abs(errors.mean(axis=0)) < 3.5 * errors.std(axis=0) / sqrt(len(found)))
    assert errors.std(axis=0) == pytest.approx(np.mean(u, axis=0), rel=0.07)
    together = float(np.corrcoef(errors[:, 0], errors[:, 1])[0, 1])
    assert together == pytest.approx(float(np.mean([one.correlation for one in found])), abs=0.04)
    chances = np.array([one.p_value for one in found])
    assert 0.035 < np.mean(chances < 0.05) < 0.067
    assert 0.46 < chances.mean() < 0.54


def test_a_shared_width_makes_no_chi_square_and_bounds_the_baseline() -> None:
    """Many passes do not help against a board that is 1 mm too wide; the baseline's u says so."""
    rig, quiet = planes(), Errors(None)
    wide = [replace(by_board(rig, told, quiet), width_m=0.801) for told in STANDS_M * 10]
    found = calibrate_rig(wide, COMMON)
    lane = lane_baseline(found, LANE_M)
    assert found.chi2 == pytest.approx(0.0, abs=1e-6)
    assert lane.u_baseline_m > rig.between(LANE_M) * 0.0008 / 0.8
    assert abs(lane.baseline_m - rig.between(LANE_M)) < 1.96 * lane.u_baseline_m


def test_shared_scales_do_not_pull_the_baseline_down() -> None:
    """Weights made from the observed spans would (Peelle's puzzle): the fit lies among its passes."""
    passes = [
        RigPass(
            name=str(k), distance_m=d, speed_mps=v, u_speed_mps=0.02, line_1=0.0, line_2=1450.0, u_line=1.0
        )
        for k, (d, v) in enumerate([(3.0, 1.97), (3.0, 2.03), (9.0, 1.98), (9.0, 2.02)])
    ]
    found = calibrate_rig(passes, replace(COMMON, u_speed_ratio=0.05))
    assert found.passes[0].span_m < found.passes[0].fitted_m < found.passes[1].span_m


@given(
    baseline=st.floats(0.1, 5.0),
    turned=st.floats(-0.2, 0.2),
    opening=st.floats(-0.01, 0.01),
    acceleration=st.floats(-0.3, 1.5),
    backwards=st.booleans(),
)
def test_whatever_the_board_does_its_span_is_exact(
    baseline: float, turned: float, opening: float, acceleration: float, backwards: bool
) -> None:
    rig = planes(baseline, turned, opening)
    speed_there = sqrt(max(1.6**2 + 2 * acceleration * (2.2 + baseline + 3 * tan(0.21)), 0.0))
    if speed_there < 0.6:
        return
    one = by_board(rig, 3.0, Errors(None), acceleration)
    if backwards:
        one = replace(
            one,
            front_line_1=one.front_line_2,
            rear_line_1=one.rear_line_2,
            front_line_2=one.front_line_1,
            rear_line_2=one.rear_line_1,
        )
    assert span_of(one, COMMON).span_m == pytest.approx(rig.between(3.0), rel=1e-7, abs=1e-8)


@given(width=st.floats(0.3, 3.0), jump=st.integers(0, 3))
def test_the_u_of_a_boards_span_is_how_it_answers_to_its_lines(width: float, jump: int) -> None:
    """Differences against the analytic gradient, one line at a time."""
    names = ("front_line_1", "rear_line_1", "front_line_2", "rear_line_2")
    one = replace(by_board(planes(), 3.0, Errors(None)), width_m=width, u_width_m=0.0)
    span = span_of(one, COMMON)

    def moved(name: str) -> float:
        by = 1e-3
        ends = [replace(one, **{name: getattr(one, name) + sign * by}) for sign in (1, -1)]
        return (span_of(ends[0], COMMON).span_m - span_of(ends[1], COMMON).span_m) / (2 * by)

    slopes = [moved(name) for name in names]
    assert sum(slopes) == pytest.approx(0.0, abs=1e-8)
    assert span.u_span_m == pytest.approx(3.0 * sqrt(sum(s * s for s in slopes)), rel=1e-4)
    assert abs(slopes[jump]) > 0


@given(
    u_b=st.floats(0.0, 0.1),
    u_q=st.floats(0.0, 0.01),
    correlation=st.floats(-1.0, 1.0),
    away=st.floats(0.1, 50.0),
    u_away=st.floats(0.0, 1.0),
)
def test_a_lanes_u_is_that_of_the_joint_covariance(
    u_b: float, u_q: float, correlation: float, away: float, u_away: float
) -> None:
    q = 0.002
    value, u = baseline_at((0.6, u_b), (q, u_q), correlation, (away, u_away))
    joint = np.array([[u_b**2, correlation * u_b * u_q], [correlation * u_b * u_q, u_q**2]])
    slopes = np.array([1.0, away])
    expected = max(float(slopes @ joint @ slopes), 0.0) + (q * u_away) ** 2
    assert value == pytest.approx(0.6 + q * away)
    assert u**2 == pytest.approx(expected, abs=1e-12)


def good() -> list[RigPass]:
    rig = planes()
    return [replace(by_positions(rig, told, Errors(None)), name=f"n{k}") for k, told in enumerate(STANDS_M)]


@pytest.mark.parametrize(
    ("passes", "said"),
    [
        (lambda: good()[:2], "2 usable passes are too few"),
        (
            lambda: [replace(one, distance_m=3.0) for one in good()],
            "between 3.000 and 3.000 m away, too close",
        ),
        (lambda: [replace(one, u_distance_m=2.0) for one in good()], "too close"),
        (
            lambda: [*good()[:5], replace(good()[5], position_2_m=4.5)],
            r"contradict each other .*: pass n5 differs from the others",
        ),
        (lambda: [*good(), replace(good()[0], name="x", u_distance_m=0.5)], "3.000 m has two different"),
        (lambda: [replace(one, u_position_m=0.0) for one in good()], "Pass n0: The value u_position_m"),
    ],
)
def test_what_gives_no_calibration_is_refused_in_words(
    passes: Callable[[], list[RigPass]], said: str
) -> None:
    with pytest.raises(BadInput, match=said):
        calibrate_rig(passes(), COMMON)


def test_two_uncertainties_of_one_board_are_refused() -> None:
    board = [by_board(planes(), told, Errors(None)) for told in STANDS_M]
    with pytest.raises(BadInput, match=r"board of 0\.8 m has two different uncertainties"):
        calibrate_rig([*board, replace(board[0], u_width_m=0.1)], COMMON)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"front_line_1": None}, "The value front_line_1 is missing"),
        ({"line_1": 3.0}, r"two methods \(speed and board\)"),
        ({"rear_line_1": 1.0}, "not in order"),
        ({"width_m": 0.0}, "The value width_m is out of range: 0"),
        ({"front_line_2": float("nan")}, "The value front_line_2 is out of range: nan"),
        ({"u_line": -1.0}, "The value u_line is out of range: -1"),
        ({"distance_m": 2000.0}, "The value distance_m is out of range: 2000"),
        ({"width_m": 300.0}, "It gives a baseline of"),
        ({"rear_line_2": 1e6}, "stopped or nearly stopped"),
    ],
)
def test_a_pass_that_tells_nothing_says_why(change: dict[str, float | None], said: str) -> None:
    one = by_board(planes(), 3.0, Errors(None))
    with pytest.raises(RigPassError, match=said):
        span_of(replace(one, **change), COMMON)  # type: ignore[arg-type]


def test_a_known_speed_needs_the_line_rate_and_an_empty_pass_a_way() -> None:
    with pytest.raises(RigPassError, match="needs the line rate"):
        span_of(by_speed(planes(), 3.0, Errors(None)), Common())
    with pytest.raises(RigPassError, match="neither positions nor lines"):
        kind_of(RigPass(name="", distance_m=3.0))
    with pytest.raises(BadInput, match=r"relative, from 0 to 0\.1"):
        calibrate_rig(good(), Common(u_tape_ratio=2.0))


def test_what_to_look_at_is_said() -> None:
    assert tuple(map(str, calibrate_rig(good()).warnings)) == (
        "The passes agree better than their stated uncertainties; these may be too large.",
    )
    two = calibrate_rig([one for one in good() if one.distance_m < 9])
    assert "Two distances cannot test" in str(two.warnings[-1])
    off = [*good()[:5], replace(good()[5], position_2_m=(good()[5].position_2_m or 0) + 0.01)]
    assert "check pass n5 first" in str(calibrate_rig(off, COMMON).warnings[0])
    assert "far outside the passes" in str(lane_baseline(two, 30.0).warning)
    assert lane_baseline(two, 7.0).warning is None
