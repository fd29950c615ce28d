"""Total 95 % intervals of MAE, MSE, SD and shares of errors against known heights.

Each is of the figure that many such surveys would have on average: other vehicles, and other errors of what
heights share (road pose, mean inset), whose size the budgets state. Random errors of heights and those of the
known heights are in the differences of which the rows are a sample. Sites may differ by more than their
budgets say; what they are seen to differ by counts. An unknown bias of the method is part of the figures: the
shared errors of one pose may just have hidden it, so limits on its side are wide.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
import scipy

from sightline.arrays import Floats, Ints
from sightline.coverage import COVERAGE_95
from sightline.statistics.distributions import share_interval
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.sites import compact, excess_variance, sites_of

_TAIL = 0.025
_SEED = 20190403  # intervals of the same rows are the same numbers
_DRAWS = 1000
_LEAST_DRAWS = 200
_MOST_DRAWN = 100_000  # errors of cells that are drawn at once
_MANY = 40  # cells; a mean of so many has a normal distribution
_POOL = 1000  # errors that stand for all within cells
_NODES = 400
_STEPS, _FEW_STEPS = 12, 6


class Ends(NamedTuple):
    """A 95 % interval."""

    low: float
    high: float


@dataclass(frozen=True, eq=False)
class _Cells:
    """Rows (N,) in cells (C,) that share all of what they share: code (N,), weight (C,), mean_m (C,).

    moved_m: (D, C), draws of what the shared errors move each cell by; u_mean_m: what they move the mean of
    all by; own_m: (P,), errors about their cell's mean, each as likely.
    """

    code: Ints
    weight: Floats
    mean_m: Floats
    moved_m: Floats
    u_mean_m: float
    own_m: Floats


class ErrorTotals:
    """Total intervals of figures of errors error_m (N,), metres, N > 4; weight (N,): of each, None: alike.

    Own method: a figure is what sampling within cells and what shared errors make of it, and the limits of
    both are joined (method of variance estimates recovery, Zou & Donner 2008). Coverage by simulation:
    `tests/bench/bench_error_coverage.py`, DECISIONS.md 66.
    """

    def __init__(
        self,
        error_m: Floats,
        shared: Sequence[SharedErrors] = (),
        site: Ints | None = None,
        weight: Floats | None = None,
    ) -> None:
        share = np.ones(len(error_m)) if weight is None else weight
        self._error_m, self._share = error_m, np.asarray(share / share.sum(), np.float64)
        self._n = 1.0 / float(np.square(self._share).sum())
        self._cells = _cells(error_m, self._share, [*shared, *_of_sites(error_m, shared, site, weight)])
        self._noise = _deviates(1, len(self._cells.moved_m), 0)[:, 0]
        cells = self._cells
        away = float(np.abs(cells.mean_m).max()) + 2.0 * float(np.abs(cells.moved_m).max())
        self._node_m = np.linspace(-away, away, 2 * _NODES + 1) if away > 0.0 else np.array([-1e-6, 1e-6])

    def mse(self) -> Ends:
        """Of the mean squared error, m^2."""
        own_m2 = float(np.square(self._cells.own_m).mean())
        squares = np.square(self._error_m)
        return self._join_limits(
            squares,
            lambda d: np.asarray(d * d + own_m2, np.float64),
            lambda tail: self._sampled(squares, tail, True),
        )

    def mae(self) -> Ends:
        """Of the mean absolute error, metres."""
        at = np.abs(self._node_m[:, None] + self._cells.own_m).mean(axis=1)
        sizes = np.abs(self._error_m)
        return self._join_limits(
            sizes, self._interpolate_nodes(at), lambda tail: self._sampled(sizes, tail, False)
        )

    def share_within(self, limit_m: float) -> Ends:
        """Of the share of errors of at most limit_m, either way, 0 to 1."""
        beyond = np.asarray(np.abs(self._error_m) > limit_m, dtype=np.float64)
        at = (np.abs(self._node_m[:, None] + self._cells.own_m) > limit_m).mean(axis=1)
        value = self._mean(beyond)
        low, high = self._join_limits(
            beyond, self._interpolate_nodes(at), lambda tail: self._sampled_share(value, tail)
        )
        return Ends(max(1.0 - high, 0.0), min(1.0 - low, 1.0))

    def sd(self) -> Ends:
        """Of the standard deviation of the signed error, metres, among as many poses and sites as these."""
        cells, n = self._cells, self._n
        apart = np.square(self._error_m - self._mean(self._error_m))
        value = self._mean(apart) * n / (n - 1.0)
        low, high = self._sampled(apart * n / (n - 1.0), _TAIL, True)
        moved = np.square(cells.moved_m - (cells.moved_m @ cells.weight)[:, None]) @ cells.weight
        expected = float(moved.mean())
        if expected > 0.0:
            least, most = np.quantile(moved, [_TAIL, 1.0 - _TAIL])
            seen = float(cells.weight @ np.square(cells.mean_m - cells.weight @ cells.mean_m))
            low = value - np.hypot(value - low, seen * (1.0 - expected / most))
            high = value + np.hypot(high - value, expected - least)
        return Ends(float(np.sqrt(max(low, 0.0))), float(np.sqrt(high)))

    def _mean(self, of_rows: Floats) -> float:
        """The mean of values (N,), as they weigh. A product of vectors would hang on the threads of BLAS."""
        return float(np.sum(self._share * of_rows))

    def _interpolate_nodes(self, at: Floats) -> Callable[[Floats], Floats]:
        """A function of what moves a cell from its values `at` the nodes."""
        step = self._node_m[1] - self._node_m[0]

        def found(d: Floats) -> Floats:
            place = np.clip((d - self._node_m[0]) / step, 0.0, len(at) - 1.000001)
            low = place.astype(np.int64)
            return np.asarray(at[low] + (at[low + 1] - at[low]) * (place - low), np.float64)

        return found

    def _sampled(self, of_rows: Floats, tail: float, squares: bool) -> Ends:
        """Limits of a mean of positive values (N,) by sampling within cells, of its logarithm; of squares
        with Bonett's correction for few (Computational Statistics & Data Analysis 50, 2006).
        """
        value = self._mean(of_rows)
        sigma = self._sigma(of_rows)
        few = self._n / max(self._n - COVERAGE_95, 1.0)
        middle, sigma = (np.log(few), few * sigma) if squares else (sigma**2 / 2.0, sigma)
        below = float(scipy.special.ndtri(tail)) * sigma
        return Ends(
            float(value * np.exp(middle + below)), float(value * np.exp(middle + COVERAGE_95 * sigma))
        )

    def _sigma(self, of_rows: Floats) -> float:
        """Standard uncertainty of a mean of values (N,) by sampling within cells, as a part of it."""
        cells = self._cells
        mean = np.bincount(cells.code, self._share * of_rows) / cells.weight
        freedom = max(len(of_rows) - len(cells.weight), 1)
        apart = float(np.sum(np.square(self._share * (of_rows - mean[cells.code]))))
        found = np.sqrt(apart * len(of_rows) / freedom)
        return float(found / max(self._mean(of_rows), 1e-18))

    def _sampled_share(self, share: float, tail: float) -> Ends:
        """Limits of a share by sampling, exact (Clopper and Pearson 1934)."""
        n = max(round(self._n), 1)
        there = round(share * n)
        low = float(scipy.special.betaincinv(there, n - there + 1, tail)) if there else 0.0
        return Ends(low, share_interval(there, n)[1])

    def _join_limits(
        self, of_rows: Floats, given_m: Callable[[Floats], Floats], sampled: Callable[[float], Ends]
    ) -> Ends:
        """Limits of the mean of values (N,) that grow with an error; given_m: their mean in cells that are
        moved by so much, any shape; sampled: limits by sampling alone, with such a tail below.

        An unknown bias hardly lets the upper limit fail, so the lower one may fail as much more often.
        """
        cells = self._cells
        value = self._mean(of_rows)
        if not cells.moved_m.any():
            return sampled(_TAIL)
        bias = float(cells.weight @ cells.mean_m)
        moved = _Moved(given_m, cells.moved_m * (-1.0 if bias < 0.0 else 1.0), cells.weight, cells.u_mean_m)
        nearest = max(abs(bias) - COVERAGE_95 * cells.u_mean_m, 0.0)
        tail = 2.0 * _TAIL - min(moved.missed_above(nearest, self._sigma(of_rows), self._noise), _TAIL)
        low, high = sampled(tail)
        seen = float(given_m(cells.mean_m) @ cells.weight)
        below = max(seen - moved.lowest(seen, abs(bias), tail), 0.0)
        above = max(float(moved.highest(np.array([abs(bias)]))[0]) - seen, 0.0)
        return Ends(value - float(np.hypot(value - low, below)), value + float(np.hypot(high - value, above)))


@dataclass(frozen=True, eq=False)
class _Moved:
    """A figure under shared errors: given_m as in `_join_limits`; moved_m (D, C), weight, u_mean_m of
    `_Cells`.
    """

    given_m: Callable[[Floats], Floats]
    moved_m: Floats
    weight: Floats
    u_mean_m: float

    def drawn(self, bias_m: float, times: float = 1.0) -> Floats:
        """(D,) draws of the figure at a bias, the shared errors taken so many times."""
        return np.asarray(self.given_m(bias_m + times * self.moved_m) @ self.weight, np.float64)

    def highest(self, bias_m: Floats) -> Floats:
        """The figure at the largest bias that these seen biases (M,) leave possible."""
        return np.array([float(self.drawn(b + COVERAGE_95 * self.u_mean_m).mean()) for b in bias_m])

    def lowest(self, observed: float, bias_m: float, tail: float) -> float:
        """The least figure under which one as large as `observed` is not in the `tail` of the largest: with
        less of the shared errors or, if all of them are too few, with a bias up to bias_m.
        """
        levels: list[float] = []
        most: list[float] = []
        steps = _FEW_STEPS if len(self.weight) > _MANY else _STEPS
        for part in np.arange(2 * steps + 1) / steps:
            if part > 1.0 and (most[-1] >= observed or bias_m == 0.0):
                break
            drawn = self.drawn(bias_m * max(float(part) - 1.0, 0.0), min(float(part), 1.0))
            levels.append(float(drawn.mean()))
            most.append(_quantile(drawn, 1.0 - tail, len(self.weight)))
        return float(np.interp(observed, np.maximum.accumulate(most), levels))

    def missed_above(self, bias_m: float, sigma: float, noise: Floats) -> float:
        """How often the upper limit would lie below the figure at this bias; sigma: of sampling, a part of
        the figure; noise: (D,), deviates.
        """
        drawn = self.drawn(bias_m)
        seen = np.abs(bias_m + self.moved_m @ self.weight)
        steps = _FEW_STEPS if len(self.weight) > _MANY else _STEPS
        grid = np.linspace(0.0, float(seen.max()), steps)
        above = np.maximum(np.interp(seen, grid, self.highest(grid)) - drawn, 0.0)
        value = drawn * np.exp(sigma * noise - sigma**2 / 2.0)
        more = value * np.expm1(COVERAGE_95 * sigma + sigma**2 / 2.0)
        return float(np.mean(value + np.hypot(more, above) < drawn.mean()))


def _quantile(drawn: Floats, level: float, cells: int) -> float:
    if cells > _MANY:
        return float(drawn.mean() + scipy.special.ndtri(level) * drawn.std())
    return float(np.quantile(drawn, level))


def _deviates(columns: int, draws: int, seed: int) -> Floats:
    """(D, K) normal deviates, each column the same ones in another order (Latin hypercube)."""
    rng = np.random.default_rng([_SEED, seed])
    even = scipy.special.ndtri((np.arange(draws) + 0.5) / draws)
    return np.stack([rng.permutation(even) for _ in range(columns)], axis=1)


def _of_sites(
    error_m: Floats, shared: Sequence[SharedErrors], site: Ints | None, weight: Floats | None
) -> list[SharedErrors]:
    """What sites are seen to differ by beyond sampling and shared errors, as an error that each has."""
    sites = sites_of(site)
    if sites is None:
        return []
    sites = replace(sites, weight=weight)
    moved = [one.by_site_m(sites.code, len(sites.count), weight) for one in shared]
    extra = excess_variance(sites, error_m, moved)
    return [SharedErrors(sites.code, np.full(len(error_m), np.sqrt(extra)))] if extra > 0.0 else []


def _ranks(group: Ints, weight: Floats, told: Sequence[Floats]) -> Ints:
    """Numbers (C,) from 0 of the groups of cells, by their sums of what is told of cells, the last first: how
    groups were numbered, and so the order of rows, changes no draw.
    """
    _, column = np.unique(group, return_inverse=True)
    parts = [np.bincount(column, weight * one) for one in told]
    return np.argsort(np.lexsort([part.round(12) for part in parts]))[column]


def _cells(error_m: Floats, share: Floats, shared: Sequence[SharedErrors]) -> _Cells:
    code = np.zeros(len(error_m), np.int64)
    for one in shared:
        code = compact(code * (int(one.group.max()) + 2) + one.group + 1)
    weight = np.asarray(np.bincount(code, share), dtype=np.float64)
    count = np.asarray(np.bincount(code), dtype=np.float64)
    mean = np.bincount(code, share * error_m) / weight
    draws = max(min(_DRAWS, _MOST_DRAWN // len(weight)), _LEAST_DRAWS)
    moved = np.zeros((draws, len(weight)))
    groups = np.full((len(shared), len(weight)), -1)
    for k, errors in enumerate(shared):
        groups[k, code] = errors.group
    amounts = [np.ones(len(weight)), mean, np.bincount(code, share * error_m**2) / weight]
    told = [np.bincount(group + 1, weight * one)[group + 1] for group in groups for one in amounts]
    for k, (group, errors) in enumerate(zip(groups, shared, strict=True)):
        u = np.sqrt(np.bincount(code, share * errors.u_m**2) / weight)
        known = group >= 0
        if known.any():
            of_known = [one[known] for one in (*told, u, *amounts[::-1])]
            column = _ranks(group[known], weight[known], of_known)
            told.append(np.zeros(len(weight)))
            told[-1][known] = column
            moved[:, known] += _deviates(int(column.max()) + 1, draws, k + 1)[:, column] * u[known]
    several = count[code] > 1.0
    own = (error_m - mean[code]) * np.sqrt(count / np.maximum(count - 1.0, 1.0))[code]
    many = np.count_nonzero(several) > 4
    own = np.sort(own[several] if many else error_m - np.sum(share * error_m))
    if len(own) > _POOL:
        own = np.quantile(own, (np.arange(_POOL) + 0.5) / _POOL)
    return _Cells(
        code=code,
        weight=weight,
        mean_m=mean,
        moved_m=moved,
        u_mean_m=float((moved @ weight).std()),
        own_m=own,
    )
