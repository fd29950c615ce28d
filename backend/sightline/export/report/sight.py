"""Values and figure of the report's section on sight distance: what the heights mean for crests."""

from __future__ import annotations

from collections.abc import Mapping

from matplotlib.axes import Axes

from sightline.enums import CrestVerdict, LengthUnit
from sightline.export.report import marks
from sightline.export.report.canvas import FULL, INK, MUTED, Drawing, svg
from sightline.export.report.facts import ReportFacts
from sightline.export.report.said import said, told
from sightline.export.report.settable import Json, Values
from sightline.export.report.units import HEIGHT, SPEED, Scale, count, decimal, limit, percent
from sightline.export.report.words import TARGETS
from sightline.results.sightdistance.records import CaseOfHeights, SightQuestion
from sightline.results.sightdistance.service import case_of, design_speeds, distance_of, exact, height_of_rule
from sightline.results.survey_statistics import Filter, Statistics
from sightline.sightdistance.distances import GREEN_BOOK
from sightline.sightdistance.workbench import Bounded
from sightline.statistics.standards import Standard

FIGURE = "crest-k"
_SPEED_MPS: dict[LengthUnit, float] = {"m": 100 / 3.6, "ft": 60 * 0.44704}
_SENTENCES: dict[CrestVerdict, str] = {
    "alike": "sight-verdict-alike",
    "shorter": "sight-verdict-shorter",
    "longer": "sight-verdict-longer",
    "unknown": "sight-verdict-unknown",
}


def sight(facts: ReportFacts) -> Values | None:
    """What stands in the section; None where no standard gives both an eye and an object."""
    found = _cases(facts.statistics, facts.unit)
    if found is None:
        return None
    eye, thing, question, standard, survey = found
    scale = HEIGHT[facts.unit]
    values: Values = {
        "standard": ", ".join(dict.fromkeys(told(one.name) for one in (eye, thing))),
        "eye": limit(eye.height_m, facts.unit),
        "object": limit(thing.height_m, facts.unit),
        "eye_percent": decimal(f"{question.eye_percent:g}"),
        "object_percent": decimal(f"{question.object_percent:g}"),
        "own_rule": all(one in facts.statistics.standards for one in (eye, thing)),
        "classes": _classes(facts.statistics),
        "source": told(GREEN_BOOK),
        "missing": [TARGETS[target] for target in survey.missing],
        "rows": _rows(question, standard, survey, facts.unit),
        "constant": _with_interval(None if survey.crest is None else survey.crest.constant_m, scale),
    }
    return values


def _classes(result: Statistics) -> str:
    """Whose heights the percentiles are of: "class" where others were left out, else "all"."""
    return "class" if result.sight is not None and all(one.by_class for one in result.sight) else "all"


def crest_of(facts: ReportFacts) -> bool:
    """Whether the survey's own heights give a crest."""
    found = _cases(facts.statistics, facts.unit)
    return found is not None and found[4].crest is not None


def consequence(result: Statistics, unit: LengthUnit) -> str | None:
    """The one sentence that says what the heights change on the road, where there is one."""
    found = _cases(result, unit)
    return None if found is None else crest_sentence(*found[2:])


def sight_figure(result: Statistics, unit: LengthUnit) -> dict[str, Drawing | str]:
    """K against design speed for the standard and the survey, by name; nothing without a survey's crest."""
    found = _cases(result, unit)
    if found is None or found[4].crest is None:
        return {}
    *_, standard, survey = found
    scale, speed = HEIGHT[unit], SPEED[unit]
    title = said("report-fig-crest")
    speeds = [speed.factor * one for one in design_speeds(unit)]

    def draw(axes: Axes) -> None:
        k = [scale.factor * one.value for one in survey.k_m]
        if survey.k_m[0].low is not None:
            low = [scale.factor * (one.low or 0.0) for one in survey.k_m]
            high = [scale.factor * (one.high or 0.0) for one in survey.k_m]
            axes.fill_between(speeds, low, high, color=INK, alpha=0.14, linewidth=0)
        by_standard = [scale.factor * one.value for one in standard.k_m]
        axes.plot(speeds, by_standard, label=said("report-fig-by-standard"), **marks.SECOND.line())
        axes.plot(speeds, k, label=said("report-fig-by-survey"), **marks.MAIN.line())
        axes.set(
            xlabel=said("report-fig-design-speed", unit=speed.sign),
            ylabel=said("report-fig-k", unit=scale.sign),
            ylim=(0, None),
        )
        axes.legend(loc="upper left", edgecolor=MUTED)

    caption = said("report-fig-crest-caption")
    return {FIGURE: Drawing(svg(draw, title, FULL), title, caption)}


