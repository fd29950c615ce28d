"""Marks of the figures. Dashes, greys and words tell lines apart, never a hue."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from sightline.enums import LengthUnit
from sightline.export.report.canvas import FAINT, INK, MUTED, Sheet
from sightline.export.report.labels import Named, write
from sightline.export.report.said import sentence_of_key
from sightline.export.report.units import HEIGHT, limit
from sightline.messages import write_count
from sightline.statistics.distributions import Density, Ecdf, Percentile
from sightline.statistics.summary import Distribution

#: A row of `spread_rows`.
ROW_MM = 4.6
_WORD_MM = 3.2  # a row of words
#: A simultaneous band of fewer covers more than half of the axis and hides the curves.
LEAST_FOR_A_BAND = 30


@dataclass(frozen=True)
class LineStyle:
    """How a curve looks. `band`: whether its interval is drawn."""

    dash: tuple[float, ...] = ()
    colour: str = INK
    width_pt: float = 1.2
    band: bool = True

    def line(self) -> dict[str, Any]:
        """Matplotlib's words for it."""
        style = (0, self.dash) if self.dash else "-"
        return {"color": self.colour, "linewidth": self.width_pt, "linestyle": style}


MAIN = LineStyle()
SECOND = LineStyle(dash=(5, 2))
THIRD = LineStyle(dash=(1, 1.4), colour=MUTED, width_pt=1.1, band=False)
RAW = LineStyle(dash=(5, 2), colour=MUTED, width_pt=1.1, band=False)


@dataclass(frozen=True)
class Limit:
    """A height that standards are set by, `count` of them, in the figure's unit; `word` names them."""

    at: float
    word: str
    share: float | None = None
    count: int = 1


def steps(axes: Axes, ecdf: Ecdf, style: LineStyle, factor: float, word: str = "") -> Named:
    """A cumulative distribution as steps in per cent, with its band where there are enough for one."""
    x = factor * np.concatenate([ecdf.value[:1], ecdf.value])
    y = 100.0 * np.concatenate([[0.0], ecdf.share])
    if style.band and ecdf.n >= LEAST_FOR_A_BAND:
        low, high = 100.0 * ecdf.low, 100.0 * ecdf.high
        axes.fill_between(x[1:], low, high, step="post", color=INK, alpha=0.11, linewidth=0)
    axes.step(x, y, where="post", label=word, **style.line())
    return Named(np.repeat(x, 2)[1:], np.repeat(y, 2)[:-1], word)


def density_curve(axes: Axes, density: Density, style: LineStyle, factor: float, word: str = "") -> Named:
    """A density with its band where there are enough for one, per unit of the axis."""
    x, y = factor * density.value, density.density / factor
    if style.band and density.n >= LEAST_FOR_A_BAND:
        low, high = density.low / factor, density.high / factor
        axes.fill_between(x, low, high, color=INK, alpha=0.11, linewidth=0)
    axes.plot(x, y, label=word, **style.line())
    return Named(x, y, word)


def band_words(counts: Sequence[int], *, pointwise: bool = False) -> str:
    """Ends a caption: what the bands of curves of so many vehicles are, and that few vehicles have none."""
    sentences = []
    if any(n >= LEAST_FOR_A_BAND for n in counts):
        sentences.append(sentence_of_key("report-fig-band-pointwise" if pointwise else "report-fig-band"))
    if any(n < LEAST_FOR_A_BAND for n in counts):
        sentences.append(sentence_of_key("report-fig-no-band", least=write_count(LEAST_FOR_A_BAND)))
    return " ".join(sentences)


def whiskers(axes: Axes, found: Sequence[Percentile], factor: float) -> None:
    """Percentiles that have a value, at their per cent, with their intervals."""
    for percentile in found:
        if percentile.value is not None:
            axes.plot(factor * percentile.value, percentile.percent, "o", color=INK, markersize=2.6, zorder=4)
        if percentile.low is not None and percentile.high is not None:
            ends = [factor * percentile.low, factor * percentile.high]
            axes.plot(
                ends, [percentile.percent] * 2, "|-", color=INK, linewidth=0.8, markersize=4.5, zorder=4
            )


