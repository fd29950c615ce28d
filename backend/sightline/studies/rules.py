"""The rules of standards on a study's heights: each on its class, as the class is in the fleet."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from sightline.enums import Category, ClassSet, StatisticsTarget
from sightline.results.measured_columns_query import CATEGORIES, CLASS_SETS
from sightline.results.survey_statistics import RULE_OF
from sightline.statistics.rules import RuleToday, rule_of_draws, unknown_rule
from sightline.statistics.standards import Standard
from sightline.statistics.study_figures import StudyFigures
from sightline.studies.records import StudiedHeights, StudyRule
from sightline.studies.weighted import Weighted

_Classes = tuple[tuple[Category, ...], tuple[ClassSet, ...]]


def rules_of(
    target: StatisticsTarget, of: Weighted, whole: StudyFigures | None, standards: Sequence[Standard]
) -> list[StudyRule]:
    """The rule of every standard that states one for this target, on the heights of its class; of all, where
    no class is known. whole: the figures of all heights.
    """
    asked = [
        one for one in standards if one.percent is not None and RULE_OF.get(one.what, ("",))[0] == target
    ]
    known = bool(np.any(of.rows.category >= 0))
    made: dict[_Classes, tuple[Weighted, StudyFigures | None]] = {}
    found = []
    for one in asked:
        classes = RULE_OF[one.what][1]
        if classes not in made:
            made[classes] = _of_class(of, whole, classes) if known else (of, whole)
        found.append(StudyRule(target, _rule(one, *made[classes], known)))
    return found


def _of_class(
    of: Weighted, whole: StudyFigures | None, classes: _Classes
) -> tuple[Weighted, StudyFigures | None]:
    chosen = _are(of.rows, classes)
    if chosen.all():
        return of, whole
    own = of.domain(chosen)
    return own, None if own.design is None else own.figures()


def _are(rows: StudiedHeights, classes: _Classes) -> NDArray[np.bool_]:
    """Whose vehicles (N,) are of one of the classes, or count in one of the sets in their survey."""
    categories, sets = classes
    of_set = np.isin(rows.class_set, [CLASS_SETS.index(one) for one in sets])
    return of_set | np.isin(rows.category, [CATEGORIES.index(one) for one in categories])


def _rule(standard: Standard, of: Weighted, figures: StudyFigures | None, by_class: bool) -> RuleToday:
    if figures is None:
        none = "no height of its class counts"
        return unknown_rule(standard, of.n, by_class, None, (of.reason if of.n else None) or none)
    percent = standard.percent or 50.0
    return rule_of_draws(
        standard, of.n, by_class, figures.percentile(percent), figures.percentile_draws(percent)
    )
