"""Figures of the error against reference heights: its size, its share, its density, its trend."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, Protocol, TypeVar

from matplotlib.axes import Axes

from sightline.enums import LengthUnit
from sightline.export.report import labels, marks
from sightline.export.report.canvas import HALF, INK, MUTED, Drawing, svg
from sightline.export.report.marks import MAIN, SECOND, THIRD, LineStyle
from sightline.export.report.said import sentence_of_key, sentence_of_said
from sightline.export.report.units import HEIGHT, SMALL, Scale, format_fixed
from sightline.export.report.words import LIGHTING, heading
from sightline.messages import write_count
from sightline.messages.said import Said
from sightline.statistics.agreement import Trend
from sightline.statistics.distributions import Ecdf
from sightline.statistics.errors import GROUPS, WHOLE_CM
from sightline.statistics.summary import Errors

_PENS: dict[str, LineStyle] = {"daytime": MAIN, "low_light": SECOND, "overall": THIRD}
_DOTS: tuple[tuple[str, dict[str, Any]], ...] = (
    ("daytime", {"marker": "o", "facecolors": "none", "edgecolors": INK}),
    ("low_light", {"marker": "^", "facecolors": MUTED, "edgecolors": "none"}),
    ("unknown", {"marker": "s", "facecolors": "none", "edgecolors": MUTED}),
)
_MANY = 300  # points


class SampleCounts(Protocol):
    """A part that knows how many vehicles it is of."""

    @property
    def n(self) -> int: ...


Part = TypeVar("Part", bound=SampleCounts)


def error_figures(errors: Errors, unit: LengthUnit) -> dict[str, Drawing | str]:
    """Name to figure, or to the sentence that stands in its place."""
    small = SMALL[unit]
    return {
        "absolute-error-ecdf": _cumulative(
            errors.absolute,
            small.factor,
            sentence_of_key("report-fig-absolute-axis", unit=small.sign),
            sentence_of_key("report-fig-absolute"),
            sentence_of_key("report-fig-absolute-caption"),
        ),
        "relative-error-ecdf": _cumulative(
            errors.relative,
            100.0,
            sentence_of_key("report-fig-relative-axis"),
            sentence_of_key("report-fig-relative"),
            sentence_of_key("report-fig-relative-caption"),
        ),
        "signed-error-density": _density(errors, unit),
        "error-against-height": _trend(errors, unit),
    }


def _groups_to_draw(parts: Mapping[str, Part | Said | None]) -> list[tuple[str, Part, LineStyle]]:
    """The groups that have something to draw; one that is the same as "overall" is drawn once."""
    there = {
        name: part for name in GROUPS if (part := parts.get(name)) is not None and not isinstance(part, Said)
    }
    overall = there.get("overall")
    if overall is not None and any(part.n == overall.n for name, part in there.items() if name != "overall"):
        del there["overall"]
    if len(there) == 1:
        return [(name, part, MAIN) for name, part in there.items()]
    return [(name, part, _PENS[name]) for name, part in there.items()]


def _word(name: str, part: SampleCounts) -> str:
    return sentence_of_key("report-fig-group", group=LIGHTING[name], n=write_count(part.n))


def _cumulative(
    parts: Mapping[str, Ecdf | None], factor: float, axis: str, title: str, caption: str
) -> Drawing | str:
    drawn = _groups_to_draw(parts)
    if not drawn:
        return sentence_of_key("report-fig-no-error")

    def draw(axes: Axes) -> None:
        named = [marks.steps(axes, part, style, factor, _word(name, part)) for name, part, style in drawn]
        axes.set(xlabel=axis, ylabel=sentence_of_key("report-fig-share"), ylim=(0, 100.8))
        axes.set_xlim(0, None)
        if not labels.label(axes, named):
            axes.legend(loc="lower right")

    bands = marks.band_words([part.n for _, part, style in drawn if style.band])
    return Drawing(svg(draw, title, HALF), title, f"{caption} {bands}")


def _density(errors: Errors, unit: LengthUnit) -> Drawing | str:
    drawn = _groups_to_draw(errors.density)
    drawn = [one for one in drawn if one[0] != "overall"] or drawn  # which lies between the two
    small, title = SMALL[unit], sentence_of_key("report-fig-signed")
    if not drawn:
        overall = errors.density.get("overall")
        return (
            sentence_of_said(overall)
            if isinstance(overall, Said)
            else sentence_of_key("report-fig-no-errors")
        )

    def draw(axes: Axes) -> None:
        axes.axvline(0.0, color=MUTED, linewidth=0.6)
        named = [
            marks.density_curve(axes, part, style, small.factor, _word(name, part))
            for name, part, style in drawn
        ]
        axes.set(
            xlabel=sentence_of_key("report-fig-signed-axis", unit=small.sign),
            ylabel=sentence_of_key("report-fig-density-axis", unit=small.sign),
        )
        axes.set_ylim(0, None)
        axes.margins(x=0.01)
        wished = [replace(one, at=at) for one, at in zip(named, (0.38, 0.62), strict=False)]
        if not labels.label(axes, wished):
            axes.set_ylim(0, 1.35 * axes.get_ylim()[1])
            axes.legend(loc="upper left")

    widths = ", ".join(
        sentence_of_key("report-fig-signed-width", width=small.length(part.bandwidth), group=LIGHTING[name])
        for name, part, _ in drawn
    )
    bands = marks.band_words([part.n for _, part, style in drawn if style.band], pointwise=True)
    return Drawing(svg(draw, title, HALF), title, f"{_density_caption(errors, widths, small)} {bands}")


def _density_caption(errors: Errors, widths: str, small: Scale) -> str:
    if errors.rounding != "cm":
        return sentence_of_key("report-fig-signed-caption", widths=widths)
    return sentence_of_key("report-fig-signed-caption-cm", widths=widths, rounding=small.length(WHOLE_CM))


def _trend(errors: Errors, unit: LengthUnit) -> Drawing | str:
    points, line = errors.points, errors.trend
    long, small, title = HEIGHT[unit], SMALL[unit], sentence_of_key("report-fig-trend")
    if len(points) == 0:
        return sentence_of_key("report-fig-no-error")

    def draw(axes: Axes) -> None:
        axes.axhline(0.0, color=MUTED, linewidth=0.6)
        many = len(points) > _MANY
        for code, (light, look) in enumerate(_DOTS):
            rows = points[points[:, 2] == code]
            if len(rows):
                x, y = long.factor * rows[:, 0], small.factor * rows[:, 1]
                size, alpha = (4.0, 0.45) if many else (11.0, 0.8)
                axes.scatter(x, y, s=size, alpha=alpha, linewidths=0.5, label=LIGHTING[light], **look)
        if isinstance(line, Trend):
            at = long.factor * line.at
            low, high = small.factor * line.low, small.factor * line.high
            axes.fill_between(at, low, high, color=INK, alpha=0.16, linewidth=0)
            axes.plot(
                at, small.factor * line.value, label=sentence_of_key("report-fig-regression"), **MAIN.line()
            )
        axes.set(
            xlabel=sentence_of_key("report-fig-maker-height", unit=long.sign),
            ylabel=sentence_of_key("report-fig-signed-axis", unit=small.sign),
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


#: Decimals of a slope in mm per m, and as fine in inches per foot: 0.1 mm per m are 0.0012 in per ft.
SLOPE_DIGITS: dict[LengthUnit, int] = {"m": 1, "ft": 3}


def _trend_caption(errors: Errors, unit: LengthUnit) -> str:
    line, absolute = errors.trend, errors.absolute_trend
    if not isinstance(line, Trend):
        return sentence_of_key("report-fig-one-mark", reason=sentence_of_said(line))
    per = SMALL[unit].factor / HEIGHT[unit].factor
    sign = sentence_of_key("report-fig-per", small=SMALL[unit].sign, height=HEIGHT[unit].sign)
    low, high, digits = line.slope_ci95.low, line.slope_ci95.high, SLOPE_DIGITS[unit]
    shown = len(errors.points)
    points_words = (
        sentence_of_key("report-fig-seen")
        if shown >= line.n
        else sentence_of_key("report-fig-seen-some", shown=write_count(shown), n=write_count(line.n))
    )
    values = {
        "seen": points_words,
        "slope": f"{format_fixed(per * line.slope, digits)} {sign}",
        "interval": sentence_of_key(
            "report-between", low=format_fixed(per * low, digits), high=format_fixed(per * high, digits)
        ),
        "r": format_fixed(line.correlation, 2),
    }
    if not isinstance(absolute, Trend):
        return heading(sentence_of_key("report-fig-trend-caption", **values))
    of_absolute = format_fixed(absolute.correlation, 2)
    return heading(sentence_of_key("report-fig-trend-caption-absolute", **values, r_absolute=of_absolute))
