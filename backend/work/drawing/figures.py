"""The figures of a survey's statistics as SVG: the paper's and more, readable in grey and without colours.

Names are those that the statistics page gives to its downloads.
"""

from __future__ import annotations

from backend.work.drawing.canvas import Drawing
from backend.work.drawing.error_figures import error_figures
from backend.work.drawing.height_figures import height_figures
from backend.work.drawing.scan_figures import scan_drawings
from backend.work.drawing.units import Unit
from backend.work.figuring import Statistics, standards_of
from backend.work.scanning_statistics import ScanStatistics


def figures(result: Statistics, unit: Unit = "m") -> dict[str, bytes]:
    """Name to SVG of every figure that has something to draw; the same result gives the same bytes."""
    return {name: one.svg for name, one in drawings(result, unit).items() if isinstance(one, Drawing)}


def drawings(
    result: Statistics, unit: Unit = "m", scans: ScanStatistics | None = None
) -> dict[str, Drawing | str]:
    """Name to figure, or to the sentence that stands in its place; those of line scans last."""
    found = error_figures(result.errors, unit)
    for name, target in result.targets.items():
        found |= height_figures(name, target, standards_of(result.standards, name), unit)
    return found if scans is None else {**found, **scan_drawings(scans, unit)}
