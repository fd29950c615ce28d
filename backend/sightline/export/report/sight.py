"""Values and figure of the report's section on sight distance: what the heights mean for crests."""

from __future__ import annotations

from collections.abc import Mapping

from matplotlib.axes import Axes

from sightline.enums import CrestVerdict, LengthUnit, StatisticsTarget
from sightline.export.report import marks
from sightline.export.report.canvas import FULL, INK, MUTED, Drawing, svg
from sightline.export.report.facts import ReportFacts
from sightline.export.report.pictures import Pictures
from sightline.export.report.said import said, told
from sightline.export.report.settable import Json, Values
from sightline.export.report.units import HEIGHT, SPEED, Scale, count, decimal, limit, percent
from sightline.export.report.words import TARGETS
from sightline.results.sightdistance.records import CaseOfHeights, SightQuestion
from sightline.results.sightdistance.service import bounded_of, case_of, design_speeds, distance_of
from sightline.results.survey_statistics import Filter, Statistics, standards_of
from sightline.sightdistance.distances import GREEN_BOOK
from sightline.sightdistance.workbench import Bounded
from sightline.statistics.distributions import PERCENTILES
from sightline.statistics.figures import TotalPercentile
from sightline.statistics.standards import Standard

FIGURE = "crest-k"
# Where the standard states no rule that the survey has a percentile of: that of AASHTO's heights.
_EYE_PERCENT, _OBJECT_PERCENT = 10.0, 5.0
_SPEED_MPS: dict[LengthUnit, float] = {"m": 100 / 3.6, "ft": 60 * 0.44704}
_SENTENCES: dict[CrestVerdict, str] = {
    "alike": "sight-verdict-alike",
    "shorter": "sight-verdict-shorter",
    "longer": "sight-verdict-longer",
    "unknown": "sight-verdict-unknown",
}


def sight(facts: ReportFacts, pictures: Pictures) -> Values | None:
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
        "own_rule": None not in (eye.percent, thing.percent),
        "source": told(GREEN_BOOK),
        "missing": [TARGETS[target] for target in survey.missing],
        "sentence": crest_sentence(question, standard, survey),
        "rows": _rows(question, standard, survey, facts.unit),
        "figures": pictures.figures([FIGURE]),
        "constant": _with_interval(None if survey.crest is None else survey.crest.constant_m, scale),
    }
    return values


def consequence(facts: ReportFacts) -> str | None:
    """The one sentence that says what the heights change on the road, where there is one."""
    found = _cases(facts.statistics, facts.unit)
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
    pair = _pair(result)
    if pair is None:
        return None
    eye, thing = pair
    question = question_of(eye, thing, unit)
    standard = case_of(question, "standard", Bounded(eye.height_m), Bounded(thing.height_m))
    survey = case_of(
        question,
        "survey",
        bounded_of(_percentile(result, "driver_eye", question.eye_percent)),
        bounded_of(_percentile(result, "taillight", question.object_percent)),
        (
            _by_pose_m(result, "driver_eye", question.eye_percent),
            _by_pose_m(result, "taillight", question.object_percent),
        ),
    )
    return eye, thing, question, standard, survey


def question_of(eye: Standard, thing: Standard, unit: LengthUnit) -> SightQuestion:
    """What a standard's eye and object are asked on a crest."""
    return SightQuestion(
        chosen=Filter(),
        eye_m=eye.height_m,
        object_m=thing.height_m,
        eye_percent=_rule(eye, _EYE_PERCENT),
        object_percent=_rule(thing, _OBJECT_PERCENT),
        object_target="taillight",
        kind="stopping",
        speed_mps=_SPEED_MPS[unit],
        difference_percent=6.0,
        headlight_m=0.6,
        radius_m=500.0,
        shares={},
        unit=unit,
    )


def _pair(result: Statistics) -> tuple[Standard, Standard] | None:
    """The first eye and object of one standard, else the first of each."""
    eyes, objects = standards_of(result.standards, "driver_eye"), standards_of(result.standards, "taillight")
    if not eyes or not objects:
        return None
    same = ((eye, thing) for eye in eyes for thing in objects if eye.name == thing.name)
    return next(same, (eyes[0], objects[0]))


def _rule(standard: Standard, usual: float) -> float:
    """The percentile that a standard's value stands for, where statistics hold it."""
    return standard.percent if standard.percent in PERCENTILES else usual


def _percentile(result: Statistics, target: StatisticsTarget, at: float) -> TotalPercentile | None:
    found = result.targets.get(target)
    if found is None or found.total is None:
        return None
    return next((one for one in found.total.percentiles if one.percent == at), None)


def _by_pose_m(result: Statistics, target: StatisticsTarget, at: float) -> Mapping[int, float]:
    found = result.targets.get(target)
    return {} if found is None else found.by_pose_m.get(at, {})


def crest_sentence(
    question: SightQuestion, standard: CaseOfHeights, survey: CaseOfHeights, whose: str = "survey"
) -> str | None:
    """The same as on the page, in the report's unit. whose: a survey's heights, or a study's."""
    if survey.crest is None or survey.comparison is None or standard.crest is None:
        return None
    scale = HEIGHT[question.unit]
    crest, before = survey.crest, standard.crest
    far = Scale(scale.factor, scale.sign, 0)
    near = Scale(scale.factor, scale.sign, 2)
    plain = Scale(scale.factor, "", 1)
    values: Mapping[str, str] = {
        "case": whose,
        "eye": near.length(crest.eye_m.value),
        "object": near.length(crest.object_m.value),
        "constant": plain.number(crest.constant_m.value),
        "standard": plain.number(before.constant_m.value),
        "change": percent(abs(survey.comparison.k_change)),
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
