"""The figures of a survey's statistics as SVG: the paper's and more, readable in grey and without colours.

Names are those that the statistics page gives to its downloads.
"""

from sightline.enums import LengthUnit
from sightline.export.report.canvas import Drawing
from sightline.export.report.error_figures import error_figures
from sightline.export.report.height_figures import height_figures
from sightline.export.report.lateral import lateral_figure
from sightline.export.report.scan_figures import scan_drawings
from sightline.export.report.sight import sight_figure
from sightline.results.survey_statistics import Statistics, standards_of
from sightline.scans.statistics.service import ScanStatistics


def figures(result: Statistics, unit: LengthUnit = "m") -> dict[str, bytes]:
    """Name to SVG of every figure that has something to draw; the same result gives the same bytes."""
    return {name: one.svg for name, one in drawings(result, unit).items() if isinstance(one, Drawing)}


def drawings(
    result: Statistics, unit: LengthUnit = "m", scans: ScanStatistics | None = None
) -> dict[str, Drawing | str]:
    """Name to figure, or to the sentence that stands in its place; those of line scans last."""
    figures_by_name = error_figures(result.errors, unit)
    for name, target in result.targets.items():
        figures_by_name |= height_figures(name, target, standards_of(result.standards, name), unit)
    figures_by_name |= lateral_figure(result, unit)
    figures_by_name |= sight_figure(result, unit)
    return figures_by_name if scans is None else {**figures_by_name, **scan_drawings(scans, unit)}
