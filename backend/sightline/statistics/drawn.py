"""What a design makes of a figure's influences: its variance, within sites and between them.

Vehicles stand for others by their weights, sites are drawn within strata of a known or unknown number, and
weights that were made to meet the fleet take from a height what its classes explain. Few and unequal sites
are held as in `sites`. A survey is a design of one stratum and equal weights.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from sightline.arrays import Floats, Ints
from sightline.coverage import COVERAGE_95
from sightline.messages.said import Said
from sightline.statistics.draws import OTHER, TAIL, ends_of, normal_draws, student_draws
from sightline.statistics.figures import TotalFigure, without_interval
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.sites import NOTHING, Sites, compact, mean_variance, pooled_variance, variances
from sightline.statistics.survey_design import Design
from sightline.statistics.survey_weights import left_of_squares, residuals

_MANY = 1e6  # degrees of freedom of a variance that is as good as known


@dataclass(frozen=True)
class Sampled:
    """Variance of a weighted figure by its design, its degrees of freedom, and the variance of shared errors
    that differences between sites do not show.

    within: the share of the variance that comes of sampling within sites; shift: that of shared errors, by
    which sites differ.
    """

    variance: float
    freedom: float
    unseen: float
    within: float = 1.0
    shift: float = 0.0

    def draws(self) -> Floats:
        """Draws (D,) of an error of this estimated variance, ascending."""
        return np.asarray(student_draws(self.freedom) * np.sqrt(self.variance), dtype=np.float64)

    def other_draws(self) -> Floats:
        """Draws (D,) beside `draws` of an error of the same variance, uncorrelated with it: of two normal
        ones over the same estimate of their variance, the second given the first (Ding 2016).
        """
        first, more = student_draws(self.freedom), student_draws(self.freedom + 1.0)[OTHER]
        wider = np.sqrt((self.freedom + first**2) / (self.freedom + 1.0))
        return np.asarray(more * wider * np.sqrt(self.variance), dtype=np.float64)


def lonely_strata(design: Design) -> list[int]:
    """The strata that have one site of several: differences between their sites cannot be seen."""
    n = np.bincount(design.stratum_of_site(), minlength=len(design.sites_there))
    return [h for h in range(len(n)) if n[h] == 1 and design.sites_there[h] > 1.0]


@dataclass(frozen=True, eq=False)
class _Stratum:
    """The rows of a stratum with their sites; part: what it weighs; seen: the share of its sites; own: the
    variance of its mean, of heights of variance 1 within sites; moved: what shared errors move the sites by;
    kept, free, cell: of each row, what estimated means leave of it (`survey_weights.left_of_squares`).
    """

    rows: Ints | slice
    sites: Sites
    part: float
    seen: float
    own: float
    moved: list[Floats]
    kept: Floats
    free: Floats
    cell: Ints

    def apart(self, influence: Floats) -> Floats:
        """Squares of what the influences (N,) of its rows lie beside those of their sites."""
        return np.square(influence - self.sites.means(influence)[self.sites.code])

    def within(self, apart: Floats, otherwise: tuple[float, float]) -> tuple[float, float]:
        """Variance of its mean by sampling within sites, with Satterthwaite's degrees of freedom.

        Each site has the spread of its own heights; one that stands alone has that of the stratum, or
        `otherwise`, the whole design's with its degrees of freedom (Cochran 1977, 5.3 and 5.4).
        """
        assert self.sites.weight is not None
        free = float(self.free.sum())
        spread = mean_variance(apart, self.kept) if free > NOTHING else otherwise[0]
        weight = np.square(self.sites.weight / self.sites.weight.sum())
        each = variances(apart, self.kept, spread)
        of_site = (np.bincount(self.sites.code, each) / self.sites.count)[self.sites.code]
        by_cell, freedom = np.bincount(self.cell, weight * of_site), np.bincount(self.cell, self.free)
        told = freedom > NOTHING
        squares = float(np.sum(by_cell[told] ** 2 / freedom[told]))
        squares += float(by_cell[~told].sum()) ** 2 / max(free if free > NOTHING else otherwise[1], 1.0)
        found = float(by_cell.sum()) ** 2 / squares if squares > 0.0 else max(free, 1.0)
        return float(np.sum(weight * each)), found


class Drawn:
    """A design made ready for many figures of the same rows (N,). shared: errors (N,) that act on heights."""

    def __init__(self, design: Design, shared: tuple[SharedErrors, ...] = ()) -> None:
        self.design, self._shared = design, shared
        self._drawn = design.weight if design.drawn is None else design.drawn
        whole = float(design.weight.sum())
        self._strata: list[_Stratum] = []
        left = left_of_squares(self._drawn, design.site, design.margins) if design.margins else None
        for h in range(len(design.sites_there)):
            chosen = np.flatnonzero(design.stratum == h)
            if not len(chosen):
                continue
            rows = slice(None) if len(chosen) == len(design.weight) else chosen
            code = compact(design.site[rows])
            sites = Sites(code, np.bincount(code).astype(np.float64), design.weight[rows])
            part = float(design.weight[rows].sum()) / whole
            j = len(sites.count)
            told = [one.where(rows) for one in shared]
            moved = [one.by_site_m(sites.code, j, sites.weight) for one in told]
            # Of sites with one height each their differences alone say how far heights lie apart.
            part_seen = 0.0 if 1 < j == len(sites.code) else min(j / float(design.sites_there[h]), 1.0)
            own_weight = design.weight[rows]
            own = float(np.square(own_weight).sum()) / float(own_weight.sum()) ** 2
            if left is None:
                kept, free, cell = sites.kept, 1.0 - own_weight / sites.total[sites.code], sites.code
            else:
                kept, free, cell = left[0][rows], left[1][rows], compact(left[2][rows])
            self._strata.append(
                _Stratum(
                    rows=rows, sites=sites, part=part, seen=part_seen, own=own, moved=moved,
                    kept=kept, free=free, cell=cell,
                )
            )  # fmt: skip
        self._kept = np.concatenate([one.kept for one in self._strata])
        self._free = sum(float(one.free.sum()) for one in self._strata)
        self.of_all_m2 = sum(float(np.square(one.of_mean_m(design.weight)).sum()) for one in shared)

    def sampled(self, influence: Floats, smooth: Sequence[Floats] = (), *, height: bool = True) -> Sampled:
        """Variance of a weighted mean of which `influence` (N,) is each height's influence, in its unit
        squared.

        Within strata as `sites.pooled_variance`, sampling within sites as `_Stratum.within`; of a stratum of
        which part f was seen, 1 - f of the variance between sites and f of that within them counts (Särndal,
        Swensson & Wretman 1992, 4.3), with degrees of freedom by Satterthwaite. smooth: (N,) each, as there,
        of which that counts by which the variance is largest; none: the influence itself. height: shared
        errors act as on heights.
        """
        own = residuals(influence, self._drawn, self.design.margins)
        if np.abs(own).max(initial=0.0) < 1e-12:  # the weights were made to meet it
            return Sampled(0.0, _MANY, self.of_all_m2 if height else 0.0)
        apart = [one.apart(own[one.rows]) for one in self._strata]
        otherwise = mean_variance(np.concatenate(apart), self._kept), self._free
        inner = [one.within(here, otherwise) for one, here in zip(self._strata, apart, strict=True)]
        evens = (residuals(one, self._drawn, self.design.margins) for one in smooth) if smooth else (own,)
        return max((self._pooled(even, inner, height) for even in evens), key=lambda one: one.variance)

    def _pooled(self, even: Floats, inner: Sequence[tuple[float, float]], height: bool) -> Sampled:
        """`sampled` by one smooth influence `even` (N,); inner: of each stratum, within its sites."""
        variance, squares, shared_seen, inside = 0.0, 0.0, 0.0, 0.0
        for stratum, (here, freedom) in zip(self._strata, inner, strict=True):
            within = here
            if len(stratum.sites.count) > 1 and stratum.seen < 1.0:
                moved = stratum.moved if height else []
                found = pooled_variance(stratum.sites, even[stratum.rows], here / stratum.own, moved)
                here, freedom = (1.0 - stratum.seen) * found.variance + stratum.seen * here, found.freedom
                within = (1.0 - stratum.seen) * found.within * found.variance + stratum.seen * within
                shared_seen += stratum.part**2 * (1.0 - stratum.seen) * found.seen
            inside += stratum.part**2 * within
            variance += stratum.part**2 * here
            squares += (stratum.part**2 * here) ** 2 / freedom
        unseen = max(self.of_all_m2 - shared_seen, 0.0) if height else 0.0
        freedom = variance**2 / squares if squares > 0.0 else _MANY
        within = min(inside / max(variance, 1e-300), 1.0)
        shift = min(shared_seen / max(variance, 1e-300), 1.0 - within)
        return Sampled(variance, freedom, unseen, within, shift)

    @property
    def tells_spread(self) -> bool:
        """Whether its heights say how far heights lie apart: not where each is all that a mean is made of."""
        return self.compares_sites or self._free > NOTHING

    @property
    def compares_sites(self) -> bool:
        """Whether differences between sites are part of its variances."""
        return any(len(one.sites.count) > 1 and one.seen < 1.0 for one in self._strata)

    def more_needed(self) -> Said:
        """Why a figure has no interval where nothing tells how far heights lie apart."""
        count = len(self.design.weight)
        return Said("stat-heights-needed", needed=count + 1, count=count)

    def between(self, influence: Floats) -> float:
        """Standard deviation of sites within strata, of figures with this influence (N,), beyond sampling."""
        variances, weights = [], []
        for stratum in self._strata:
            if len(stratum.sites.count) > 1:
                own = influence[stratum.rows]
                apart = np.square(own - stratum.sites.means(own)[stratum.sites.code])
                inner = np.bincount(stratum.sites.code, apart) / np.maximum(stratum.sites.count - 1.0, 1.0)
                sampling = float(np.mean(inner / stratum.sites.effective_count))
                variances.append(float(stratum.sites.means(own).var(ddof=1)) - sampling)
                weights.append(len(stratum.sites.count) - 1.0)
        found = float(np.average(variances, weights=weights)) if weights else 0.0
        return float(np.sqrt(max(found, 0.0)))

    def figure(self, value: float, influence: Floats, *, height: bool = False) -> TotalFigure:
        """A figure with this value and influence (N,), with Student's interval (Cochran 1977, 2.8)."""
        if not self.tells_spread:
            return without_interval(self.more_needed(), value)
        found = self.sampled(influence, height=height)
        low, high = ends_of(found.draws() + np.sqrt(found.unseen) * normal_draws())
        return TotalFigure(value, value + low, value + high)


