"""Errors of measured heights against those that were known before, by target: vehicles, and check targets."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sightline.arrays import Floats
from sightline.coverage import COVERAGE_95
from sightline.enums import Category, ErrorGrouping, Lighting, Target
from sightline.messages.said import Said
from sightline.statistics.distributions import share_interval
from sightline.statistics.errors import LENGTHS, ErrorGroup, error_group, signed_errors
from sightline.statistics.total_uncertainty import HeightSample

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
class KnownGroup:
    """Bias, MAE, RMSE and SD of the errors of some vehicles: of all, or of one lighting or class, `group`."""

    grouping: ErrorGrouping
    group: str
    errors: ErrorGroup


@dataclass(frozen=True, eq=False)
class KnownErrors:
    """The errors of one target, of the traffic or of check targets.

    groups: all of them first, then each lighting and class that there is; inside: of the heights whose known
    height has an uncertainty, else the reason in its place.
    """

    target: Target
    check_target: bool
    groups: tuple[KnownGroup, ...]
    inside: Inside | Said

    @property
    def overall(self) -> ErrorGroup:
        """Of all of its heights."""
        return self.groups[0].errors


@dataclass(frozen=True, eq=False)
class Compared:
    """Measured heights, N > 0, with the parts of their uncertainty, and the known ones, (N,) each, metres, u
    at k = 1, NaN where unknown; `lighting`, `category` "" where unknown.
    """

    measured: HeightSample
    u_measured_m: Floats
    known_m: Floats
    u_known_m: Floats
    lighting: Sequence[str]
    category: Sequence[str]


def known_errors(target: Target, check_target: bool, of: Compared) -> KnownErrors:
    """Bias, MAE, RMSE and SD (as in Dupuis et al. 2019, Table 1, not rounded) of one target, of all its
    heights and by lighting and class, with the share inside its uncertainty.

    The paper tests roofs alone; nothing in these figures is particular to them. Each has one interval, the
    total one: what heights share (pose, mean inset) is in it (`error_group`).
    """
    error_m, _ = signed_errors(of.measured.height_m, of.known_m, "none")

    def group(rows: NDArray[np.intp]) -> ErrorGroup:
        return error_group(error_m[rows], of.known_m[rows], of.measured.where(rows), LENGTHS)

    groups = [KnownGroup("all", "all", group(np.arange(len(error_m))))]
    divided: tuple[tuple[ErrorGrouping, Sequence[str], tuple[str, ...]], ...] = (
        ("lighting", of.lighting, get_args(Lighting)),
        ("category", of.category, get_args(Category)),
    )
    for grouping, codes, words in divided:
        where = np.array(codes, dtype=object)
        for word in words:
            rows = np.flatnonzero(where == word)
            if len(rows):
                groups.append(KnownGroup(grouping, word, group(rows)))
    inside = inside_uncertainty(error_m, of.u_measured_m, of.u_known_m)
    return KnownErrors(target, check_target, tuple(groups), inside)


def shown_groups(groups: Sequence[KnownGroup]) -> list[KnownGroup]:
    """The first, which is of all, and those that say something else: not of every one of its heights."""
    return [groups[0], *(one for one in groups[1:] if one.errors.n < groups[0].errors.n)]


def inside_uncertainty(error_m: ArrayLike, u_measured_m: ArrayLike, u_known_m: ArrayLike) -> Inside | Said:
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
        return Said("stat-known-without-u")
    inside = int(np.count_nonzero(np.abs(error[rows]) <= COVERAGE_95 * u_m[rows]))
    return Inside(n, inside, inside / n, *share_interval(inside, n))
