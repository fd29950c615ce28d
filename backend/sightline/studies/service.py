"""A study: heights of many surveys as one designed sample, weighted to a fleet, with total intervals.

The surveys' tables come from packages (`query.StudyTables`) or from this installation's own database
(`stored_query.StoredTables`); what is made of them is the same to the last digit.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Protocol, get_args

import numpy as np

from sightline.arrays import Ints
from sightline.enums import StatisticsTarget
from sightline.errors import BadInput
from sightline.messages.said import Said
from sightline.results.measured_columns_query import Heights
from sightline.results.standards_store import joined_standards
from sightline.statistics.figures import TotalFigure
from sightline.statistics.standards import Standard
from sightline.statistics.study_plan import U95_of, plan
from sightline.statistics.survey_design import weighting_effect
from sightline.statistics.total_uncertainty import TotalUncertainty
from sightline.studies.beside import difference_in_cells, no_difference
from sightline.studies.places import Places, places_of
from sightline.studies.records import (
    Curve,
    Fleet,
    PlanRow,
    SiteFacts,
    StudiedSurvey,
    Study,
    TargetFigures,
    YearRow,
)
from sightline.studies.rules import rules_of_all, rules_of_classes
from sightline.studies.shares import class_shares, error_figures
from sightline.studies.weighted import Weighted, refuse_fleet, weight_heights

TARGETS: tuple[StatisticsTarget, ...] = get_args(StatisticsTarget)
PERCENTS = (2.5, 5.0, 10.0, 15.0, 50.0, 85.0, 90.0, 95.0, 97.5)
_CURVE = (1.0, *PERCENTS[:4], *(float(one) for one in range(20, 81, 5)), *PERCENTS[5:], 99.0)
_PLANNED_PERCENT = 10.0
_PLANNED_SITES = (2, 3, 4, 5, 6, 8, 10, 12, 15, 20, 30, 50)


Tell = Callable[[float], None]


class Tables(Protocol):
    """Accepted heights of the surveys of a study, each by its place among them."""

    def counted(self) -> tuple[Ints, Ints]:
        """Of each survey, (P,) each: how many count, and how many do not, for they are out of its sample."""
        ...

    def vehicles(self) -> tuple[Ints, Ints, Ints]:
        """(survey, category, lighting), (V,) each, of every vehicle with a counted height."""
        ...

    def heights(self, target: StatisticsTarget) -> Heights:
        """The counted heights of one target, by survey and number."""
        ...


@dataclass(frozen=True)
class Plan:
    """What is asked of a study: its fleet, what is known of sites, the U95 that a further one is to have, and
    whether its distributions are to be drawn.
    """

    fleet: Fleet | None = None
    sites: Mapping[str, SiteFacts] | None = None
    goal_m: float = 0.010
    curves: bool = False


def _silent(_part: float) -> None:
    """Tell nobody how far it is."""


def make_study(surveys: Sequence[StudiedSurvey], tables: Tables, asked: Plan, tell: Tell = _silent) -> Study:
    """Figures, rules of standards, error table, class shares and a plan from the surveys' own tables.

    tell: called with the part, 0 to 1, that is done. Raises BadInput where surveys, fleet and sites do not
    fit, in one sentence.
    """
    places = places_of(surveys, asked.sites)
    counted, outside = tables.counted()
    if not counted.sum():
        raise BadInput("studies-no-height-counts")
    cars = tables.vehicles()
    refuse_fleet(asked.fleet, cars, places)
    study = Study(
        surveys=list(surveys),
        counted=counted.tolist(),
        out_of_sample=outside.tolist(),
        heights=int(counted.sum()),
        vehicles=len(cars[0]),
        classes=class_shares(cars, places, asked.fleet),
        notes=_notes(surveys, places) + _notes_of_counts(surveys, counted, outside),
    )
    standards = joined_standards([one.standards for one in surveys])
    for done, target in enumerate(TARGETS):
        tell(done / len(TARGETS))
        rows = tables.heights(target)
        _put_target(study, target, rows, places, asked, standards)
        if target == "roof":
            study.errors.extend(error_figures(rows, places))
    return study


def _notes(surveys: Sequence[StudiedSurvey], places: Places) -> list[Said]:
    made_with = sorted({one.made_with for one in surveys})
    invented = sum(one.simulated for one in surveys)
    notes = []
    if invented == len(surveys):
        notes.append(Said("study-all-simulated"))
    elif invented:
        notes.append(Said("study-some-simulated", count=invented, surveys=len(surveys)))
    if len(made_with) > 1:
        notes.append(Said("study-versions", count=len(made_with), versions=", ".join(made_with)))
    if len(places.names) == 1:
        notes.append(Said("study-one-site"))
    return notes


def _notes_of_counts(surveys: Sequence[StudiedSurvey], counted: Ints, outside: Ints) -> list[Said]:
    notes = [
        Said("study-none-counts", name=one.name)
        for one, n in zip(surveys, counted.tolist(), strict=True)
        if n == 0
    ]
    if outside.any():
        notes.append(Said("study-outside-sample", count=int(outside.sum())))
    return notes


def _put_target(
    study: Study,
    target: StatisticsTarget,
    rows: Heights,
    places: Places,
    asked: Plan,
    standards: Sequence[Standard],
) -> None:
    """Everything of one target, put with what was found."""
    of = weight_heights(rows, places, asked.fleet)
    left_out = len(rows) - of.n
    if left_out:
        study.notes.append(Said("study-without-class", count=left_out, target=target))
    figures = None if of.design is None else of.figures()
    study.targets.append(_target_figures(target, of, figures, places))
    if figures is not None:
        if figures.sites_are_unlike:
            study.notes.append(Said("study-sites-unlike", target=target))
        if asked.curves:
            points = [figures.percentile(percent) for percent in _CURVE]
            supported = [one for one in points if one.value is not None]
            study.curves.extend([Curve(target, supported)] if supported else [])
        study.plans.extend(_plans(target, figures, asked.goal_m, float(places.sites_there.sum())))
    rules = rules_of_all(target, of, figures, standards)
    del figures  # as large as all heights, and so are those of a class
    rules |= rules_of_classes(target, of, standards, rules)
    study.rules.extend(rules[n] for n in sorted(rules))
    study.years.extend(_years(target, rows, study.surveys, asked))


def _target_figures(
    target: StatisticsTarget, of: Weighted, figures: TotalUncertainty | None, places: Places
) -> TargetFigures:
    at = int(np.count_nonzero(np.bincount(places.of_survey[of.rows.survey_id]))) if of.n else 0
    if figures is None or of.design is None:
        return TargetFigures(target, of.n, at, reason=of.reason)
    return TargetFigures(
        target=target,
        n=of.n,
        sites=at,
        weighting_effect=weighting_effect(of.design.weight),
        mean=figures.mean(),
        sd=figures.sd(),
        percentiles=[figures.percentile(percent) for percent in PERCENTS],
    )


def _plans(
    target: StatisticsTarget, figures: TotalUncertainty, goal_m: float, sites_there: float
) -> list[PlanRow]:
    told = figures.components(_PLANNED_PERCENT)
    if told is None:
        return []
    components = replace(told, sites_there=sites_there)
    return [
        PlanRow(
            target=target,
            percent=_PLANNED_PERCENT,
            goal_U95_m=goal_m,
            sites=sites,
            vehicles_each=vehicles,
            U95_m=None if vehicles is None else U95_of(components, sites, vehicles),
        )
        for sites, vehicles in plan(components, _PLANNED_SITES, goal_m)
    ]


def _years(
    target: StatisticsTarget, rows: Heights, surveys: Sequence[StudiedSurvey], asked: Plan
) -> list[YearRow]:
    """Each later year beside the first: percentiles and mean, each year weighted to the fleet by itself."""
    years = sorted({one.year for one in surveys if one.year is not None})
    if len(years) < 2 or not len(rows):
        return []
    first, *later = [_of_year(year, rows, surveys, asked) for year in years]
    return [
        one
        for year, second in zip(years[1:], later, strict=True)
        for one in _differences(target, (years[0], year), (first, second))
    ]


def _of_year(
    year: int, rows: Heights, surveys: Sequence[StudiedSurvey], asked: Plan
) -> tuple[Weighted, TotalUncertainty | None]:
    """The heights of one year's surveys as a study of its own."""
    here = [n for n, one in enumerate(surveys) if one.year == year]
    own = np.full(len(surveys), -1, dtype=np.int64)
    own[here] = np.arange(len(here))
    of_year = rows.where(own[rows.survey_id] >= 0)
    of_year = replace(of_year, survey_id=own[of_year.survey_id])
    of = weight_heights(of_year, places_of([surveys[n] for n in here], asked.sites), asked.fleet)
    return of, None if of.design is None else of.figures()


def _differences(
    target: StatisticsTarget,
    years: tuple[int, int],
    both: tuple[tuple[Weighted, TotalUncertainty | None], tuple[Weighted, TotalUncertainty | None]],
) -> list[YearRow]:
    (of_first, first), (of_second, second) = both
    named: dict[str, Any] = {"target": target, "first_year": years[0], "second_year": years[1]}
    named |= {"n_first": of_first.n, "n_second": of_second.n}
    if first is None or second is None:
        none = no_difference(of_first.reason or of_second.reason)
        return [YearRow(**named, percent=None, **none)] if of_first.n and of_second.n else []
    pairs: list[tuple[float | None, TotalFigure, TotalFigure]] = [
        (percent, first.percentile(percent), second.percentile(percent)) for percent in PERCENTS
    ]
    pairs.append((None, first.mean(), second.mean()))
    return [
        YearRow(**named, percent=percent, **difference_in_cells(before, after))
        for percent, before, after in pairs
    ]
