"""The error table of heights against reference heights (Dupuis et al. 2019, Table 1), with intervals.

The paper's "overall" column is not the pool of its two groups (MAE pools to 0.0198 m, printed
0.0203 m); here every figure is computed from the raw errors, never from other figures.
"""

import warnings
from dataclasses import dataclass, field, replace
from typing import get_args

import numpy as np
import scipy
from numpy.typing import ArrayLike

from sightline.arrays import Floats
from sightline.coverage import COVERAGE_95
from sightline.enums import IntervalPart, Lighting, Rounding
from sightline.messages.said import Said
from sightline.statistics.distributions import share_interval
from sightline.statistics.error_totals import ErrorTotals
from sightline.statistics.total_uncertainty import HeightSample, TotalUncertainty
from sightline.statistics.wording import interval_contents

FIGURES = (
    "bias_m",
    "mae_m",
    "rmse_m",
    "mse_m2",
    "sd_m",
    "pearson_error_vs_height",
    "pearson_abs_error_vs_height",
    "skewness",
)
#: The share of errors of at most so many metres, either way.
SHARES_WITHIN_M = {
    "share_within_10_mm": 0.010,
    "share_within_15_mm": 0.015,
    "share_within_20_mm": 0.020,
    "share_within_30_mm": 0.030,
    "share_within_40_mm": 0.040,
}
ALL_FIGURES = (*FIGURES, *SHARES_WITHIN_M)
#: Those that are lengths, each with a total interval.
LENGTHS = ("bias_m", "mae_m", "rmse_m", "sd_m")
_SAMPLED_ALONE = ("pearson_error_vs_height", "pearson_abs_error_vs_height", "skewness")
_ROUNDING_M = 1e-9  # 0.02 m written as a difference of two heights is not 0.02 in binary
GROUPS = (*get_args(Lighting), "overall")
_RESAMPLES = 4999
_BATCH_NUMBERS = 2_000_000  # resampled values held at once: bounds the memory whatever n is
_SEED = 20190403  # intervals of the same rows are the same numbers
_LEAST_FOR_INTERVALS = 5
MOST_FOR_BOOTSTRAP = 1000
WHOLE_CM = 0.01  # metres: what heights are rounded to as the paper rounds them


@dataclass(frozen=True)
class Interval:
    low: float
    high: float


@dataclass(frozen=True)
class ErrorGroup:
    """One column of the error table. A figure that n rows cannot give is None, and `reason` says why.

    holds: by figure, what its interval holds; words: the same of all but correlations and skewness, and for
    which roads, as the end of a sentence; both empty where there are no intervals.
    """

    n: int
    figures: dict[str, float | None]
    ci95: dict[str, Interval | None]
    reason: Said | None = None
    holds: dict[str, tuple[IntervalPart, ...]] = field(default_factory=dict)
    words: Said | None = None

    def total_ends(self) -> tuple[Interval | None, Interval | None]:
        """Of bias and SD, where they hold more than sampling."""
        if {"shared_errors", "sites"}.isdisjoint(self.holds.get("bias_m", ())):
            return None, None
        return self.ci95["bias_m"], self.ci95["sd_m"]


