"""The adjustment's least squares: passes are eliminated one by one, the shared errors solved for what is
left.

Gauss-Newton with halved steps over the shared z and the unknowns of every pass; the normal equations of a
pass touch no other pass, so the Schur complement over them (Triggs et al. 2000) leaves a system of the size
of z.
"""

from dataclasses import dataclass

import numpy as np

from sightline.adjustment.shared_errors import SharedErrors
from sightline.adjustment.traffic_model import Linear, Traffic, guesses, linearise, prior_information
from sightline.arrays import Floats
from sightline.errors import BadInput

_ROUNDS = 30
_SETTLED = 1e-7  # of the cost, which is a chi-square


@dataclass(frozen=True, eq=False)
class Weights:
    """Roots of the weights of points (N,) and lengths (P, 3), 0 for what is left out; `prior` (m,):
    information on each shared z, 1 as stated, less where a part was released.
    """

    points: Floats
    lengths: Floats
    prior: Floats


@dataclass(frozen=True, eq=False)
class Solution:
    """The minimum: shared `z` (m,) with `covariance` (m, m), the passes' `unknown` (P, K), and what the tests
    need of it: the linear system and `pass_covariance` (P, K, K), each pass's own with z held.
    """

    z: Floats
    unknown: Floats
    at: Linear
    covariance: Floats
    pass_covariance: Floats
    chi2: float


@dataclass(frozen=True, eq=False)
class _Reduced:
    """The normal equations with the passes eliminated."""

    normal: Floats
    pull: Floats
    inverse: Floats  # (P, K, K)
    cross: Floats  # (P, K, m)
    own_pull: Floats  # (P, K)


def solve(
    shared: SharedErrors, traffic: Traffic, weights: Weights, start: tuple[Floats, Floats] | None = None
) -> Solution:
    """The least-squares solution from `start` (z (m,) and unknowns (P, K)), or from the pose as it is.

    Triggs et al. 2000, sections 6 and 7. Raises BadInput where it does not settle.
    """
    z, unknown = (np.zeros(shared.size), traffic.start) if start is None else start
    guess, known_nothing = guesses(traffic), prior_information(traffic)
    at, cost = _cost(shared, traffic, weights, z, unknown, guess, known_nothing)
    for _ in range(_ROUNDS):
        system = _reduced(at, weights.prior, z, unknown - guess, known_nothing)
        step: Floats = np.asarray(np.linalg.solve(system.normal, system.pull), dtype=np.float64)
        own_step = _solve_own_steps(system, step)
        expected = float(step @ system.pull)
        tried = None
        for halving in range(12):
            share = 0.5**halving
            try_z, try_unknown = z + share * step, unknown + share * own_step
            with np.errstate(all="ignore"):
                tried, new = _cost(shared, traffic, weights, try_z, try_unknown, guess, known_nothing)
            if np.isfinite(new) and new <= cost + 1e-9 * (1.0 + cost):
                break
        else:
            raise BadInput("adjustment-does-not-settle")
        settled = abs(cost - new) <= _SETTLED * (1.0 + cost) and expected <= 1e-3 * (1.0 + cost)
        z, unknown, at, cost = try_z, try_unknown, tried, new
        if settled:
            break
    else:
        raise BadInput("adjustment-does-not-settle")
    system = _reduced(at, weights.prior, z, unknown - guess, known_nothing)
    return Solution(
        z=z,
        unknown=unknown,
        at=at,
        covariance=np.asarray(np.linalg.inv(system.normal), dtype=np.float64),
        pass_covariance=system.inverse,
        chi2=float(np.square(at.residual).sum() + weights.prior @ (z * z)),
    )


def _cost(
    shared: SharedErrors,
    traffic: Traffic,
    weights: Weights,
    z: Floats,
    unknown: Floats,
    guess: Floats,
    known_nothing: Floats,
) -> tuple[Linear, float]:
    at = linearise(shared, traffic, z, unknown, weights.points, weights.lengths)
    cost = np.square(at.residual).sum() + weights.prior @ (z * z)
    return at, float(cost + (known_nothing * np.square(unknown - guess)).sum())


def _reduced(at: Linear, prior: Floats, z: Floats, off: Floats, known_nothing: Floats) -> _Reduced:
    turned = np.swapaxes(at.own, 1, 2)
    normal = turned @ at.own
    rows = np.arange(normal.shape[1])
    normal[:, rows, rows] += known_nothing
    scale = 1.0 / np.sqrt(normal[:, rows, rows])
    inverse = (
        np.linalg.inv(normal * scale[:, :, None] * scale[:, None, :]) * scale[:, :, None] * scale[:, None, :]
    )
    cross = turned @ at.shared
    own_pull = np.einsum("prk,pr->pk", at.own, at.residual) - known_nothing * off
    solved = inverse @ cross
    flat = at.shared.reshape(-1, at.shared.shape[2])
    whole = flat.T @ flat + np.diag(prior) - np.einsum("pki,pkj->ij", cross, solved)
    pull = flat.T @ at.residual.ravel() - prior * z - np.einsum("pki,pk->i", solved, own_pull)
    return _Reduced(np.asarray(0.5 * (whole + whole.T)), pull, inverse, cross, own_pull)


def _solve_own_steps(system: _Reduced, step: Floats) -> Floats:
    """The passes' steps (P, K) that belong to a step of z."""
    left = system.own_pull - system.cross @ step
    return np.asarray(np.einsum("pij,pj->pi", system.inverse, left), dtype=np.float64)
