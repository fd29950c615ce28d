"""Repeatability and reproducibility of repeated heights and clicks (gauge R&R by variance components).

Model of repeated values: y = item + person + e. An item is one target of one vehicle on one frame; its own
value is of no interest here and taken as fixed. `person` is random with variance s_p^2 (reproducibility: what
another person adds), e with s_e^2 (repeatability: what clicking again adds).

Any number of repeats in any cell will do. With the items projected out, Z'MZ = U diag(c) U' turns the person
sums into independent t_i ~ N(0, s_e^2 + c_i s_p^2), i = 1..s, independent of the residual sum of squares
SSE ~ s_e^2 chi2_f (Harville & Fenech, Biometrics 41, 1985, 137). From these
  s_e^2 = SSE / f with its exact chi-square interval, and
  s_p^2 = (sum t_i^2 - s s_e^2) / sum c_i, unbiased (Henderson's method 3; for balanced data the ANOVA's),
with the interval of the generalised pivot: sum t_i^2 / (s_e^2 + c_i s_p^2) is chi2_s (Weerahandi 1995).

Left out: e is taken as equally large everywhere, though in metres it grows with the distance; a person's
leaning that differs from vehicle to vehicle counts as e (`interaction_p` tells when it shows).
"""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from sightline.arrays import Floats
from sightline.messages.said import Said

Codes = NDArray[np.intp]

LEAST_FREEDOM = 5  # below this the 95 % interval of a standard deviation spans a factor of six
_LEVEL = 0.95
_LOG2_DRAWS = 11
_STEPS = 30
_SEED = 20190403  # intervals of the same rows are the same numbers


@dataclass(frozen=True)
class Spread:
    """A standard deviation with its 95 % interval, in the unit of the values; or why there is none.

    freedom: degrees of freedom that it rests on.
    """

    sd: float | None
    low: float | None
    high: float | None
    freedom: int
    reason: Said | None = None


@dataclass(frozen=True)
class Gauge:
    """What repeats say. n values of `items` items that were repeated, by `persons` persons.

    person_variance: the unbiased estimate behind `reproducibility`, negative where chance made it so (its sd
    is then 0); interaction_p: probability of persons' leanings differing from item to item as much as they
    do by chance, None where nobody repeated enough of their own.
    """

    n: int
    items: int
    persons: int
    repeatability: Spread
    reproducibility: Spread
    person_variance: float | None = None
    interaction_p: float | None = None


def codes_of(labels: Sequence[Hashable]) -> Codes:
    """Integers (N,) from 0 that name equal labels alike."""
    known: dict[Hashable, int] = {}
    return np.array([known.setdefault(label, len(known)) for label in labels], dtype=np.intp)


def no_spread(reason: Said, freedom: int = 0) -> Spread:
    """A standard deviation that is not there, and why."""
    return Spread(None, None, None, freedom, reason)


def spread_of(sum_of_squares: float, freedom: int, few: Said) -> Spread:
    """The standard deviation of a sum of squares with its exact interval; `few`: the reason if too few."""
    if freedom < LEAST_FREEDOM:
        return no_spread(few, freedom)
    low, high = scipy.stats.chi2.ppf([(1 + _LEVEL) / 2, (1 - _LEVEL) / 2], freedom)
    sd, low, high = (float(np.sqrt(sum_of_squares / by)) for by in (freedom, low, high))
    return Spread(sd, low, high, freedom)


def within_cells(values: ArrayLike, cells: Codes) -> tuple[float, int]:
    """(sum of squares about each cell's mean, degrees of freedom); `values` (N,) or (N, coordinates), `cells`
    (N,).

    CONVENTIONS.md, Repeats: sum (x - mean of its cell)^2 with (N - number of cells) times coordinates degrees
    of freedom. The sum has the square of the values' unit.
    """
    if not len(cells):
        return 0.0, 0
    rows = np.asarray(values, dtype=np.float64).reshape(len(cells), -1)
    centred = _centred(rows, cells)
    return float(np.square(centred).sum()), (len(cells) - len(np.unique(cells))) * rows.shape[1]


