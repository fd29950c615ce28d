"""Figures of a study's heights: weighted to a fleet, with the total uncertainty of a designed sample.

The parts are those of `total_uncertainty`; what is added is the design: vehicles stand for others by their
weights, sites are drawn within strata of a known or unknown number, and weights that were made to meet the
fleet take from a height what its classes explain. Few and unequal sites are held as in `sites`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from sightline.coverage import COVERAGE_95
from sightline.statistics.deconvolution import SmoothDensity, noise_of, smooth_density
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.sites import Sites, pooled_variance
from sightline.statistics.study_plan import Components
from sightline.statistics.survey_design import Design
from sightline.statistics.survey_weights import residuals
from sightline.statistics.total_uncertainty import (
    HeightSample,
    TotalFigure,
    TotalPercentile,
    normal_draws,
    student_draws,
)

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

_LEVELS = (np.arange(4000) + 0.5) / 4000
_TAIL = 0.025
_SHAPE = 0.1  # of a correction for random error: what a density of another shape may change it by (k = 1)
_SMOOTHED = 0.5  # spreads: heights by which sites are compared at a percentile
_WINDOW = 0.10  # of all heights, on either side of a percentile: those that say which poses it rests on
_NODES = 20_000
_MANY = 1e6  # degrees of freedom of a variance that is as good as known


@dataclass(frozen=True)
class Sampled:
    """Variance of a weighted figure by its design, its degrees of freedom, and the variance of shared errors
    that differences between sites do not show.
    """

    variance: float
    freedom: float
    unseen: float


@dataclass(frozen=True)
class StudyPercentile(TotalPercentile):
    """A percentile of the fleet's true heights; effect: the design effect, of sampling alone."""

    effect: float | None = None


@dataclass(frozen=True, eq=False)
class _DrawnPercentile:
    """A percentile's value and draws of its error (D,), metres; effect: the design effect."""

    value_m: float
    raw_m: float
    error_m: Floats
    effect: float | None


@dataclass(frozen=True)
class StudyFigure(TotalFigure):
    """A figure of the fleet; effect: the design effect, of sampling alone."""

    effect: float | None = None


def lonely_strata(design: Design) -> list[int]:
    """The strata that have one site of several: differences between their sites cannot be seen."""
    n = np.bincount(design.stratum_of_site(), minlength=len(design.sites_there))
    return [h for h in range(len(n)) if n[h] == 1 and design.sites_there[h] > 1.0]


@dataclass(frozen=True, eq=False)
class _Stratum:
    """The rows of a stratum with their sites; part: what it weighs; seen: the share of its sites; own: the
    variance of its mean, of heights of variance 1 within sites; moved: what shared errors move the sites by.
    """

    rows: Ints | slice
    sites: Sites
    part: float
    seen: float
    own: float
    moved: list[Floats]


