"""The textbook's estimators, linearised (Cochran 1977; Särndal, Swensson & Wretman 1992), for comparison."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sightline.statistics.survey_design import Design
from sightline.statistics.survey_weights import residuals

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class Estimated:
    """A figure with its variance by the design."""

    value: float
    variance: float

    @property
    def u(self) -> float:
        """Standard uncertainty of sampling."""
        return float(np.sqrt(self.variance))


def variance_of_sum(design: Design, influence: Floats) -> float:
    """Variance of the weighted sum of influence (N,), in its unit squared.

    Of site totals within strata, less the share of sites that were seen (Särndal, Swensson & Wretman 1992,
    4.3). NaN where a stratum has one site of several.
    """
    drawn = design.weight if design.drawn is None else design.drawn
    own = design.weight * residuals(influence, drawn, design.margins)
    of_site, stratum = np.bincount(design.site, own), design.stratum_of_site()
    n = np.bincount(stratum, minlength=len(design.sites_there)).astype(np.float64)
    seen = n / design.sites_there
    mean = np.bincount(stratum, of_site, minlength=len(n)) / np.maximum(n, 1.0)
    squares = np.bincount(stratum, np.square(of_site - mean[stratum]), minlength=len(n))
    with np.errstate(invalid="ignore", divide="ignore"):
        first = np.where(seen < 1.0, (1.0 - seen) * n / (n - 1.0) * squares, 0.0)
    return float(first[n > 0].sum())


def total(design: Design, values: Floats) -> Estimated:
    """The weighted sum of values (N,) (Horvitz & Thompson 1952)."""
    return Estimated(float(design.weight @ values), variance_of_sum(design, values))


def mean(design: Design, values: Floats) -> Estimated:
    """The weighted mean of values (N,) (Cochran 1977, 6.3)."""
    below = float(design.weight.sum())
    value = float(design.weight @ values) / below
    return Estimated(value, variance_of_sum(design, (values - value) / below))
