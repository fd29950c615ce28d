"""The density of true heights behind measured ones: what random error added to the spread is taken out.

Measured heights are true ones plus errors of known size, so their density is the true density smoothed by the
errors'. The logarithm of the true density is a penalised spline; smoothed by the errors' own distribution it
is fitted to counts on a grid (composite link model of Thompson & Baker 1981, penalised as in Eilers 2007).
The penalty is on third differences, so that what it tends to is the normal distribution with the sample's
mean and variance less the errors' (Silverman 1982): normal heights cost three parameters, and mixtures and
skewed ones keep their shape. Its weight is found with the fit (Fellner and Schall's step; Wood & Fasiolo
2017).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy
from numpy.typing import NDArray

from sightline.arrays import Floats

_CELLS_PER_SPREAD = 12
_MOST_CELLS = 400
_FINER = 10  # cells are divided into so many to read quantiles between them
_KNOTS_PER_SPREAD = 2.0
_MOST_KNOTS = 60
_PAD = 2.0  # spreads beyond the outermost values: as far as intervals of small samples reach
_STEPS = 60
_STILL, _STILL_WEIGHT, _LONGEST = 1e-5, 0.01, 2.0
_FIRST_WEIGHT, _WEIGHTS, _LIGHTER = 10.0, (1e-4, 1e7), 0.1  # of the penalty; large: a normal distribution
_LEAST_VALUES = 6
_MOST_PARTS = 8  # of a mixture of errors
LEAST_SPREAD = 1e-6  # metres; less is the rounding of equal values


@dataclass(frozen=True, eq=False)
class Noise:
    """One measurement's error: a mixture of normals around 0. sd_m, share: (L,) each, shares sum to 1."""

    sd_m: Floats
    share: Floats

    @property
    def variance_m2(self) -> float:
        """Variance of the mixture."""
        return float(np.sum(self.share * self.sd_m**2))


@dataclass(frozen=True, eq=False)
class SmoothDensity:
    """Density of true heights and of measured ones on a grid of M cells.

    spread_m: of the narrowest group of heights; edge_m: (M + 1,); true, measured: probability of each cell,
    (M,); influence: (M, K), change of the spline's coefficients by one more height among N in a cell, times
    N; true_slope, measured_slope: (M, K), change of the probabilities with them.
    """

    spread_m: float
    edge_m: Floats
    true: Floats
    measured: Floats
    influence: Floats
    true_slope: Floats
    measured_slope: Floats

    @cached_property
    def _true_below(self) -> tuple[Floats, Floats]:
        return _cumulative(self.edge_m, self.true)

    @cached_property
    def _measured_below(self) -> tuple[Floats, Floats]:
        return _cumulative(self.edge_m, self.measured)

    def cell_of(self, heights_m: Floats) -> NDArray[np.int64]:
        """The cell (N,) in which each of heights_m (N,) lies."""
        at = np.searchsorted(self.edge_m, heights_m, side="right") - 1
        return np.clip(at, 0, len(self.true) - 1)

    def measured_density(self, height_m: float) -> float:
        """Density of the measured heights, per metre."""
        return _density(self.edge_m, self.measured, height_m)

    def true_density(self, height_m: float) -> float:
        """Density of the true heights, per metre."""
        return _density(self.edge_m, self.true, height_m)

    def correction_m(self, p: float) -> float:
        """What is to be added to a percentile of the measured heights to have that of the true ones."""
        return float(_quantile(self._true_below, p) - _quantile(self._measured_below, p))

    def share_correction(self, limit_m: float) -> float:
        """What is to be added to the share of measured heights below a limit for that of the true ones."""
        return float(_share_below(self.edge_m, limit_m) @ (self.true - self.measured))

    def correction_influence_m(self, p: float, least: float = 0.0) -> Floats:
        """Influence (M,) of one height in each cell on `correction_m`; its mean is about 0.

        least: no density, 1/m, is taken for smaller.
        """
        true_at, measured_at = (float(_quantile(of, p)) for of in (self._true_below, self._measured_below))
        of_true = (
            _share_below(self.edge_m, true_at) @ self.true_slope / max(self.true_density(true_at), least)
        )
        below = _share_below(self.edge_m, measured_at)
        of_measured = below @ self.measured_slope / max(self.measured_density(measured_at), least)
        return np.asarray(self.influence @ (of_measured - of_true), dtype=np.float64)