def spread_row(axes: Axes, row: int, distribution: Distribution, factor: float) -> None:
    """A group as a row: median, middle 70 % and middle 90 %, as far as it has the vehicles for them; each
    vehicle where it has too few for the middle 70 %.
    """
    at = {one.percent: factor * one.value for one in distribution.percentiles if one.value is not None}
    if 5.0 in at and 95.0 in at:
        axes.plot([at[5.0], at[95.0]], [row, row], color=INK, linewidth=0.8)
    if 15.0 in at and 85.0 in at:
        axes.plot([at[15.0], at[85.0]], [row, row], color=INK, linewidth=3.2, solid_capstyle="butt")
    elif distribution.ecdf is not None:
        each = factor * distribution.ecdf.value
        axes.plot(each, np.full(len(each), row), "|", color=MUTED, markersize=5.0, markeredgewidth=0.8)
    if 50.0 in at:
        axes.plot(at[50.0], row, "o", color="white", markeredgecolor=INK, markersize=4.2, markeredgewidth=0.9)


def spread_rows(axes: Axes, rows: Sequence[tuple[str, Distribution]], factor: float) -> None:
    """Named groups below each other (`spread_row`), each name with how many vehicles it is of."""
    for k, (_, found) in enumerate(rows):
        spread_row(axes, k, found, factor)
    axes.set_yticks(range(len(rows)), labels=[f"{word}  ({write_count(one.n)})" for word, one in rows])
    axes.set_ylim(len(rows) - 0.4, -0.6)
    axes.tick_params(axis="y", length=0)
    axes.grid(axis="y", visible=False)
    axes.spines["left"].set_visible(False)


def limits_of(
    named: Iterable[tuple[float, str]],
    within_m: tuple[float, float],
    unit: LengthUnit,
    shares: Mapping[float, float | None] = {},
) -> list[Limit]:
    """Standards (height in metres, name) within what a figure shows; those of one height share a rule."""
    names: dict[float, list[str]] = {}
    for at_m, name in named:
        if within_m[0] <= at_m <= within_m[1]:
            names.setdefault(at_m, []).append(name)
    return [
        Limit(HEIGHT[unit].factor * at, f"{', '.join(of)} {limit(at, unit)}", shares.get(at), len(of))
        for at, of in sorted(names.items())
    ]


def add_header_row(sheet: Sheet, drawn: Sequence[Limit]) -> Sheet:
    """The sheet with a row above the axes for the words of each standard (`limits`)."""
    rows = _WORD_MM * len(drawn)
    return replace(sheet, height=sheet.height + rows, top=sheet.top + rows)


def limits(axes: Axes, drawn: Sequence[Limit]) -> None:
    """Standards as upright rules that lead to their words above the axes, where no curve runs: the lowest on
    top, so that no rule crosses the words of another. The sheet is of `add_header_row`; the axes reach to
    each rule.
    """
    low, high = axes.get_xlim()
    air = 0.01 * (high - low)
    axes.set_xlim(min([low, *(one.at - air for one in drawn)]), max([high, *(one.at + air for one in drawn)]))
    frame = axes.get_window_extent()
    row_px = _WORD_MM * axes.figure.dpi / 25.4
    for row, rule in enumerate(sorted(drawn, key=lambda one: -one.at)):
        foot = frame.y1 + row * row_px
        up = (foot - frame.y0) / frame.height
        axes.axvline(rule.at, ymax=up, color=FAINT, linewidth=0.7, dashes=(7, 1.5, 1, 1.5), clip_on=False)
        x = float(axes.transData.transform((rule.at, 0.0))[0])
        word = write(axes, rule.word, x, foot, (-1.0, 2.0, "left", "bottom"))
        beyond = word.get_window_extent().x1 - axes.figure.bbox.x1
        if beyond > 0.0:
            word.set_position((-1.0 - beyond * 72.0 / axes.figure.dpi, 2.0))
