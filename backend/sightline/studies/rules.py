"""The rules of standards on a study's heights: each on its class, as the class is in the fleet."""

from collections.abc import Collection, Sequence

import numpy as np

from sightline.enums import StatisticsTarget
from sightline.results.survey_statistics import RULE_OF
from sightline.statistics.rules import RuleToday, rule_today
from sightline.statistics.standards import Standard
from sightline.statistics.total_uncertainty import TotalUncertainty
from sightline.studies.weighted import Weighted


def rules_of_all(
    target: StatisticsTarget, of: Weighted, figures: TotalUncertainty | None, standards: Sequence[Standard]
) -> dict[int, RuleToday]:
    """The rule of every standard that states one for this target and whose class is that of all heights, or
    where no class is known, by the standard's place among them. figures: of all heights.
    """
    known = bool(np.any(of.rows.category >= 0))
    return {
        n: _make_rule(one, of, figures, known)
        for n, one in _standards_of_target(target, standards).items()
        if not known or of.rows.of_classes(*RULE_OF[one.what][1]).all()
    }


def rules_of_classes(
    target: StatisticsTarget, of: Weighted, standards: Sequence[Standard], made: Collection[int]
) -> dict[int, RuleToday]:
    """The other rules, each on the heights of its class, by the standard's place; figures of one class at a
    time, for they are as large as those of all. made: those that are there.
    """
    waiting = {n: one for n, one in _standards_of_target(target, standards).items() if n not in made}
    rules = {}
    for classes in dict.fromkeys(RULE_OF[one.what][1] for one in waiting.values()):
        own = of.domain(of.rows.of_classes(*classes))
        figures = None if own.design is None else own.figures()
        for n, one in waiting.items():
            if RULE_OF[one.what][1] == classes:
                rules[n] = _make_rule(one, own, figures, True)
        del own, figures
    return rules


def _standards_of_target(target: StatisticsTarget, standards: Sequence[Standard]) -> dict[int, Standard]:
    return {
        n: one
        for n, one in enumerate(standards)
        if one.percent is not None and RULE_OF.get(one.what, ("",))[0] == target
    }


def _make_rule(
    standard: Standard, of: Weighted, figures: TotalUncertainty | None, by_class: bool
) -> RuleToday:
    found = rule_today(standard, figures, by_class, of.n, of.reason if of.n else None)
    assert found is not None  # only standards that state a percentile are asked for
    return found
