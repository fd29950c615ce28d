"""How well a registration knows its answer: from the scatter of pieces of the vehicle.

The answer solves sum psi(r) J = 0 (psi: Tukey's weight times residual r, J: r's derivatives as strip 1 shows
them), so its error is A^-1 times that sum, with A = sum psi'(r) J J2'. psi', not the weight: where the weight
falls, a residual says less (Huber 1981, ch. 6). J2 is J out of strip 2's own gradients: strip 1's hold the
noise by which its pixels were chosen, which makes J J' too large (Carroll et al. 2006, ch. 6, instruments).

The sum over a cluster of neighbouring pixels, which share what matters (a reflection, a window's edge), is
one observation (Liang and Zeger 1986). Clusters are few and those at the ends weigh most, so each is left
out in turn (jackknife, "CR3": MacKinnon and White 1985, Bell and McCaffrey 2002), and the result is widened
until 1.96 times it covers what Student's t covers. Of t's degrees of freedom there are as many as clusters of
equal information would be (Kish 1965): of a white van's fifteen, four may hold nearly all that is to be seen.
"""

from dataclasses import replace
from functools import lru_cache

import numpy as np
import scipy
from numpy.typing import NDArray

from sightline.coverage import COVERAGE_95
from sightline.linescan.masks import Points, Sheet, sampled, shifted, slopes_along
from sightline.linescan.registration import TUKEY, Clock, Fit, Prior, levelled

Array = NDArray[np.float64]
# rows up and down between which the slope across the lines is taken
_ROWS_APART = 0.25


def second_slopes(
    first: Sheet, second: Sheet, points: Points, clock: Clock, fit: Fit, cell: NDArray[np.intp] | None = None
) -> Array:
    """J2 (n, 5): the residuals' derivatives with the gradients of strip 2 in the place of strip 1's.

    `cell` (n,) as in `register`. They are the instruments of the errors-in-variables fit (Carroll et al.
    2006, ch. 6), and the splines' own: a difference of neighbours is smaller than the slope, its u too large.
    """
    state, seen = fit.state, fit.look
    lower, moved, upper = (shifted(second, state.shift + by) for by in (-_ROWS_APART, 0.0, _ROWS_APART))
    place = second.place(clock.lines(seen.second_s))
    row = points.row
    along = slopes_along(moved, place, row)
    across = (sampled(upper, place, row) - sampled(lower, place, row)) / (2 * _ROWS_APART)
    per_s = along * clock.line_rate_hz / second.step
    by_speed, by_acceleration = state.course.derivatives(seen.first_s, seen.second_s)
    columns = [per_s * by_speed, per_s * by_acceleration, across, -points.value, -np.ones_like(along)]
    slopes = np.stack(columns).T
    if cell is None:
        return slopes
    own = replace(seen, jacobian=slopes, along=along)
    return levelled(own, points.value, fit.weight * seen.inside, cell).jacobian


def covariance(fit: Fit, slopes: Array, cluster: NDArray[np.intp], free: int, prior: Prior) -> Array:
    """Covariance (free, free) of the first `free` unknowns, those that the fit solved for.

    `slopes` (n, 5) of `second_slopes`; `cluster` (n,): numbers of the pixels' clusters. With a prior of the
    row shift, that is one more observation. Clusters: Liang and Zeger 1986; psi': Huber 1981, ch. 6; each
    cluster left out in turn: MacKinnon and White 1985, Bell and McCaffrey 2002; then widened as Student's t
    is wider, for the effective number of clusters (Kish 1965).
    """
    size = np.sqrt(np.maximum((fit.look.jacobian**2 * fit.weight[:, None]).sum(axis=0), 1e-12))[:free]
    first, second = fit.look.jacobian[:, :free].T / size[:, None], slopes[:, :free].T / size[:, None]
    count = int(cluster.max()) + 1

    def total(values: Array) -> Array:
        return np.asarray(np.bincount(cluster, weights=values, minlength=count))

    used = total(fit.weight) > 0
    score = np.stack([total(fit.weight * fit.look.residual * one) for one in first], -1)[used]
    bent = _slope_of_weighted(fit)
    normal = np.stack([np.stack([total(bent * one * other) for other in second], -1) for one in first], 1)
    whole, known = normal.sum(axis=0), np.zeros((free, free))
    if prior.u_shift is not None and free > 2:
        trust = (fit.scale_dn / max(prior.u_shift, 1e-3) / size[2]) ** 2
        whole[2, 2] += trust
        known[2, 2] = (trust * prior.u_shift * size[2]) ** 2
    apart = _solved(whole - normal[used], score[:, :, None])[:, :, 0]
    inverse = _solved(whole, np.eye(free))
    groups = len(score)
    seen = widening(_effective(normal[used])) ** 2 * (groups - 1) / groups * apart.T @ apart
    return np.asarray((seen + inverse @ known @ inverse.T) / np.outer(size, size))


def _effective(normal: Array) -> float:
    """How many clusters of equal information are worth those of normal matrices (clusters, free, free); at
    least 1, in steps of a tenth.
    """
    told = np.maximum(np.trace(normal, axis1=1, axis2=2), 0.0)
    return max(round(float(told.sum() ** 2 / max(float((told**2).sum()), 1e-12)), 1), 1.0)


def _slope_of_weighted(fit: Fit) -> Array:
    """psi' (n,): the slope of Tukey's weight times residual, times the block's part of the weight."""
    share = np.minimum((fit.look.residual / (TUKEY * fit.scale_dn)) ** 2, 1 - 1e-6)
    return np.asarray(fit.weight * (1 - 5 * share) / (1 - share))


def _solved(normal: Array, right: Array) -> Array:
    try:
        return np.asarray(np.linalg.solve(normal, right))
    except np.linalg.LinAlgError:
        # nothing of the vehicle tells one of the unknowns
        return np.asarray(np.linalg.pinv(normal, rcond=1e-12) @ right)


@lru_cache(maxsize=64)
def widening(freedom: float) -> float:
    """By how much an uncertainty from so few observations is to be widened for a coverage of 95 %:
    Student's t over 1.96.
    """
    return float(scipy.stats.t.ppf(0.975, freedom) / COVERAGE_95)
