"""Figures of line scans: what the scanned vehicles drive, measure and keep apart, as cumulative curves."""

from matplotlib.axes import Axes

from sightline.enums import LengthUnit
from sightline.export.report import marks
from sightline.export.report.canvas import HALF, Drawing, svg
from sightline.export.report.marks import MAIN
from sightline.export.report.said import sentence_of_key
from sightline.export.report.units import SPEED, WAY, Scale, format_fixed
from sightline.export.report.words import QUANTITIES
from sightline.messages import write_count
from sightline.scans.statistics.service import ScanStatistics, Spread

_SECONDS = Scale(1.0, "s", 2)
_MARKED = (15.0, 50.0, 85.0)


def scale_of(unit_of: str, unit: LengthUnit) -> Scale:
    """How a quantity of m/s, m or s is shown."""
    return {"m/s": SPEED, "m": WAY}[unit_of][unit] if unit_of != "s" else _SECONDS


def scan_drawings(found: ScanStatistics, unit: LengthUnit = "m") -> dict[str, Drawing]:
    """Name to figure of every quantity that has values."""
    return {
        f"scan-{one.quantity.replace('_', '-')}": _cumulative(one, scale_of(one.unit, unit))
        for one in found.spreads
        if one.ecdf is not None
    }


def _cumulative(spread: Spread, scale: Scale) -> Drawing:
    name, curve = QUANTITIES[spread.quantity], spread.ecdf
    assert curve is not None
    title = sentence_of_key("report-fig-scanned", quantity=name)
    chosen = [each for each in spread.percentiles if each.percent in _MARKED and each.value is not None]

    def draw(axes: Axes) -> None:
        marks.steps(axes, curve, MAIN, scale.factor)
        marks.whiskers(axes, chosen, scale.factor)
        axes.set(
            xlabel=f"{name[:1].upper()}{name[1:]} ({scale.sign})",
            ylabel=sentence_of_key("report-fig-share"),
            ylim=(0, 100.8),
        )
        axes.margins(x=0.02)

    listed = ", ".join(f"P{format_fixed(each.percent, 0)} {scale.length(each.value)}" for each in chosen)
    caption = sentence_of_key("report-fig-scanned-caption", n=write_count(spread.n), percentiles=listed)
    caption = f"{caption} {marks.band_words([curve.n])}"
    return Drawing(svg(draw, title, HALF), title, caption)
