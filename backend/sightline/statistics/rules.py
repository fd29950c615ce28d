"""A standard's own rule on today's heights, and what may be said of the difference.

A standard's height is a percentile of a class of vehicles. THE figure of a survey or a study is that
percentile of its true heights, of the class that the rule names, with its total 95 % interval, unrounded:
pages, reports, packages and the command line say this one, and name any other by what it is. The verdict is a
decision rule with guard bands as wide as the total uncertainty (JCGM 106:2012, 8.3): "lower" or "higher" is
said only where the probability that it is not so is at most 2.5 %; between them the two are not told apart.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from sightline.enums import RuleHeights, RuleVerdict, StandardHeight
from sightline.messages.said import Said
from sightline.statistics.standards import Standard
from sightline.statistics.total_uncertainty import TotalUncertainty

MOST_RISK = 0.025


@dataclass(frozen=True)
class RuleToday:
    """The percentile of a standard's rule in a survey, metres, and the verdict on its difference to the
    standard.

    n: heights of the class; whose: those of the class, or of all where no class is known; lower: the
    probability that the true percentile lies below the standard's height; risk: that the verdict is wrong,
    None where the two are not told apart; by_pose_m: what one standard uncertainty of each road pose moves
    the percentile by, by the pose's number. Without an interval `verdict` is "unknown" and `reason` says why.
    """

    standard: Standard
    n: int
    whose: RuleHeights
    value_m: float | None
    U95_low_m: float | None
    U95_high_m: float | None
    difference_m: float | None
    lower: float | None
    risk: float | None
    verdict: RuleVerdict
    reason: Said | None = None
    by_pose_m: Mapping[int, float] = field(default_factory=dict)

    @property
    def by_class(self) -> bool:
        """Whether heights of other classes could be left out."""
        return self.whose != "all"


def whose_heights(what: StandardHeight, by_class: bool) -> RuleHeights:
    """Whose heights the rule of a standard is read on: the standard may name others."""
    return "all" if not by_class else "trucks" if what == "eye_truck" else "cars"


def rule_today(
    standard: Standard,
    figures: TotalUncertainty | None,
    by_class: bool,
    n: int = 0,
    reason: Said | None = None,
) -> RuleToday | None:
    """The rule of a standard on the heights of its class, None: there are none, or n that have no figures for
    a reason; None where it states no percentile.

    JCGM 106:2012, 8.3.
    """
    if standard.percent is None:
        return None
    if figures is None:
        return unknown_rule(standard, n, by_class, None, reason or Said("stat-none-of-class"))
    figure, draws = figures.percentile(standard.percent), figures.percentile_draws(standard.percent)
    if isinstance(draws, Said):
        return unknown_rule(standard, figures.n, by_class, figure.value, draws)
    value, error = draws
    lower = float(np.mean(value + error < standard.height_m))
    verdict, risk = _verdict(lower)
    return RuleToday(
        standard=standard,
        n=figures.n,
        whose=whose_heights(standard.what, by_class),
        value_m=value,
        U95_low_m=figure.U95_low,
        U95_high_m=figure.U95_high,
        difference_m=value - standard.height_m,
        lower=lower,
        risk=risk,
        verdict=verdict,
        by_pose_m=figures.named_effects_m(standard.percent),
    )


def _verdict(lower: float) -> tuple[RuleVerdict, float | None]:
    if lower >= 1.0 - MOST_RISK:
        return "lower", 1.0 - lower
    if lower <= MOST_RISK:
        return "higher", lower
    return "alike", None


def unknown_rule(
    standard: Standard, n: int, by_class: bool, value_m: float | None, reason: Said
) -> RuleToday:
    """A rule without a verdict, and why."""
    return RuleToday(
        standard=standard,
        n=n,
        whose=whose_heights(standard.what, by_class),
        value_m=value_m,
        U95_low_m=None,
        U95_high_m=None,
        difference_m=None if value_m is None else value_m - standard.height_m,
        lower=None,
        risk=None,
        verdict="unknown",
        reason=reason,
    )
