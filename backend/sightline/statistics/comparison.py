"""Two samples of heights beside each other (two surveys, two years): is the difference more than noise?"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sightline.enums import ComparisonVerdict
from sightline.messages.said import Said
from sightline.statistics.figures import TotalFigure, without_interval
from sightline.statistics.total_uncertainty import TotalUncertainty, difference


@dataclass(frozen=True)
class Compared:
    """The second's figure less the first's, metres; verdict None where there is no interval.

    `verdict`: higher or lower where the 95 % interval of the difference leaves 0 out, so that the risk of
    saying so of two that are alike is at most 2.5 % either way, for each figure by itself.
    """

    difference: TotalFigure
    verdict: ComparisonVerdict | None


@dataclass(frozen=True)
class Comparison:
    """Percentiles in the order asked for, and means."""

    percentiles: list[Compared]
    mean: Compared


def compare(first: TotalUncertainty, second: TotalUncertainty, percents: Sequence[float]) -> Comparison:
    """The second sample less the first one: percentiles by draws of both, means by their intervals (Zou &
    Donner 2008), each with total uncertainty.

    The two are taken to share no error: where they do (a pose, a site, a mean inset), what they share would
    cancel in part, so the intervals are too wide then, never too narrow.
    """
    found = [difference(first, second, percent) for percent in percents]
    return Comparison(
        [_judge_difference(_figure(one)) for one in found], difference_of_figures(first.mean(), second.mean())
    )


def _figure(found: TotalFigure | Said | None) -> TotalFigure:
    return found if isinstance(found, TotalFigure) else without_interval(found)


def difference_of_figures(first: TotalFigure, second: TotalFigure) -> Compared:
    """Two figures of samples that share no error, by their own intervals: the second less the first.

    Zou and Donner 2008: each end is as far as the two ends that lie that way are together.
    """
    return _judge_difference(_subtract_figures(first, second))


def _subtract_figures(first: TotalFigure, second: TotalFigure) -> TotalFigure:
    if first.value is None or second.value is None:
        return _figure(first.reason if first.value is None else second.reason)
    value = second.value - first.value
    if first.U95_low is None or first.U95_high is None or second.U95_low is None or second.U95_high is None:
        return without_interval(first.reason or second.reason, value)
    low = float(np.hypot(second.value - second.U95_low, first.U95_high - first.value))
    high = float(np.hypot(second.U95_high - second.value, first.value - first.U95_low))
    return TotalFigure(value, value - low, value + high)


def _judge_difference(figure: TotalFigure) -> Compared:
    if figure.U95_low is None or figure.U95_high is None:
        return Compared(figure, None)
    if figure.U95_low > 0.0:
        return Compared(figure, "higher")
    return Compared(figure, "lower" if figure.U95_high < 0.0 else "not_told_apart")
