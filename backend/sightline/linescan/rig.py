"""What a rig may be, and what the traffic says of it: misalignment, gain, baseline; and wheelbases.

The residual divergence of the scanning planes cannot be told from the traffic: it acts as a longer baseline
at a farther vehicle, which looks like a faster one. It takes vehicles of known length at several distances,
or a staff or board at two (`rig_calibration`).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import hypot, isfinite, sqrt
from typing import Any, Protocol

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from sightline.coverage import COVERAGE_95, expanded
from sightline.enums import KnownLength, ScanDirection
from sightline.errors import BadInput
from sightline.linescan.equations import travelled_m
from sightline.linescan.parts import Lane, Motion, Rig
from sightline.messages.said import Said
from sightline.robust import robust_scale

#: What a calibration of the rig gives; the correlation is that of these errors and goes with them.
CALIBRATED = ("baseline_m", "u_baseline_m", "divergence_rad", "u_divergence_rad", "baseline_correlation")
LEAST_VEHICLES = 5
LEAST_U_M = 1e-3
# A median's standard deviation over a mean's, for normal errors.
_MEDIAN = sqrt(np.pi / 2)
# Of the larger of two baselines: no tape or calibration errs by so much.
_OTHER_RIG_RATIO = 0.05


@dataclass(frozen=True)
class Limits:
    """From where to where a value of a rig goes, both included, and what it is called in a sentence."""

    name: str
    least: float
    most: float
    unit: str

    def require(self, value: float, name: str | None = None) -> None:
        """Raise BadInput for a value that no rig has; name: what it is called instead."""
        if not (isfinite(value) and self.least <= value <= self.most):
            raise BadInput(
                "linescan-cannot-used-give",
                name=name or self.name,
                value=format(value, ".7g"),
                unit=self.unit,
                least=format(self.least, ".7g"),
                most=format(self.most, ".7g"),
            )


BASELINE_M = Limits("A baseline", 0.01, 100.0, "m")
DIVERGENCE_RAD = Limits("A divergence", -0.2, 0.2, "rad")
DISTANCE_M = Limits("A distance to the vehicles", 0.01, 1000.0, "m")
U_DISTANCE_M = Limits("An uncertainty of the distance to the vehicles", 0.0, 100.0, "m")
MISALIGNMENT_PX = Limits("A misalignment", -1000.0, 1000.0, "px")
SHADOW_SHARE = Limits("A shadow zone", 0.0, 0.6, "of the rows")
#: What the numbers of a rig may be, by name; its baseline's u is no more than the baseline either.
LIMITS: Mapping[str, Limits] = {
    "baseline_m": BASELINE_M,
    "line_rate_hz": Limits("A line rate", 10.0, 1e6, "Hz"),
    "u_baseline_m": Limits("An uncertainty of the baseline", 0.0, BASELINE_M.most, "m"),
    "u_line_rate_ratio": Limits("An uncertainty of the line rate", 0.0, 0.1, "of the line rate"),
    "divergence_rad": DIVERGENCE_RAD,
    "u_divergence_rad": Limits("An uncertainty of the divergence", 0.0, DIVERGENCE_RAD.most, "rad"),
    "distance_m": DISTANCE_M,
    "misalignment_px": MISALIGNMENT_PX,
    "u_misalignment_px": Limits("An uncertainty of the misalignment", 0.0, MISALIGNMENT_PX.most, "px"),
    "shadow_share": SHADOW_SHARE,
    "baseline_correlation": Limits("A correlation of baseline and divergence", -1.0, 1.0, ""),
    "u_distance_m": U_DISTANCE_M,
}


def require_rig(
    rig: Rig, named: Mapping[str, str] | None = None, *, most_u_distance_m: float = U_DISTANCE_M.most
) -> None:
    """Raise BadInput for the first value that no rig has, for a divergence without its distance, and for
    planes that cross before the vehicles or lie too near to each other there; `named`: what values are
    called instead.
    """
    own = {"u_baseline_m": rig.baseline_m, "u_distance_m": most_u_distance_m}
    for name, limits in LIMITS.items():
        value = getattr(rig, name)
        if value is not None:
            replace(limits, most=own.get(name, limits.most)).require(value, (named or {}).get(name))
    _require_lanes(rig.lanes)
    if (rig.divergence_rad or rig.u_divergence_rad) and rig.distance_m is None and not rig.lanes:
        raise BadInput("linescan-divergence-without-distance")
    for distance_m in [one.distance_m for one in rig.lanes] or [rig.distance_m or 0.0]:
        baseline_m = rig.baseline_m + rig.divergence_rad * distance_m
        if baseline_m < 0:
            raise BadInput("linescan-planes-cross", distance_m=distance_m)
        if baseline_m < BASELINE_M.least:
            raise BadInput(
                "linescan-planes-too-near",
                distance_m=distance_m,
                baseline_m=round(baseline_m, 3),
                least_m=BASELINE_M.least,
            )


def rig_from(document: Mapping[str, Any]) -> Rig:
    """The rig of a document that holds its fields by name; lanes that are not there are none. Numbers of
    lanes are floats, so that 106 and 106.0 are one rig.
    """
    lanes = tuple(_lane_from(one) for one in document.get("lanes") or ())
    return Rig(**{**document, "lanes": lanes})


def _lane_from(document: Mapping[str, Any]) -> Lane:
    held: dict[str, Any] = {
        name: float(value) if isinstance(value, int) else value for name, value in document.items()
    }
    return Lane(**held)


def sound_rig_from(document: Mapping[str, Any]) -> Rig | None:
    """The rig of a document that people may have changed by hand; None where no rig is as it says. It may be
    that of a vehicle whose lane is not known (`at_lane`).
    """
    try:
        rig = rig_from(document)
        require_rig(rig, most_u_distance_m=hypot(DISTANCE_M.most / sqrt(12), U_DISTANCE_M.most))
    except (ArithmeticError, AttributeError, TypeError, ValueError, BadInput):
        return None
    return rig


def lane_named(rig: Rig, name: str | None) -> Lane | None:
    """The lane of that name; None where the rig has none."""
    return next((one for one in rig.lanes if one.name == name), None)


def may_be_one_rig(first: Rig, second: Rig) -> bool:
    """Whether two rigs may be one pair of cameras, taped or calibrated at two times: their baselines at the
    vehicles differ by no more than 5 % of the larger, or than their combined U95.
    """
    (first_m, u_first_m), (second_m, u_second_m) = (
        baseline_of(at_lane(one, None)) for one in (first, second)
    )
    corrected_m = _OTHER_RIG_RATIO * max(first_m, second_m)
    return abs(first_m - second_m) <= max(corrected_m, COVERAGE_95 * hypot(u_first_m, u_second_m))


def at_lane(rig: Rig, name: str | None, way: ScanDirection | None = None) -> Rig:
    """The rig with the distance of one lane, its u and its shadow zone; where the lane is not known, of all
    lanes that have the direction `way`.

    Of all: the middle between nearest and farthest, with the u of a distance that lies anywhere between them
    (JCGM 100:2008, 4.3.7), and the highest zone. A rig without lanes as it is.
    """
    if not rig.lanes:
        return rig
    lane = lane_named(rig, name)
    if lane is not None:
        return replace(
            rig,
            distance_m=lane.distance_m,
            u_distance_m=lane.u_distance_m,
            shadow_share=_shadow_share(rig, lane),
        )
    ways = [one for one in rig.lanes if way is None or one.direction in (None, way)] or rig.lanes
    nearest, farthest = (ends(one.distance_m for one in ways) for ends in (min, max))
    u_m = hypot((farthest - nearest) / sqrt(12), max(one.u_distance_m for one in ways))
    shade = max(_shadow_share(rig, one) for one in ways)
    return replace(rig, distance_m=(nearest + farthest) / 2, u_distance_m=u_m, shadow_share=shade)


def _shadow_share(rig: Rig, lane: Lane) -> float:
    return rig.shadow_share if lane.shadow_share is None else lane.shadow_share


def baseline_at(
    baseline: tuple[float, float],
    divergence: tuple[float, float],
    correlation: float,
    distance: tuple[float, float],
) -> tuple[float, float]:
    """B = b + q D and its u, m: u^2 = u_b^2 + D^2 u_q^2 + 2 r D u_b u_q + q^2 u_D^2; given as (value, u).

    Never fails: the square is kept from below 0, which rounding makes of r near -1. JCGM 100:2008, 5.2.2.
    """
    (b, u_b), (q, u_q), (away, u_away) = baseline, divergence, distance
    square = u_b**2 + (away * u_q) ** 2 + 2 * correlation * u_b * away * u_q + (q * u_away) ** 2
    return b + q * away, sqrt(max(square, 0.0))


def baseline_of(rig: Rig) -> tuple[float, float]:
    """Baseline at the vehicle and its standard uncertainty, m: divergence of the planes included, with how
    both go together, and the vehicle's distance.
    """
    return baseline_at(
        (rig.baseline_m, rig.u_baseline_m),
        (rig.divergence_rad, rig.u_divergence_rad),
        rig.baseline_correlation,
        (rig.distance_m or 0.0, rig.u_distance_m),
    )


def common_baseline_of(rig: Rig) -> tuple[float, float]:
    """Baseline at the vehicle, m, and the standard uncertainty of it that all vehicles there share."""
    return baseline_of(rig)[0], hypot(*shared_errors_m(rig))


def shared_errors_m(rig: Rig) -> tuple[float, float]:
    """By how much two independent errors, common to all vehicles of a rig in whichever lane, move the
    baseline at a vehicle, m (k = 1): of baseline and divergence. What a vehicle's own distance adds
    (`u_distance_m`: of one vehicle's) is its own.

    u_b + r D u_q and D u_q (1 - r^2)^1/2: their products for two lanes are the covariance of both baselines,
    u_b^2 + r u_b u_q (D1 + D2) + D1 D2 u_q^2 (JCGM 100:2008, 5.2.2).
    """
    of_divergence, r = (rig.distance_m or 0.0) * rig.u_divergence_rad, rig.baseline_correlation
    return rig.u_baseline_m + r * of_divergence, of_divergence * sqrt(max(1 - r * r, 0.0))


def speed_ratio_of(rig: Rig) -> float:
    """What baseline and line rate give to every speed alike, a share of it (k = 1)."""
    baseline_m, u_baseline_m = common_baseline_of(rig)
    return hypot(u_baseline_m / baseline_m, rig.u_line_rate_ratio)


@dataclass(frozen=True)
class RigEstimate:
    """A rig's constant from n vehicles: value, standard uncertainty, spread of one vehicle; or a reason.

    `agrees`: what is said where there is something to agree with, and no warning.
    """

    value: float | None
    u: float | None
    spread: float | None
    n: int
    reason: Said | None = None
    warning: Said | None = None
    agrees: Said | None = None


class Registered(Protocol):
    """What a vehicle's registration found of the rig: a `Motion`, or a stored one."""

    @property
    def status(self) -> str: ...
    @property
    def misalignment_px(self) -> float | None: ...
    @property
    def u_misalignment_px(self) -> float | None: ...
    @property
    def gain(self) -> float | None: ...


@dataclass(frozen=True)
class Wheelbase:
    """Distance between two clicked axles, m, with its standard uncertainty; or a reason."""

    wheelbase_m: float | None
    u_wheelbase_m: float | None
    reason: Said | None = None


def misalignment(motions: Sequence[Registered]) -> RigEstimate:
    """Row in strip 2 minus row in strip 1, px: the median of what each vehicle's registration found.

    A warning where vehicles differ by much more than their own uncertainties: then it is no constant of the
    rig (a camera moved, or it changes along the rows).
    """
    shifts = [
        (one.misalignment_px, one.u_misalignment_px or 0.0)
        for one in motions
        if one.status == "ok" and one.misalignment_px is not None
    ]
    estimate = _median([value for value, _ in shifts], "misalignment")
    if estimate.spread is None:
        return estimate
    claimed = float(np.median([u for _, u in shifts]))
    if estimate.spread > max(3 * claimed, 0.1):
        warning = Said("rig-misalignments-scatter", sd_px=round(estimate.spread, 2))
        return replace(estimate, warning=warning)
    return estimate


def gain(motions: Sequence[Registered]) -> RigEstimate:
    """Grey of strip 2 over grey of strip 1, the median over the vehicles."""
    return _median([one.gain for one in motions if one.status == "ok" and one.gain is not None], "gain")


def u_without_baseline_m(size_m: float, u_m: float | None, baseline_m: float, u_baseline_m: float) -> float:
    """The uncertainty of a length or wheelbase without the baseline's part, which all vehicles share, m; at
    least LEAST_U_M, for a size without any would outweigh all others.
    """
    common = size_m * u_baseline_m / baseline_m
    return hypot(max((u_m or 0.0) ** 2 - common**2, 0.0) ** 0.5, LEAST_U_M)


def baseline_ratio(
    of: KnownLength, measured_m: ArrayLike, u_measured_m: ArrayLike, true_m: ArrayLike, u_true_m: ArrayLike
) -> RigEstimate:
    """Measured over true lengths or wheelbases (`of`), by weighted mean: 1.01 says the baseline is 1 % long.
    `measured_m`, `u_measured_m`, `true_m`, `u_true_m` (n,), metres.

    The uncertainties are those of single vehicles (boundaries, fit), without the baseline's. Weights 1 / u^2
    of the ratio, u = hypot(u_measured, ratio u_true) / true (JCGM 100:2008, 5.1.2); where vehicles scatter by
    more than that, the mean's u is widened by Birge's ratio (Birge 1932). Too few vehicles give a
    reason. A warning where the ratio is off 1 by more than its U95; whole lengths carry shadows, wheelbases
    do not.
    """
    values, u_values, truth, u_truth = (
        np.atleast_1d(np.asarray(one, dtype=np.float64))
        for one in (measured_m, u_measured_m, true_m, u_true_m)
    )
    n = len(values)
    if n < LEAST_VEHICLES:
        return RigEstimate(None, None, None, n, Said("rig-few-known", count=n, least=LEAST_VEHICLES))
    ratios = values / truth
    u_ratios = np.hypot(u_values, ratios * u_truth) / truth
    weights = 1 / np.maximum(u_ratios, 1e-9) ** 2
    mean = float(np.sum(weights * ratios) / np.sum(weights))
    # where vehicles scatter by more than claimed, the claim is not believed
    excess = max(1.0, float(np.sum(weights * (ratios - mean) ** 2) / (n - 1)))
    u = sqrt(excess / float(np.sum(weights)))
    spread = float(np.std(ratios, ddof=1))
    U95 = expanded(u)
    if abs(mean - 1) <= U95:
        off_percent, U95_percent = (round(100 * share, 2) for share in (abs(mean - 1), U95))
        agrees = Said("rig-baseline-agrees", count=n, of=of, off_percent=off_percent, U95_percent=U95_percent)
        return RigEstimate(mean, u, spread, n, agrees=agrees)
    warning = Said(
        "rig-baseline-off",
        count=n,
        of=of,
        percent=round(100 * abs(mean - 1), 2),
        than="longer" if mean > 1 else "shorter",
        u_percent=round(100 * u, 2),
    )
    return RigEstimate(mean, u, spread, n, warning=warning)


def wheelbase(motion: Motion, rig: Rig, line_a: float, line_b: float, *, u_line: float = 2.0) -> Wheelbase:
    """Distance between the axles clicked at two lines of strip 1, in either order.

    u_line: standard uncertainty of a click, lines. Entries: clicks, the motion's speed and acceleration
    (`u_travelled_m`); the baseline is part of the motion's.
    """
    if motion.speed_mps is None or motion.acceleration_mps2 is None:
        return Wheelbase(None, None, motion.reason or Said("scan-wheelbase-no-motion"))
    lines = np.sort(np.array([line_a, line_b], dtype=np.float64))
    if not np.all(np.isfinite(lines)) or lines[0] == lines[1]:
        return Wheelbase(None, None, Said("scan-wheelbase-one-wheel"))
    seconds = (lines - motion.crossings.front_line_1) / rig.line_rate_hz
    speed, acceleration = motion.speed_mps, motion.acceleration_mps2
    leaving = speed + acceleration * seconds
    if leaving.min() <= 0:
        return Wheelbase(None, None, Said("scan-wheelbase-at-rest"))
    first, second = np.asarray(travelled_m(speed, acceleration, seconds))
    u_clicks = float(np.hypot(*leaving)) * u_line / rig.line_rate_hz
    u_motion = u_travelled_m(motion, float(seconds[0]), float(seconds[1]), rig.u_line_rate_ratio)
    return Wheelbase(float(second - first), hypot(u_clicks, u_motion))


def u_travelled_m(motion: Motion, begin_s: float, end_s: float, u_line_rate_ratio: float) -> float:
    """Standard uncertainty, m, that a measured motion gives to the way v t + a t^2 / 2 between two of its
    lines, `begin_s` and `end_s` after the front's: of speed and acceleration, correlated as fitted (JCGM
    100:2008, 5.2.2), without the clock's.

    A line rate that is c too high makes v and a too large by c and 2 c, and both times too short by c, so the
    way is what it was, like a length.
    """
    speed, acceleration = motion.speed_mps or 0.0, motion.acceleration_mps2 or 0.0
    by_speed, by_acceleration = end_s - begin_s, (end_s**2 - begin_s**2) / 2
    of_speed = by_speed * (motion.u_speed_mps or 0.0)
    of_acceleration = by_acceleration * (motion.u_acceleration_mps2 or 0.0)
    together = 2 * (motion.correlation or 0.0) * of_speed * of_acceleration
    of_clock = (by_speed * speed + 2 * by_acceleration * acceleration) * u_line_rate_ratio
    return sqrt(max(of_speed**2 + of_acceleration**2 + together - of_clock**2, 0.0))


def _require_lanes(lanes: tuple[Lane, ...]) -> None:
    """Raise BadInput for names that are missing or the same, distances of no lane, or rows out of
    order. Lanes may be alike: people then say which is whose.
    """
    names = [one.name.strip() for one in lanes]
    if not all(names):
        raise BadInput("linescan-lane-needs-name")
    for number, lane in enumerate(lanes):
        if names.count(lane.name) > 1 or lane.name != names[number]:
            raise BadInput("linescan-lanes-same-name", name=names[number])
        DISTANCE_M.require(lane.distance_m)
        U_DISTANCE_M.require(lane.u_distance_m)
        SHADOW_SHARE.require(_shadow_share(Rig(1.0, 1.0), lane))
        if (lane.tyres_from_px is None) != (lane.tyres_to_px is None):
            raise BadInput("linescan-lane-rows-both", name=lane.name)
        if lane.tyres_from_px is not None and not 0 <= lane.tyres_from_px < (lane.tyres_to_px or 0.0):
            raise BadInput("linescan-lane-rows-order", name=lane.name)


def _median(values: Sequence[float], of: str) -> RigEstimate:
    n = len(values)
    if n < LEAST_VEHICLES:
        return RigEstimate(
            None, None, None, n, Said("rig-few-vehicles", count=n, of=of, least=LEAST_VEHICLES)
        )
    array: NDArray[np.float64] = np.asarray(values, dtype=np.float64)
    middle = float(np.median(array))
    spread = robust_scale(array - middle)
    # few vehicles: the spread itself is uncertain, as Student's t widens it
    widened = float(scipy.special.stdtrit(n - 1, 0.975) / COVERAGE_95)
    return RigEstimate(middle, widened * _MEDIAN * spread / sqrt(n), spread, n)
