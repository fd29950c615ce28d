"""Errors of measured heights against those that were known before, by target: vehicles, and check targets."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sightline.coverage import COVERAGE_95
from sightline.enums import Rounding, Target
from sightline.statistics.distributions import share_interval
from sightline.statistics.errors import ErrorGroup, error_table
from sightline.statistics.figures import TotalFigure
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty

Floats = NDArray[np.float64]

#: In the order of the tables.
COMPARED: tuple[Target, ...] = get_args(Target)


@dataclass(frozen=True, slots=True)
class Inside:
    """How many of `n` differences are not larger than their own U95, and the share's exact 95 % interval.

    About 95 % should be: fewer, and the stated uncertainties are too small.
    """

    n: int
    inside: int
    share: float
    low: float
    high: float


@dataclass(frozen=True, eq=False)
class KnownErrors:
    """The errors of one target, of the traffic or of check targets.

    groups: the columns of the error table by lighting and "overall"; inside: of the heights whose known
    height has an uncertainty, else the reason in its place; bias: the mean error, not rounded, with its total
    uncertainty; words: what its interval holds, and for which roads.
    """

    target: Target
    check_target: bool
    groups: dict[str, ErrorGroup]
    inside: Inside | str
    bias: TotalFigure
    words: str


@dataclass(frozen=True, eq=False)
class Compared:
    """Measured heights, N > 0, with the parts of their uncertainty, and the known ones, (N,) each, metres, u
    at k = 1, NaN where unknown; `lighting` "" where unknown.
    """

    measured: HeightSample
    u_measured_m: Floats
    known_m: Floats
    u_known_m: Floats
    lighting: Sequence[str]


def known_errors(
    target: Target,
    check_target: bool,
    of: Compared,
    rounding: Rounding,
    table: dict[str, ErrorGroup] | None = None,
) -> KnownErrors:
    """The error table (Dupuis et al. 2019, Table 1) of one target, with the share inside its uncertainty.

    The paper tests roofs alone; nothing in its figures is particular to them. The bias is a mean of errors,
    so what heights share (pose, mean inset) is in its interval as in that of a mean height
    (`TotalUncertainty`). table: where it is made already.
    """
    error_m = of.measured.height_m - of.known_m
    total = TotalUncertainty(replace(of.measured, height_m=error_m))
    return KnownErrors(
        target=target,
        check_target=check_target,
        groups=table
        or error_table(of.measured.height_m, of.known_m, list(of.lighting), rounding, of.measured),
        inside=inside_uncertainty(error_m, of.u_measured_m, of.u_known_m),
        bias=total.mean(),
        words=total.holds_in_words,
    )


def inside_uncertainty(error_m: ArrayLike, u_measured_m: ArrayLike, u_known_m: ArrayLike) -> Inside | str:
    """How many differences error_m (N,) are not larger than their own U95, of those whose standard
    uncertainties u_measured_m (N,) and u_known_m (N,) are both known, all in metres; else the reason.

    |error| <= k sqrt(u_measured^2 + u_known^2), the E_n criterion of ISO 13528, k for 95 %; the interval of
    the share is that of Clopper and Pearson 1934.
    """
    error = np.asarray(error_m, dtype=np.float64)
    u_m = np.hypot(np.asarray(u_measured_m, dtype=np.float64), np.asarray(u_known_m, dtype=np.float64))
    rows = np.isfinite(u_m) & np.isfinite(error)
    n = int(np.count_nonzero(rows))
    if n == 0:
        return "no known height has an uncertainty to be compared with"
    inside = int(np.count_nonzero(np.abs(error[rows]) <= COVERAGE_95 * u_m[rows]))
    return Inside(n, inside, inside / n, *share_interval(inside, n))
