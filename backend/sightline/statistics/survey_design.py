"""How a sample of vehicles was drawn: strata, sites as primary sampling units, weights."""

from dataclasses import dataclass

import numpy as np

from sightline.arrays import Floats, Ints
from sightline.statistics.survey_weights import Margin


@dataclass(frozen=True, eq=False)
class Design:
    """How a sample (N,) was drawn: weight (N,), stratum (N,) codes 0 to H - 1, site (N,) codes 0 to J - 1,
    each in one stratum.

    sites_there: (H,), how many sites each stratum has on the roads, inf where not known. margins: what the
    weights were made to meet; drawn: (N,), the weights before.
    """

    weight: Floats
    stratum: Ints
    site: Ints
    sites_there: Floats
    margins: tuple[Margin, ...] = ()
    drawn: Floats | None = None

    def stratum_of_site(self) -> Ints:
        """The stratum of each site, (J,)."""
        found = np.zeros(int(self.site.max(initial=-1)) + 1, dtype=np.int64)
        found[self.site] = self.stratum
        return found


def weighting_effect(weight: Floats) -> float:
    """How much a `weight` (N,) that differs widens a mean by itself: n times the sum of their squares over
    the square of their sum (Kish 1965, 11.7).
    """
    return float(len(weight) * np.square(weight).sum() / weight.sum() ** 2)
