"""How measured heights agree with reference heights: trend, Bland-Altman, what the reference explains.

Error = measured - reference. A negative correlation of the error with the reference height is no proof of
an error of the camera: an uncertain reference alone makes one (errors in variables), which `reference_part`
states beside it.
"""

from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import ArrayLike

from sightline.arrays import Floats
from sightline.coverage import COVERAGE_95
from sightline.messages.said import Said
from sightline.statistics.errors import Interval

CONFIDENCE = 0.95
LEAST = 4
_PLACES = 64  # of a band
# A manufacturer's height of +-3 cm, anywhere within it alike: 3 cm / sqrt(3).
U_MANUFACTURER_M = 0.03 / 3.0**0.5
ROUNDING_M = 0.01 / np.sqrt(12.0)


@dataclass(frozen=True, eq=False)
class Trend:
    """Straight line through points by least squares: value = intercept + slope * at, with the band of the
    line (not of single points) on a grid of `at`, (M,).
    """

    slope: float
    slope_ci95: Interval
    intercept: float
    correlation: float
    n: int
    at: Floats
    value: Floats
    low: Floats
    high: Floats


@dataclass(frozen=True)
class BlandAltman:
    """Mean difference and limits of agreement (Bland & Altman 1999), metres; the limits with their intervals.
    That of the bias stands in the error table.
    """

    n: int
    bias_m: float
    lower_m: float
    lower_ci95: Interval
    upper_m: float
    upper_ci95: Interval


@dataclass(frozen=True)
class ReferencePart:
    """What the reference heights' own uncertainty, and rounding, explain of the errors' variance.

    `camera_sd_m` is what is left for the measurement, None where nothing is left. `correlation_alone`: the
    correlation of error and reference height that the reference's uncertainty makes by itself.
    """

    u_reference_m: float
    share_of_variance: float
    rounding_share: float
    camera_sd_m: float | None
    correlation_alone: float
    words: Said


def trend(at: ArrayLike, value: ArrayLike) -> Trend | Said:
    """Regression of `value` (N,) on `at` (N,), both finite and in any unit; or the reason why there is none.

    The band is that of the line, at 64 places: +- t s sqrt(1/n + (x - mean)^2 / sum (x - mean)^2), t with
    n - 2 degrees of freedom (Draper and Smith 1998).
    """
    x, y = np.asarray(at, dtype=np.float64), np.asarray(value, dtype=np.float64)
    n = len(x)
    if n < LEAST:
        return Said("stat-trend-needs", least=LEAST, count=n)
    if np.ptp(x) <= 0:
        return Said("stat-heights-alike")
    if np.ptp(y) <= 0:
        return Said("stat-errors-of-one-size")
    line = scipy.stats.linregress(x, y)
    t = float(scipy.stats.t.ppf(0.5 + 0.5 * CONFIDENCE, n - 2))
    grid = np.linspace(x.min(), x.max(), _PLACES)
    fitted = line.intercept + line.slope * grid
    power = float(np.sum((x - x.mean()) ** 2))
    residual = y - line.intercept - line.slope * x
    s = float(np.sqrt(np.square(residual).sum() / (n - 2)))
    half = t * s * np.sqrt(1.0 / n + (grid - x.mean()) ** 2 / power)
    r = float(line.rvalue)
    return Trend(
        slope=float(line.slope),
        slope_ci95=Interval(float(line.slope - t * line.stderr), float(line.slope + t * line.stderr)),
        intercept=float(line.intercept),
        correlation=r,
        n=n,
        at=grid,
        value=fitted,
        low=fitted - half,
        high=fitted + half,
    )


def bland_altman(
    error_m: ArrayLike, bias: Interval | None = None, sd: Interval | None = None
) -> BlandAltman | Said:
    """Limits of agreement from errors `error_m` (N,), metres: bias +- 1.96 sd, or the reason why there are
    none. bias, sd: total 95 % intervals of both, where heights share errors or have several sites.

    Bland and Altman 1999: the variance of a limit is sd^2 (1/n + 1.96^2 / (2 (n - 1))). Its two parts are
    recovered from the intervals of bias and SD where these are given (Zou and Donner 2008).
    """
    error = np.asarray(error_m, dtype=np.float64)
    n = len(error)
    if n < LEAST:
        return Said("stat-limits-need", least=LEAST, count=n)
    if np.ptp(error) <= 0:
        return Said("stat-errors-alike")
    z = COVERAGE_95
    t = float(scipy.stats.t.ppf(0.5 + 0.5 * CONFIDENCE, n - 1))
    mean, spread = float(error.mean()), float(error.std(ddof=1))
    bias = bias or _about(mean, t * spread / np.sqrt(n))
    sd = sd or _about(spread, t * spread / np.sqrt(2.0 * (n - 1)))
    down, up = mean - bias.low, bias.high - mean
    narrower, wider = z * (spread - sd.low), z * (sd.high - spread)
    lower, upper = mean - z * spread, mean + z * spread
    return BlandAltman(
        n=n,
        bias_m=mean,
        lower_m=lower,
        lower_ci95=Interval(lower - float(np.hypot(down, wider)), lower + float(np.hypot(up, narrower))),
        upper_m=upper,
        upper_ci95=Interval(upper - float(np.hypot(down, narrower)), upper + float(np.hypot(up, wider))),
    )


def _about(value: float, half: float) -> Interval:
    return Interval(value - half, value + half)


def reference_part(
    error_m: ArrayLike,
    reference_m: ArrayLike,
    u_reference_m: ArrayLike = U_MANUFACTURER_M,
    rounded: bool = False,
) -> ReferencePart | Said:
    """How much of the errors' variance the reference explains: `error_m`, `reference_m` (N,), `u_reference_m`
    a number or (N,), all in metres; or the reason why that cannot be told.

    u_reference_m: standard uncertainty of each reference height. rounded: both heights were rounded to whole
    centimetres, which adds 1 cm^2 / 12 each (JCGM 100:2008, F.2.2.1).

    Own derivation: error = camera - reference's error, so camera_sd^2 = var(error) - mean(u^2) - rounding,
    and the reference's error alone makes the covariance -mean(u^2) of error and reference height.
    """
    error, reference = np.asarray(error_m, dtype=np.float64), np.asarray(reference_m, dtype=np.float64)
    n = len(error)
    if n < LEAST:
        return Said("stat-variance-shares-need", least=LEAST, count=n)
    if np.ptp(error) <= 0:
        return Said("stat-errors-alike")
    variance = float(error.var(ddof=1))
    truth = float(np.mean(np.square(np.broadcast_to(u_reference_m, (n,)))))
    rounding = 2.0 * float(ROUNDING_M) ** 2 if rounded else 0.0
    left = variance - truth - rounding
    spread = float(reference.std(ddof=1))
    alone = -truth / (spread * np.sqrt(variance)) if spread > 0 else 0.0
    camera = float(np.sqrt(left)) if left > 0 else None
    return ReferencePart(
        u_reference_m=float(np.sqrt(truth)),
        share_of_variance=truth / variance,
        rounding_share=rounding / variance,
        camera_sd_m=camera,
        correlation_alone=float(np.clip(alone, -1.0, 1.0)),
        words=_describe_share(truth / variance, camera),
    )


def _describe_share(share: float, camera_sd_m: float | None) -> Said:
    if camera_sd_m is None:
        return Said("stat-reference-explains-all")
    return Said("stat-reference-explains", share=round(100 * share), camera_sd_m=round(camera_sd_m, 3))
