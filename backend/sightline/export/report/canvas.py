"""A sheet to draw on: one look for all figures, greys only, and SVG whose bytes depend on the data alone."""

import io
from collections.abc import Callable
from dataclasses import dataclass, field
from threading import Lock
from typing import Any

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import ScalarFormatter

from sightline.export.report.units import decimal

INK, MUTED, FAINT, RULE = "#111111", "#666666", "#8c8c8c", "#dcdcdc"
TEXT_PT, NOTE_PT = 7.0, 6.3
_MM = 1.0 / 25.4
_DPI = 72.0  # the SVG writer's own: what is measured is what is written
_SALT = "sightline"

_LOOK: Any = {
    "svg.fonttype": "path",
    "svg.hashsalt": _SALT,
    "font.family": ["DejaVu Sans"],
    "font.size": TEXT_PT,
    "axes.labelsize": TEXT_PT,
    "axes.labelcolor": INK,
    "axes.labelpad": 3.0,
    "axes.linewidth": 0.6,
    "axes.edgecolor": MUTED,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.axisbelow": True,
    "axes.grid": True,
    "grid.color": RULE,
    "grid.linewidth": 0.4,
    "xtick.labelsize": TEXT_PT,
    "ytick.labelsize": TEXT_PT,
    "xtick.color": MUTED,
    "ytick.color": MUTED,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.major.size": 2.5,
    "ytick.major.size": 2.5,
    "legend.frameon": True,
    "legend.framealpha": 0.9,
    "legend.edgecolor": "none",
    "legend.fancybox": False,
    "legend.fontsize": TEXT_PT,
    "legend.handlelength": 3.2,
    "legend.borderaxespad": 0.3,
    "legend.labelspacing": 0.35,
    "text.usetex": False,
    "text.parse_math": False,  # a name may hold dollar signs
    "path.simplify": True,
    "path.simplify_threshold": 0.05,
}


@dataclass(frozen=True)
class Drawing:
    """A figure: its SVG, a title, and a caption that says what is seen."""

    svg: bytes = field(repr=False)
    title: str
    caption: str


# Matplotlib's settings are the process's: one figure at a time.
_alone = Lock()


@dataclass(frozen=True)
class Sheet:
    """Width, height and margins round the axes, in millimetres; fixed, so that axes line up in print."""

    width: float
    height: float
    left: float = 14.0
    right: float = 2.0
    bottom: float = 9.0
    top: float = 2.0

    def frame(self) -> tuple[float, float, float, float]:
        """The axes' place as shares of the sheet: left, bottom, width, height."""
        width, height = self.width - self.left - self.right, self.height - self.bottom - self.top
        return (self.left / self.width, self.bottom / self.height, width / self.width, height / self.height)


class _Ticks(ScalarFormatter):
    """Numbers along an axis, with the decimal sign of the language."""

    def __call__(self, x: float, pos: int | None = None) -> str:
        """One tick's number."""
        return decimal(super().__call__(x, pos))


HALF = Sheet(84.0, 60.0)  # a column of an A4 page
FULL = Sheet(174.0, 78.0, right=23.0)  # its width, with words on the right


def svg(draw: Callable[[Axes], None], title: str, sheet: Sheet) -> bytes:
    """What `draw` puts on a sheet, as SVG; `title` is what a screen reader says."""
    with _alone, matplotlib.rc_context():
        matplotlib.rcdefaults()  # whatever a machine's own settings say
        matplotlib.rcParams.update(_LOOK)
        figure = Figure(figsize=(sheet.width * _MM, sheet.height * _MM), dpi=_DPI)
        FigureCanvasAgg(figure)  # measures texts
        axes = figure.add_axes(sheet.frame())
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_formatter(_Ticks())
        draw(axes)
        out = io.BytesIO()
        figure.savefig(out, format="svg", metadata={"Title": title, "Date": None, "Creator": "Sightline"})
    return out.getvalue()
