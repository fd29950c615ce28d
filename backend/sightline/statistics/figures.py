"""A figure with its total interval, and a percentile that may lack the heights to be one."""

from dataclasses import dataclass

from sightline.messages.said import Said


@dataclass(frozen=True)
class TotalFigure:
    """A figure of the true heights with its 95 % interval; `reason` says why there is none, or no figure.

    effect: the design effect, of sampling alone: how much the variance exceeds that of as many vehicles drawn
    one by one.
    """

    value: float | None
    U95_low: float | None
    U95_high: float | None
    reason: Said | None = None
    effect: float | None = None


def without_interval(reason: Said | None, value: float | None = None) -> TotalFigure:
    """A figure without an interval, or without a value too, and why."""
    return TotalFigure(value, None, None, reason)


@dataclass(frozen=True, kw_only=True)
class TotalPercentile(TotalFigure):
    """A percentile of the true heights, metres.

    raw: the plain percentile of the measured heights (linear between heights, Hyndman & Fan 1996, type 7, as
    NumPy, R and spreadsheets have it). Without support, where fewer heights are there than an interval of the
    percentile `needs`, there is no value either, and `reason` says how many are needed and there.
    """

    percent: float
    raw: float
    needs: int
