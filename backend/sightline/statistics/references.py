"""Our own values against reference values that came from elsewhere: a radar, a counter, GPS, a tape."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot

import numpy as np

from sightline.coverage import COVERAGE_95
from sightline.statistics.distributions import share_interval


@dataclass(frozen=True, slots=True)
class Agreement:
    """A difference, ours minus the reference, with its standard uncertainty (k = 1), and its E_n; `within`:
    |E_n| <= 1, the combined U95 holds it.
    """

    difference: float
    u_difference: float
    U95_difference: float
    E_n: float
    within: bool


@dataclass(frozen=True, slots=True)
class ReferenceErrors:
    """Differences, ours minus the references: n of them; `sd` with n - 1, None for one.

    `share_within`: of those with |E_n| <= 1, with its exact 95 % interval.
    """

    n: int
    mean: float
    sd: float | None
    rmse: float
    within: int
    share_within: float
    share_low: float
    share_high: float


def agreement(value: float, u: float, reference: float, u_reference: float) -> Agreement:
    """One value beside its reference, both with standard uncertainties (k = 1) of which one is positive.

    E_n is the difference over its expanded uncertainty (ISO 13528:2022, 9.7), here U95 = 1.96 u; the two
    errors are taken as independent, so the squares of both u add (JCGM 100:2008, 5.1.2).
    """
    difference, u_difference = value - reference, hypot(u, u_reference)
    U95_difference = COVERAGE_95 * u_difference
    E_n = difference / U95_difference
    return Agreement(difference, u_difference, U95_difference, E_n, abs(E_n) <= 1.0)


def reference_errors(agreements: Sequence[Agreement]) -> ReferenceErrors | None:
    """What several say together; None for none of them. The interval of the share is Clopper and Pearson's
    (1934), which takes the vehicles as independent: an error that all share, as of the baseline, widens it.
    """
    if not agreements:
        return None
    n = len(agreements)
    difference = np.array([one.difference for one in agreements])
    within = sum(one.within for one in agreements)
    low, high = share_interval(within, n)
    return ReferenceErrors(
        n=n,
        mean=float(difference.mean()),
        sd=float(difference.std(ddof=1)) if n > 1 else None,
        rmse=float(np.sqrt(np.mean(difference**2))),
        within=within,
        share_within=within / n,
        share_low=low,
        share_high=high,
    )
