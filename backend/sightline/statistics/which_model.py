"""Which model a measured vehicle can be: known sizes ranked by how well they fit, and those that cannot."""

from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import ArrayLike

from sightline.arrays import Bools, Floats
from sightline.messages.said import Said

CANNOT_FIT_P = 0.001
SAME_CLASS = 0.9  # the share of vehicles whose class, as a person gave it, is that of their row (estimate)


@dataclass(frozen=True, eq=False)
class ModelFits:
    """How N models fit one vehicle of which K sizes were measured.

    `deviate` (N, K): difference over its u, NaN where the model's size is unknown. `chi_square`, `compared`,
    `p` (N,): sum of squared deviates, their number, and how rare the worst of so many is if the model is the
    right one (NaN, 0, NaN where nothing can be compared). `order`: indices of the models compared, the
    likeliest by the sizes that rank first. `ranks` (K,): sizes that rank, were measured and are stated by a
    model. `cannot` (N,): p below `CANNOT_FIT_P`.
    """

    deviate: Floats
    chi_square: Floats
    compared: Floats
    p: Floats
    order: tuple[int, ...]
    ranks: Bools
    cannot: Bools


def fit_models(
    measured_m: ArrayLike,
    u_measured_m: ArrayLike,
    sizes_m: ArrayLike,
    u_sizes_m: ArrayLike,
    same_class: ArrayLike | None = None,
    ranking: ArrayLike | None = None,
) -> ModelFits | Said:
    """Fit of N models' `sizes_m`, `u_sizes_m` (N, K) to `measured_m`, `u_measured_m` (K,), NaN where unknown,
    metres; or the reason why there is none. `same_class` (N,): 1 the vehicle's own class, 0 another, NaN
    unknown. `ranking` (K,): whether a size ranks; left out: all do.

    Ranked by normal likelihood of the sizes that rank, the class as a prior; models that these do not tell
    apart stay in the order given. A size that does not rank counts in p alone: a height that is held against
    a model must not choose that model. A size that a model does not state is taken as that of
    any model (mean and standard deviation of those that state it), so that silence is no merit. p is that of
    the largest deviate by Sidak 1967, which holds whatever errors the sizes have in common (one pose).
    """
    measured, u_measured = (np.asarray(one, dtype=np.float64) for one in (measured_m, u_measured_m))
    sizes = np.asarray(sizes_m, dtype=np.float64).reshape(-1, len(measured))
    u_sizes = np.asarray(u_sizes_m, dtype=np.float64).reshape(sizes.shape)
    used = np.isfinite(measured) & (u_measured > 0)
    if not used.any():
        return Said("models-nothing-measured")
    known = np.isfinite(sizes) & used
    compared = known.sum(axis=1)
    if not compared.any():
        return Said("models-no-such-size")
    variance = u_measured**2 + u_sizes**2
    deviate = np.where(known, (measured - sizes) / np.sqrt(variance), np.nan)
    score = np.where(known, deviate**2 + np.log(variance), _of_any(measured, u_measured, sizes, known))
    wanted = np.ones(len(measured)) if ranking is None else np.asarray(ranking)
    ranks = used & wanted.astype(np.bool_) & known.any(axis=0)
    total = np.where(ranks, score, 0.0).sum(axis=1) + _class_score(same_class, len(sizes))
    some = compared > 0
    worst = np.max(np.abs(np.where(known, deviate, 0.0)), axis=1)
    p = np.where(
        some, -np.expm1(compared * np.log1p(-2.0 * scipy.stats.norm.sf(np.maximum(worst, 1e-12)))), np.nan
    )
    ranked = [int(index) for index in np.argsort(total, kind="stable") if some[index]]
    return ModelFits(
        deviate=deviate,
        chi_square=np.where(some, np.nansum(deviate**2, axis=1), np.nan),
        compared=compared.astype(np.float64),
        p=np.asarray(p),
        order=tuple(ranked),
        ranks=ranks,
        cannot=some & (p < CANNOT_FIT_P),
    )


def _of_any(measured: Floats, u_measured: Floats, sizes: Floats, known: Bools) -> Floats:
    """What a size adds to the score of a model that does not state it, (K,); 0 where none does."""
    score = np.zeros(len(measured))
    for k in np.flatnonzero(known.any(axis=0)):
        stated = sizes[known[:, k], k]
        variance = u_measured[k] ** 2 + max(float(stated.var()), 0.01**2)
        score[k] = (measured[k] - stated.mean()) ** 2 / variance + np.log(variance)
    return score


def _class_score(same_class: ArrayLike | None, count: int) -> Floats:
    if same_class is None:
        return np.zeros(count)
    same = np.asarray(same_class, dtype=np.float64)
    share = np.where(same > 0, SAME_CLASS, 1.0 - SAME_CLASS)
    return np.asarray(np.where(np.isnan(same), 0.0, -2.0 * np.log(share)), dtype=np.float64)
