"""How many sites, and how many vehicles at each, give a percentile the interval that is wanted."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy

_MOST_VEHICLES = 100_000


@dataclass(frozen=True)
class Components:
    """What makes a percentile uncertain, metres: sampling_m, of one vehicle (the root of p (1 - p) over the
    density there); between_m, standard deviation of sites' own percentiles, their road poses' errors
    included; common_m, of what all sites share. sites_there: of how many sites they are drawn.
    """

    sampling_m: float
    between_m: float
    common_m: float = 0.0
    sites_there: float = np.inf


def U95_of(components: Components, sites: int, vehicles: int) -> float:
    """Half-width, metres, of the 95 % interval from `vehicles` at each of `sites` sites: two stages (Cochran
    1977, 10.3) with Student's t of one degree of freedom less than there are sites; of all sites, the normal.
    """
    part_seen = min(sites / components.sites_there, 1.0)
    within = components.sampling_m**2 / (sites * vehicles)
    between = (1.0 - part_seen) * components.between_m**2 / sites
    if part_seen < 1.0 and sites < 2:
        return float("inf")
    wider = (
        float(scipy.special.stdtrit(sites - 1, 0.975))
        if part_seen < 1.0
        else float(scipy.special.ndtri(0.975))
    )
    normal = float(scipy.special.ndtri(0.975))
    return float(np.hypot(wider * np.sqrt(between + within), normal * components.common_m))


def vehicles_needed(components: Components, sites: int, goal_m: float) -> int | None:
    """The least number of vehicles at each of `sites` sites for U95 <= goal_m, None where none is enough.

    By halving, for `U95_of` falls with every vehicle.
    """
    if U95_of(components, sites, _MOST_VEHICLES) > goal_m:
        return None
    low, high = 0, _MOST_VEHICLES
    while high - low > 1:
        middle = (low + high) // 2
        if U95_of(components, sites, middle) <= goal_m:
            high = middle
        else:
            low = middle
    return high


def plan(components: Components, sites: Sequence[int], goal_m: float) -> list[tuple[int, int | None]]:
    """(sites, vehicles at each) that meet the goal, for each number of sites. By `vehicles_needed`."""
    possible = [one for one in sites if one <= components.sites_there]
    return [(one, vehicles_needed(components, one, goal_m)) for one in possible]
