"""The report of a study as PDF: percentile, total U95, rule, verdict and consequence on its first two pages.

Set as a survey's report is (`export.report`), from a template of its own beside this file.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import datetime
from pathlib import Path

from sightline import messages
from sightline.enums import ComparisonVerdict, LengthUnit, StatisticsTarget
from sightline.export.report.pictures import Pictures
from sightline.export.report.report import set_pdf, templates, values_json
from sightline.export.report.results import rule_values
from sightline.export.report.said import Called, said, speaking, told
from sightline.export.report.settable import Json, Values
from sightline.export.report.setup import moment
from sightline.export.report.units import HEIGHT, SMALL, Scale, decimal, fixed, unit_words
from sightline.export.report.words import GROUPS, TARGETS, group_word
from sightline.results.standards_store import joined_standards
from sightline.results.survey_statistics import standards_of
from sightline.statistics.figures import Figure
from sightline.statistics.standards import Standard
from sightline.studies.consequence import consequence
from sightline.studies.records import (
    ErrorFigure,
    PlannedStudy,
    StoredStudy,
    Study,
    TargetFigures,
    YearDifference,
)
from sightline.studies.report.drawing import curve_drawing
from sightline.studies.stored import Computed, plan_of

_FOLDER, _FIRST = Path(__file__).parent, "study.typ"
_UNIT: LengthUnit = "m"
_GLANCE = (5.0, 10.0, 50.0, 85.0, 95.0)
_COMPARED = (10.0, 50.0)  # of years, on the first pages; all stand in the package
_SHORT = 60
_PER_CENT = Scale(100.0, "%", 1)
_MARGINS = Called(
    {
        "category": "report-by-category",
        "lighting": "report-by-lighting",
        "stratum": "report-by-stratum",
        "site": "report-by-site",
    }
)
_VERDICTS_KEYS: dict[ComparisonVerdict, str] = {
    "higher": "report-more-higher",
    "lower": "report-more-lower",
    "not_told_apart": "report-not-told-apart",
}
_VERDICTS = Called(_VERDICTS_KEYS)


def study_report(
    stored: StoredStudy, found: Computed, sha256: str, as_of: datetime, language: str = messages.SOURCE
) -> bytes:
    """The report as PDF in a language; the same figures give the same bytes. sha256: of the package."""
    with speaking(language):
        return set_pdf(_sources(stored, found, sha256, as_of), as_of)


def _sources(stored: StoredStudy, found: Computed, sha256: str, as_of: datetime) -> dict[str, bytes]:
    """The files that Typst compiles."""
    pictures = Pictures(
        {
            curve.target: curve_drawing(curve, standards_of(_standards(found.study), curve.target), _UNIT)
            for curve in found.study.curves
        }
    )
    values = values_json(_values(stored, found, sha256, as_of, pictures))
    return {**templates(_FOLDER, _FIRST), "values.json": values, **pictures.files}


def _standards(study: Study) -> tuple[Standard, ...]:
    return joined_standards([one.standards for one in study.surveys])


def _values(stored: StoredStudy, found: Computed, sha256: str, as_of: datetime, pictures: Pictures) -> Values:
    study, facts = found.study, stored.facts
    plan_targets = list(dict.fromkeys(one.target for one in study.plans))
    return {
        "as_of": moment(as_of),
        "unit": unit_words(_UNIT),
        "simulated": stored.simulated,
        "title": {
            "study": facts.name,
            "short": facts.name if len(facts.name) <= _SHORT else facts.name[: _SHORT - 1] + "…",
            "description": [one for one in facts.description.splitlines() if one.strip()],
        },
        "sites": len({one.site for one in study.surveys}),
        "heights": study.heights,
        "vehicles": study.vehicles,
        "fleet": _fleet(stored),
        "code": study.surveys[0].made_with,
        "glance": [fixed(at, 0) for at in _GLANCE],
        "targets": [_target(one, pictures) for one in study.targets if one.n],
        "rules": [rule_values(one.rule, HEIGHT[_UNIT], SMALL[_UNIT]) for one in study.rules if one.rule.n],
        "consequence": consequence(study.rules, _UNIT),
        "years": [_year(one) for one in study.years if one.percent in (None, *_COMPARED)],
        "errors": _errors(study.errors),
        "surveys": _surveys(stored, study),
        "notes": [told(one) for one in study.notes],
        "classes": [
            {
                "category": group_word("category", one.category),
                "n": one.n,
                **_figure(one.share, _PER_CENT, "share"),
                "fleet": None if one.fleet is None else _PER_CENT.number(one.fleet),
            }
            for one in study.classes
            if one.group == "all"
        ],
        "goal": SMALL[_UNIT].number(facts.goal_m),
        "plan_targets": [TARGETS[one] for one in plan_targets],
        "plan": _plan(study.plans, plan_targets),
        "sha256": sha256,
    }


def _fleet(stored: StoredStudy) -> str | None:
    fleet = plan_of(stored.facts).fleet
    if fleet is None:
        return None
    return said("report-fleet-by", margins=", ".join(_MARGINS[one] for one in fleet.margins))


def _surveys(stored: StoredStudy, study: Study) -> list[Json]:
    rows = zip(stored.facts.surveys, study.surveys, study.counted, study.out_of_sample, strict=True)
    strata = {site: one.stratum for site, one in (plan_of(stored.facts).sites or {}).items()}
    return [
        {
            "name": one.name,
            "site": one.site,
            "stratum": strata.get(one.site) or None,
            "year": None if told.year is None else str(told.year),
            "counted": counted,
            "out_of_sample": outside,
            "head": one.head,
        }
        for told, one, counted, outside in rows
    ]


def _figure(one: Figure | None, scale: Scale, name: str = "value") -> Values:
    """A figure with its interval."""
    if one is None:
        return {name: None, "ci95": None}
    if one.U95_low is None or one.U95_high is None:
        return {name: scale.number(one.value), "ci95": None}
    ends: Values = {"low": scale.number(one.U95_low), "high": scale.number(one.U95_high)}
    return {name: scale.number(one.value), "ci95": ends}


def _target(one: TargetFigures, pictures: Pictures) -> Values:
    scale = HEIGHT[_UNIT]
    at = {found.percent: found for found in one.percentiles}
    return {
        "name": TARGETS[one.target],
        "n": one.n,
        "sites": str(one.sites),
        "reason": told(one.reason) if one.reason else None,
        "glance": [_figure(at.get(percent), scale) for percent in _GLANCE],
        "mean": _figure(one.mean, scale),
        "rows": _rows(one),
        "figure": next(iter(pictures.figures([one.target])), said("report-no-distribution")),
    }


def _rows(one: TargetFigures) -> list[Json]:
    """Percentiles, mean and SD with their design effects."""
    if one.mean is None or one.sd is None:
        return []
    scale = HEIGHT[_UNIT]
    named: list[tuple[str, Figure, str | None]] = [
        (decimal(f"P{found.percent:g}"), found, scale.number(found.raw)) for found in one.percentiles
    ]
    rows: list[Json] = []
    for name, figure, raw in [
        *named,
        (said("report-mean"), one.mean, None),
        (said("report-sd"), one.sd, None),
    ]:
        effect = figure.effect
        effective = one.n / effect if effect else None
        rows.append(
            {
                "figure": name,
                **_figure(figure, scale),
                "raw": raw,
                "effect": None if effect is None else fixed(effect, 2),
                "effective": None if effective is None else fixed(effective, 0),
            }
        )
    return rows


def _year(one: YearDifference) -> Values:
    small = SMALL[_UNIT]
    ends: Values | None = None
    if one.U95_low is not None and one.U95_high is not None:
        ends = {
            "low": small.number(one.U95_low, signed=True),
            "high": small.number(one.U95_high, signed=True),
        }
    figure = said("report-figure-mean") if one.percent is None else decimal(f"P{one.percent:g}")
    return {
        "figure": said("report-year-figure", target=TARGETS[one.target], figure=figure),
        "years": said("report-between", low=str(one.first_year), high=str(one.second_year)),
        "n": f"{one.n_first}, {one.n_second}",
        "value": small.number(one.value, signed=True),
        "ci95": ends,
        "verdict": _year_verdict(one),
    }


def _year_verdict(one: YearDifference) -> str:
    if one.verdict is not None:
        return _VERDICTS[one.verdict]
    none = said("report-year-no-interval")
    return said("report-verdict-why", verdict=none, reason=told(one.reason)) if one.reason else none


def _errors(errors: Sequence[ErrorFigure]) -> list[Json]:
    """A row of each group: bias, MAE, RMSE, SD."""
    groups: dict[str, Values] = {}
    for one in errors:
        row = groups.setdefault(one.group, {"group": GROUPS[one.group], "n": one.n})
        row[one.figure.removesuffix("_m")] = _figure(one.value, SMALL[_UNIT])
    return list(groups.values())


def _plan(plans: Sequence[PlannedStudy], targets: Sequence[StatisticsTarget]) -> list[Json]:
    """Sites, and of each target how many vehicles at each."""
    by: Mapping[tuple[int, str], int | None] = {(one.sites, one.target): one.vehicles for one in plans}
    return [
        {
            "sites": sites,
            "vehicles": [
                said("report-no-number") if (needed := by.get((sites, target))) is None else fixed(needed, 0)
                for target in targets
            ],
        }
        for sites in dict.fromkeys(one.sites for one in plans)
    ]
