"""Errors that many heights share (a road pose's, a mean inset's), and what they do to means and spreads."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats, Ints


def correlation_of(
    effects: Mapping[int, float], other: Mapping[int, float], u_one_m: float, u_other_m: float
) -> float:
    """Correlation of two figures' errors, of which `effects` and `other` are what one standard uncertainty of
    each error by name moves them by, and u_one_m, u_other_m their whole standard uncertainties.

    JCGM 100:2008, F.1.2.3: the covariance is the sum of the products over what both share.
    """
    covariance = sum(by * other[name] for name, by in effects.items() if name in other)
    u2 = u_one_m * u_other_m
    return float(np.clip(covariance / u2, -1.0, 1.0)) if u2 > 0.0 else 0.0


def inset_codes(inset_m: Floats, u_inset_m: Floats) -> Ints:
    """Which inset each height assumes, (N,), codes from 0, by `inset_m`, `u_inset_m` (N,), metres, to 0.1 mm.

    Never fails. Own reading: heights that assume the same have the same error of its mean.
    """
    inset = np.rint(np.nan_to_num(inset_m) * 1e4) * 100_000 + np.rint(np.nan_to_num(u_inset_m) * 1e4)
    if np.all(inset == inset[:1]):
        return np.zeros(len(inset), np.int64)
    return np.asarray(np.unique(inset, return_inverse=True)[1], dtype=np.int64)


@dataclass(frozen=True, eq=False)
class SharedErrors:
    """One error for each group of heights, independent between groups and of mean 0.

    group: (N,) codes from 0 without many gaps, -1 for none; u_m: (N,), the error's standard uncertainty as it
    acts on each height. Its sign is taken to be the same on all heights of a group. names: (G,), by which
    the same error is known in another sample (a road pose's number); None: it acts in this one alone.
    """

    group: Ints
    u_m: Floats
    names: Ints | None = None

    def where(self, chosen: Ints | NDArray[np.bool_] | slice) -> "SharedErrors":
        """The rows that are `chosen` (M,), by number, a slice, or (N,), by truth."""
        return SharedErrors(self.group[chosen], self.u_m[chosen], self.names)

    def variance_of_mean_m2(self, weight: Floats | None = None) -> float:
        """Variance of the mean of heights of which these (N,) are a sample; 0 of fewer than 2. weight (N,):
        of each height, None: all alike.

        Over pairs of different heights, so that few heights do not make one group look larger than it is.
        """
        n = len(self.group)
        if n < 2:
            return 0.0
        if weight is None:
            sums, squares = self._by_group()
            return max(float((sums**2 - squares).sum()) / (n * (n - 1)), 0.0)
        sums, squares = SharedErrors(self.group, self.u_m * weight)._by_group()
        pairs = float(weight.sum() ** 2 - np.square(weight).sum())
        return max(float((sums**2 - squares).sum()) / pairs, 0.0)

    def spread_m2(self, share: Floats | None = None) -> float:
        """Variance that differences between groups are expected to add to the spread of the heights, of which
        each has this `share` (N,), None: all alike.
        """
        own, mean = self._of_spread_m2(share)
        return max(float(own.sum()) - float(mean.sum()), 0.0)

    def variance_of_spread_m4(self, share: Floats | None = None) -> float:
        """Variance of what one draw of the errors adds to the spread, about `spread_m2`: of a quadratic form
        in normal variables, twice the sum of its squared coefficients. share: (N,), as there.
        """
        own, mean = self._of_spread_m2(share)
        return max(2.0 * float((own**2 - 2.0 * own * mean).sum() + mean.sum() ** 2), 0.0)

    def by_site_m(self, site: Ints, sites: int, weight: Floats | None = None) -> Floats:
        """What one standard uncertainty of each group moves the mean of each site by, (J, G); site (N,):
        codes; weight (N,): of each height, None: all alike. Groups that act on no height have no column.
        """
        known = self.group >= 0
        there = np.bincount(self.group[known]) > 0
        used, group = np.flatnonzero(there), (np.cumsum(there) - 1)[self.group[known]]
        by = self.u_m[known] if weight is None else self.u_m[known] * weight[known]
        moved = np.bincount(site[known] * len(used) + group, by, sites * len(used)).reshape(sites, len(used))
        return np.asarray(moved / np.bincount(site, weight, minlength=sites)[:, None], dtype=np.float64)

    def of_mean_m(self, weight: Floats) -> Floats:
        """What one standard uncertainty of each group moves the mean of heights of weight (N,) by, (G,)."""
        known = self.group >= 0
        moved = np.bincount(self.group[known], self.u_m[known] * weight[known])
        return np.asarray(moved / weight.sum(), dtype=np.float64)

    def named_of_mean_m(self, weight: Floats) -> dict[int, float]:
        """What one standard uncertainty of each named error moves the mean of heights of weight (N,) by."""
        if self.names is None:
            return {}
        known = self.group >= 0
        moved = np.bincount(self.group[known], self.u_m[known] * weight[known], len(self.names))
        there = np.flatnonzero(moved)
        return dict(zip(self.names[there].tolist(), (moved[there] / weight.sum()).tolist(), strict=True))

    def _of_spread_m2(self, share: Floats | None) -> tuple[Floats, Floats]:
        """The mean square of the heights' errors, and the square of their mean, of each group, (G,) each."""
        n = max(len(self.group), 1)
        if share is None:
            sums, squares = self._by_group()
            return squares / n, sums**2 / n**2
        known = self.group >= 0
        group, u, share = self.group[known], self.u_m[known], share[known]
        own, mean = np.bincount(group, share * u * u), np.bincount(group, share * u)
        return own.astype(np.float64), mean.astype(np.float64) ** 2

    def _by_group(self) -> tuple[Floats, Floats]:
        """Sums of u and of its squares by group, (G,) each."""
        known = self.group >= 0
        group, u = self.group[known], self.u_m[known]
        return np.bincount(group, u).astype(np.float64), np.bincount(group, u * u).astype(np.float64)