def round_to_cm(height_m: ArrayLike) -> Floats:
    """Heights `height_m`, any shape, as the paper compares them (Dupuis et al. 2019, section 3.4): to integer
    millimetres, then to centimetres, halves up; in metres, of the same shape.

    (NumPy rounds halves to even, and 1.445 * 100 is not exact: one datasheet height in ten ends in 5 mm. The
    paper says "to the closest integer" and not which way a half goes.)
    """
    millimetres = np.rint(np.asarray(height_m, dtype=np.float64) * 1000.0).astype(np.int64)
    return np.asarray((millimetres + 5) // 10 / 100.0, dtype=np.float64)


def signed_errors(measured_m: ArrayLike, reference_m: ArrayLike, rounding: Rounding) -> tuple[Floats, Floats]:
    """(errors, reference heights), both (N,); `measured_m`, `reference_m` (N,), all in metres.

    error = measured - reference (CONVENTIONS.md, Frames and signs), after rounding both where `rounding` is
    "cm" (Dupuis et al. 2019, section 3.4). To the picometre, so that errors that are equal are equal numbers.
    """
    measured = np.asarray(measured_m, dtype=np.float64)
    reference = np.asarray(reference_m, dtype=np.float64)
    if rounding == "cm":
        measured, reference = round_to_cm(measured), round_to_cm(reference)
    return np.round(measured - reference, 12), reference


def _pearson(a: Floats, b: Floats) -> Floats:
    differ = (np.ptp(a, axis=-1) > 0.0) & (np.ptp(b, axis=-1) > 0.0)
    a = a - a.mean(axis=-1, keepdims=True)
    b = b - b.mean(axis=-1, keepdims=True)
    scale = np.sqrt(np.sum(a * a, axis=-1) * np.sum(b * b, axis=-1))
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(np.where(differ, np.sum(a * b, axis=-1) / scale, np.nan))


def _figures(error: Floats, height: Floats, axis: int = -1) -> Floats:
    """(8, ...) the figures in the order of FIGURES, along the last axis. SD: signed error, n - 1."""
    assert axis in (-1, error.ndim - 1)
    absolute, square = np.abs(error), np.square(error)
    mse = square.mean(axis=-1)
    with np.errstate(invalid="ignore", divide="ignore"):
        sd = error.std(axis=-1, ddof=1) if error.shape[-1] > 1 else mse * np.nan
    return np.stack(
        [
            error.mean(axis=-1),
            absolute.mean(axis=-1),
            np.sqrt(mse),
            mse,
            sd,
            _pearson(error, height),
            _pearson(absolute, height),
            _skewness(error),
        ]
    )


def _skewness(error: Floats) -> Floats:
    """Of the signed error, along the last axis: third central moment over the 3/2 power of the second.

    Positive where the large errors are those that are too high; NaN where all are equal.
    """
    apart = error - error.mean(axis=-1, keepdims=True)
    second = np.square(apart).mean(axis=-1)
    with np.errstate(invalid="ignore", divide="ignore"):
        third = (apart**3).mean(axis=-1)
        return np.asarray(np.where(second > 1e-30, third / second**1.5, np.nan))


def _shares(error: Floats) -> tuple[dict[str, float | None], dict[str, Interval | None]]:
    """The shares of errors within SHARES_WITHIN_M, with exact 95 % intervals (Clopper and Pearson 1934)."""
    values: dict[str, float | None] = {}
    ci95: dict[str, Interval | None] = {}
    for name, limit_m in SHARES_WITHIN_M.items():
        within = int(np.count_nonzero(np.abs(error) <= limit_m + _ROUNDING_M))
        values[name] = within / len(error)
        ci95[name] = Interval(*share_interval(within, len(error)))
    return values, ci95


def _intervals(error: Floats, height: Floats) -> Floats:
    """(8, 2) intervals at 95 %: BCa bootstrap, and for many rows, where it costs minutes and changes nothing,
    the normal ones of the figures' influence values.
    """
    return _bootstrap(error, height) if len(error) <= MOST_FOR_BOOTSTRAP else _of_many(error, height)


def _of_many(error: Floats, height: Floats) -> Floats:
    """(8, 2) normal intervals, variances by the infinitesimal jackknife (Efron 1982, chapter 6)."""
    values = _figures(error, height)
    n, absolute = len(error), np.abs(error)
    mean, mae, rmse, mse, sd = (float(v) for v in values[:5])
    with np.errstate(invalid="ignore", divide="ignore"):
        influence = [
            error - mean,
            absolute - mae,
            (error * error - mse) / (2.0 * rmse),
            error * error - mse,
            ((error - mean) ** 2 - sd * sd) / (2.0 * sd),
            _pearson_influence(error, height, float(values[5])),
            _pearson_influence(absolute, height, float(values[6])),
            _skewness_influence(error, float(values[7])),
        ]
    half = COVERAGE_95 * np.array([np.sqrt(np.mean(np.square(v)) / n) for v in influence])
    return np.stack([values - half, values + half], axis=1)


def _pearson_influence(a: Floats, b: Floats, r: float) -> Floats:
    x, y = (a - a.mean()) / a.std(), (b - b.mean()) / b.std()
    return np.asarray(x * y - 0.5 * r * (x * x + y * y), dtype=np.float64)


def _skewness_influence(error: Floats, skewness: float) -> Floats:
    z = (error - error.mean()) / error.std()
    return np.asarray(z**3 - skewness - 3.0 * z - 1.5 * skewness * (z * z - 1.0), dtype=np.float64)


def _bootstrap(error: Floats, height: Floats) -> Floats:
    """(8, 2) BCa bootstrap intervals at 95 % (Efron 1987), rows resampled together."""
    batch = max(1, min(_RESAMPLES, _BATCH_NUMBERS // len(error)))
    with np.errstate(all="ignore"), warnings.catch_warnings():
        # Equal errors have no interval; the caller sees that in its NaN.
        warnings.simplefilter("ignore", scipy.stats.DegenerateDataWarning)
        interval = scipy.stats.bootstrap(
            (error, height),
            _figures,
            paired=True,
            vectorized=True,
            n_resamples=_RESAMPLES,
            batch=batch,
            method="BCa",
            rng=np.random.default_rng(_SEED),
        ).confidence_interval
    return np.stack([interval.low, interval.high], axis=1)


def error_group(
    error_m: ArrayLike,
    reference_m: ArrayLike,
    measured: HeightSample | None = None,
    names: tuple[str, ...] = ALL_FIGURES,
    rounding: Rounding = "none",
) -> ErrorGroup:
    """One column of the table from `error_m`, `reference_m` (N,), metres, with its 95 % intervals; `names`:
    which of its figures; `rounding`: what the errors were rounded to.

    The figures of Dupuis et al. 2019, Table 1 (its MSE is in m^2, printed as m), and of section 3.4
    (correlations), with skewness and shares that it leaves out, each from the raw errors; SD is that of the
    signed error, with n - 1. measured: the heights (N,) with what they share and their sites.

    Intervals: where heights share errors or have several sites those of `ErrorTotals`, the bias's that of
    `TotalUncertainty`. Otherwise, and for correlations and skewness always, of sampling: exact for shares;
    BCa bootstrap (Efron 1987), for many rows the infinitesimal jackknife's (Efron 1982, ch. 6).
    """
    error = np.asarray(error_m, dtype=np.float64)
    height = np.asarray(reference_m, dtype=np.float64)
    n = len(error)
    if n == 0:
        none: dict[str, float | None] = dict.fromkeys(names)
        return ErrorGroup(0, none, dict.fromkeys(names), Said("stat-no-reference"))
    values = _figures(error, height)
    figures = {name: float(v) if np.isfinite(v) else None for name, v in zip(FIGURES, values, strict=True)}
    shares, shares_ci95 = _shares(error)
    figures = {name: value for name, value in (figures | shares).items() if name in names}
    total, parts, words = _totals(error, measured, names, rounding)
    sampled: tuple[IntervalPart, ...] = ("sampling", "random_error", "known_heights")
    holds = {name: sampled if name in _SAMPLED_ALONE else parts for name in names}
    if n < _LEAST_FOR_INTERVALS:
        none_yet: dict[str, Interval | None] = dict.fromkeys(names)
        if "bias_m" not in total:
            few = Said("stat-too-few", count=n, needed=_LEAST_FOR_INTERVALS)
            return ErrorGroup(n, figures, none_yet, few)
        why = Said("stat-too-few-of-spread", count=n, needed=_LEAST_FOR_INTERVALS)
        ci95 = {**none_yet, "bias_m": total["bias_m"]}
        return ErrorGroup(n=n, figures=figures, ci95=ci95, reason=why, holds=holds, words=words)
    if not np.ptp(error) > 0.0:
        ci95 = {name: shares_ci95.get(name) for name in names}
        holds = {name: holds[name] for name in names if ci95[name]}
        why = Said("stat-errors-without-interval")
        return ErrorGroup(n, figures, ci95, reason=why, holds=holds, words=words if holds else None)
    ci95 = dict.fromkeys(FIGURES)
    if not total.keys() >= set(names):
        ci95 = {
            name: Interval(float(low), float(high)) if np.isfinite([low, high]).all() else None
            for name, (low, high) in zip(FIGURES, _intervals(error, height), strict=True)
        }
    ci95 |= shares_ci95 | total
    return ErrorGroup(n, figures, {name: ci95[name] for name in names}, holds=holds, words=words)


def _totals(
    error: Floats, measured: HeightSample | None, names: tuple[str, ...], rounding: Rounding
) -> tuple[dict[str, Interval], tuple[IntervalPart, ...], Said]:
    """Total intervals of what has them, what they hold, and that in words; of few errors the bias alone."""
    intervals: dict[str, Interval] = {}
    sites = None
    shared = measured is not None and any(bool(np.any(one.group >= 0)) for one in measured.shared)
    if measured is not None:
        of_errors = TotalUncertainty(replace(measured, height_m=error))
        sites = of_errors.sites
        if shared or sites is not None:
            bias = of_errors.mean()
            if bias.U95_low is not None and bias.U95_high is not None:
                intervals["bias_m"] = Interval(bias.U95_low, bias.U95_high)
            if len(error) >= _LEAST_FOR_INTERVALS:
                totals = ErrorTotals(error, measured.shared, measured.site)
                intervals |= _spread_totals(totals, names, rounding)
    there = {"sites": sites is not None, "shared_errors": shared}
    parts = tuple(part for part in get_args(IntervalPart) if there.get(part, True))
    return intervals, parts, interval_contents(parts, sites, Said("stat-random-errors"))


def _spread_totals(totals: ErrorTotals, names: tuple[str, ...], rounding: Rounding) -> dict[str, Interval]:
    mse, mae, sd = totals.mse(), totals.mae(), totals.sd()
    intervals = {
        "mae_m": Interval(*mae),
        "rmse_m": Interval(float(np.sqrt(max(mse.low, 0.0))), float(np.sqrt(mse.high))),
        "mse_m2": Interval(*mse),
        "sd_m": Interval(*sd),
    }
    for name, limit_m in SHARES_WITHIN_M.items():
        if name not in names:
            continue
        intervals[name] = Interval(*totals.share_within(_parting_m(limit_m, rounding)))
    return intervals


def _parting_m(limit_m: float, rounding: Rounding) -> float:
    """Where a limit parts errors: of whole centimetres halfway between two, for what heights share moves them
    before they are rounded.
    """
    if rounding == "none":
        return limit_m + _ROUNDING_M
    return WHOLE_CM * (int(limit_m / WHOLE_CM + _ROUNDING_M) + 0.5)


def error_table(
    measured_m: ArrayLike,
    reference_m: ArrayLike,
    lighting: list[str],
    rounding: Rounding = "cm",
    measured: HeightSample | None = None,
) -> dict[str, ErrorGroup]:
    """The table of errors against reference heights: daytime, low light, overall.

    Dupuis et al. 2019, Table 1; its "overall" is not the pool of its two groups, here it is.

    Parameters
    ----------
    measured_m, reference_m : (N,) array
        Metres.
    lighting : list of str
        N words; rows without one count in overall only.
    rounding : {"cm", "none"}
        "cm": both heights to whole centimetres before they are compared, as in the paper.
    measured : HeightSample, optional
        The measured heights with their budgets, as of `error_group`.

    Returns
    -------
    dict of str to ErrorGroup
        `figures` of each group, metres, with their intervals.

    Examples
    --------
    >>> import sightline
    >>> light = ["daytime", "daytime", "low_light"]
    >>> table = sightline.error_table([1.452, 1.398, 1.511], [1.45, 1.41, 1.50], light, rounding="none")
    >>> list(table), round(table["overall"].figures["mae_m"], 4)
    (['daytime', 'low_light', 'overall'], 0.0083)
    """
    error, reference = signed_errors(measured_m, reference_m, rounding)
    where = np.array(lighting, dtype=object)
    chosen = {name: where == name for name in GROUPS[:2]} | {"overall": np.ones(len(error), dtype=bool)}
    return {
        name: error_group(
            error[rows],
            reference[rows],
            None if measured is None else measured.where(np.flatnonzero(rows)),
            rounding=rounding,
        )
        for name, rows in chosen.items()
    }