def reorder_design(design: Design, order: Ints | NDArray[np.bool_]) -> Design:
    """The same design for rows of `order`, (M,) by number or (N,) by truth. Own method: columns alike."""
    return Design(
        weight=design.weight[order],
        stratum=design.stratum[order],
        site=design.site[order],
        sites_there=design.sites_there,
        margins=tuple(one.where(order) for one in design.margins),
        drawn=None if design.drawn is None else design.drawn[order],
    )


def share_of(drawn: Drawn, chosen: NDArray[np.bool_], among: NDArray[np.bool_] | None = None) -> TotalFigure:
    """The share of the fleet, or of the part of it that `among` (N,) are of, that is `chosen` (N,), 0 to 1,
    with its interval: sampling and sites.

    Of a part by the weights of the whole (Särndal, Swensson & Wretman 1992, 5.8). By the Beta distribution
    of as many vehicles as would tell it as well (Korn & Graubard 1998).
    """
    share = drawn.design.weight / drawn.design.weight.sum()
    part = np.ones(len(share)) if among is None else among.astype(np.float64)
    whole, count = float(np.sum(share * part)), int(part.sum())
    value = float(np.sum(share * part * chosen)) / whole
    if not drawn.tells_spread:
        return without_interval(drawn.more_needed(), value)
    sampled = drawn.sampled(np.asarray(part * (chosen - value) / whole, dtype=np.float64), height=False)
    if sampled.freedom == _MANY and 0.0 < value < 1.0:  # the weights were made to meet it
        return TotalFigure(value, value, value)
    plain = value * (1.0 - value) / count
    longer = float(scipy.special.stdtrit(sampled.freedom, 1.0 - TAIL)) / COVERAGE_95
    n = value * (1.0 - value) / (sampled.variance * longer**2) if sampled.variance > 0.0 else float(count)
    n = min(n, 10.0 * count)
    low, high = scipy.special.betaincinv(n * value + 0.5, n * (1.0 - value) + 0.5, [TAIL, 1.0 - TAIL])
    effect = sampled.variance / plain if plain > 0.0 else None
    return TotalFigure(value, float(min(low, value)), float(max(high, value)), effect=effect)
