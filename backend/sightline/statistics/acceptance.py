"""Review by lots: single sampling plans by attributes, from two risk points and the exact distribution.

A lot of N heights holds D nonconforming ones. Of n drawn without replacement, X are nonconforming, X being
hypergeometric; the lot is accepted if X <= c, the criterion of ISO 2859. (n, c) is the smallest plan that
keeps both risks for this very N. The standard's tables (code letters, switching rules, plans for a series of
lots) are not reproduced, and no conformity with it is claimed: surveys have a few lots, not a series.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
import scipy

from sightline.arrays import Floats
from sightline.errors import BadInput

_HAIR = 1e-9  # 0.1 x 30 is 3, not 3.0000000000000004
_POINTS = 120
CONFIDENCE = 0.95


@dataclass(frozen=True, slots=True)
class RiskPoints:
    """What a plan promises: of a lot as good as `producer_quality` (fraction nonconforming) at most
    `producer_risk` are not accepted; of one as bad as `consumer_quality` at most `consumer_risk` are.
    """

    producer_quality: float
    producer_risk: float
    consumer_quality: float
    consumer_risk: float


#: 1 height in 100 may be wrong and the lot nearly always passes; with 1 in 10 it hardly ever does.
USUAL_RISKS = RiskPoints(0.01, 0.05, 0.10, 0.10)


@dataclass(frozen=True, slots=True)
class SamplingPlan:
    """Of a lot of `size`, `sample_size` are judged; it is accepted with `acceptance_number` nonconforming
    ones or fewer. `producer_risk` and `consumer_risk` are what the plan keeps, not what was asked.
    """

    size: int
    sample_size: int
    acceptance_number: int
    producer_risk: float
    consumer_risk: float

    @property
    def saves(self) -> bool:
        """Whether the sample is not the whole lot."""
        return self.sample_size < self.size


@dataclass(frozen=True, eq=False)
class OperatingCurve:
    """`fraction` (k,) nonconforming in the lot and `accepted` (k,), the probability that it is accepted."""

    fraction: Floats
    accepted: Floats


@dataclass(frozen=True, slots=True)
class Outgoing:
    """The heights of an accepted lot that nobody looked at: how many, how many of them are nonconforming by
    estimate, and how many at most (one-sided, 95 %).
    """

    count: int
    estimate: float
    at_most: int


def require_risks(risks: RiskPoints) -> None:
    """Raises BadInput for what is no pair of risk points: fractions from 0 to below 1, the producer's below
    the consumer's, risks from 0.001 to 0.5.
    """
    fractions = (risks.producer_quality, risks.consumer_quality)
    chances = (risks.producer_risk, risks.consumer_risk)
    if not all(math.isfinite(one) and 0.0 <= one < 1.0 for one in fractions):
        raise BadInput("lots-fraction-between")
    if not all(math.isfinite(one) and 0.001 <= one <= 0.5 for one in chances):
        raise BadInput("lots-risk-between")
    if not risks.producer_quality < risks.consumer_quality:
        raise BadInput("lots-fractions-in-order")


def worst_good(size: int, risks: RiskPoints) -> int:
    """The largest number of nonconforming heights in a lot no worse than the producer's risk quality."""
    return math.floor(risks.producer_quality * size + _HAIR)


def best_bad(size: int, risks: RiskPoints) -> int:
    """The least number in a lot no better than the consumer's risk quality."""
    return max(1, math.ceil(risks.consumer_quality * size - _HAIR))


def accepted_with(size: int, nonconforming: int, sample_size: int, acceptance_number: int) -> float:
    """Probability that a lot of `size` with so many nonconforming heights is accepted, P(X <= c): X is
    hypergeometric (Johnson, Kemp and Kotz 2005, 6.2), as in type A curves of a single lot.
    """
    return float(scipy.stats.hypergeom.cdf(acceptance_number, size, nonconforming, sample_size))