def gauge(values: ArrayLike, items: Codes, persons: Codes) -> Gauge:
    """Repeatability and reproducibility of values that were measured again.

    CONVENTIONS.md, Repeats: Henderson 1953 (method 3), Harville and Fenech 1985, Weerahandi 1995; the module
    has the equations.

    Parameters
    ----------
    values : (N,) array
        In any unit.
    items, persons : (N,) array of int
        Codes from 0: what was measured, and by whom. Items with a single value say nothing and are left out.

    Returns
    -------
    Gauge
        Standard deviations with their 95 % intervals, in the values' unit. Never raises for few repeats: a
        figure that they cannot give has its reason.

    Examples
    --------
    >>> import numpy as np, sightline
    >>> values_m = [1.450, 1.452, 1.449, 1.500, 1.503, 1.501, 1.380, 1.381, 1.379]
    >>> found = sightline.gauge(values_m, np.repeat([0, 1, 2], 3), np.array([0, 0, 1, 0, 1, 1, 0, 1, 0]))
    >>> round(found.repeatability.sd, 4), found.persons
    (0.0015, 2)
    """
    y = np.asarray(values, dtype=np.float64)
    often = np.bincount(items, minlength=1)[items] > 1 if len(items) else np.zeros(0, dtype=bool)
    y, item, person = y[often], items[often], persons[often]
    counts = (len(y), len(np.unique(item)), len(np.unique(person)))
    if not counts[0]:
        nothing = no_spread(Said("repeats-nothing-yet"))
        return Gauge(*counts, nothing, nothing)
    scale, squares = _persons_part(y, item, person)
    within = _centred(y[:, None], item)[:, 0]
    residual = max(float(np.square(within).sum()) - float(squares.sum()), 0.0)
    freedom = counts[0] - counts[1] - len(scale)
    few = Said("repeats-few", freedom=max(freedom, 0), least=LEAST_FREEDOM)
    repeatability = spread_of(residual, freedom, few)
    if not len(scale):  # said before "too few": more repeats of one person would not help
        alone = no_spread(Said("repeats-one-operator"))
        return Gauge(*counts, repeatability, alone)
    if repeatability.sd is None:
        return Gauge(*counts, repeatability, no_spread(few, len(scale)))
    variance = float((squares.sum() - len(scale) * repeatability.sd**2) / scale.sum())
    low, high = _pivot_interval(scale, squares, residual, freedom)
    between = Spread(float(np.sqrt(max(variance, 0.0))), low, high, len(scale))
    if high <= 0:  # an interval from 0 to 0 would claim what nobody knows
        between = no_spread(Said("repeats-no-difference"), len(scale))
    return Gauge(
        *counts, repeatability, between, variance, _interaction_p(y, item, person, residual, freedom)
    )


def _centred(rows: Floats, cells: Codes) -> Floats:
    """Rows (N, k) minus the mean row of their cell."""
    _, cell = np.unique(cells, return_inverse=True)
    sums = np.zeros((int(cell.max()) + 1, rows.shape[1]))
    np.add.at(sums, cell, rows)
    return np.asarray(rows - sums[cell] / np.bincount(cell)[cell, None], dtype=np.float64)


def _persons_part(y: Floats, item: Codes, person: Codes) -> tuple[Floats, Floats]:
    """(c_i, t_i^2) both (s,): see the module; s = 0 where no two persons share an item."""
    _, column = np.unique(person, return_inverse=True)
    shares = _centred(np.eye(int(column.max()) + 1)[column], item)
    scale, turn = np.linalg.eigh(shares.T @ shares)
    kept = scale > 1e-9 * max(float(scale.max()), 1.0)
    sums = turn[:, kept].T @ (shares.T @ y)
    return np.asarray(scale[kept]), np.asarray(np.square(sums) / scale[kept])