def smooth_density(heights_m: Floats, noise: Noise, weight: Floats | None = None) -> SmoothDensity | None:
    """The density behind heights_m (N,), sorted, metres, that carry errors like `noise`; None for fewer than
    6 heights, and for heights without a spread. weight: (N,), how many vehicles each height stands for;
    they count as so many heights of equal weight as tell a mean as well (Kish 1965, 11.7).

    Penalised composite link model (Eilers 2007).
    """
    spread = _spread(heights_m)
    if len(heights_m) < _LEAST_VALUES or spread < LEAST_SPREAD:
        return None
    low, high = heights_m[0] - _PAD * spread, heights_m[-1] + _PAD * spread
    cells = min(int(np.ceil((high - low) / spread * _CELLS_PER_SPREAD)), _MOST_CELLS)
    edge = np.linspace(low, high, cells + 1)
    kernel = _kernel(noise, float(edge[1] - edge[0]), cells)
    knots = int(np.clip(np.ceil((high - low) / spread * _KNOTS_PER_SPREAD) + 4, 8, _MOST_KNOTS))
    basis = _basis(edge, knots)
    n = float(len(heights_m))
    if weight is not None:
        weight = weight * (weight.sum() / np.square(weight).sum())
        n = float(weight.sum())
    fit = _Fit(basis, kernel, np.histogram(heights_m, edge, weights=weight)[0].astype(np.float64))
    fit.solve(_normal(edge, heights_m, noise.variance_m2))
    gamma, mu, design = fit.model()
    true = gamma / gamma.sum()
    slope = true[:, None] * basis
    slope = slope - true[:, None] * slope.sum(axis=0)
    return SmoothDensity(
        spread_m=spread,
        edge_m=edge,
        true=true,
        measured=mu / mu.sum(),
        influence=n * scipy.linalg.cho_solve(fit.factor(mu, design), design.T).T,
        true_slope=slope,
        measured_slope=kernel @ slope,
    )


class _Fit:
    """Penalised likelihood of counts (M,) under exp(basis @ beta) smoothed by the errors' kernel (M, M)."""

    def __init__(self, basis: Floats, kernel: Floats, counts: Floats) -> None:
        self._basis, self._kernel, self._counts = basis, kernel, counts
        third = np.diff(np.eye(basis.shape[1]), 3, axis=0)
        self._rough = third.T @ third
        self._beta: Floats = np.zeros(basis.shape[1])
        self._weight = _FIRST_WEIGHT

    def solve(self, start: Floats) -> None:
        """Newton's steps from a density `start` (M,); with each the penalty's weight by its expectation, then
        a lighter one: a tenth of it costs a correction little scatter and takes half of its smoothing bias.
        """
        counted = float(self._counts.sum())
        self._beta = np.asarray(np.linalg.lstsq(self._basis, np.log(counted * start), rcond=None)[0])
        for _ in range(_STEPS):
            step, freedom = self._step()
            wanted = max(freedom - 3.0, 0.0) / max(float(self._beta @ self._rough @ self._beta), 1e-12)
            before, self._weight = self._weight, float(np.clip(wanted, *_WEIGHTS))
            if abs(np.log(self._weight / before)) < _STILL_WEIGHT and step < _STILL:
                break
        self._weight *= _LIGHTER
        for _ in range(_STEPS):
            if self._step()[0] < _STILL:
                break

    def _step(self) -> tuple[float, float]:
        """One step of beta: its largest part, and the fit's effective number of parameters."""
        _, mu, design = self.model()
        factor = self.factor(mu, design)
        gradient = design.T @ (self._counts - mu) - self._weight * (self._rough @ self._beta)
        step = scipy.linalg.cho_solve(factor, gradient)
        largest = float(np.abs(step).max())
        self._beta = self._beta + step * min(1.0, _LONGEST / max(largest, 1e-12))
        return largest, float(np.trace(scipy.linalg.cho_solve(factor, design.T @ (design * mu[:, None]))))

    def model(self) -> tuple[Floats, Floats, Floats]:
        """Expected counts without the errors (M,), with them (M,), slope of their logarithm (M, K)."""
        gamma = np.exp(np.clip(self._basis @ self._beta, -60.0, 60.0))
        mu = np.maximum(self._kernel @ gamma, 1e-12)
        return gamma, mu, (self._kernel @ (gamma[:, None] * self._basis)) / mu[:, None]

    def factor(self, mu: Floats, design: Floats) -> tuple[Floats, bool]:
        """Cholesky's factor of the penalised information (K, K)."""
        information = design.T @ (design * mu[:, None]) + self._weight * self._rough
        information[np.diag_indices_from(information)] += 1e-9
        found: tuple[Floats, bool] = scipy.linalg.cho_factor(information)
        return found