class Drawn:
    """A design made ready for many figures of the same rows (N,). shared: errors (N,) that act on heights."""

    def __init__(self, design: Design, shared: tuple[SharedErrors, ...] = ()) -> None:
        self.design, self._shared = design, shared
        self._drawn = design.weight if design.drawn is None else design.drawn
        whole = float(design.weight.sum())
        self._strata = []
        for h in range(len(design.sites_there)):
            chosen = np.flatnonzero(design.stratum == h)
            if not len(chosen):
                continue
            rows = slice(None) if len(chosen) == len(design.weight) else chosen
            sites = _sites(design.site[rows], design.weight[rows])
            part = float(design.weight[rows].sum()) / whole
            j = len(sites.count)
            told = [one.where(rows) for one in shared]
            moved = [one.by_site_m(sites.code, j, sites.weight) for one in told]
            seen = min(j / float(design.sites_there[h]), 1.0)
            own_weight = design.weight[rows]
            own = float(np.square(own_weight).sum()) / float(own_weight.sum()) ** 2
            self._strata.append(_Stratum(rows=rows, sites=sites, part=part, seen=seen, own=own, moved=moved))
        self._of_all_m2 = sum(float(np.square(one.of_mean_m(design.weight)).sum()) for one in shared)

    def sampled(self, influence: Floats, smooth: Floats | None = None, *, height: bool = True) -> Sampled:
        """Variance of a weighted mean of which `influence` (N,) is each height's influence, in its unit
        squared.

        Within strata as `sites.pooled_variance`; of a stratum of which part f was seen, 1 - f of the variance
        between sites and f of that within them counts (Särndal, Swensson & Wretman 1992, 4.3), with degrees
        of freedom by Satterthwaite. smooth: (N,), as there. height: shared errors act as on heights.
        """
        own = residuals(influence, self._drawn, self.design.margins)
        even = own if smooth is None else residuals(smooth, self._drawn, self.design.margins)
        if np.abs(own).max(initial=0.0) < 1e-12:  # the weights were made to meet it
            return Sampled(0.0, _MANY, 0.0)
        variance, squares, seen = 0.0, 0.0, 0.0
        for one in self._strata:
            here, freedom = _within(one.sites, own[one.rows])
            if len(one.sites.count) > 1 and one.seen < 1.0:
                moved = one.moved if height else []
                found = pooled_variance(one.sites, own[one.rows], even[one.rows], (), here / one.own, moved)
                here, freedom = (1.0 - one.seen) * found.variance + one.seen * here, found.freedom
                seen += one.part**2 * (1.0 - one.seen) * found.seen
            variance += one.part**2 * here
            squares += (one.part**2 * here) ** 2 / freedom
        unseen = max(self._of_all_m2 - seen, 0.0) if height else 0.0
        return Sampled(variance, variance**2 / squares if squares > 0.0 else _MANY, unseen)

    def between(self, influence: Floats) -> float:
        """Standard deviation of sites within strata, of figures with this influence (N,), beyond sampling."""
        variances, weights = [], []
        for one in self._strata:
            if len(one.sites.count) > 1:
                own = influence[one.rows]
                apart = np.square(own - one.sites.means(own)[one.sites.code])
                inner = np.bincount(one.sites.code, apart) / np.maximum(one.sites.count - 1.0, 1.0)
                sampling = float(np.mean(inner / one.sites.effective_count))
                variances.append(float(one.sites.means(own).var(ddof=1)) - sampling)
                weights.append(len(one.sites.count) - 1.0)
        found = float(np.average(variances, weights=weights)) if weights else 0.0
        return float(np.sqrt(max(found, 0.0)))

    def figure(self, value: float, influence: Floats, *, height: bool = False) -> StudyFigure:
        """A figure with this value and influence (N,), with Student's interval (Cochran 1977, 2.8)."""
        found = self.sampled(influence, height=height)
        low, high = _ends(_student(found) + np.sqrt(found.unseen) * normal_draws())
        return StudyFigure(value, value + low, value + high)


def _sites(site: Ints, weight: Floats) -> Sites:
    code = (np.cumsum(np.bincount(site) > 0) - 1)[site]
    return Sites(code, np.bincount(code).astype(np.float64), weight)


def _within(sites: Sites, influence: Floats) -> tuple[float, float]:
    """Variance of the weighted mean by sampling within sites, with its degrees of freedom."""
    assert sites.weight is not None
    n, freedom = len(influence), max(len(influence) - len(sites.count), 1)
    apart = np.square(influence - sites.means(influence)[sites.code])
    found = float(np.square(sites.weight) @ apart) / float(sites.weight.sum()) ** 2
    return found * n / freedom, float(freedom)


