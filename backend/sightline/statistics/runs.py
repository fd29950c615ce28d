"""Several runs of one car: its length and wheelbase do not change, so the runs must agree within their u."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt

import numpy as np
import scipy
from numpy.typing import NDArray

from sightline.coverage import COVERAGE_95
from sightline.enums import RunsVerdict

#: The chance, on both sides together, of calling runs that agree too far apart or too alike.
LEVEL = 0.05


@dataclass(frozen=True, slots=True)
class Run:
    """One run's value: `u_own` is what no other run shares; `u_shared` what each of the errors that all runs
    of one `rig` share makes of it (k = 1), as many for every run and in the same order.
    """

    value: float
    u_own: float
    u_shared: tuple[float, ...] = (0.0,)
    rig: object = None


@dataclass(frozen=True, slots=True)
class RunsTogether:
    """The runs' weighted mean with its u (what they share included), their spread, and the chi-square.

    `sd`: with n - 1, None for one run; `u_stated`: root mean square of what each run states for itself, the
    spread that one expects. `p`: the chance of a chi-square as large or larger if every u holds.
    """

    n: int
    mean: float
    u_mean: float
    U95_mean: float
    sd: float | None
    u_stated: float
    chi_square: float | None
    degrees: int
    p: float | None
    verdict: RunsVerdict


def runs_together(runs: Sequence[Run]) -> RunsTogether | None:
    """Generalised least squares for one value behind all runs (Aitken 1936): mean 1'C^-1 y / 1'C^-1 1, its u
    (1'C^-1 1)^-1/2, chi-square (y - mean)'C^-1 (y - mean) with n - 1 degrees. None for no run.

    C holds each run's own u^2, and for two runs with one rig the products of what they share: an error that
    is the same in every run moves the mean and spreads nothing.
    """
    if not runs:
        return None
    value = np.array([one.value for one in runs])
    weight = np.linalg.inv(_covariance(runs))
    total = float(weight.sum())
    mean = float(weight.sum(axis=0) @ value) / total
    n, apart = len(runs), value - mean
    own = np.array([one.u_own for one in runs])
    chi_square = float(apart @ weight @ apart) if n > 1 else None
    p = None if chi_square is None else float(scipy.stats.chi2.sf(chi_square, n - 1))
    return RunsTogether(
        n=n,
        mean=mean,
        u_mean=1.0 / sqrt(total),
        U95_mean=COVERAGE_95 / sqrt(total),
        sd=float(value.std(ddof=1)) if n > 1 else None,
        u_stated=float(np.sqrt(np.mean(own**2))),
        chi_square=chi_square,
        degrees=n - 1,
        p=p,
        verdict=_verdict(p),
    )


def _covariance(runs: Sequence[Run]) -> NDArray[np.float64]:
    shared = np.array([one.u_shared for one in runs])
    same = np.array([[a.rig == b.rig for b in runs] for a in runs])
    own = np.diag(np.array([one.u_own**2 for one in runs]))
    return np.asarray(own + shared @ shared.T * same, dtype=np.float64)


def _verdict(p: float | None) -> RunsVerdict:
    if p is None:
        return "too_few"
    if p < LEVEL / 2:
        return "too_far_apart"
    return "too_alike" if p > 1 - LEVEL / 2 else "agree"
