"""Sites as clusters: the variance of a figure that is pooled from several, by what they differ in.

Heights of J sites say of all roads what J numbers say: the pooled figure is a weighted mean of the sites'
own, and its variance is seen in their differences (Bell & McCaffrey, Survey Methodology 28, 2002, for unequal
sites), with Satterthwaite's degrees of freedom (Biometrics Bulletin 2, 1946). For few sites no other interval
covers alike whether they differ or not.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from sightline.arrays import Floats, Ints

_SOME = 6  # sites; from then on sampling within them is taken from all heights, not from their differences
_MANY = 400  # sites; from then on their degrees of freedom are one less than they are
NOTHING = 1e-9  # of a squared deviation's mean: a height that its own site's mean is made of alone


@dataclass(frozen=True, eq=False)
class Sites:
    """code: (N,), 0 to J - 1, the site of each height; count: (J,), heights of each; weight: (N,), how many
    vehicles each height stands for, None: all alike.
    """

    code: Ints
    count: Floats
    weight: Floats | None = None

    @cached_property
    def total(self) -> Floats:
        """The weight of each site, (J,)."""
        total = self.count if self.weight is None else np.bincount(self.code, self.weight)
        return np.asarray(total, dtype=np.float64)

    @cached_property
    def share(self) -> Floats:
        """What each site weighs among all, (J,)."""
        return np.asarray(self.total / self.total.sum(), dtype=np.float64)

    @cached_property
    def effective_count(self) -> Floats:
        """Heights of equal weight that would tell each site's mean as well, (J,) (Kish 1965, 11.7)."""
        if self.weight is None:
            return self.count
        return np.asarray(self.total**2 / np.bincount(self.code, self.weight**2), dtype=np.float64)

    @cached_property
    def kept(self) -> Floats:
        """The mean of each squared deviation from its site's mean, (N,), of heights of variance 1."""
        assert self.weight is not None
        squares = np.bincount(self.code, self.weight**2) / self.total**2
        kept = 1.0 - 2.0 * self.weight / self.total[self.code] + squares[self.code]
        return np.asarray(np.maximum(kept, 0.0), dtype=np.float64)

    def means(self, values: Floats) -> Floats:
        """Each site's mean, (J,), of values (N,)."""
        if self.weight is None:
            return np.asarray(np.bincount(self.code, values) / self.count, dtype=np.float64)
        return np.asarray(np.bincount(self.code, self.weight * values) / self.total, dtype=np.float64)


@dataclass(frozen=True)
class PooledVariance:
    """Variance of a pooled figure with its degrees of freedom.

    within: the share of it that comes of sampling within sites; seen: that part of it which is of shared
    errors, by which sites differ.
    """

    variance: float
    freedom: float
    within: float
    seen: float


def sites_of(site: Ints | None) -> Sites | None:
    """Sites by `site` (N,), codes of any kind; None where there are not two, or where each height has its
    own.

    Own reading: a cluster of one height each is a sample without clusters.
    """
    if site is None:
        return None
    code = np.unique(site, return_inverse=True)[1].astype(np.int64)
    count = np.bincount(code).astype(np.float64)
    return Sites(code, count) if 1 < len(count) < len(code) else None


def pooled_variance(sites: Sites, smooth: Floats, inner: float, moved: Sequence[Floats]) -> PooledVariance:
    """Variance of a figure by each height's influence on it, in the figure's unit.

    The estimate of Bell and McCaffrey 2002 with Satterthwaite's degrees of freedom (Satterthwaite 1946).
    smooth: (N,), an influence of the same mean in every site whose values do not jump, for a percentile's own
    takes two values only and sites tie; the influence itself where it does not jump. inner: variance of the
    influence within sites. moved: what each error that heights share moves the sites by, (J, G).
    """
    count, weight = sites.effective_count, sites.share
    of_site = sites.means(smooth)
    of_site = of_site - weight @ of_site
    inner_smooth = _within(sites, smooth)
    emphasis = weight**2 / (1.0 - weight)
    observed = float(emphasis @ of_site**2)
    apart = max(_excess(count, of_site, inner_smooth), sum(_variance_between(one) for one in moved))
    alike = 1.0 if inner_smooth == inner == apart == 0.0 else 0.0  # sites of one height each, all the same
    expected, freedom = _moments(weight, emphasis, (inner_smooth + alike) / count + apart)
    total = float(weight**2 @ ((inner + alike) / count + apart))
    variance = observed * total / expected
    more = float(weight**2 @ ((inner - inner_smooth) / count))
    if len(count) >= _SOME and more > 0.0:  # taken away it could leave nothing, or less
        seen = observed * (total - more) / expected
        variance = seen + more
        freedom *= (variance / max(seen, 1e-30)) ** 2
    shown = 0.0
    for one in moved:
        all_together = float(np.square(weight @ one).sum())
        differing = float(emphasis @ np.square(one - weight @ one).sum(axis=1))
        shown += min(differing * total / expected, all_together)
    within = min(inner * float(weight**2 @ (1.0 / count)) / total, 1.0)
    return PooledVariance(variance, freedom, within, shown)


