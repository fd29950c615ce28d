"""The figure of a study's report: a target's distribution with its band, beside the heights of standards."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes

from sightline.enums import LengthUnit
from sightline.export.report import marks
from sightline.export.report.canvas import FULL, INK, Drawing, svg
from sightline.export.report.marks import MAIN, RAW
from sightline.export.report.said import sentence_of_key, spoken_language
from sightline.export.report.units import HEIGHT
from sightline.export.report.words import TARGETS
from sightline.results.usual_standards import in_language
from sightline.statistics.standards import Standard
from sightline.studies.records import Curve

_REACH_M = 0.15  # so far beyond the heights a standard is still drawn


def curve_drawing(curve: Curve, standards: Sequence[Standard], unit: LengthUnit) -> Drawing:
    """Percentiles of true heights with their total intervals; dashed: with random error left in."""
    scale, word = HEIGHT[unit], TARGETS[curve.target]
    title = sentence_of_key("report-fig-true", target=word)
    share = [one.percent for one in curve.points]
    value = scale.factor * np.array([one.value for one in curve.points])
    raw = scale.factor * np.array([one.raw for one in curve.points])
    known = [one for one in curve.points if one.U95_low is not None and one.U95_high is not None]
    heights_m = [one.value for one in curve.points if one.value is not None]
    shown = (heights_m[0] - _REACH_M, heights_m[-1] + _REACH_M)
    named = ((one.height_m, in_language(one, spoken_language()).name) for one in standards)
    limits = marks.limits_of(named, shown, unit)

    def draw(axes: Axes) -> None:
        if known:
            low = scale.factor * np.array([one.U95_low for one in known])
            high = scale.factor * np.array([one.U95_high for one in known])
            at = [one.percent for one in known]
            axes.fill_betweenx(at, low, high, color=INK, alpha=0.13, linewidth=0)
        axes.plot(raw, share, label=sentence_of_key("report-fig-error-left-in"), **RAW.line())
        axes.plot(value, share, label=sentence_of_key("report-fig-true-curve"), **MAIN.line())
        axes.set(
            xlabel=sentence_of_key("report-fig-height-above", target=word, unit=scale.sign),
            ylabel=sentence_of_key("report-fig-share"),
            ylim=(0, 100),
        )
        axes.margins(x=0.02)
        marks.limits(axes, limits)
        axes.legend(loc="lower right")

    sheet = marks.add_header_row(FULL, limits)
    return Drawing(svg(draw, title, sheet), title, sentence_of_key("report-fig-true-caption"))
