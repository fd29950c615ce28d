"""Registers strip 2 to strip 1 by least squares on grey values: speed, acceleration, row shift, gain, offset.

Every chosen pixel of strip 1 says what strip 2 must show where the motion puts it. Gauss-Newton from coarse
to fine; weights follow the residuals of single pixels and of whole blocks, so that wheels (which turn between
the cameras), windows (through which each camera sees its own background) and drops lose their say.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.linescan.masks import Points, Sheet, sample_sheet, shift_sheet
from sightline.linescan.middle import median
from sightline.linescan.warp import Course
from sightline.robust import robust_scale

ROUNDS = 8
SETTLED = 1e-5
LEVEL_DN = 6.0
TUKEY = 4.7
#: How many times as bright camera 2 may be as camera 1: the search ends there.
GAINS = 0.2, 5.0


@dataclass(frozen=True)
class Prior:
    """What is known of the row shift beforehand, in rows of the sheets; u None: nothing."""

    shift: float = 0.0
    u_shift: float | None = None


@dataclass(frozen=True, eq=False)
class State:
    """The answer so far: motion, row shift (rows of the sheets), gain and offset of strip 2 against 1."""

    course: Course
    shift: float = 0.0
    gain: float = 1.0
    offset: float = 0.0


@dataclass(frozen=True, eq=False)
class Clock:
    """Turns lines into seconds since the front reached camera 1."""

    front_line_1: float
    line_rate_hz: float

    def seconds(self, line: Floats) -> Floats:
        """Seconds, of the same shape, of strip lines, `line` of any shape."""
        return np.asarray((line - self.front_line_1) / self.line_rate_hz)

    def lines(self, seconds: Floats) -> Floats:
        """Strip lines, of the same shape, of `seconds` of any shape."""
        return np.asarray(seconds * self.line_rate_hz + self.front_line_1)


@dataclass(frozen=True, eq=False)
class Look:
    """Strip 2 compared with strip 1 under a state: residuals, derivatives (n, 5), and what was inside."""

    residual: Floats
    jacobian: Floats
    inside: NDArray[np.bool_]
    first_s: Floats
    second_s: Floats
    along: Floats


@dataclass(frozen=True, eq=False)
class Fit:
    """The end: state, last look, weights (n,), normal matrix (5, 5), scale of residuals, the last step (5,)
    of its unknowns, and whether that was small enough to stop at.
    """

    state: State
    look: Look
    weight: Floats
    normal: Floats
    scale_dn: float
    last_step: Floats
    settled: bool


def look(first: Sheet, second: Sheet, points: Points, clock: Clock, state: State) -> Look:
    """Residuals and their derivatives by speed, acceleration, shift, gain and offset.

    `second` is already shifted by the state's rows.
    """
    first_s = clock.seconds(first.line(points.place))
    second_s = state.course.second_s(first_s)
    place = second.place(clock.lines(second_s))
    seen = sample_sheet(second, place, points.row)
    margin = 2 + abs(state.shift)
    inside = (place > 2) & (place < len(second.values) - 3)
    inside &= (points.row > margin) & (points.row < second.values.shape[1] - 1 - margin)
    residual = seen - state.gain * points.value - state.offset
    # strip 2's gradient from strip 1's, stretched as the motion stretches the picture
    stretch = state.course.speed_at_mps(second_s) / np.maximum(state.course.speed_at_mps(first_s), 1e-3)
    along = state.gain * points.along * stretch * first.step / second.step
    per_s = along * clock.line_rate_hz / first.step
    by_speed, by_acceleration = state.course.derivatives(first_s, second_s)
    jacobian = np.stack(
        [
            per_s * by_speed,
            per_s * by_acceleration,
            state.gain * points.across,
            -points.value,
            -np.ones_like(residual),
        ]
    ).T  # each unknown's derivatives side by side in memory
    return Look(
        residual=residual.astype(float),
        jacobian=jacobian,
        inside=inside,
        first_s=first_s,
        second_s=second_s,
        along=along,
    )


def _scale(residual: Floats) -> float:
    return max(robust_scale(residual), 0.05) if len(residual) else 1.0


def _weights(observed: Look, block: NDArray[np.intp]) -> tuple[Floats, float]:
    """Tukey's weight of each pixel times that of its block, which falls where a whole block disagrees."""
    use, blocks = observed.inside, int(block.max()) + 1
    scale = _scale(observed.residual[use])
    part = np.clip(np.abs(observed.residual) / (TUKEY * scale), 0, 1)
    pixel = np.where(use, (1 - part**2) ** 2, 0.0)
    count = np.bincount(block, weights=use.astype(float), minlength=blocks)
    capped = np.minimum((observed.residual / scale) ** 2, 36.0) * use
    energy = np.bincount(block, weights=capped, minlength=blocks) / np.maximum(count, 1)
    known = count > 8
    usual = float(median(energy[known])[0]) if known.any() else 1.0
    trust = 1 / (1 + (energy / max(3 * usual, 1e-9)) ** 3)
    return pixel * trust[block], scale


