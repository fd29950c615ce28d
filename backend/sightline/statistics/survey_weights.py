"""Weights that make a sample's classes weigh what they do in the fleet: post-stratification and raking."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats, Ints

_ROUNDS = 1000
_CLOSE = 1e-10
_RESIDUAL_ROUNDS = 100


@dataclass(frozen=True, eq=False)
class Margin:
    """The classes of one kind in the fleet: code (N,), 0 to K - 1, of each vehicle; share (K,), sums to 1."""

    code: Ints
    share: Floats

    def where(self, chosen: NDArray[np.bool_] | Ints) -> Margin:
        """The rows that are chosen, (N,) by truth or (M,) by number."""
        return Margin(self.code[chosen], self.share)


def calibrate_weights(weight: Floats, margins: Sequence[Margin]) -> Floats | None:
    """The weights (N,) nearest to `weight` (N,) under which every margin is met; their sum stays.

    One margin: post-stratification (Holt & Smith 1979), exact; several: raking (Deming & Stephan 1940), until
    every margin is met to 1e-10. None where no such weights are found: margins that contradict each other.
    """
    total = float(weight.sum())
    nearest = weight.astype(np.float64)
    for _ in range(_ROUNDS):
        for margin in margins:
            there = np.bincount(margin.code, nearest, minlength=len(margin.share))
            factor = np.divide(margin.share * total, there, out=np.zeros(len(there)), where=there > 0.0)
            nearest = nearest * factor[margin.code]
        if _largest_miss(nearest, margins) < _CLOSE:
            return np.asarray(nearest, dtype=np.float64)
    return None


def _largest_miss(weight: Floats, margins: Sequence[Margin]) -> float:
    total = float(weight.sum())
    misses = [
        np.abs(np.bincount(one.code, weight, minlength=len(one.share)) / total - one.share).max()
        for one in margins
    ]
    return float(max(misses, default=0.0))


def left_of_squares(weight: Floats, site: Ints, margins: Sequence[Margin]) -> tuple[Floats, Floats, Ints]:
    """What the means of sites and of the margins' classes, estimated of the heights themselves, leave of each
    height: of the mean of its squared deviation, (N,); of one degree of freedom, (N,); and its cell (N,), the
    heights of its site and classes. weight, site: (N,), codes from 0.

    Of least squares with these weights: with H the matrix that predicts heights of variance 1, the diagonals
    of (1 - H)(1 - H)' and of 1 - H (Bell & McCaffrey 2002).
    """
    codes = [site, *(one.code for one in margins)]
    groups, cell = np.unique(np.stack(codes, axis=1), axis=0, return_inverse=True)
    cell = np.asarray(cell, dtype=np.int64).reshape(-1)
    starts = np.cumsum([0, *(int(one.max()) + 1 for one in codes)])
    is_of = np.zeros((len(groups), int(starts[-1])))
    for n, start in enumerate(starts[:-1]):
        is_of[np.arange(len(groups)), start + groups[:, n]] = 1.0
    of_cell, squares = np.bincount(cell, weight), np.bincount(cell, weight**2)
    solved = is_of @ np.linalg.pinv(is_of.T @ (of_cell[:, None] * is_of), hermitian=True)
    leverage = weight * np.sum(solved * is_of, axis=1)[cell]
    both = np.sum((solved @ (is_of.T @ (squares[:, None] * is_of))) * solved, axis=1)[cell]
    return np.maximum(1.0 - 2.0 * leverage + both, 0.0), np.maximum(1.0 - leverage, 0.0), cell


def residuals(values: Floats, weight: Floats, margins: Sequence[Margin]) -> Floats:
    """What of `values` (N,) the margins do not explain, (N,), under `weight` (N,): the influence of a vehicle
    on a figure whose weights were made to meet them (Deville & Särndal 1992), by turns until it stands.
    """
    unexplained = values
    of_class = [np.bincount(one.code, weight, minlength=len(one.share)) for one in margins]
    for _ in range(_RESIDUAL_ROUNDS if len(margins) > 1 else 1):
        largest = 0.0
        for margin, there in zip(margins, of_class, strict=True):
            mean = np.bincount(margin.code, weight * unexplained, minlength=len(margin.share))
            mean = np.divide(mean, there, out=np.zeros(len(mean)), where=there > 0.0)
            unexplained = unexplained - mean[margin.code]
            largest = max(largest, float(np.abs(mean).max(initial=0.0)))
        if len(margins) < 2 or largest < _CLOSE * max(float(np.abs(values).max(initial=0.0)), 1e-300):
            break
    return unexplained