def _basis(edge: Floats, knots: int) -> Floats:
    """Cubic B-splines at the cells' centres, (M, knots)."""
    centre = 0.5 * (edge[1:] + edge[:-1])
    step = (edge[-1] - edge[0]) / (knots - 3)
    at = edge[0] + step * np.arange(-3, knots + 1)
    return np.asarray(
        scipy.interpolate.BSpline.design_matrix(centre, at, 3, extrapolate=True).toarray(), dtype=np.float64
    )


def _kernel(noise: Noise, cell_m: float, cells: int) -> Floats:
    """Probability (M, M) that an error moves a value from one cell to another."""
    reach = np.arange(cells) * cell_m
    row = np.zeros(cells)
    for sd, share in zip(noise.sd_m, noise.share, strict=True):
        if sd < 0.3 * cell_m:
            row[0] += share
        else:
            part = np.exp(-0.5 * (reach / sd) ** 2)
            row += share * part / (2 * part.sum() - part[0])
    return np.asarray(scipy.linalg.toeplitz(row), dtype=np.float64)


def _normal(edge: Floats, heights: Floats, noise_m2: float) -> Floats:
    """The normal density of the sample's mean and variance less the noise's, (M,): where a fit begins."""
    centre = 0.5 * (edge[1:] + edge[:-1])
    variance = float(heights.var())
    variance = max(variance - noise_m2, 0.2 * variance)
    density = np.exp(np.maximum(-0.5 * (centre - heights.mean()) ** 2 / variance, -30.0))
    return np.asarray(density / density.sum(), dtype=np.float64)


def _spread(ordered: Floats) -> float:
    """The smallest of three spreads of sorted values that agree for a normal distribution: the standard
    deviation, the quartiles', and the shortest half's, which a second group of vehicles does not widen.
    """
    n = len(ordered)
    if n < 2:
        return 0.0
    half = n // 2
    quartiles = np.quantile(ordered, [0.25, 0.75])
    of_quartiles = float(quartiles[1] - quartiles[0]) / 1.349
    shortest = float((ordered[half:] - ordered[: n - half]).min()) / 1.349
    found = [one for one in (float(ordered.std()), of_quartiles, shortest) if one > LEAST_SPREAD]
    return min(found, default=0.0)


def _fine(edge: Floats, share: Floats) -> tuple[Floats, Floats]:
    """Edges and probabilities of cells `_FINER` times finer: a cubic spline of the logarithm."""
    centre = 0.5 * (edge[1:] + edge[:-1])
    finer = np.linspace(edge[0], edge[-1], _FINER * len(share) + 1)
    log = scipy.interpolate.CubicSpline(centre, np.log(np.maximum(share, 1e-300)))(
        0.5 * (finer[1:] + finer[:-1])
    )
    return finer, np.exp(np.minimum(log, 0.0))


def _cumulative(edge: Floats, share: Floats) -> tuple[Floats, Floats]:
    """Heights (K,) and the share below each, rising, K at most the fine edges."""
    edge, share = _fine(edge, share)
    cumulative = np.concatenate([[0.0], np.cumsum(share)])
    cumulative /= cumulative[-1]
    rising = np.concatenate([[True], np.diff(cumulative) > 0])
    return edge[rising], cumulative[rising]


def _quantile(below: tuple[Floats, Floats], p: Floats | float) -> Floats:
    return np.asarray(np.interp(p, below[1], below[0]), dtype=np.float64)


def _density(edge: Floats, share: Floats, at: float) -> float:
    centre = 0.5 * (edge[1:] + edge[:-1])
    return max(float(np.interp(at, centre, share)) / float(edge[1] - edge[0]), 1e-9)


def _share_below(edge: Floats, at: float) -> Floats:
    """How much of each cell lies below a height, (M,), 0 to 1."""
    return np.clip((at - edge[:-1]) / np.diff(edge), 0.0, 1.0)


def noise_of(u_random_m: Floats, extra_m2: float, weight: Floats | None = None) -> Noise:
    """The errors of heights whose random parts are u_random_m (N,), metres, as a mixture of at most 8 normal
    ones; extra_m2: a variance that all of them carry besides; weight: (N,), of each height, None: all alike.

    Own method: parts of equal number in the order of u, each with its mean square, as heights weigh.
    """
    order = np.argsort(u_random_m, kind="stable")
    weight = np.ones(len(order)) if weight is None else weight
    parts: Sequence[NDArray[np.int64]] = np.array_split(order, min(_MOST_PARTS, len(order)))
    share = np.array([float(weight[one].sum()) for one in parts])
    squares = np.array([float(np.sum(weight[one] * u_random_m[one] ** 2)) for one in parts])
    there = share > 0.0  # some heights may weigh nothing
    return Noise(np.sqrt(squares[there] / share[there] + extra_m2), share[there] / share.sum())
