"""In which order measurements are reviewed: those that are most likely wrong come first."""

from dataclasses import dataclass
from typing import get_args

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.coverage import COVERAGE_95
from sightline.enums import ReviewSign

Codes = NDArray[np.int64]

SIGNS: tuple[ReviewSign, ...] = get_args(ReviewSign)
#: An uncertainty this many times the usual one of its target is large.
LARGE = 1.5
#: Beyond this modified z-score a height is unusual (Iglewicz & Hoaglin 1993, section 3).
UNUSUAL = 3.5
#: Fewer heights than this say nothing of what is usual.
LEAST = 10
#: Who has measured fewer than this is new.
NEW = 20


@dataclass(frozen=True, eq=False)
class ReviewOrder:
    """`risk` (n,): how far the worst sign lies beyond its limit, 1 at it; `signs` (n, 4): which are there."""

    risk: Floats
    signs: NDArray[np.bool_]


def review_order(
    height_m: Floats, u_m: Floats, target: Codes, operator: Codes, error_m: Floats, u_error_m: Floats
) -> ReviewOrder:
    """Signs that a height may be wrong, from what else was measured in the same survey.

    `height_m` (n,) and `u_m` (n,) metres; `target` (n,) and `operator` (n,) codes; `error_m` (n,) metres, the
    height less the maker's, and `u_error_m` (n,) its standard uncertainty. NaN where there is no height or no
    maker's height: then that sign is absent, and nothing is raised. The modified z-score of a height is
    0.6745 times its distance from the median, in median absolute deviations (Iglewicz and Hoaglin 1993, 3).
    """
    beyond = np.zeros((height_m.size, len(SIGNS)))
    for code in np.unique(target):
        of = target == code
        beyond[of, 0] = u_m[of] / (LARGE * _median(u_m[of]))
        beyond[of, 1] = _scores(height_m[of]) / UNUSUAL
    with np.errstate(divide="ignore", invalid="ignore"):
        beyond[:, 2] = np.abs(error_m) / (COVERAGE_95 * u_error_m)
    codes, counts = np.unique(operator, return_counts=True)
    beyond[:, 3] = np.isin(operator, codes[counts < NEW])
    beyond = np.nan_to_num(beyond, nan=0.0, posinf=0.0)
    return ReviewOrder(beyond.max(axis=1, initial=0.0), beyond > np.array([1.0, 1.0, 1.0, 0.0]))


def _median(values: Floats) -> float:
    known = values[np.isfinite(values) & (values > 0.0)]
    return float(np.median(known)) if known.size else float("nan")


def _scores(heights_m: Floats) -> Floats:
    """Absolute modified z-scores of (n,) heights in metres; NaN where there are too few, or no spread."""
    known = heights_m[np.isfinite(heights_m)]
    if known.size < LEAST:
        return np.full(heights_m.shape, np.nan)
    median = np.median(known)
    spread = float(np.median(np.abs(known - median)))
    return 0.6745 * np.abs(heights_m - median) / (spread if spread > 0.0 else np.nan)