def _pivot_interval(scale: Floats, squares: Floats, residual: float, freedom: int) -> tuple[float, float]:
    """The 95 % interval of the persons' sd from the generalised pivot, on a fixed low-discrepancy sample."""
    by, want = _pivots(freedom, len(scale))
    clicks = residual / by
    alone = (squares / want[:, None] - clicks[:, None]) / scale  # the roots of each term by itself
    variance = np.maximum(alone.max(axis=1), 0.0)
    for _ in range(_STEPS):  # Newton from below: the sum is convex and falls, so no step goes too far
        total = clicks[:, None] + scale * variance[:, None]
        excess = (squares / total).sum(axis=1) - want
        step = np.maximum(excess / (squares * scale / np.square(total)).sum(axis=1), 0.0)
        variance += step
        if (step <= 1e-9 * variance).all():
            break
    ends = np.quantile(variance, [(1 - _LEVEL) / 2, (1 + _LEVEL) / 2])
    return float(np.sqrt(max(ends[0], 0.0))), float(np.sqrt(max(ends[1], 0.0)))


@lru_cache(maxsize=32)
def _pivots(freedom: int, more: int) -> tuple[Floats, Floats]:
    """Chi-square values of the two freedoms that stand for all their possible pairs."""
    draws = scipy.stats.qmc.Sobol(2, rng=np.random.default_rng(_SEED)).random_base2(_LOG2_DRAWS)
    return scipy.stats.chi2.ppf(draws[:, 0], freedom), scipy.stats.chi2.ppf(draws[:, 1], more)


def _interaction_p(y: Floats, item: Codes, person: Codes, residual: float, freedom: int) -> float | None:
    """F test of the residual between cells against that within them; None with too few of either."""
    own, of_own = within_cells(y, codes_of(list(zip(item.tolist(), person.tolist(), strict=True))))
    if of_own < LEAST_FREEDOM or freedom - of_own < 1 or own <= 0:
        return None
    ratio = max(residual - own, 0.0) / (freedom - of_own) / (own / of_own)
    return float(scipy.stats.f.sf(ratio, freedom - of_own, of_own))


@dataclass(frozen=True)
class UncertaintyCheck:
    """Observed scatter of repeats over the scatter that their budgets claim, with its 95 % interval.

    claimed: root mean square of the claims; observed: standard deviation of the values within items, both in
    the unit of the values. Where claims differ, `ratio` is not observed over claimed: each deviation counts
    in its own u.
    """

    ratio: float | None
    low: float | None
    high: float | None
    claimed: float | None
    observed: float | None
    freedom: int
    reason: Said | None = None


def uncertainty_check(values: ArrayLike, u_clicks: ArrayLike, items: Codes) -> UncertaintyCheck:
    """Whether `values` (N,) of `items` (N,) scatter as their click parts `u_clicks` (N,) say; in the values'
    unit.

    ratio^2 = sum ((y - weighted mean of its item) / u)^2 / freedom (Birge 1932), which is chi2 / freedom
    where the claim is right. Too few repeats give a reason.

    Only the clicks belong in `u_clicks`: lens, pose, board and inset are the same for all values of an item
    (same frame, same pose), shift them alike and cancel in their differences; the clicks do not
    (CONVENTIONS.md, Repeats).
    """
    y, u = np.asarray(values, dtype=np.float64), np.asarray(u_clicks, dtype=np.float64)
    usable = np.isfinite(u) & (u > 0)
    y, u, items = y[usable], u[usable], items[usable]
    freedom = len(y) - len(np.unique(items))
    if freedom < LEAST_FREEDOM:
        few = Said("repeats-few-to-compare", freedom=freedom, least=LEAST_FREEDOM)
        return UncertaintyCheck(
            ratio=None, low=None, high=None, claimed=None, observed=None, freedom=freedom, reason=few
        )
    _, item = np.unique(items, return_inverse=True)
    weights = 1 / np.square(u)
    means = np.bincount(item, weights * y) / np.bincount(item, weights)
    total = float((weights * np.square(y - means[item])).sum())
    spread = spread_of(total, freedom, Said("repeats-nothing-yet"))
    assert spread.sd is not None
    often = np.bincount(item)[item] > 1
    claimed = float(np.sqrt(np.mean(np.square(u[often]))))
    return UncertaintyCheck(
        ratio=spread.sd,
        low=spread.low,
        high=spread.high,
        claimed=claimed,
        observed=float(np.sqrt(within_cells(y, item)[0] / freedom)),
        freedom=freedom,
    )