class StudyFigures:
    """Figures of the heights (N,), N > 1, of one target, each with its total 95 % interval.

    The sample's own `site` is not read: the design has the sites. Coverage by simulated nations:
    `tests/bench/bench_nations.py`.
    """

    def __init__(self, sample: HeightSample, design: Design) -> None:
        order = np.argsort(sample.height_m, kind="stable")
        self._height_m = sample.height_m[order]
        shared = tuple(one.where(order) for one in sample.shared)
        self._shared = shared
        design = ordered(design, order)
        self._drawn = Drawn(design, shared)
        self._site = design.site
        self._share = design.weight / design.weight.sum()
        noise = noise_of(sample.u_random_m, sum(one.spread_m2() for one in shared))
        self._noise_m2 = noise.variance_m2
        self._density = smooth_density(self._height_m, noise, self._share)
        self._cell = None if self._density is None else self._density.cell_of(self._height_m)
        self._nodes_m, self._node = _nodes(self._height_m)
        self._at_nodes = np.bincount(self._node, self._share)
        below = np.cumsum(self._share)
        self._middle = below - 0.5 * self._share

    @property
    def n(self) -> int:
        """How many heights."""
        return len(self._height_m)

    @property
    def sites(self) -> int:
        """At how many sites."""
        return int(np.count_nonzero(np.bincount(self._site)))

    def mean(self) -> StudyFigure:
        """The mean height of the fleet, metres."""
        value = float(self._share @ self._height_m)
        found = self._drawn.sampled(self._height_m - value)
        draws = _student(found) + np.sqrt(found.unseen) * normal_draws()
        plain = float(self._share @ np.square(self._height_m - value)) / self.n
        low, high = _ends(draws)
        return StudyFigure(value, value + low, value + high, effect=_effect(found, plain))

    def sd(self) -> StudyFigure:
        """The standard deviation of the fleet's true heights, metres."""
        apart = np.square(self._height_m - self._share @ self._height_m)
        measured_m2 = float(self._share @ apart) * self.n / (self.n - 1)
        found = self._drawn.sampled(apart - self._share @ apart, height=False)
        draws = measured_m2 * np.expm1(np.minimum(_student(found) / max(measured_m2, 1e-12), 30.0))
        value = measured_m2 - self._noise_m2
        low, high = _ends(draws)
        ends = np.sqrt(np.maximum([value, value + low, value + high], 0.0))
        return StudyFigure(float(ends[0]), float(ends[1]), float(ends[2]))

    def percentile(self, percent: float) -> StudyPercentile:
        """A percentile of the fleet's true heights, 0 < percent < 100, metres.

        The interval is Woodruff's (JASA 47, 1952): that of the share below, by the Beta distribution of as
        many heights as would tell it as well (Korn & Graubard 1998), read off the weighted heights.
        """
        found = self._percentile(percent)
        if isinstance(found, str):
            at = float(self._quantile(np.array([percent / 100.0]))[0])
            return StudyPercentile(at, None, None, found, percent=percent, raw=at)
        low, high = _ends(found.error_m)
        value = found.value_m
        return StudyPercentile(
            value, value + low, value + high, percent=percent, raw=found.raw_m, effect=found.effect
        )

    def percentile_draws(self, percent: float) -> tuple[float, Floats] | str:
        """A percentile's value and draws of its error (D,), metres, or the reason why there are none.

        The same as `percentile`'s.
        """
        found = self._percentile(percent)
        return found if isinstance(found, str) else (found.value_m, found.error_m)

    def named_effects_m(self, percent: float) -> dict[int, float]:
        """What one standard uncertainty of each error that other samples know (a road pose's) moves a
        percentile by, metres, by the error's name: of the heights whose ranks lie about it.

        Own method: as `TotalUncertainty.named_effects_m`, weighted.
        """
        near = np.flatnonzero(np.abs(self._middle - percent / 100.0) <= _WINDOW)
        found: dict[int, float] = {}
        for one in self._shared:
            found |= one.where(near).named_of_mean_m(self._share[near]) if len(near) else {}
        return found

    def _percentile(self, percent: float) -> _DrawnPercentile | str:
        p = percent / 100.0
        if self._density is None or self.n * min(p, 1.0 - p) < 1.0:
            needed = max(int(np.ceil(1.0 / min(p, 1.0 - p))), 8)
            return f"its interval needs at least {needed} heights that differ; there are {self.n}"
        at = float(self._quantile(np.array([p]))[0])
        slope = self._density.measured_density(at)
        own = (p - (self._height_m <= at)) / slope
        of_correction = self._density.correction_influence_m(p)[self._cell]
        smooth = self._smooth_influence(at, self._density) + of_correction
        found = self._drawn.sampled(own + of_correction, smooth)
        plain = p * (1.0 - p) / self.n / slope**2
        longer = float(scipy.special.stdtrit(found.freedom, 1.0 - _TAIL)) / COVERAGE_95
        n = p * (1.0 - p) / max(found.variance * (longer * slope) ** 2, 1e-300)
        draws = self._quantile(scipy.special.betaincinv(n * p + 0.5, n * (1.0 - p) + 0.5, _LEVELS)) - at
        correction = self._density.correction_m(p)
        u_m2 = found.unseen + (_SHAPE * correction) ** 2
        return _DrawnPercentile(
            value_m=at + correction,
            raw_m=at,
            error_m=draws + np.sqrt(u_m2) * normal_draws(),
            effect=_effect(found, plain),
        )

    def components(self, percent: float) -> Components | None:
        """What makes a percentile uncertain, for the plan of another study; None where it has no interval.

        What sites differ by beyond sampling within them is taken from the variance that they show (moments,
        Cochran 1954), their road poses' errors included.
        """
        p = percent / 100.0
        if self._density is None or self.n * min(p, 1.0 - p) < 1.0:
            return None
        at = float(self._quantile(np.array([p]))[0])
        smooth = self._smooth_influence(at, self._density)
        sampling = float(np.sqrt(p * (1.0 - p))) / self._density.measured_density(at)
        found = self._drawn.sampled(smooth, smooth)
        return Components(sampling, self._drawn.between(smooth), float(np.sqrt(found.unseen)))

    def _quantile(self, p: Floats) -> Floats:
        """Weighted quantiles (P,), read between heights; beyond the outermost by the smooth density."""
        found = np.interp(p, self._middle, self._height_m)
        if self._density is None:
            return np.asarray(found, dtype=np.float64)
        for end, beyond in ((0, p < self._middle[0]), (-1, p > self._middle[-1])):
            if beyond.any():
                edge = float(self._density.measured_quantile_m(float(self._middle[end])))
                found[beyond] = self._height_m[end] + self._density.measured_quantile_m(p[beyond]) - edge
        return np.asarray(found, dtype=np.float64)

    def _smooth_influence(self, at: float, density: SmoothDensity) -> Floats:
        """Influence (N,) of each height on the percentile of heights smoothed by half their spread."""
        width = _SMOOTHED * density.spread_m
        away = (at - self._nodes_m) / width
        below = scipy.special.ndtr(away)
        slope = float(self._at_nodes @ np.exp(-0.5 * away**2)) / (width * np.sqrt(2.0 * np.pi))
        influence = (self._at_nodes @ below - below) / slope
        return np.asarray(influence[self._node], dtype=np.float64)


