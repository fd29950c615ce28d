"""Where vehicles drive across the road, by lane and class: the report's figure and table."""

from matplotlib.axes import Axes

from sightline.enums import LengthUnit
from sightline.export.report import marks
from sightline.export.report.canvas import FULL, Drawing, Sheet, svg
from sightline.export.report.facts import ReportFacts
from sightline.export.report.pictures import Pictures
from sightline.export.report.said import sentence_of_key
from sightline.export.report.settable import Values
from sightline.export.report.units import HEIGHT
from sightline.export.report.words import group_word, heading
from sightline.results.survey_statistics import Statistics
from sightline.statistics.lateral import Lateral
from sightline.statistics.summary import Distribution

FIGURE = "lateral-position"
_SHOWN = (5.0, 50.0, 95.0)


def lateral_figure(result: Statistics, unit: LengthUnit) -> dict[str, Drawing | str]:
    """The figure by its name; nothing where no contact lies on the road."""
    found = result.lateral
    if found is None or not found.lanes.of:
        return {}
    scale, title = HEIGHT[unit], sentence_of_key("report-fig-lateral")
    rows = _rows_of_lanes(found)

    def draw(axes: Axes) -> None:
        marks.spread_rows(axes, rows, scale.factor)
        axes.set_xlabel(sentence_of_key("report-fig-lateral-axis", unit=scale.sign))

    caption = sentence_of_key("report-fig-lateral-caption")
    sheet = Sheet(FULL.width, 12.0 + marks.ROW_MM * len(rows), left=62.0, right=3.0)
    return {FIGURE: Drawing(svg(draw, title, sheet), title, caption)}


def _rows_of_lanes(positions: Lateral) -> list[tuple[str, Distribution]]:
    """Each lane, and below it its classes, where it has more than one."""
    rows: list[tuple[str, Distribution]] = []
    for lane, one in positions.lanes.of.items():
        rows.append((heading(group_word("lane", lane)), one))
        classes = positions.classes.get(lane)
        if classes is not None and len(classes.of) > 1:
            rows += [
                (f"{group_word('lane', lane)}, {group_word('category', word)}", of)
                for word, of in classes.of.items()
            ]
    return rows


def lateral(facts: ReportFacts, pictures: Pictures) -> Values | None:
    """What the template shows; None where there is nothing to show."""
    positions = facts.statistics.lateral
    if positions is None or positions.all.n == 0:
        return None
    rows = [(sentence_of_key("report-lateral-all"), positions.all), *_rows_of_lanes(positions)]
    return {
        "rows": [
            {"name": word, "n": one.n, "mean": one.mean_m, "sd": one.sd_m, "at": _values_at_percents(one)}
            for word, one in rows
        ],
        "figures": pictures.figures([FIGURE]) if positions.lanes.of else [],
    }


def _values_at_percents(one: Distribution) -> list[float | None]:
    at = {each.percent: each.value for each in one.percentiles}
    return [at.get(percent) for percent in _SHOWN]