@lru_cache(maxsize=1024)
def single_plan(size: int, risks: RiskPoints) -> SamplingPlan:
    """The plan with the smallest sample that keeps both risks for a lot of this size.

    For each acceptance number the least sample that keeps the consumer's risk is found by bisection; the
    first that keeps the producer's too has the smallest sample, since a larger number needs a larger one.
    There always is one: the whole lot, at worst.

    Parameters
    ----------
    size : int
        Of the lot.
    risks : RiskPoints
        What the plan is to promise, fractions from 0 to 1.

    Returns
    -------
    SamplingPlan
        `sample_size`, `acceptance_number`, and the risks that it keeps.

    Raises
    ------
    ValueError
        For an empty lot.

    Examples
    --------
    >>> import sightline
    >>> plan = sightline.single_plan(1000, sightline.RiskPoints(0.01, 0.05, 0.10, 0.10))
    >>> plan.sample_size, plan.acceptance_number
    (37, 1)
    """
    if size < 1:
        raise ValueError("a lot holds something")
    good, bad = worst_good(size, risks), best_bad(size, risks)
    for number in range(good + 1):
        sample = _least_sample(size, bad, number, risks.consumer_risk)
        if 1.0 - accepted_with(size, good, sample, number) <= risks.producer_risk + _HAIR:
            break
    kept = 1.0 - accepted_with(size, good, sample, number), accepted_with(size, bad, sample, number)
    return SamplingPlan(size, sample, number, *(max(0.0, one) for one in kept))


def _least_sample(size: int, bad: int, number: int, risk: float) -> int:
    low, high = 0, size  # at `high` the risk is kept: a sample that is the lot holds all `bad` > `number`
    while high - low > 1:
        middle = (low + high) // 2
        if accepted_with(size, bad, middle, number) <= risk:
            high = middle
        else:
            low = middle
    return high


def operating_curve(plan: SamplingPlan, up_to: float = 1.0) -> OperatingCurve:
    """The plan's operating characteristic for fractions nonconforming from 0 to `up_to`: at whole numbers of
    heights, for a lot holds no others; at most some hundred points. Both arrays (k,); nothing is raised.
    """
    most = max(1, math.ceil(min(1.0, up_to) * plan.size))
    numbers = np.unique(np.linspace(0, most, min(most + 1, _POINTS)).round().astype(np.int64))
    accepted = scipy.stats.hypergeom.cdf(plan.acceptance_number, plan.size, numbers, plan.sample_size)
    return OperatingCurve(numbers / plan.size, np.asarray(accepted, dtype=np.float64))


def estimate_outgoing(
    size: int, sample_size: int, nonconforming: int, confidence: float = CONFIDENCE
) -> Outgoing:
    """What an accepted lot lets through, its sample's nonconforming heights being known and not let through.

    Estimate: the sample's fraction of the rest. Upper limit: the largest D for which `nonconforming` or fewer
    in the sample are not yet less likely than 1 - confidence (exact, one-sided, by inverting the
    hypergeometric test; Wright 1991), less those found. Raises ValueError where the sample is empty, or
    larger than the lot.
    """
    if not 0 < sample_size <= size:
        raise ValueError("a sample is of the lot, and holds something")
    rest = size - sample_size
    estimate = rest * nonconforming / sample_size
    numbers = np.arange(nonconforming, nonconforming + rest + 1)
    likely = scipy.stats.hypergeom.cdf(nonconforming, size, numbers, sample_size) > 1.0 - confidence
    return Outgoing(rest, estimate, int(numbers[likely].max()) - nonconforming)


def outgoing_of_lots(lots: Iterable[tuple[int, int, int, int]]) -> Outgoing:
    """The same of several lots, each (size, sample size, nonconforming in it, how many of its rest still
    stand by it), together: of those that stand, for what was judged or withdrawn since is not let through.

    Lots are drawn apart, so k limits at the confidence 0.95^(1/k) hold together in 95 % of cases (Sidak
    1967); their sum is therefore no less than the number let through, and wide where there are many lots.
    """
    listed = tuple(lots)
    each = CONFIDENCE ** (1.0 / max(1, len(listed)))
    limits = [estimate_outgoing(size, sample, bad, each).at_most for size, sample, bad, _ in listed]
    return Outgoing(
        count=sum(standing for _, _, _, standing in listed),
        estimate=sum(standing * bad / sample for _, sample, bad, standing in listed),
        at_most=sum(min(limit, one[3]) for limit, one in zip(limits, listed, strict=True)),
    )
