"""How well a registration knows its answer: from the scatter of pieces of the vehicle.

The answer solves sum psi(r) J = 0 (psi: weight times residual r, J: r's derivatives as strip 1 shows them),
so its error is A^-1 times that sum, A being the sum's own derivative by the unknowns. A is taken by
differences: strip 2's own gradients are in it, where strip 1's hold the noise by which its pixels were chosen
(Carroll et al. 2006, ch. 6), the falling weights of pixels (Huber 1981, ch. 6) and of whole blocks, and every
cell's own gain and offset.

The sum over a cluster of neighbouring pixels, which share what matters (a reflection, a window's edge), is
one observation (Liang and Zeger 1986). Clusters are few, and what one of them errs by the fit takes in part
for motion. Let K be a cluster's part of A, scaled so that A is 1, and errors go with it, cov S = K. What the
fit leaves of S is S - K sum S, of covariance K - K^2, so (1 - K)^-1/2 times that has K again, and squares
summed over the clusters are right in the mean ("CR2", Bell and McCaffrey 2002). Each cluster left out in turn
("CR3") has (1 - K)^-1: u is a fifth too large for drawn cars, of whom one cluster may hold half. The sum of
squares scatters, so u is widened until 1.96 times it covers what Student's t covers, of as many degrees of
freedom as a Wishart matrix that scatters alike (Pustejovsky and Tipton 2018).
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

# a cluster that holds more of what is seen leaves next to nothing of its error
MOST_HELD = 0.98
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
    observation. Clusters: Liang and Zeger 1986; psi': Huber 1981, ch. 6; what the fit takes of a cluster's
    error given back: Bell and McCaffrey 2002; widened as Student's t is wider: Pustejovsky and Tipton 2018.
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
    power, axes = np.linalg.eigh((whole + whole.T) / 2)
    size = np.sqrt(np.maximum(power, 1e-12 * max(power[-1], 1e-12)))
    to_one = axes / size
    part, along = np.linalg.eigh(to_one.T @ (normal + normal.transpose(0, 2, 1)) @ to_one / 2)
    part = np.clip(part, 0.0, MOST_HELD)
    given_back = (along / np.sqrt(1 - part)[:, None]) @ along.transpose(0, 2, 1)
    inverse = _solved(whole, np.eye(free))
    error = np.einsum("cij,cj->ci", given_back, score @ to_one) @ (inverse @ (axes * size)).T
    seen = widening(_freedom(part, along)) ** 2 * error.T @ error
    return np.asarray((seen + inverse @ known @ inverse.T) * np.outer(step, step))


def _freedom(part: Floats, along: Floats) -> float:
    """Degrees of freedom, at least 1, in steps of a tenth, of clusters whose K has these parts along these
    axes, (clusters, free) and (clusters, free, free).

    A Wishart matrix of mean 1 and size n has n (n + 1) over its elements' summed variance. Clusters c and d,
    given back what the fit took, have the covariance K_c where they are one and else -B_c B_d, with
    B = (1 - K)^-1/2 K; all pairs' sums are those of T = sum B[ij] B[kl].
    """

    def own(of: Floats) -> float:
        return float((of.sum(axis=1) ** 2 + (of**2).sum(axis=1)).sum())

    taken = (along * (part / np.sqrt(1 - part))[:, None]) @ along.transpose(0, 2, 1)
    pairs = np.einsum("cij,ckl->ijkl", taken, taken)
    shared = float((pairs**2).sum() + np.einsum("ijkl,jkli->", pairs, pairs))
    variance = shared - own(part**2 / (1 - part)) + own(part)
    told = float(part.sum())
    return max(round(told * (told + 1) / max(variance, 1e-12), 1), 1.0)


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
