"""Figures of heights: each target's distribution, its density, and its groups."""

from collections.abc import Sequence
from dataclasses import replace

from matplotlib.axes import Axes

from sightline.enums import LengthUnit, StatisticsTarget
from sightline.export.report import labels, marks
from sightline.export.report.canvas import FULL, HALF, INK, MUTED, NOTE_PT, Drawing, Sheet, svg
from sightline.export.report.marks import MAIN, Limit
from sightline.export.report.said import sentence_of_key, sentence_of_said, spoken_language
from sightline.export.report.units import HEIGHT, Scale, format_fixed, percent
from sightline.export.report.words import GROUPINGS, TARGETS, group_word, heading, join_with_semicolons
from sightline.messages import write_count
from sightline.results.usual_standards import in_language
from sightline.statistics.distributions import Density, Percentile
from sightline.statistics.standards import Standard
from sightline.statistics.summary import Groups, Target
from sightline.statistics.total_uncertainty import TotalFigures

_MARKED = (5.0, 15.0, 50.0, 85.0, 95.0)
_LONGEST_WORD = 34


def height_figures(
    name: StatisticsTarget, target: Target, standards: Sequence[Standard], unit: LengthUnit
) -> dict[str, Drawing | str]:
    """One target's figures by name; `standards` in the order of the target's shares."""
    limits = _limits(target, standards, unit)
    figures: dict[str, Drawing | str] = {
        f"{name}-ecdf": _cumulative(name, target, limits, len(standards), unit),
        f"{name}-density": _density(name, target, limits, unit),
    }
    for grouping, groups in target.groups.items():
        if len(groups.of) > 1:
            figures[f"{name}-by-{grouping}"] = _side_by_side(name, grouping, groups, limits, unit)
    return figures


def _limits(target: Target, standards: Sequence[Standard], unit: LengthUnit) -> list[Limit]:
    """The standards near enough to the heights to be drawn."""
    found = target.corrected.ecdf
    if found is None:
        return []
    low, high = float(found.value[0]), float(found.value[-1])
    reach = max(0.1, 0.4 * (high - low))
    shares = {one.limit: one.share for one in target.corrected.shares}
    if target.total is not None:
        told_of = zip(target.corrected.shares, target.total.shares, strict=True)
        known = ((one.limit, total) for one, total in told_of if total.U95_low is not None)
        shares |= {limit: total.value for limit, total in known if total.value is not None}
    named = ((one.height_m, _short(in_language(one, spoken_language()).name)) for one in standards)
    return marks.limits_of(named, (low - reach, high + reach), unit, shares)


def _with_share(limit: Limit) -> Limit:
    """Its words with the share of vehicles below it."""
    return (
        limit
        if limit.share is None
        else replace(
            limit,
            word=sentence_of_key("report-fig-share-below", standard=limit.word, share=percent(limit.share)),
        )
    )


def _short(word: str) -> str:
    return word if len(word) <= _LONGEST_WORD else word[: _LONGEST_WORD - 1] + "…"


def _cumulative(
    name: StatisticsTarget, target: Target, limits: Sequence[Limit], standards: int, unit: LengthUnit
) -> Drawing | str:
    """`standards`: how many there are; those that the figure does not reach are counted below it."""
    scale, word = HEIGHT[unit], TARGETS[name]
    ecdf, total = target.corrected.ecdf, target.total
    title = sentence_of_key("report-fig-cumulative", target=word)
    if ecdf is None:
        return sentence_of_key("report-fig-no-height", target=word)

    def draw(axes: Axes) -> None:
        named = marks.steps(
            axes, ecdf, MAIN, scale.factor, sentence_of_key("report-fig-corrected", n=write_count(ecdf.n))
        )
        if total is not None:
            _whiskers(axes, total, scale)
        axes.set(
            xlabel=sentence_of_key("report-fig-height-above", target=word, unit=scale.sign),
            ylabel=sentence_of_key("report-fig-share"),
            ylim=(0, 100.8),
        )
        axes.margins(x=0.02)
        marks.limits(axes, [_with_share(one) for one in limits])
        if not labels.label(axes, [replace(named, at=0.62)]):
            axes.legend(loc="lower right")

    caption = f"{sentence_of_key('report-fig-cumulative-caption')} {marks.band_words([ecdf.n])}"
    away = standards - sum(one.count for one in limits)
    if away:
        caption += " " + sentence_of_key("statistics-target-ecdf-away", count=away)
    return Drawing(svg(draw, title, marks.add_header_row(FULL, limits)), title, caption)


