"""What the sight-distance page and the report show of a survey's heights."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated

from pydantic import Field

from sightline.enums import (
    Category,
    EyeRule,
    LengthUnit,
    SightCase,
    SightClasses,
    SightKind,
    StatisticsTarget,
)
from sightline.messages.said import Said
from sightline.results.survey_statistics import Filter
from sightline.sightdistance.curves import CurveLength
from sightline.sightdistance.distances import SightDistance
from sightline.sightdistance.workbench import Bounded, Comparison, Crest

Number = Annotated[float, Field(allow_inf_nan=False)]
Percent = Annotated[float, Field(gt=0, lt=100, allow_inf_nan=False)]


@dataclass(frozen=True, kw_only=True)
class SightQuestion:
    """What is asked: which measurements, the standard's heights, the rule that reads the survey's, and the
    road.

    eye_what: whose rule the eyes are read by, which names their class; objects are read by that of passenger
    cars; where classes are chosen, each is of those of its class that are. object_target None: the object's
    height is the standard's in every case, as where the object is a whole vehicle. shares: a fleet's, by
    class; empty: no what-if. unit: which of the two sets of formulas.
    """

    chosen: Filter
    eye_m: Annotated[Number, Field(description="The standard's eye.")] = 1.08
    object_m: Annotated[Number, Field(description="The standard's object.")] = 0.60
    eye_what: Annotated[
        EyeRule, Field(description="Whose rule the eyes are read by: it names their class.")
    ] = "eye_car"
    eye_percent: Annotated[Percent, Field(description="The rule that reads the survey's eyes.")] = 10.0
    object_percent: Annotated[Percent, Field(description="The rule that reads its objects.")] = 5.0
    object_target: Annotated[
        StatisticsTarget | None,
        Field(description="What stands for the object; none: the standard's height."),
    ] = None
    kind: SightKind = "stopping"
    speed_mps: Number = 100 / 3.6
    difference_percent: Annotated[Number, Field(description="Of both grades, for lengths of curves.")] = 6.0
    headlight_m: Annotated[Number, Field(description="For a sag, with a beam that rises 1 degree.")] = 0.60
    radius_m: Annotated[Number, Field(gt=0, description="Of a horizontal curve.")] = 500.0
    shares: Mapping[Category, float] = field(default_factory=dict)
    unit: Annotated[LengthUnit, Field(description="Which set of formulas and design speeds.")] = "m"


@dataclass(frozen=True)
class WithoutFigure:
    """A target whose percentile has no value, and why: fewer heights than it needs, and how many."""

    target: StatisticsTarget
    reason: Said


@dataclass(frozen=True)
class CaseOfHeights:
    """One pair of heights; without `crest`, `missing` says what nobody measured, and `too_few` what has
    too few heights for its percentile. `comparison` is with the standard.
    """

    name: SightCase
    crest: Crest | None
    comparison: Comparison | None
    k_m: Annotated[tuple[Bounded, ...], Field(description="K at each of `speeds_mps`.")]
    missing: tuple[StatisticsTarget, ...] = ()
    too_few: tuple[WithoutFigure, ...] = ()


@dataclass(frozen=True)
class ClassOfFleet:
    """How many eyes and objects of a class were measured, and its share of those whose class is known."""

    category: Category
    eyes: int
    objects: int
    share: float


@dataclass(frozen=True)
class SightDistances:
    """Crests by case, and what the road needs besides: a sag by headlights, room beside a curve."""

    distance: SightDistance
    speeds_mps: tuple[float, ...]
    distances_m: tuple[float, ...]
    cases: tuple[CaseOfHeights, ...]
    eyes: Annotated[int, Field(description="That the survey's percentile is of.")]
    objects: Annotated[int, Field(description="That the survey's percentile is of.")]
    of_class: Annotated[
        SightClasses,
        Field(description="Which are of the class that their rule names, or those of it chosen; else all."),
    ]
    classes: tuple[ClassOfFleet, ...]
    sag_k_m: float
    sag: CurveLength
    offset_m: float | None
