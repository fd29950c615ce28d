"""Which observations do not belong to the rest: tests of every point, every known length and every stated
error.

Data snooping (Baarda 1968): a residual v over its own standard uncertainty, which is that of the
observation less what the adjustment took up of it. Whatever fails is left out, worst first, and everything
is solved again.
"""

import math
from dataclasses import dataclass

import numpy as np

from sightline.adjustment.least_squares import Solution, Weights, solve
from sightline.adjustment.observed import LENGTHS
from sightline.adjustment.shared_errors import SharedErrors
from sightline.adjustment.traffic_model import Traffic
from sightline.arrays import Bools, Floats

FAILED = 3.29  # of a normal deviate: 1 in 1000 good ones fails
_POINT_FAILED = -2.0 * math.log(1e-5)  # chi-square of two coordinates; there are thousands of points
_TESTABLE = 1e-3  # below this share of its variance nothing checks an observation
_MOST_POINTS = 0.25  # of a pass; with more bad ones it is left out
_ROUNDS = 40
_RESCALINGS = 3
_MEDIAN_ABS = 0.6745  # of a normal deviate
_MEDIAN_CHI2 = 2.0 * math.log(2.0)  # of two coordinates


@dataclass(frozen=True, eq=False)
class Tests:
    """Deviates that a normal one should be: `lengths` (P, 3), `parts` (number of parts), and chi-squares of 2
    degrees of freedom `points` (N,). NaN where nothing checks it.
    """

    points: Floats
    lengths: Floats
    parts: Floats


@dataclass(frozen=True, eq=False)
class Cleaned:
    """The solution without what fails: `dropped` points (N,), `wrong` lengths (P, 3) of passes left out,
    `crooked` passes (P,) whose points do not fit, `released` indices of parts. `point_factor`: how much
    larger the points' scatter is than stated; `length_factors` the same of wheelbases and roofs.
    """

    solution: Solution
    weights: Weights
    tests: Tests
    dropped: Bools
    wrong: Floats
    crooked: Bools
    released: tuple[int, ...]
    point_factor: float
    length_factors: Floats


def tests_of(shared: SharedErrors, traffic: Traffic, solution: Solution, weights: Weights) -> Tests:
    """All local tests of one solution.

    Baarda 1968: Q_vv = 1 - A (A'A)^-1 A' for whitened observations, here with the passes eliminated.
    """
    at = solution.at
    taken = at.own @ solution.pass_covariance
    left = at.shared - taken @ (np.swapaxes(at.own, 1, 2) @ at.shared)
    spread = left @ solution.covariance
    first = at.residual.shape[1] - len(LENGTHS)
    diagonal = 1.0 - (taken * at.own).sum(axis=2) - (spread * left).sum(axis=2)
    share = diagonal[:, first:]
    with np.errstate(all="ignore"):
        lengths = np.where(share > _TESTABLE, at.residual[:, first:] / np.sqrt(share), np.nan)
    lengths[weights.lengths == 0] = np.nan
    lengths[~np.isfinite(traffic.u_m)] = np.nan
    return Tests(
        points=_of_points(traffic, solution, weights, taken, left, spread),
        lengths=lengths,
        parts=_of_parts(shared, solution, weights),
    )


def _of_points(
    traffic: Traffic, solution: Solution, weights: Weights, taken: Floats, left: Floats, spread: Floats
) -> Floats:
    """v' Q_vv^+ v of each point's coordinates, by the directions that are checked at all, as of 2 degrees."""
    rows = 2 * traffic.slot[:, None] + np.arange(2)
    where = traffic.owner[:, None], rows
    own, mine = solution.at.own[where], taken[where]
    variance = np.eye(2) - mine @ np.swapaxes(own, 1, 2) - spread[where] @ np.swapaxes(left[where], 1, 2)
    values, vectors = np.linalg.eigh(0.5 * (variance + np.swapaxes(variance, 1, 2)))
    along = np.einsum("nij,ni->nj", vectors, solution.at.residual[where])
    checked = values > _TESTABLE
    with np.errstate(all="ignore"):
        out = np.where(checked, along**2 / values, 0.0).sum(axis=1)
    out[(weights.points == 0) | ~checked.any(axis=1)] = np.nan
    return np.asarray(out, dtype=np.float64)


def _of_parts(shared: SharedErrors, solution: Solution, weights: Weights) -> Floats:
    first = shared.first_part
    prior = weights.prior[first:]
    share = 1.0 - prior * np.diag(solution.covariance)[first:]
    u = np.array([part.u for part in shared.parts])
    with np.errstate(all="ignore"):
        out = solution.z[first:] * np.sqrt(prior) / np.sqrt(share)
    return np.where((share > _TESTABLE) & (u > 0), out, np.nan)


