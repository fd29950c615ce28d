"""Figures of the error against reference heights: its size, its share, its density, its trend."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, Protocol, TypeVar

from matplotlib.axes import Axes

from sightline.enums import LengthUnit
from sightline.export.report import labels, marks
from sightline.export.report.canvas import HALF, INK, MUTED, Drawing, svg
from sightline.export.report.marks import MAIN, SECOND, THIRD, LineStyle
from sightline.export.report.units import HEIGHT, SMALL, count, fixed
from sightline.export.report.words import GROUPS, heading
from sightline.statistics.agreement import Trend
from sightline.statistics.distributions import Ecdf
from sightline.statistics.errors import WHOLE_CM
from sightline.statistics.summary import Errors

_PENS: dict[str, LineStyle] = {"daytime": MAIN, "low_light": SECOND, "overall": THIRD}
_DOTS: tuple[tuple[str, dict[str, Any]], ...] = (
    ("daytime", {"marker": "o", "facecolors": "none", "edgecolors": INK}),
    ("low light", {"marker": "^", "facecolors": MUTED, "edgecolors": "none"}),
    ("lighting unknown", {"marker": "s", "facecolors": "none", "edgecolors": MUTED}),
)
_SHARES = "Share of vehicles (%)"
_MANY = 300  # points


class SampleCounts(Protocol):
    """A part that knows how many vehicles it is of."""

    @property
    def n(self) -> int: ...


Part = TypeVar("Part", bound=SampleCounts)


def error_figures(errors: Errors, unit: LengthUnit) -> dict[str, Drawing | str]:
    """Name to figure, or to the sentence that stands in its place."""
    return {
        "absolute-error-ecdf": _absolute(errors, unit),
        "relative-error-ecdf": _relative(errors),
        "signed-error-density": _density(errors, unit),
        "error-against-height": _trend(errors, unit),
    }


def _drawn(parts: Mapping[str, Part | str | None]) -> list[tuple[str, Part, LineStyle]]:
    """The groups that have something to draw; one that is the same as "overall" is drawn once."""
    there = {
        name: part for name in GROUPS if (part := parts.get(name)) is not None and not isinstance(part, str)
    }
    overall = there.get("overall")
    if overall is not None and any(part.n == overall.n for name, part in there.items() if name != "overall"):
        del there["overall"]
    if len(there) == 1:
        return [(name, part, MAIN) for name, part in there.items()]
    return [(name, part, _PENS[name]) for name, part in there.items()]


def _word(name: str, part: SampleCounts) -> str:
    return f"{GROUPS[name]}, n = {count(part.n)}"


def _cumulative(
    parts: Mapping[str, Ecdf | None], factor: float, axis: str, title: str, caption: str
) -> Drawing | str:
    drawn = _drawn(parts)
    if not drawn:
        return "No vehicle has a reference height, so there is no error to draw."

    def draw(axes: Axes) -> None:
        for name, part, style in drawn:
            marks.steps(axes, part, style, factor, _word(name, part))
        axes.set(xlabel=axis, ylabel=_SHARES, ylim=(0, 100.8))
        axes.set_xlim(0, None)
        axes.legend(loc="lower right")

    return Drawing(svg(draw, title, HALF), title, caption)


def _absolute(errors: Errors, unit: LengthUnit) -> Drawing | str:
    small = SMALL[unit]
    return _cumulative(
        errors.absolute,
        small.factor,
        f"Absolute error ({small.sign})",
        "Absolute error, cumulative",
        "Share of vehicles whose absolute error is at most so much. Bands: 95 %, everywhere at once.",
    )


def _relative(errors: Errors) -> Drawing | str:
    return _cumulative(
        errors.relative,
        100.0,
        "Absolute error over reference height (%)",
        "Relative error, cumulative",
        "The absolute error as a share of the reference height. Bands: 95 %, everywhere at once.",
    )


def _density(errors: Errors, unit: LengthUnit) -> Drawing | str:
    drawn = _drawn(errors.density)
    drawn = [one for one in drawn if one[0] != "overall"] or drawn  # which lies between the two
    small, title = SMALL[unit], "Signed error, density"
    if not drawn:
        overall = errors.density.get("overall")
        return overall if isinstance(overall, str) else "There is no error to draw."

    def draw(axes: Axes) -> None:
        axes.axvline(0.0, color=MUTED, linewidth=0.6)
        named = [
            marks.density_curve(axes, part, style, small.factor, _word(name, part))
            for name, part, style in drawn
        ]
        axes.set(xlabel=f"Measured minus reference ({small.sign})", ylabel=f"Density (per {small.sign})")
        axes.set_ylim(0, None)
        axes.margins(x=0.01)
        wished = [replace(one, at=at) for one, at in zip(named, (0.38, 0.62), strict=False)]
        if not labels.label(axes, wished):
            axes.set_ylim(0, 1.35 * axes.get_ylim()[1])
            axes.legend(loc="upper left")

    widths = ", ".join(f"{small.length(part.bandwidth)} {GROUPS[name]}" for name, part, _ in drawn)
    least = f", at least half of the {small.length(WHOLE_CM)} of rounding" if errors.rounding == "cm" else ""
    caption = f"Gaussian kernel, bandwidth {widths}{least}. Bands: 95 %, pointwise."
    return Drawing(svg(draw, title, HALF), title, caption)


def _trend(errors: Errors, unit: LengthUnit) -> Drawing | str:
    points, line = errors.points, errors.trend
    long, small, title = HEIGHT[unit], SMALL[unit], "Signed error against true height"
    if len(points) == 0:
        return "No vehicle has a reference height, so there is no error to draw."

    def draw(axes: Axes) -> None:
        axes.axhline(0.0, color=MUTED, linewidth=0.6)
        many = len(points) > _MANY
        for code, (word, look) in enumerate(_DOTS):
            rows = points[points[:, 2] == code]
            if len(rows):
                x, y = long.factor * rows[:, 0], small.factor * rows[:, 1]
                size, alpha = (4.0, 0.45) if many else (11.0, 0.8)
                axes.scatter(x, y, s=size, alpha=alpha, linewidths=0.5, label=word, **look)
        if isinstance(line, Trend):
            at = long.factor * line.at
            low, high = small.factor * line.low, small.factor * line.high
            axes.fill_between(at, low, high, color=INK, alpha=0.16, linewidth=0)
            axes.plot(at, small.factor * line.value, label="regression", **MAIN.line())
        axes.set(
            xlabel=f"Manufacturer’s height ({long.sign})",
            ylabel=f"Measured minus reference ({small.sign})",
        )
        key = axes.legend(
            loc="lower left",
            bbox_to_anchor=(0, 1),
            ncols=4,
            columnspacing=1,
            handletextpad=0.3,
            handlelength=2,
        )
        for handle in key.legend_handles:
            handle.set_alpha(1.0)  # type: ignore[union-attr]

    return Drawing(svg(draw, title, replace(HALF, top=6.0)), title, _trend_caption(errors, unit))


def _trend_caption(errors: Errors, unit: LengthUnit) -> str:
    line, absolute = errors.trend, errors.absolute_trend
    if not isinstance(line, Trend):
        return f"One mark a vehicle. {line}"
    per = SMALL[unit].factor / HEIGHT[unit].factor
    sign = f"{SMALL[unit].sign} per {HEIGHT[unit].sign}"
    low, high = line.slope_ci95.low, line.slope_ci95.high
    shown = len(errors.points)
    seen = (
        "One mark a vehicle"
        if shown >= line.n
        else f"One mark for {count(shown)} of {count(line.n)} vehicles"
    )
    words = (
        f"{seen}; regression with its 95 % band: slope {fixed(per * line.slope, 1)} {sign} "
        f"({fixed(per * low, 1)} to {fixed(per * high, 1)}), r = {fixed(line.correlation, 2)}"
    )
    if isinstance(absolute, Trend):
        words += f"; absolute error: r = {fixed(absolute.correlation, 2)}"
    return heading(words) + "."