def register(
    first: Sheet,
    second: Sheet,
    points: Points,
    clock: Clock,
    start: State,
    prior: Prior,
    block: NDArray[np.intp],
    free: tuple[bool, ...] = (True, True, True, True, True),
    cell: NDArray[np.intp] | None = None,
    most_rounds: int = ROUNDS,
) -> Fit:
    """Least squares from `start`; `block` (n,) groups the pixels, `free` says which of the five may move.

    With `cell` (n,), every cell has a gain and an offset of its own, and only the motion moves.

    CONVENTIONS.md, Line scan, and DECISIONS.md 19. Own method: Gauss-Newton on I2(row, t2) - gain I1(row, t1)
    - offset with t2 of t1 by the motion, weights by Tukey's biweight (Beaton and Tukey 1974) times those of
    whole blocks.
    """
    state, fit = start, None
    weight = np.ones(len(points))
    held = np.flatnonzero(~np.array(free)) if cell is None else np.array([2, 3, 4])
    moved, at = shift_sheet(second, state.shift), state.shift
    for _ in range(most_rounds):
        if abs(state.shift - at) > 5e-4:
            moved, at = shift_sheet(second, state.shift), state.shift
        observed = look(first, moved, points, clock, state)
        if cell is not None:
            observed = level_cells(observed, points.value, weight * observed.inside, cell)
        weight, scale = _weights(observed, block)
        normal, right = _normal(observed, weight, prior, state, scale)
        bound = normal.copy()
        bound[held], bound[:, held], right[held] = 0, 0, 0
        bound[held, held] = 1
        step = _solved(bound, right)
        small = abs(step[0]) < SETTLED * state.course.speed_mps and bool((np.abs(step[1:3]) < 2e-3).all())
        # the last look is one small step behind the state, which no uncertainty would notice
        state = apply_step(state, step)
        fit = Fit(
            state=state,
            look=observed,
            weight=weight,
            normal=normal,
            scale_dn=scale,
            last_step=step,
            settled=small,
        )
        if small:
            break
    assert fit is not None
    return fit


def scores(
    first: Sheet,
    moved: Sheet,
    points: Points,
    clock: Clock,
    state: State,
    fit: Fit,
    block: NDArray[np.intp],
    cell: NDArray[np.intp] | None = None,
) -> Floats:
    """(n, 5) what every pixel adds to the sums that are zero at the fit: weight, residual and derivative
    multiplied, all of them under `state`, near the fit's. `moved`: strip 2, shifted by the state's rows;
    `block`, `cell` (n,) as in `register`. Own method: the estimating function of DECISIONS.md 144.
    """
    observed, weight = look(first, moved, points, clock, state), fit.weight
    if cell is not None:
        weight, _ = _weights(level_cells(observed, points.value, weight * observed.inside, cell), block)
        observed = level_cells(observed, points.value, weight * observed.inside, cell)
    weight, _ = _weights(observed, block)
    return np.asarray(observed.jacobian * (weight * observed.residual)[:, None])


def level_cells(observed: Look, value: Floats, weight: Floats, cell: NDArray[np.intp]) -> Look:
    """The look with every cell's own gain and offset taken out of residuals and derivatives; `value`,
    `weight`, `cell` (n,).

    Behind a window each camera sees its own road, so an edge between paint and glass has another height in
    strip 2 than in strip 1; without this it would seem moved. Gain and offset drop out of the unknowns: all
    is replaced by what its weighted regression on (1, value) in the cell leaves (Frisch and Waugh 1933), a
    slope from next to no contrast held back by LEVEL_DN^2.
    """
    count = int(cell.max()) + 1

    def total(values: Floats) -> Floats:
        return np.asarray(np.bincount(cell, weights=values, minlength=count))

    mass = np.maximum(total(weight), 1e-9)
    mean = total(weight * value) / mass
    x = value - mean[cell]
    wx = weight * x
    power = total(wx * x) + LEVEL_DN**2

    def cleared(y: Floats) -> Floats:
        y = y - (total(weight * y) / mass)[cell]
        return np.asarray(y - x * (total(wx * y) / power)[cell])

    jacobian = observed.jacobian.copy(order="K")
    for k in range(3):
        jacobian[:, k] = cleared(jacobian[:, k])
    jacobian[:, 3:] = 0.0
    return replace(observed, residual=cleared(observed.residual), jacobian=jacobian)


def _normal(seen: Look, weight: Floats, prior: Prior, state: State, scale: float) -> tuple[Floats, Floats]:
    weighted = seen.jacobian * weight[:, None]
    normal = seen.jacobian.T @ weighted
    right = -weighted.T @ seen.residual
    if prior.u_shift is not None:
        trust = (scale / max(prior.u_shift, 1e-3)) ** 2
        normal[2, 2] += trust
        right[2] += trust * (prior.shift - state.shift)
    return np.asarray(normal), np.asarray(right)


def _solved(normal: Floats, right: Floats) -> Floats:
    size = np.sqrt(np.maximum(np.diag(normal), 1e-12))
    return np.asarray(np.linalg.lstsq(normal / np.outer(size, size), right / size, rcond=1e-12)[0] / size)


def apply_step(state: State, step: Floats) -> State:
    """The state after a `step` (5,), kept from leaving what a vehicle can do. Own method: limits of each."""
    most = most_step(state)
    speed, acceleration, shift, gain, offset = (float(one) for one in np.clip(step, -most, most))
    return State(
        Course(
            state.course.speed_mps + speed,
            float(np.clip(state.course.acceleration_mps2 + acceleration, -12, 12)),
            state.course.baseline_m,
        ),
        state.shift + shift,
        float(np.clip(state.gain + gain, *GAINS)),
        state.offset + offset,
    )


def most_step(state: State) -> Floats:
    """(5,) by which each of the unknowns moves at most in one step. Own method: limits of each."""
    return np.array([0.1 * abs(state.course.speed_mps), 3.0, 1.0, 0.3, 60.0])