def solve_without_outliers(shared: SharedErrors, traffic: Traffic) -> Cleaned:
    """Solve, leave out the worst that fails, solve again, until nothing does; passes that lose a known length
    are left out whole, for a wrong model is wrong in all its lengths.

    Baarda 1968, with scatter that is larger than stated estimated first, from medians (Huber 1981), so that
    careless sigmas do not throw out the traffic.
    """
    state = _State(shared, traffic)
    state.solve()
    for attempt in range(_RESCALINGS):
        if not state.rescale() and attempt > 0:
            break
        for _ in range(_ROUNDS):
            if not state.leave_out():
                break
    return state.result()


class _State:
    """What is left out so far, and the solution without it."""

    def __init__(self, shared: SharedErrors, traffic: Traffic) -> None:
        self.shared, self.traffic = shared, traffic
        self.dropped = np.zeros(len(traffic.owner), dtype=bool)
        self.crooked = np.zeros(traffic.passes, dtype=bool)
        self.wrong = np.full((traffic.passes, len(LENGTHS)), np.nan)
        self.point_factor, self.length_factors = 1.0, np.ones(len(LENGTHS))
        self.prior = np.ones(shared.size)
        self.released: list[int] = []
        self.last: Solution | None = None

    @property
    def out(self) -> Bools:
        """Which passes are left out, (P,)."""
        return np.asarray(self.crooked | np.isfinite(self.wrong).any(axis=1), dtype=np.bool_)

    def solve(self) -> None:
        out = self.out
        points = np.where(self.dropped | out[self.traffic.owner], 0.0, 1.0 / self.point_factor)
        lengths = np.where(out[:, None], 0.0, 1.0 / self.length_factors)
        self.weights = Weights(points, lengths, self.prior)
        start = None if self.last is None else (self.last.z, self.last.unknown)
        self.last = solve(self.shared, self.traffic, self.weights, start)
        self.tests = tests_of(self.shared, self.traffic, self.last, self.weights)

    def rescale(self) -> bool:
        """Set the scatter beyond what was stated, told from medians that a few wrong ones do not move, and
        solve again; False where it is as it was.
        """
        points = np.sqrt(self.tests.points[np.isfinite(self.tests.points)] / _MEDIAN_CHI2)
        factors = [_factor(points * self.point_factor)]
        for k in range(len(LENGTHS)):
            told = np.abs(self.tests.lengths[:, k]) * self.length_factors[k]
            factors.append(_factor(told[np.isfinite(told)] / _MEDIAN_ABS))
        if np.allclose(factors, [self.point_factor, *self.length_factors], rtol=0.02):
            return False
        self.point_factor, self.length_factors = factors[0], np.array(factors[1:])
        self.solve()
        return True

    def leave_out(self) -> bool:
        """Take the worst out and solve again; False where nothing fails."""
        parts = np.abs(np.nan_to_num(self.tests.parts))
        for index, part in enumerate(self.shared.parts):
            if part.released_u is None or index in self.released:
                parts[index] = 0.0
        lengths = np.abs(np.nan_to_num(self.tests.lengths))
        points = np.nan_to_num(self.tests.points)
        worst = max(parts.max(), lengths.max())
        if worst <= FAILED and points.max() <= _POINT_FAILED:
            return False
        if parts.max() == worst > FAILED:
            self._release(int(np.argmax(parts)))
        elif worst > FAILED:
            bad = (lengths > max(FAILED, 0.7 * worst)).any(axis=1)
            self.wrong[bad] = np.where(lengths[bad] > FAILED, self.tests.lengths[bad], np.nan)
        self._drop_points(points)
        self.solve()
        return True

    def _release(self, index: int) -> None:
        part = self.shared.parts[index]
        allowed = max(part.released_u or 0.0, part.u)
        self.prior = self.prior.copy()
        self.prior[self.shared.first_part + index] = (part.u / allowed) ** 2
        self.released.append(index)

    def _drop_points(self, points: Floats) -> None:
        """Of each pass the worst point that fails; a pass that would lose too many is left out."""
        worst = np.zeros(self.traffic.passes)
        np.maximum.at(worst, self.traffic.owner, points)
        mine = worst[self.traffic.owner]
        self.dropped |= (points > _POINT_FAILED) & (points >= mine)
        lost = np.bincount(self.traffic.owner, self.dropped, self.traffic.passes)
        count = np.bincount(self.traffic.owner, minlength=self.traffic.passes)
        self.crooked |= lost > np.maximum(_MOST_POINTS * count, 1.0)

    def result(self) -> Cleaned:
        assert self.last is not None
        return Cleaned(
            solution=self.last,
            weights=self.weights,
            tests=self.tests,
            dropped=self.dropped,
            wrong=self.wrong,
            crooked=self.crooked,
            released=tuple(self.released),
            point_factor=self.point_factor,
            length_factors=self.length_factors,
        )


def _factor(scatter: Floats) -> float:
    """The median of `scatter` (N,), 1 expected, where it is larger beyond chance (3.5 x 1.17 / root n)."""
    if len(scatter) < 8:
        return 1.0
    median = float(np.median(scatter))
    return median if median > 1.0 + 3.5 * 1.17 / np.sqrt(len(scatter)) else 1.0