def _nodes(height_m: Floats) -> tuple[Floats, Ints]:
    """Heights (M,) at which smooth functions of sorted heights (N,) are computed, and which each has, (N,):
    their own of few, of many those of fine steps over their range.
    """
    if len(height_m) <= _NODES:
        return height_m, np.arange(len(height_m))
    step = (height_m[-1] - height_m[0]) / _NODES
    node = np.minimum(((height_m - height_m[0]) / max(step, 1e-12)).astype(np.int64), _NODES - 1)
    return height_m[0] + (np.arange(_NODES) + 0.5) * step, node


def ordered(design: Design, order: Ints | NDArray[np.bool_]) -> Design:
    """The same design for the rows of `order`, (M,) by number or (N,) by truth.

    Own method: all columns alike.
    """
    return Design(
        weight=design.weight[order],
        stratum=design.stratum[order],
        site=design.site[order],
        sites_there=design.sites_there,
        units_there=design.units_there,
        margins=tuple(one.where(order) for one in design.margins),
        drawn=None if design.drawn is None else design.drawn[order],
    )


def share_of(drawn: Drawn, chosen: NDArray[np.bool_]) -> StudyFigure:
    """The share of the fleet that is `chosen` (N,), 0 to 1, with its interval: sampling and sites.

    By the Beta distribution of as many vehicles as would tell it as well (Korn & Graubard 1998).
    """
    share = drawn.design.weight / drawn.design.weight.sum()
    value = float(share @ chosen)
    found = drawn.sampled(np.asarray(chosen - value, dtype=np.float64), height=False)
    if found.variance == 0.0 and 0.0 < value < 1.0:
        return StudyFigure(value, value, value)
    plain = value * (1.0 - value) / len(chosen)
    longer = float(scipy.special.stdtrit(found.freedom, 1.0 - _TAIL)) / COVERAGE_95
    n = value * (1.0 - value) / max(found.variance * longer**2, 1e-300) if plain > 0.0 else len(chosen)
    n = min(n, 10.0 * len(chosen))
    low, high = scipy.special.betaincinv(n * value + 0.5, n * (1.0 - value) + 0.5, [_TAIL, 1.0 - _TAIL])
    effect = _effect(found, plain) if plain > 0.0 else None
    return StudyFigure(value, float(min(low, value)), float(max(high, value)), effect=effect)


def _effect(found: Sampled, plain: float) -> float | None:
    return found.variance / plain if plain > 0.0 else None


def _student(found: Sampled) -> Floats:
    return np.asarray(student_draws(found.freedom) * np.sqrt(found.variance), dtype=np.float64)


def _ends(draws: Floats) -> tuple[float, float]:
    low, high = np.quantile(draws, [_TAIL, 1.0 - _TAIL])
    return float(low), float(high)
