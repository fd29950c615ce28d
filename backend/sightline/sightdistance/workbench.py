"""From heights with intervals to crests with theirs, and what a survey would change of a standard's road."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from sightline.coverage import COVERAGE_95, expanded
from sightline.enums import CrestVerdict, Crossing, Manoeuvre, SightKind
from sightline.errors import BadInput
from sightline.messages.said import Said
from sightline.sightdistance.curves import (
    TALLEST_M,
    crest_constant,
    crest_distance_m,
    crest_k_m,
    crest_length,
)
from sightline.sightdistance.distances import (
    METRIC,
    SightDistance,
    UnitSystem,
    decision_distance,
    intersection_distance,
    passing_distance,
    stopping_distance,
)

_MANOEUVRE: dict[SightKind, Manoeuvre] = {
    "decision_a": "A",
    "decision_b": "B",
    "decision_c": "C",
    "decision_d": "D",
    "decision_e": "E",
}
_CROSSING: dict[SightKind, Crossing] = {
    "intersection_left": "left_from_stop",
    "intersection_right": "right_from_stop",
}


@dataclass(frozen=True)
class Bounded:
    """A value with its 95 % interval; low and high None: exact, unless `reason` says that none is known."""

    value: float
    low: float | None = None
    high: float | None = None
    reason: Said | None = None

    @property
    def u(self) -> float:
        """The standard uncertainty that the interval states; 0 without one."""
        if self.low is None or self.high is None:
            return 0.0
        return (self.high - self.low) / (2.0 * COVERAGE_95)


@dataclass(frozen=True)
class Crest:
    """What one pair of heights means for a sight distance S and a difference A of the grades.

    constant_m: C; k_m: S^2 / C; length_m: the least length for A; seen_m: how far one sees on the crest
    that the standard's heights ask for.
    """

    eye_m: Bounded
    object_m: Bounded
    constant_m: Bounded
    k_m: Bounded
    length_m: Bounded
    seen_m: Bounded


@dataclass(frozen=True)
class Comparison:
    """One pair of heights against the standard's: the change of K (and of C, by its inverse) as a share.

    verdict: "alike" where the interval holds the standard's constant, "shorter" where crests may be shorter,
    "longer" where they have to be longer, "unknown" without an interval.
    """

    verdict: CrestVerdict
    k_change: float


def sight_distance(kind: SightKind, speed_mps: float, units: UnitSystem = METRIC) -> SightDistance:
    """The distance of a kind at a design speed (AASHTO 2018); passing in metric only. Raises BadInput."""
    if kind == "stopping":
        return stopping_distance(speed_mps, units)
    if kind == "passing":
        return passing_distance(speed_mps)
    if kind in _MANOEUVRE:
        return decision_distance(speed_mps, _MANOEUVRE[kind], units)
    return intersection_distance(speed_mps, _CROSSING[kind], units)


def with_u(value_m: float, u_m: float | None) -> Bounded:
    """A height with the 95 % interval of its u, metres; exact without. Raises BadInput for a u above all."""
    if u_m is None:
        return Bounded(value_m)
    if not 0.0 <= u_m <= TALLEST_M:
        raise BadInput("sightdistance-uncertainty")
    return Bounded(value_m, value_m - expanded(u_m), value_m + expanded(u_m))


def constant_of(eye_m: Bounded, object_m: Bounded, correlation: float = 0.0) -> Bounded:
    """The crest constant of two heights with the interval that theirs give, metres.

    sqrt(C / 200) = sqrt(h1) + sqrt(h2) is a sum of two parameters, whose limits are recovered from those of
    each (Zou and Donner 2008): (l, u) = sum -+ sqrt(d1^2 + d2^2 + 2 r d1 d2), d: what each limit is away from
    its value, r: the correlation of both errors (heights of one road pose share its and its board's).
    Intervals need not be symmetric. A height without an interval is taken as exact, unless
    it has a reason for lacking one: then so has the constant. Raises BadInput for heights that cannot be.
    """
    constant = crest_constant(eye_m.value, object_m.value).constant_m
    reason = eye_m.reason or object_m.reason
    if reason is not None:
        return Bounded(constant, reason=reason)
    if eye_m.low is None and object_m.low is None:
        return Bounded(constant)
    middle = math.sqrt(eye_m.value) + math.sqrt(object_m.value)
    below = _combine_gaps(_root_gap(eye_m, eye_m.low), _root_gap(object_m, object_m.low), correlation)
    above = _combine_gaps(_root_gap(eye_m, eye_m.high), _root_gap(object_m, object_m.high), correlation)
    low = max(middle - below, 0.0)
    return Bounded(constant, 200.0 * low**2, 200.0 * (middle + above) ** 2)


def crest_of(
    eye_m: Bounded,
    object_m: Bounded,
    distance_m: float,
    difference_percent: float,
    built_constant_m: float,
    correlation: float = 0.0,
) -> Crest:
    """What two heights mean for S and A; built_constant_m: the standard's, by which a road was built;
    correlation: of the errors of both heights.
    """
    constant = constant_of(eye_m, object_m, correlation)
    built = crest_length(distance_m, difference_percent, built_constant_m).length_m
    return Crest(
        eye_m=eye_m,
        object_m=object_m,
        constant_m=constant,
        k_m=k_of(distance_m, constant),
        length_m=map_bounded(
            constant, lambda c: crest_length(distance_m, difference_percent, c).length_m, falling=True
        ),
        seen_m=map_bounded(constant, lambda c: crest_distance_m(built, difference_percent, c)),
    )


def map_bounded(estimate: Bounded, by: Callable[[float], float], *, falling: bool = False) -> Bounded:
    """A monotone function of an estimate, with its interval.

    Own method: limits of a monotone function are the function of the limits.
    """
    if estimate.low is None or estimate.high is None:
        return Bounded(by(estimate.value), reason=estimate.reason)
    low, high = (
        by(limit) for limit in ((estimate.high, estimate.low) if falling else (estimate.low, estimate.high))
    )
    return Bounded(by(estimate.value), low, high)


def k_of(distance_m: float, constant_m: Bounded) -> Bounded:
    """K = S^2 / C with the interval of C."""
    return map_bounded(constant_m, lambda c: crest_k_m(distance_m, c), falling=True)


def compare(standard_constant_m: float, constant_m: Bounded) -> Comparison:
    """What the constant of measured heights says of the standard's."""
    change = standard_constant_m / constant_m.value - 1.0
    if constant_m.low is None or constant_m.high is None:
        return Comparison("unknown", change)
    if constant_m.low > standard_constant_m:
        return Comparison("shorter", change)
    if constant_m.high < standard_constant_m:
        return Comparison("longer", change)
    return Comparison("alike", change)


def shares_of_fleet(shares: Sequence[float]) -> tuple[float, ...]:
    """Shares of a fleet that sum to 1 within 1 %, scaled to do so. Raises BadInput for others."""
    total = math.fsum(shares)
    if any(not (math.isfinite(one) and one >= 0.0) for one in shares) or not 0.99 <= total <= 1.01:
        raise BadInput("sightdistance-shares", total_percent=f"{100 * total:.1f}")
    return tuple(one / total for one in shares)


def _combine_gaps(one: float, other: float, correlation: float) -> float:
    return math.sqrt(max(one * one + other * other + 2.0 * correlation * one * other, 0.0))


def _root_gap(height: Bounded, limit: float | None) -> float:
    return 0.0 if limit is None else abs(math.sqrt(height.value) - math.sqrt(max(limit, 0.0)))
