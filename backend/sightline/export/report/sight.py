"""Values and figure of the report's section on sight distance: what the heights mean for crests."""

from matplotlib.axes import Axes

from sightline.enums import LengthUnit
from sightline.export.report import marks
from sightline.export.report.canvas import FULL, INK, MUTED, Drawing, svg
from sightline.export.report.crest import cases_of
from sightline.export.report.facts import ReportFacts
from sightline.export.report.said import sentence_of_key, spoken_language
from sightline.export.report.settable import Values
from sightline.export.report.units import HEIGHT, SPEED, decimal, limit
from sightline.export.report.words import TARGETS
from sightline.results.sightdistance.records import CaseOfHeights, SightQuestion
from sightline.results.sightdistance.service import design_speeds, distance_of, of_class
from sightline.results.survey_statistics import Statistics
from sightline.results.usual_standards import in_language
from sightline.sightdistance.distances import GREEN_BOOK

FIGURE = "crest-k"


def sight(facts: ReportFacts) -> Values | None:
    """What stands in the section; None where no standard gives both an eye and an object."""
    found = cases_of(facts.statistics, facts.unit)
    if found is None or facts.statistics.sight is None:
        return None
    eye, thing, question, standard, survey = found
    return {
        "standard": ", ".join(
            dict.fromkeys(in_language(one, spoken_language()).name for one in (eye, thing))
        ),
        "eye": limit(eye.height_m, facts.unit),
        "object": limit(thing.height_m, facts.unit),
        "eye_percent": decimal(f"{question.eye_percent:g}"),
        "object_percent": decimal(f"{question.object_percent:g}"),
        "own_rule": all(one in facts.statistics.standards for one in (eye, thing)),
        "classes": sentence_of_key(
            "sight-read", whose=of_class(*facts.statistics.sight, facts.statistics.of_chosen)
        ),
        "source": GREEN_BOOK,
        "missing": [TARGETS[target] for target in survey.missing],
        "rows": _rows_of_speeds(question, standard, survey, facts.unit),
    }


def crest_of(facts: ReportFacts) -> bool:
    """Whether the survey's own heights give a crest."""
    found = cases_of(facts.statistics, facts.unit)
    return found is not None and found[4].crest is not None


def sight_figure(result: Statistics, unit: LengthUnit) -> dict[str, Drawing | str]:
    """K against design speed for the standard and the survey, by name; nothing without a survey's crest."""
    found = cases_of(result, unit)
    if found is None or found[4].crest is None:
        return {}
    *_, standard, survey = found
    scale, speed = HEIGHT[unit], SPEED[unit]
    title = sentence_of_key("report-fig-crest")
    speeds = [speed.factor * one for one in design_speeds(unit)]

    def draw(axes: Axes) -> None:
        k = [scale.factor * one.value for one in survey.k_m]
        if survey.k_m[0].low is not None:
            low = [scale.factor * (one.low or 0.0) for one in survey.k_m]
            high = [scale.factor * (one.high or 0.0) for one in survey.k_m]
            axes.fill_between(speeds, low, high, color=INK, alpha=0.14, linewidth=0)
        by_standard = [scale.factor * one.value for one in standard.k_m]
        axes.plot(speeds, by_standard, label=sentence_of_key("report-fig-by-standard"), **marks.SECOND.line())
        axes.plot(speeds, k, label=sentence_of_key("report-fig-by-survey"), **marks.MAIN.line())
        axes.set(
            xlabel=sentence_of_key("report-fig-design-speed", unit=speed.sign),
            ylabel=sentence_of_key("report-fig-k", unit=scale.sign),
            ylim=(0, None),
        )
        axes.legend(loc="upper left", edgecolor=MUTED)

    caption = sentence_of_key("report-fig-crest-caption")
    return {FIGURE: Drawing(svg(draw, title, FULL), title, caption)}


def _rows_of_speeds(
    question: SightQuestion, standard: CaseOfHeights, survey: CaseOfHeights, unit: LengthUnit
) -> list[Values]:
    """One row a design speed."""
    speeds = design_speeds(unit)
    of_survey = survey.k_m or (None,) * len(speeds)
    return [
        {
            "speed": speed,
            "distance": distance_of(question, speed).design_m,
            "standard": by_standard.value,
            "survey": by_survey,
        }
        for speed, by_standard, by_survey in zip(speeds, standard.k_m, of_survey, strict=True)
    ]
