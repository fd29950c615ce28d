"""Figures of heights: each target's distribution, its density, and its groups."""

from collections.abc import Sequence
from dataclasses import replace

from matplotlib.axes import Axes

from sightline.enums import LengthUnit, StatisticsTarget
from sightline.export.report import labels, marks
from sightline.export.report.canvas import FULL, HALF, INK, MUTED, NOTE_PT, Drawing, Sheet, svg
from sightline.export.report.marks import MAIN, Limit
from sightline.export.report.said import said, spoken, told
from sightline.export.report.units import HEIGHT, Scale, count, fixed, percent
from sightline.export.report.words import GROUPINGS, TARGETS, apart, group_word, heading
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
    found: dict[str, Drawing | str] = {
        f"{name}-ecdf": _cumulative(name, target, limits, len(standards), unit),
        f"{name}-density": _density(name, target, limits, unit),
    }
    for grouping, groups in target.groups.items():
        if len(groups.of) > 1:
            found[f"{name}-by-{grouping}"] = _side_by_side(name, grouping, groups, limits, unit)
    return found


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
    named = ((one.height_m, _short(in_language(one, spoken()).name)) for one in standards)
    return marks.limits_of(named, (low - reach, high + reach), unit, shares)


def _with_share(one: Limit) -> Limit:
    """Its words with the share of vehicles below it."""
    return (
        one
        if one.share is None
        else replace(one, word=said("report-fig-share-below", standard=one.word, share=percent(one.share)))
    )


def _short(word: str) -> str:
    return word if len(word) <= _LONGEST_WORD else word[: _LONGEST_WORD - 1] + "…"


def _cumulative(
    name: StatisticsTarget, target: Target, limits: Sequence[Limit], standards: int, unit: LengthUnit
) -> Drawing | str:
    """`standards`: how many there are; those that the figure does not reach are counted below it."""
    scale, word = HEIGHT[unit], TARGETS[name]
    found, total = target.corrected.ecdf, target.total
    title = said("report-fig-cumulative", target=word)
    if found is None:
        return said("report-fig-no-height", target=word)

    def draw(axes: Axes) -> None:
        named = marks.steps(axes, found, MAIN, scale.factor, said("report-fig-corrected", n=count(found.n)))
        if total is not None:
            _whiskers(axes, total, scale)
        axes.set(
            xlabel=said("report-fig-height-above", target=word, unit=scale.sign),
            ylabel=said("report-fig-share"),
            ylim=(0, 100.8),
        )
        axes.margins(x=0.02)
        marks.limits(axes, [_with_share(one) for one in limits])
        if not labels.label(axes, [replace(named, at=0.62)]):
            axes.legend(loc="lower right")

    caption = f"{said('report-fig-cumulative-caption')} {marks.band_words([found.n])}"
    away = standards - sum(one.count for one in limits)
    if away:
        caption += " " + said("statistics-target-ecdf-away", count=away)
    return Drawing(svg(draw, title, marks.headed(FULL, limits)), title, caption)


def _whiskers(axes: Axes, found: TotalFigures, scale: Scale) -> None:
    """The marked percentiles of true heights with their intervals, their values along the right edge."""
    chosen = [
        Percentile(one.percent, one.value, one.U95_low, one.U95_high, one.needs)
        for one in found.percentiles
        if one.percent in _MARKED and one.value is not None
    ]
    marks.whiskers(axes, chosen, scale.factor)
    edge = axes.secondary_yaxis("right")
    edge.set_yticks([one.percent for one in chosen], labels=[_valued(one, scale) for one in chosen])
    edge.tick_params(length=2.5, labelsize=NOTE_PT, labelcolor=INK)
    edge.spines["right"].set_visible(False)


def _valued(one: Percentile, scale: Scale) -> str:
    return f"P{fixed(one.percent, 0)}  {scale.number(one.value)} {scale.sign}"


def _density(
    name: StatisticsTarget, target: Target, limits: Sequence[Limit], unit: LengthUnit
) -> Drawing | str:
    found, scale, word = target.density, HEIGHT[unit], TARGETS[name]
    title = said("report-fig-density", target=word)
    if not isinstance(found, Density):
        return told(found)
    low, high = scale.factor * float(found.value[0]), scale.factor * float(found.value[-1])
    shown = [one for one in limits if low < one.at < high]

    def draw(axes: Axes) -> None:
        marks.density_curve(axes, found, MAIN, scale.factor)
        axes.set(
            xlabel=said("report-fig-height", target=word, unit=scale.sign),
            ylabel=said("report-fig-density-axis", unit=scale.sign),
        )
        axes.margins(x=0.01)
        highest = found.high if found.n >= marks.LEAST_FOR_A_BAND else found.density
        axes.set_ylim(0, 1.04 * float(highest.max()) / scale.factor)
        marks.limits(axes, shown)

    caption = said("report-fig-density-caption", n=count(found.n), width=scale.length(found.bandwidth))
    caption = f"{caption} {marks.band_words([found.n], pointwise=True)}"
    return Drawing(svg(draw, title, marks.headed(HALF, shown)), title, caption)


def _side_by_side(
    name: StatisticsTarget, grouping: str, groups: Groups, limits: Sequence[Limit], unit: LengthUnit
) -> Drawing:
    """Groups as rows: median, middle 70 % and middle 90 %; no colours, and room for many groups."""
    scale, word = HEIGHT[unit], TARGETS[name]
    title = said("report-fig-by", target=word, grouping=GROUPINGS.get(grouping, grouping))
    rows = [(_short(heading(group_word(grouping, one))), found) for one, found in groups.of.items()]

    def draw(axes: Axes) -> None:
        marks.spread_rows(axes, rows, scale.factor)
        _room_on_the_left(axes)
        axes.set_xlabel(said("report-fig-height-above", target=word, unit=scale.sign))
        for one in limits:
            axes.axvline(one.at, color=MUTED, linewidth=0.7, dashes=(7, 1.5, 1, 1.5), zorder=0.5)

    sentences = [said("report-fig-by-caption")]
    sentences += [said("report-fig-by-rules", rules=apart([one.word for one in limits]))] if limits else []
    sentences += [said("report-fig-by-left-out", n=count(groups.left_out))] if groups.left_out else []
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
