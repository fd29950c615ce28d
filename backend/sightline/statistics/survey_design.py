"""Design-based estimation of surveys of surveys: strata, sites as primary sampling units, weights.

The textbook's estimators (Cochran 1977; Särndal, Swensson & Wretman 1992; Wolter 2007): Taylor linearisation
with finite populations of sites and a second stage, and the stratified jackknife. Checked against R's package
`survey` on its published examples (`tests/statistics/test_survey_design.py`). The intervals of a study go
further (`total_uncertainty`): they hold errors of measurement too, and few sites of unequal size.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sightline.statistics.survey_weights import Margin, residuals

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Estimate = Callable[[Floats], float]


@dataclass(frozen=True, eq=False)
class Design:
    """How a sample (N,) was drawn: weight (N,), stratum (N,) codes 0 to H - 1, site (N,) codes 0 to J - 1,
    each in one stratum.

    sites_there: (H,), how many sites each stratum has on the roads, inf where not known; units_there: (J,),
    how many vehicles each site has, None where sites are taken for the only stage. margins: what the weights
    were made to meet; drawn: (N,), the weights before.
    """

    weight: Floats
    stratum: Ints
    site: Ints
    sites_there: Floats
    units_there: Floats | None = None
    margins: tuple[Margin, ...] = ()
    drawn: Floats | None = None

    def stratum_of_site(self) -> Ints:
        """The stratum of each site, (J,)."""
        found = np.zeros(int(self.site.max(initial=-1)) + 1, dtype=np.int64)
        found[self.site] = self.stratum
        return found


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

    Of site totals within strata, less the share of sites that were seen, and of that share the variance
    within sites (Särndal, Swensson & Wretman 1992, 4.3). NaN where a stratum has one site of several.
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
    return float(first[n > 0].sum()) + _second_stage(design, own, seen[stratum])


def _second_stage(design: Design, own: Floats, seen: Floats) -> float:
    if design.units_there is None:
        return 0.0
    units = np.bincount(design.site).astype(np.float64)
    mean = np.bincount(design.site, own) / units
    squares = np.bincount(design.site, np.square(own - mean[design.site]))
    several = units > 1.0
    part = np.zeros(len(units))
    part[several] = (1.0 - units / design.units_there)[several] * (units / np.maximum(units - 1.0, 1.0))[
        several
    ]
    return float(np.sum(seen * part * squares))


def total(design: Design, values: Floats) -> Estimated:
    """The weighted sum of values (N,) (Horvitz & Thompson 1952)."""
    return Estimated(float(design.weight @ values), variance_of_sum(design, values))


def ratio(design: Design, values: Floats, of: Floats) -> Estimated:
    """The weighted sum of values (N,) over that of `of` (N,), linearised (Cochran 1977, 6.3)."""
    below = float(design.weight @ of)
    value = float(design.weight @ values) / below
    return Estimated(value, variance_of_sum(design, (values - value * of) / below))


def mean(design: Design, values: Floats) -> Estimated:
    """The weighted mean of values (N,) (Cochran 1977, 6.3)."""
    return ratio(design, values, np.ones(len(values)))


def design_effect(design: Design, values: Floats, *, finite: bool = True) -> float:
    """The variance of the mean of values (N,) over that of as many drawn one by one (Kish 1965, 8.2).

    finite: of the finite fleet that the weights sum to.
    """
    n, there = len(values), float(design.weight.sum())
    centred = values - design.weight @ values / there
    spread = float(design.weight @ centred**2) / there * n / (n - 1)
    plain = spread / n * ((1.0 - n / there) if finite else 1.0)
    return mean(design, values).variance / plain


def jackknife(design: Design, estimate: Estimate) -> Estimated:
    """A figure with its variance by leaving each site out in turn (Wolter 2007, 4.5: the stratified JKn).

    estimate: the figure of weights (N,), calibrated anew where they are to be; the sites left in a stratum
    take up the weight of the one left out.
    """
    stratum, n_sites = design.stratum_of_site(), int(design.site.max()) + 1
    n = np.bincount(stratum, minlength=len(design.sites_there)).astype(np.float64)
    found = np.array([estimate(_without(design, one, stratum, n)) for one in range(n_sites)])
    variance = 0.0
    for h in range(len(n)):
        of = found[stratum == h]
        if len(of) > 1:
            left = 1.0 - n[h] / design.sites_there[h]
            variance += left * (n[h] - 1.0) / n[h] * float(np.square(of - found.mean()).sum())
    return Estimated(estimate(design.weight), variance)


def _without(design: Design, site: int, stratum: Ints, n: Floats) -> Floats:
    h = stratum[site]
    factor = np.where(design.stratum == h, n[h] / max(n[h] - 1.0, 1.0), 1.0)
    return np.where(design.site == site, 0.0, design.weight * factor)


def effective_size(n: int, effect: float) -> float:
    """How many vehicles drawn one by one would tell a figure as well (Kish 1965, 8.2)."""
    return n / effect


def weighting_effect(weight: Floats) -> float:
    """How much a `weight` (N,) that differs widens a mean by itself: n times the sum of their squares over
    the square of their sum (Kish 1965, 11.7).
    """
    return float(len(weight) * np.square(weight).sum() / weight.sum() ** 2)


def weighted_quantiles(values: Floats, weight: Floats, p: Sequence[float] | Floats) -> Floats:
    """Quantiles p (P,), 0 to 1, of sorted values (N,) of weight (N,), (P,): the smallest value at or below
    which that share of the weight lies (R's rule "math"; Hyndman & Fan 1996, type 1).
    """
    below = np.cumsum(weight)
    at = np.searchsorted(below, np.asarray(p) * below[-1] * (1.0 - 1e-12))
    return np.asarray(values[np.minimum(at, len(values) - 1)], dtype=np.float64)
