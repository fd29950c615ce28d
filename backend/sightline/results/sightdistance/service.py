"""From a survey's heights to sight distances: percentiles by a standard's rule, crests, and what they change.

The page asks with a session (`sight_distances`); the report has the statistics of its package at hand and
takes `case_of` with its rules' figures. Both give THE figure (`statistics.rules`): of true heights, of the
class that the rule names, with total uncertainty. Where classes are chosen, it is of those of them that are
of that class: a standard's height says nothing of others; what these would give, another fleet tells.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import get_args

import numpy as np

from sightline.enums import (
    Category,
    LengthUnit,
    SightCase,
    SightClasses,
    StandardHeight,
    StatisticsTarget,
)
from sightline.errors import BadInput
from sightline.infra.database import Session
from sightline.messages.said import Said
from sightline.results.measured_columns_query import CATEGORIES, NONE, Measured
from sightline.results.sightdistance.records import (
    CaseOfHeights,
    ClassOfFleet,
    SightDistances,
    SightQuestion,
    WithoutFigure,
)
from sightline.results.survey_statistics import (
    RULE_OF,
    figures_of_rule,
    height_sample,
    measured_columns,
    sites_of,
)
from sightline.sightdistance.curves import crest_constant, sag_k_m, sag_length, sightline_offset_m
from sightline.sightdistance.distances import METRIC, US_CUSTOMARY, SightDistance, UnitSystem
from sightline.sightdistance.workbench import (
    Bounded,
    compare,
    crest_of,
    k_of,
    shares_of_fleet,
    sight_distance,
)
from sightline.statistics.figures import TotalPercentile
from sightline.statistics.fleet import mixed_fleet
from sightline.statistics.rules import RuleToday, rule_today
from sightline.statistics.shared_errors import correlation_of
from sightline.statistics.standards import Standard

_UNITS: dict[LengthUnit, UnitSystem] = {"m": METRIC, "ft": US_CUSTOMARY}
# Whose rule an object is read by: the first of its target in the table of rules, that of passenger cars.
_OBJECT_RULE: dict[StatisticsTarget, StandardHeight] = {
    target: what for what, (target, _) in reversed(RULE_OF.items())
}
# Design speeds as tables print them: 30 to 130 km/h, 20 to 80 mph.
_SPEEDS: dict[LengthUnit, tuple[int, int, int]] = {"m": (30, 131, 10), "ft": (20, 81, 5)}


@dataclass(frozen=True)
class HeightRead:
    """A percentile as a height on the road: with its interval; or `reason`, why it has no value. by_pose_m:
    what one standard uncertainty of each road pose moves it by.
    """

    height_m: Bounded | None
    reason: Said | None = None
    by_pose_m: Mapping[int, float] = field(default_factory=dict)


def of_class(eye: RuleToday, thing: RuleToday | None, of_chosen: bool) -> SightClasses:
    """Whose heights both percentiles are of: which ones leave other classes out. One that has no height, of
    any class, is of nobody and does not count. `of_chosen`: whether classes are chosen, which all are known.
    """
    if of_chosen:
        return "chosen"
    there = [one for one in (eye, thing) if one is not None and (one.n or one.by_class)]
    if there and all(one.by_class for one in there):
        return "class"
    return "eyes" if eye.by_class else "objects" if thing is not None and thing.by_class else "all"


def exact_height(height_m: float) -> HeightRead:
    """A height that is taken as exact, as a standard's."""
    return HeightRead(Bounded(height_m))


def height_of_rule(rule: RuleToday) -> HeightRead | None:
    """THE figure of a standard's rule as a height on the road; None where nobody measured its class."""
    if rule.n == 0:
        return None
    if rule.value_m is None:
        return HeightRead(None, rule.reason)
    return HeightRead(
        Bounded(rule.value_m, rule.U95_low_m, rule.U95_high_m, rule.reason), by_pose_m=rule.by_pose_m
    )


def height_of(percentile: TotalPercentile, by_pose_m: Mapping[int, float] | None = None) -> HeightRead:
    """A percentile as a height on the road."""
    if percentile.value is None:
        return HeightRead(None, percentile.reason)
    return HeightRead(
        Bounded(percentile.value, percentile.U95_low, percentile.U95_high, percentile.reason),
        None,
        by_pose_m or {},
    )


def sight_distances(session: Session, question: SightQuestion) -> SightDistances:
    """What the measurements of a filter mean for a road. Raises BadInput for values or shares that cannot
    be.
    """
    target = question.object_target
    eyes = measured_columns(session, replace(question.chosen, target="driver_eye"))
    objects = None if target is None else measured_columns(session, replace(question.chosen, target=target))
    by_rule = Standard("", question.eye_what, question.eye_m, "", percent=question.eye_percent)
    eye, thing = _today(session, eyes, by_rule), None
    if objects is not None and target is not None:
        what = _OBJECT_RULE[target]
        by_rule = Standard("", what, question.object_m, "", percent=question.object_percent)
        thing = _today(session, objects, by_rule)
    cases = [
        case_of(question, "standard", exact_height(question.eye_m), exact_height(question.object_m)),
        case_of(question, "survey", height_of_rule(eye), None if thing is None else height_of_rule(thing)),
    ]
    if question.shares:
        asked = ((eyes, question.eye_percent), (objects, question.object_percent))
        mixed = [_mixed(session, one, question.shares, percent) for one, percent in asked]
        cases.append(case_of(question, "mix", *mixed))
    return _road(question, tuple(cases), (eyes, objects), (eye, thing))


