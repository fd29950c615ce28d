"""How many vehicles a percentile's interval of a wanted width takes."""

from dataclasses import dataclass

import numpy as np
import scipy

from sightline.coverage import COVERAGE_95
from sightline.errors import BadInput
from sightline.messages.said import Said
from sightline.statistics.distributions import vehicles_for_interval


@dataclass(frozen=True)
class SampleSize:
    """Vehicles needed so that a percentile's 95 % interval is no wider than `width_m` in the mean."""

    percent: float
    width_m: float
    vehicles: int
    words: Said


def vehicles_needed(percent: float, width_m: float, sd_m: float) -> SampleSize:
    """For heights that spread like a normal distribution of standard deviation `sd_m`.

    The large-sample interval of a percentile, z sqrt(p (1 - p) / n) / f on either side, where f is the
    density there (David & Nagaraja 2003, 10.2); never fewer than the interval needs to exist at all.
    Raises BadInput for a percentile outside 0 to 100 or widths that are not positive.
    """
    if not 0.0 < percent < 100.0:
        raise BadInput("statistics-percentile-range", percent=format(percent, "g"))
    if not (0.0 < width_m < 10.0 and 0.0 < sd_m < 10.0):
        raise BadInput("statistics-width-not-positive")
    p = percent / 100.0
    z = COVERAGE_95
    at_percentile = float(scipy.stats.norm.pdf(scipy.stats.norm.ppf(p))) / sd_m
    large = int(np.ceil((2.0 * z / (width_m * at_percentile)) ** 2 * p * (1.0 - p)))
    least = vehicles_for_interval(percent)
    vehicles = max(large, least)
    words = Said(
        "stat-vehicles-give",
        vehicles=vehicles,
        percent=percent,
        width_m=round(width_m, 3),
        sd_m=round(sd_m, 3),
    )
    return SampleSize(percent, width_m, vehicles, words)