def _whiskers(axes: Axes, found: TotalFigures, scale: Scale) -> None:
    """The marked percentiles of true heights with their intervals, their values along the right edge."""
    chosen = [
        Percentile(one.percent, one.value, one.U95_low, one.U95_high, one.needs)
        for one in found.percentiles
        if one.percent in _MARKED and one.value is not None
    ]
    marks.whiskers(axes, chosen, scale.factor)
    edge = axes.secondary_yaxis("right")
    values = [f"P{format_fixed(one.percent, 0)}  {scale.number(one.value)} {scale.sign}" for one in chosen]
    edge.set_yticks([one.percent for one in chosen], labels=values)
    edge.tick_params(length=2.5, labelsize=NOTE_PT, labelcolor=INK)
    edge.spines["right"].set_visible(False)


def _density(
    name: StatisticsTarget, target: Target, limits: Sequence[Limit], unit: LengthUnit
) -> Drawing | str:
    density, scale, word = target.density, HEIGHT[unit], TARGETS[name]
    title = sentence_of_key("report-fig-density", target=word)
    if not isinstance(density, Density):
        return sentence_of_said(density)
    low, high = scale.factor * float(density.value[0]), scale.factor * float(density.value[-1])
    shown = [one for one in limits if low < one.at < high]

    def draw(axes: Axes) -> None:
        marks.density_curve(axes, density, MAIN, scale.factor)
        axes.set(
            xlabel=sentence_of_key("report-fig-height", target=word, unit=scale.sign),
            ylabel=sentence_of_key("report-fig-density-axis", unit=scale.sign),
        )
        axes.margins(x=0.01)
        highest = density.high if density.n >= marks.LEAST_FOR_A_BAND else density.density
        axes.set_ylim(0, 1.04 * float(highest.max()) / scale.factor)
        marks.limits(axes, shown)

    caption = sentence_of_key(
        "report-fig-density-caption", n=write_count(density.n), width=scale.length(density.bandwidth)
    )
    caption = f"{caption} {marks.band_words([density.n], pointwise=True)}"
    return Drawing(svg(draw, title, marks.add_header_row(HALF, shown)), title, caption)


def _side_by_side(
    name: StatisticsTarget, grouping: str, groups: Groups, limits: Sequence[Limit], unit: LengthUnit
) -> Drawing:
    """Groups as rows: median, middle 70 % and middle 90 %; no colours, and room for many groups."""
    scale, word = HEIGHT[unit], TARGETS[name]
    title = sentence_of_key("report-fig-by", target=word, grouping=GROUPINGS.get(grouping, grouping))
    rows = [(_short(heading(group_word(grouping, one))), found) for one, found in groups.of.items()]

    def draw(axes: Axes) -> None:
        marks.spread_rows(axes, rows, scale.factor)
        _room_on_the_left(axes)
        axes.set_xlabel(sentence_of_key("report-fig-height-above", target=word, unit=scale.sign))
        for one in limits:
            axes.axvline(one.at, color=MUTED, linewidth=0.7, dashes=(7, 1.5, 1, 1.5), zorder=0.5)

    sentences = [sentence_of_key("report-fig-by-caption")]
    sentences += (
        [sentence_of_key("report-fig-by-rules", rules=join_with_semicolons([one.word for one in limits]))]
        if limits
        else []
    )
    sentences += (
        [sentence_of_key("report-fig-by-left-out", n=write_count(groups.left_out))] if groups.left_out else []
    )
    caption = " ".join(sentences)
    sheet = Sheet(FULL.width, 12.0 + marks.ROW_MM * len(rows), left=40.0, right=3.0)
    return Drawing(svg(draw, title, sheet), title, caption)


def _room_on_the_left(axes: Axes) -> None:
    """Moves the left edge of the axes to where the longest word beside them ends."""
    sheet = axes.figure.bbox
    widest = max(word.get_window_extent().width for word in axes.get_yticklabels()) / sheet.width
    place = axes.get_position()
    left = widest + 0.03
    axes.set_position((left, place.y0, place.x1 - left, place.height))
