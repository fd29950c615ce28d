"""How well a registration knows its answer: from the scatter of pieces of the vehicle.

The answer solves sum psi(r) J = 0 (psi: weight times residual r, J: r's derivatives as strip 1 shows them),
so its error is A^-1 times that sum, A being the sum's own derivative by the unknowns. A is taken by
differences: strip 2's own gradients are in it, where strip 1's hold the noise by which its pixels were chosen
(Carroll et al. 2006, ch. 6), the falling weights of pixels (Huber 1981, ch. 6) and of whole blocks, and every
cell's own gain and offset.

The sum over a cluster of neighbouring pixels, which share what matters (a reflection, a window's edge), is
one observation (Liang and Zeger 1986). Clusters are few and those at the ends weigh most, so each is left
out in turn (jackknife, "CR3": MacKinnon and White 1985, Bell and McCaffrey 2002), and the result is widened
until 1.96 times it covers what Student's t covers. Of t's degrees of freedom there are as many as clusters of
equal information would be (Kish 1965): of a white van's fifteen, four may hold nearly all that is to be seen.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import scipy
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.coverage import COVERAGE_95
from sightline.linescan.masks import Points, Sheet, shift_sheet
from sightline.linescan.registration import Clock, Fit, Prior, apply_step, most_step, scores

# about as wide as neighbouring pixels' noise, which is not their own, makes u
STEPS = 4.0


@dataclass(frozen=True, eq=False)
class Slopes:
    """Of every pixel: what it adds to the sums (n, free) that are zero at the fit, and their derivatives
    (n, free, free), each times the `step` (free,) of its unknowns.
    """

    score: Floats
    slope: Floats
    step: Floats


def slopes_of(
    first: Sheet,
    second: Sheet,
    points: Points,
    clock: Clock,
    fit: Fit,
    block: NDArray[np.intp],
    free: int,
    cell: NDArray[np.intp] | None = None,
) -> Slopes:
    """Central differences by the first `free` unknowns, those that the fit solved for (DECISIONS.md 144).

    `block` and `cell` (n,) as in `register`. A step is STEPS times the standard uncertainty that the unknown
    would have if every pixel's noise were its own; with 1 and with 6 times u comes out the same within a
    hundredth.
    """
    size = np.sqrt(np.maximum((fit.look.jacobian**2 * fit.weight[:, None]).sum(axis=0), 1e-12))
    step = np.minimum(STEPS * fit.scale_dn / size, most_step(fit.state))
    # most looks share the fit's own shift
    moved = dict[float, Sheet]()

    def at(by: Floats) -> Floats:
        state = apply_step(fit.state, by)
        if state.shift not in moved:
            moved[state.shift] = shift_sheet(second, state.shift)
        every = scores(first, moved[state.shift], points, clock, state, fit, block, cell)
        return np.asarray(every[:, :free] * step[:free])

    steps = np.diag(step)[:free]
    slope = np.stack([(at(one) - at(-one)) / 2 for one in steps], axis=-1)
    return Slopes(at(np.zeros(5)), slope, step[:free])


def covariance(slopes: Slopes, cluster: NDArray[np.intp], fit: Fit, prior: Prior) -> Floats:
    """Covariance (free, free) of the unknowns of `slopes`.

    `cluster` (n,): numbers of the pixels' clusters. With a prior of the row shift, that is one more
    observation. Clusters: Liang and Zeger 1986; psi': Huber 1981, ch. 6; each cluster left out in turn:
    MacKinnon and White 1985, Bell and McCaffrey 2002; then widened as Student's t is wider, for the effective
    number of clusters (Kish 1965).
    """
    free, step = len(slopes.step), slopes.step
    count = int(cluster.max()) + 1

    def total(values: Floats) -> Floats:
        every = values.reshape(len(values), -1).T
        sums = [np.bincount(cluster, weights=one, minlength=count) for one in every]
        return np.asarray(np.stack(sums, -1).reshape(count, *values.shape[1:]), np.float64)

    used = np.bincount(cluster, weights=fit.weight, minlength=count) > 0
    score, normal = total(slopes.score)[used], total(slopes.slope)[used]
    whole, known = normal.sum(axis=0), np.zeros((free, free))
    if prior.u_shift is not None and free > 2:
        trust = (fit.scale_dn / max(prior.u_shift, 1e-3) * step[2]) ** 2
        whole[2, 2] += trust
        known[2, 2] = (trust * prior.u_shift / step[2]) ** 2
    apart = _solved(whole - normal, score[:, :, None])[:, :, 0]
    inverse = _solved(whole, np.eye(free))
    groups = len(score)
    seen = widening(_effective(normal)) ** 2 * (groups - 1) / groups * apart.T @ apart
    return np.asarray((seen + inverse @ known @ inverse.T) * np.outer(step, step))


def _effective(normal: Floats) -> float:
    """How many clusters of equal information are worth those of normal matrices (clusters, free, free); at
    least 1, in steps of a tenth.
    """
    told = np.maximum(np.trace(normal, axis1=1, axis2=2), 0.0)
    return max(round(float(told.sum() ** 2 / max(float((told**2).sum()), 1e-12)), 1), 1.0)


def _solved(normal: Floats, right: Floats) -> Floats:
    try:
        return np.asarray(np.linalg.solve(normal, right))
    except np.linalg.LinAlgError:
        # nothing of the vehicle tells one of the unknowns
        return np.asarray(np.linalg.pinv(normal, rcond=1e-12) @ right)


@lru_cache(maxsize=64)
def widening(freedom: float) -> float:
    """The factor that widens an uncertainty of so few observations to cover 95 %: Student's t over 1.96."""
    return float(scipy.special.stdtrit(freedom, 0.975) / COVERAGE_95)
