"""Percentiles of another fleet: the heights of each class as measured, mixed by other shares."""

from collections.abc import Sequence

import numpy as np

from sightline.arrays import Ints
from sightline.statistics.sites import sites_of
from sightline.statistics.survey_design import Design
from sightline.statistics.survey_weights import Margin
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty


def mixed_fleet(sample: HeightSample, code: Ints, shares: Sequence[float]) -> TotalUncertainty:
    """A fleet in which class c has the share `shares`[c], from heights of each class: its figures with their
    total 95 % intervals.

    code (N,): the class of each height of the sample (N,). Each height weighs shares[c] / n_c
    (post-stratification: Särndal, Swensson & Wretman 1992, 7.6). Sites of the sample are some of many, as in
    its own figures; without them the fleet is that of this one place.
    Shares are taken as exact. Raises ValueError where a class with a share has no height.
    """
    shares_ = np.asarray(shares, dtype=np.float64)
    counts = np.bincount(code, minlength=len(shares_))
    if np.any((shares_ > 0.0) & (counts[: len(shares_)] == 0)) or not shares_.sum() > 0.0:
        raise ValueError("A class with a share has no height.")
    keep = shares_[code] > 0.0
    used = np.flatnonzero(shares_ > 0.0)
    of, n = np.searchsorted(used, code[keep]), int(keep.sum())
    fleet = shares_[used] / shares_.sum()
    chosen = sample.where(np.flatnonzero(keep))
    nowhere, sites = np.zeros(n, dtype=np.int64), sites_of(chosen.site)
    design = Design(
        weight=(fleet / counts[used])[of],
        stratum=nowhere,
        site=nowhere if sites is None else sites.code,
        sites_there=np.array([1.0 if sites is None else np.inf]),
        margins=(Margin(of, fleet),),
        drawn=np.ones(n),
    )
    return TotalUncertainty(chosen, design)
