"""From a survey's heights to sight distances: percentiles by a standard's rule, crests, and what they change.

The page asks with a session (`sight_distances`); the report has the statistics of its package at hand and
takes `case_of` with their percentiles. Both give the same figures: those of true heights, with total
uncertainty.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import get_args

import numpy as np

from sightline.coverage import COVERAGE_95
from sightline.enums import Category, LengthUnit, SightCase, StatisticsTarget
from sightline.errors import BadInput
from sightline.infra.database import Session
from sightline.results.measured_columns_query import CATEGORIES, NONE, Measured
from sightline.results.sightdistance.records import (
    CaseOfHeights,
    ClassOfFleet,
    SightDistances,
    SightQuestion,
)
from sightline.results.survey_statistics import height_sample, measured_columns
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
from sightline.statistics.fleet import mixed_percentile
from sightline.statistics.shared_errors import correlation_of
from sightline.statistics.total_uncertainty import TotalUncertainty

_UNITS: dict[LengthUnit, UnitSystem] = {"m": METRIC, "ft": US_CUSTOMARY}
# Design speeds as tables print them: 30 to 130 km/h, 20 to 80 mph.
_SPEEDS: dict[LengthUnit, tuple[int, int, int]] = {"m": (30, 131, 10), "ft": (20, 81, 5)}


def sight_distances(session: Session, question: SightQuestion) -> SightDistances:
    """What the measurements of a filter mean for a road. Raises BadInput for values or shares that cannot
    be.
    """
    eyes = measured_columns(session, replace(question.chosen, target="driver_eye"))
    target = question.object_target
    objects = None if target is None else measured_columns(session, replace(question.chosen, target=target))
    eye = _plain(eyes, question.eye_percent)
    thing = None if objects is None else _plain(objects, question.object_percent)
    by_pose = _by_pose_m(eyes, question.eye_percent), _by_pose_m(objects, question.object_percent)
    cases = [
        case_of(question, "standard", Bounded(question.eye_m), Bounded(question.object_m)),
        case_of(question, "survey", eye, thing, by_pose),
    ]
    if question.shares:
        eye = _mixed(eyes, question.shares, question.eye_percent)
        thing = None if objects is None else _mixed(objects, question.shares, question.object_percent)
        cases.append(case_of(question, "mix", eye, thing, by_pose))
    return _road(question, tuple(cases), eyes, objects)


def case_of(
    question: SightQuestion,
    name: SightCase,
    eye: Bounded | None,
    thing: Bounded | None,
    by_pose_m: tuple[Mapping[int, float], Mapping[int, float]] = ({}, {}),
) -> CaseOfHeights:
    """One pair of heights as a crest; None: nobody measured it (of an object: the standard's is taken).

    by_pose_m: what one standard uncertainty of each road pose moves eye and object by: errors of both that
    come from the same pose and board are the same errors, and count together in the interval.
    """
    target = question.object_target
    if thing is None and target is None:
        thing = Bounded(question.object_m)
    if eye is None or thing is None:
        missing: list[StatisticsTarget] = ["driver_eye"] if eye is None else []
        if thing is None and target is not None:
            missing.append(target)
        return CaseOfHeights(name=name, crest=None, comparison=None, k_m=(), missing=tuple(missing))
    standard = crest_constant(question.eye_m, question.object_m).constant_m
    seen_m = distance_of(question, question.speed_mps).design_m
    together = correlation_of(*by_pose_m, _u_m(eye), _u_m(thing))
    crest = crest_of(eye, thing, seen_m, question.difference_percent, standard, together)
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


def bounded_of(found: TotalPercentile | None) -> Bounded | None:
    """A percentile as a height with its total interval, or with the reason why it has none; None without a
    value.
    """
    return (
        None
        if found is None or found.value is None
        else Bounded(found.value, found.U95_low, found.U95_high, found.reason)
    )


def _road(
    question: SightQuestion, cases: tuple[CaseOfHeights, ...], eyes: Measured, objects: Measured | None
) -> SightDistances:
    distance = distance_of(question, question.speed_mps)
    speeds = design_speeds(question.unit)
    fits = distance.design_m <= np.pi * question.radius_m
    return SightDistances(
        distance=distance,
        speeds_mps=speeds,
        distances_m=tuple(distance_of(question, speed).design_m for speed in speeds),
        cases=cases,
        eyes=len(eyes),
        objects=0 if objects is None else len(objects),
        classes=_classes(eyes, objects),
        sag_k_m=sag_k_m(distance.design_m, question.headlight_m),
        sag=sag_length(distance.design_m, question.difference_percent, question.headlight_m),
        offset_m=sightline_offset_m(question.radius_m, distance.design_m) if fits else None,
    )


def _u_m(found: Bounded) -> float:
    """The standard uncertainty that an interval states; 0 without one."""
    if found.low is None or found.high is None:
        return 0.0
    return (found.high - found.low) / (2.0 * COVERAGE_95)


def _by_pose_m(measured: Measured | None, percent: float) -> dict[int, float]:
    if measured is None or not len(measured):
        return {}
    return TotalUncertainty(height_sample(measured)).named_effects_m(percent)


def _plain(measured: Measured, percent: float) -> Bounded | None:
    if not len(measured):
        return None
    return bounded_of(TotalUncertainty(height_sample(measured)).percentile(percent))


def _mixed(measured: Measured, shares: Mapping[Category, float], percent: float) -> Bounded | None:
    """Of a fleet with other shares. Raises BadInput for a class that nobody measured."""
    if not len(measured):
        return None
    parts = dict(zip(shares, shares_of_fleet(list(shares.values())), strict=True))
    asked = [parts.get(one, 0.0) for one in get_args(Category)]
    known = measured.where(measured.category != NONE)
    counts = np.bincount(known.category, minlength=len(CATEGORIES))
    unseen = [word for word, share, n in zip(CATEGORIES, asked, counts, strict=True) if share > 0 and not n]
    if unseen:
        raise BadInput("sightdistance-class-unseen", category=unseen[0])
    return bounded_of(mixed_percentile(height_sample(known), known.category, asked, percent))


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