def _within(sites: Sites, influence: Floats) -> float:
    apart = np.square(influence - sites.means(influence)[sites.code])
    if sites.weight is None:
        return float(apart.sum()) / (len(influence) - len(sites.count))
    found = variances(apart, sites.kept, mean_variance(apart, sites.kept))
    squares = sites.weight**2
    return float(np.sum(squares * found) / squares.sum())


def mean_variance(apart: Floats, kept: Floats) -> float:
    """The variance of heights of which `apart` (N,) are squared deviations from means that were estimated of
    them, and `kept` (N,) what is left of their mean; 0 where nothing is.

    Unbiased where all vary alike (Cochran 1977, 5.3).
    """
    left = float(kept.sum())
    return float(apart.sum()) / left if left > NOTHING else 0.0


def variances(apart: Floats, kept: Floats, otherwise: float) -> Floats:
    """An estimate of each height's variance (N,), of its squared deviation `apart` (N,) and what a mean that
    was estimated of the heights left of that, `kept` (N,); `otherwise`: of one that stands alone.

    Unbiased where all of a mean's heights vary alike (Cochran 1977, 5.3).
    """
    told = kept > NOTHING
    return np.where(told, apart / np.where(told, kept, 1.0), otherwise)


def _variance_between(moved: Floats) -> float:
    """Variance between sites of what shared errors (J, G) move them by."""
    return float(np.square(moved - moved.mean(axis=0)).sum()) / (len(moved) - 1)


def _excess(count: Floats, of_site: Floats, inner: float) -> float:
    """Variance between sites beyond sampling, by its moments (Cochran, Biometrics 10, 1954), not below 0."""
    n = float(count.sum())
    observed = float(count @ of_site**2)
    return max((observed - (len(count) - 1) * inner) / (n - float(count @ count) / n), 0.0)


def excess_variance(sites: Sites, values: Floats, moved: Sequence[Floats]) -> float:
    """Variance between sites of values (N,) beyond sampling and beyond what shared errors move the sites by,
    `moved` (J, G) each, not below 0; as `pooled_variance` has it.
    """
    of_site = sites.means(values)
    of_site = of_site - sites.share @ of_site
    found = _excess(sites.effective_count, of_site, _within(sites, values))
    return max(found - sum(_variance_between(one) for one in moved), 0.0)


def _moments(weight: Floats, emphasis: Floats, working: Floats) -> tuple[float, float]:
    """Mean of the sum of `emphasis` times the squared deviations of sites whose variances are `working`, (J,)
    each, and the degrees of freedom of a chi-squared variable of the same two moments.
    """
    total = float(weight**2 @ working)
    expected = float(emphasis @ (working - 2.0 * weight * working + total))
    if len(weight) > _MANY:
        return expected, float(len(weight) - 1)
    own = weight * working
    covariance = total - own[:, None] - own[None, :]
    covariance[np.diag_indices(len(weight))] += working
    variance = 2.0 * float(emphasis @ covariance**2 @ emphasis)
    return expected, 2.0 * expected**2 / variance


def compact(code: Ints) -> Ints:
    """Numbers (N,) from 0 without gaps, in the order of code (N,)."""
    if int(code.max()) > 8 * len(code) + 1000:
        return np.asarray(np.unique(code, return_inverse=True)[1], dtype=np.int64)
    return np.asarray((np.cumsum(np.bincount(code) > 0) - 1)[code], dtype=np.int64)