_Cases = tuple[Standard, Standard, SightQuestion, CaseOfHeights, CaseOfHeights]


def _cases(result: Statistics, unit: LengthUnit) -> _Cases | None:
    """The standard that is compared with, what is asked, its case and the survey's."""
    if result.sight is None:
        return None
    eye, thing = (one.standard for one in result.sight)
    question = question_of(eye, thing, unit)
    standard = case_of(question, "standard", exact(eye.height_m), exact(thing.height_m))
    survey = case_of(question, "survey", *map(height_of_rule, result.sight))
    return eye, thing, question, standard, survey


def question_of(eye: Standard, thing: Standard, unit: LengthUnit) -> SightQuestion:
    """What a standard's eye and object are asked on a crest, each read by the percentile that it states."""
    assert eye.percent is not None and thing.percent is not None
    return SightQuestion(
        chosen=Filter(),
        eye_m=eye.height_m,
        object_m=thing.height_m,
        eye_percent=eye.percent,
        object_percent=thing.percent,
        object_target="taillight",
        kind="stopping",
        speed_mps=_SPEED_MPS[unit],
        difference_percent=6.0,
        headlight_m=0.6,
        radius_m=500.0,
        shares={},
        unit=unit,
    )


def crest_sentence(
    question: SightQuestion, standard: CaseOfHeights, survey: CaseOfHeights, whose: str = "survey"
) -> str | None:
    """The same as on the page, in the report's unit; why there is no crest where heights are too few for one.
    whose: a survey's heights, or a study's.
    """
    if survey.too_few:
        each = [
            said("sight-too-few-of", target=TARGETS[one.target], reason=told(one.reason))
            for one in survey.too_few
        ]
        return said("sight-too-few", targets="; ".join(each))
    if survey.crest is None or survey.comparison is None or standard.crest is None:
        return None
    scale = HEIGHT[question.unit]
    crest, before = survey.crest, standard.crest
    far = Scale(scale.factor, scale.sign, 0)
    plain = Scale(scale.factor, "", 1)
    told_apart = survey.comparison.verdict in ("shorter", "longer")  # then words say which
    sign = "" if told_apart else "\N{MINUS SIGN}" if survey.comparison.k_change < 0 else "+"
    values: Mapping[str, str] = {
        "case": whose,
        "eye": scale.length(crest.eye_m.value),
        "object": scale.length(crest.object_m.value),
        "constant": plain.number(crest.constant_m.value),
        "standard": plain.number(before.constant_m.value),
        "change": sign + percent(abs(survey.comparison.k_change)),
        "k": plain.number(crest.k_m.value),
        "k_standard": plain.number(before.k_m.value),
        "distance": far.length(distance_of(question, question.speed_mps).design_m),
        "seen": far.length(crest.seen_m.value),
        "reason": told(crest.constant_m.reason or ""),
    }
    return said(_SENTENCES[survey.comparison.verdict], **values)


def _rows(
    question: SightQuestion, standard: CaseOfHeights, survey: CaseOfHeights, unit: LengthUnit
) -> list[Json]:
    """One row a design speed."""
    length, k = Scale(HEIGHT[unit].factor, HEIGHT[unit].sign, 0), Scale(HEIGHT[unit].factor, "", 1)
    speeds = design_speeds(unit)
    of_survey = survey.k_m or (None,) * len(speeds)
    return [
        {
            "speed": count(round(SPEED[unit].factor * speed)),
            "distance": length.number(distance_of(question, speed).design_m),
            "standard": k.number(by_standard.value),
            "survey": None if by_survey is None else _with_interval(by_survey, k),
        }
        for speed, by_standard, by_survey in zip(speeds, standard.k_m, of_survey, strict=True)
    ]


def _with_interval(found: Bounded | None, scale: Scale) -> Values | None:
    if found is None:
        return None
    ci95: Values | None = None
    if found.low is not None and found.high is not None:
        ci95 = {"low": scale.number(found.low), "high": scale.number(found.high)}
    return {"value": scale.number(found.value), "ci95": ci95}