def case_of(
    question: SightQuestion, name: SightCase, eye: HeightRead | None, thing: HeightRead | None
) -> CaseOfHeights:
    """One pair of heights as a crest; None: nobody measured it (of an object: the standard's is taken).

    Errors of both that come from the same pose and board are the same errors, and count together in the
    interval.
    """
    target = question.object_target
    if thing is None and target is None:
        thing = exact_height(question.object_m)
    named: list[tuple[StatisticsTarget, HeightRead | None]] = [("driver_eye", eye)]
    named += [] if target is None else [(target, thing)]
    if eye is None or thing is None or eye.height_m is None or thing.height_m is None:
        return CaseOfHeights(
            name=name,
            crest=None,
            comparison=None,
            k_m=(),
            missing=tuple(what for what, one in named if one is None),
            too_few=tuple(
                WithoutFigure(what, one.reason)
                for what, one in named
                if one and one.reason and one.height_m is None
            ),
        )
    standard = crest_constant(question.eye_m, question.object_m).constant_m
    seen_m = distance_of(question, question.speed_mps).design_m
    together = correlation_of(eye.by_pose_m, thing.by_pose_m, eye.height_m.u, thing.height_m.u)
    crest = crest_of(eye.height_m, thing.height_m, seen_m, question.difference_percent, standard, together)
    return CaseOfHeights(
        name=name,
        crest=crest,
        comparison=None if name == "standard" else compare(standard, crest.constant_m),
        k_m=tuple(
            k_of(distance_of(question, speed).design_m, crest.constant_m)
            for speed in design_speeds(question.unit)
        ),
    )


def design_speeds(unit: LengthUnit) -> tuple[float, ...]:
    """Those that figures and tables show, metres per second."""
    return tuple(speed * _UNITS[unit].speed_mps for speed in range(*_SPEEDS[unit]))


def distance_of(question: SightQuestion, speed_mps: float) -> SightDistance:
    """The distance of the kind that is asked for; passing is printed in metric units alone. Raises
    BadInput.
    """
    units = METRIC if question.kind == "passing" else _UNITS[question.unit]
    return sight_distance(question.kind, speed_mps, units)


def _road(
    question: SightQuestion,
    cases: tuple[CaseOfHeights, ...],
    measured: tuple[Measured, Measured | None],
    rules: tuple[RuleToday, RuleToday | None],
) -> SightDistances:
    distance = distance_of(question, question.speed_mps)
    speeds = design_speeds(question.unit)
    eye, thing = rules
    fits = distance.design_m <= np.pi * question.radius_m
    return SightDistances(
        distance=distance,
        speeds_mps=speeds,
        distances_m=tuple(distance_of(question, speed).design_m for speed in speeds),
        cases=cases,
        eyes=eye.n,
        objects=0 if thing is None else thing.n,
        of_class=of_class(eye, thing, question.chosen.of_classes),
        classes=_classes(*measured),
        sag_k_m=sag_k_m(distance.design_m, question.headlight_m),
        sag=sag_length(distance.design_m, question.difference_percent, question.headlight_m),
        offset_m=sightline_offset_m(question.radius_m, distance.design_m) if fits else None,
    )


def _today(session: Session, measured: Measured, by_rule: Standard) -> RuleToday:
    found = rule_today(by_rule, *figures_of_rule(measured, by_rule.what, sites_of(session, measured)))
    assert found is not None  # it states a percentile
    return found


def _mixed(
    session: Session, measured: Measured | None, shares: Mapping[Category, float], percent: float
) -> HeightRead | None:
    """Of a fleet with other shares. Raises BadInput for a class that nobody measured."""
    if measured is None or not len(measured):
        return None
    parts = dict(zip(shares, shares_of_fleet(list(shares.values())), strict=True))
    asked = [parts.get(one, 0.0) for one in get_args(Category)]
    known = measured.where(measured.category != NONE)
    counts = np.bincount(known.category, minlength=len(CATEGORIES))
    unseen = [word for word, share, n in zip(CATEGORIES, asked, counts, strict=True) if share > 0 and not n]
    if unseen:
        raise BadInput("sightdistance-class-unseen", category=unseen[0])
    fleet = mixed_fleet(height_sample(known, sites_of(session, known)), known.category, asked)
    return height_of(fleet.percentile(percent), fleet.named_effects_m(percent))


def _classes(eyes: Measured, objects: Measured | None) -> tuple[ClassOfFleet, ...]:
    """Those that were measured at all, in the order of the list of classes."""
    of_eyes = np.bincount(eyes.category + 1, minlength=len(CATEGORIES) + 1)[1:]
    of_objects = np.zeros_like(of_eyes)
    if objects is not None:
        of_objects = np.bincount(objects.category + 1, minlength=len(CATEGORIES) + 1)[1:]
    known = max(int(of_eyes.sum()), 1)
    return tuple(
        ClassOfFleet(category=word, eyes=int(n), objects=int(m), share=int(n) / known)
        for word, n, m in zip(get_args(Category), of_eyes, of_objects, strict=True)
        if n or m
    )
