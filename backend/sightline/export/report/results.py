"""The report's second half: results, errors, heights, what was left out, how to check it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sightline.export.report import words
from sightline.export.report.blocks import Cell, Column, Document
from sightline.export.report.canvas import Drawing
from sightline.export.report.facts import ReportFacts
from sightline.export.report.units import (
    HEIGHT,
    NONE,
    SMALL,
    SQUARE,
    Scale,
    Unit,
    count,
    fixed,
    limit,
    percent,
    plural,
)
from sightline.results.survey_statistics import standards_of
from sightline.statistics.agreement import BlandAltman, ReferencePart
from sightline.statistics.distributions import Percentile, Share
from sightline.statistics.errors import GROUPS, ErrorGroup, Interval
from sightline.statistics.paper import PAPER
from sightline.statistics.standards import Standard
from sightline.statistics.summary import Distribution, Target

Drawn = Mapping[str, Drawing | str]
_OTHER: dict[Unit, Unit] = {"m": "ft", "ft": "m"}
_GLANCE = (5.0, 15.0, 50.0, 85.0, 95.0)
_PLAIN = Scale(1.0, "", 2)
_ROWS: tuple[tuple[str, str], ...] = (
    ("bias_m", "Bias (mean error)"),
    ("mae_m", "MAE"),
    ("rmse_m", "RMSE"),
    ("mse_m2", "MSE"),
    ("sd_m", "SD of the error"),
    ("pearson_error_vs_height", "r(error, height)"),
    ("pearson_abs_error_vs_height", "r(|error|, height)"),
)
_GROUPINGS = ("category", "site", "operator")
_SIGNS = {"mm": "millimetres", "in": "inches", "cm²": "square centimetres", "in²": "square inches"}


def glance(document: Document, facts: ReportFacts) -> None:
    """The few numbers that most readers came for."""
    result, height = facts.statistics, HEIGHT[facts.unit]
    document.section("Results at a glance")
    there = {
        name: one.corrected for name, one in result.targets.items() if one.corrected.n and name != "roof"
    }
    if there:
        document.table(
            f"Heights above the road, {words.CORRECTIONS[facts.choices.correction]}, in "
            f"{_unit_words(height)}.",
            [
                Column("Target", 1.0),
                Column("Vehicles", align="right"),
                Column("Mean", align="right"),
                Column("SD", align="right"),
                *(Column(f"P{fixed(p, 0)}" if p != 50 else "Median", align="right") for p in _GLANCE),
            ],
            [_glance(name, one, height) for name, one in there.items()],
        )
    else:
        document.words("No height of an eye, a taillight or a headlight counts yet.")
    overall = result.errors.groups["overall"]
    document.words(_errors_in_short(overall, SMALL[facts.unit]))
    _below_standards(document, facts)


def _below_standards(document: Document, facts: ReportFacts) -> None:
    """Which share of drivers sits below each standard's eye height."""
    eyes = facts.statistics.targets.get("driver_eye")
    if eyes is None or not eyes.corrected.shares:
        return
    standards = standards_of(facts.statistics.standards, "driver_eye")
    document.words("Drivers’ eyes below the heights that standards are set by:", sticky=True)
    document.listed(
        f"{one.name}, {limit(one.height_m, facts.unit)}: {percent(share.share)} "
        f"(95 %: {fixed(100 * share.low, 1)} to {fixed(100 * share.high, 1)}\u00a0%)"
        for one, share in zip(standards, eyes.corrected.shares, strict=True)
    )


def _glance(name: str, one: Distribution, height: Scale) -> list[str]:
    at = {found.percent: found.value for found in one.percentiles}
    figures = [one.mean_m, one.sd_m, *(at.get(p) for p in _GLANCE)]
    return [words.heading(words.TARGETS[name]), count(one.n), *(height.number(value) for value in figures)]


def _errors_in_short(overall: ErrorGroup, small: Scale) -> str:
    mae, bias = overall.figures["mae_m"], overall.figures["bias_m"]
    if mae is None or bias is None:
        return "No vehicle has a reference height, so the error of the heights is not tested here."
    return (
        f"Against the reference heights of {plural(overall.n, 'vehicle', 'vehicles')}, roofs are measured "
        f"with a "
        f"mean absolute error of {small.length(mae)}{_bracket(overall.ci95['mae_m'], small)} and a bias of "
        f"{small.number(bias, signed=True)}\u00a0{small.sign}{_bracket(overall.ci95['bias_m'], small)}."
    )


def _bracket(interval: Interval | None, scale: Scale) -> str:
    return "" if interval is None else f" (95 %: {_range(interval, scale)})"


def _range(interval: Interval, scale: Scale) -> str:
    return f"{scale.number(interval.low)} to {scale.number(interval.high)}"


def _unit_words(scale: Scale) -> str:
    return {"m": "metres", "ft": "feet"}.get(scale.sign, scale.sign)


def errors(document: Document, facts: ReportFacts, drawn: Drawn) -> None:
    """The error table and its figures."""
    found = facts.statistics.errors
    document.section("Error against reference heights")
    if found.groups["overall"].n == 0:
        document.words(
            "No roof of a vehicle with a reference height counts here, so there is no error to be stated. "
            "Enter "
            "manufacturers’ heights in the vehicle records to have one."
        )
        return
    rounded = (
        "both rounded to whole centimetres, as the paper does"
        if found.rounding == "cm"
        else "without rounding"
    )
    heights = "corrected by their inset" if facts.choices.correction == "inset" else "with inset 0"
    document.words(
        f"Error = measured minus reference, of roofs {heights}, {rounded}. Every figure comes "
        f"from the "
        "single errors, never from other figures. Intervals at 95 %: BCa bootstrap of 4999 resamples up "
        "to 1000 "
        "vehicles, normal with the infinitesimal jackknife’s variances beyond."
    )
    _error_table(document, facts)
    for name in GROUPS[:2]:
        if found.groups[name].n == 0:
            document.words(f"No {words.GROUPS[name]} vehicle with a reference height counts here.")
    document.words(
        _reference_words(found.reference_part, facts.unit), _limits_words(found.bland_altman, facts.unit)
    )
    names = ("absolute-error-ecdf", "relative-error-ecdf", "signed-error-density", "error-against-height")
    document.figures([(name, drawn[name]) for name in names if name in drawn], across=2)
    _paper_table(document, facts.unit)


def _error_table(document: Document, facts: ReportFacts) -> None:
    groups = facts.statistics.errors.groups
    rows: list[list[Cell]] = [["n", *(count(groups[name].n) for name in GROUPS)]]
    for key, word in _ROWS:
        mine, other = _scale(key, facts.unit), _scale(key, _OTHER[facts.unit])
        sign = f" ({mine.sign})" if mine.sign else ""
        below = _SIGNS[other.sign] if mine.sign else ""
        head: Cell = (f"{word}{sign}", below) if below else word
        rows.append([head, *(_figure(groups[name], key, mine, other) for name in GROUPS)])
    document.table(
        "The error with its 95 % intervals.",
        [Column("", 1.1), *(Column(words.heading(words.GROUPS[name]), 1.2, "right") for name in GROUPS)],
        rows,
    )
    reasons = {one.reason for one in groups.values() if one.reason and one.n}
    document.note(*(f"{words.heading(one)}." for one in sorted(reasons)))


def _scale(key: str, unit: Unit) -> Scale:
    if key == "mse_m2":
        return SQUARE[unit]
    return _PLAIN if key.startswith("pearson") else SMALL[unit]


def _figure(group: ErrorGroup, key: str, mine: Scale, other: Scale) -> Cell:
    value, interval = group.figures[key], group.ci95[key]
    if value is None:
        return NONE
    own = _with_interval(value, interval, mine)
    return (own, _with_interval(value, interval, other)) if mine.sign else own


def _with_interval(value: float, interval: Interval | None, scale: Scale) -> str:
    return scale.number(value) + ("" if interval is None else f" ({_range(interval, scale)})")


def _reference_words(part: ReferencePart | str, unit: Unit) -> str:
    if isinstance(part, str):
        return part
    return (
        f"{part.words} By itself it makes a correlation of {fixed(part.correlation_alone, 2)} between "
        f"error and "
        f"height, for which no camera is to blame (u of the reference "
        f"{SMALL[unit].length(part.u_reference_m)})."
    )


def _limits_words(found: BlandAltman | str, unit: Unit) -> str:
    if isinstance(found, str):
        return found
    small = SMALL[unit]
    return (
        f"Limits of agreement (Bland and Altman): {small.length(found.lower_m)} "
        f"({_range(found.lower_ci95, small)}) and {small.length(found.upper_m)} "
        f"({_range(found.upper_ci95, small)})."
    )


def _paper_table(document: Document, unit: Unit) -> None:
    small, square = SMALL[unit], SQUARE[unit]
    titles = ("MAE", "RMSE", "MSE", "SD")
    signs = (small.sign, small.sign, square.sign, small.sign)
    document.table(
        "For comparison, Table 1 of the paper as printed.",
        [
            Column("Its column"),
            Column("n", align="right"),
            *(Column(one, 0.0, "right", sign) for one, sign in zip(titles, signs, strict=True)),
            Column("What is inconsistent in it", 1.0),
        ],
        [
            [
                words.heading(words.GROUPS[one.group]),
                str(one.n),
                small.number(one.mae_m),
                small.number(one.rmse_m),
                square.number(one.mse_m2),
                small.number(one.sd_m),
                one.note.replace("+-", "±"),
            ]
            for one in PAPER
        ],
    )


def heights(document: Document, facts: ReportFacts, drawn: Drawn) -> None:
    """Each target's distribution, percentiles, and who sits below the standards."""
    document.section("Distributions of heights")
    result = facts.statistics
    there = {name: one for name, one in result.targets.items() if one.raw.n or one.corrected.n}
    if not there:
        document.words("No height counts here yet; accepted measurements will stand here.")
        return
    document.words(
        "Percentiles are estimated without bias of the median (type 8 of Hyndman and Fan); their "
        "intervals lie "
        "between order statistics and assume no shape. Bands of cumulative distributions hold everywhere "
        "at once "
        "(Dvoretzky, Kiefer, Wolfowitz, Massart); intervals of shares are Clopper’s and Pearson’s."
    )
    for name, one in there.items():
        _target(document, facts, name, one, drawn)
    absent = [words.TARGETS[name] for name in result.targets if name not in there]
    if absent:
        document.words(f"Not measured, or nothing of it counts here: {', '.join(absent)}.")


def _target(document: Document, facts: ReportFacts, name: str, one: Target, drawn: Drawn) -> None:
    document.subsection(words.heading(words.TARGETS[name]))
    if isinstance(one.correction, str):
        document.words(f"Not corrected: {one.correction}")
    else:
        document.words(one.correction.words, sticky=True)
        if one.correction.warning:
            document.warning(one.correction.warning)
    document.figures([(f"{name}-ecdf", drawn[f"{name}-ecdf"])])
    _percentile_table(document, facts, name, one)
    _share_table(document, facts, name, one)
    if name != "roof":
        document.figures([(key, drawn[key]) for word in _GROUPINGS if (key := f"{name}-by-{word}") in drawn])


def _percentile_table(document: Document, facts: ReportFacts, name: str, one: Target) -> None:
    mine, other = HEIGHT[facts.unit], HEIGHT[_OTHER[facts.unit]]
    raw = {found.percent: found for found in one.raw.percentiles}
    corrected = {found.percent: found for found in one.corrected.percentiles}
    counts = f"{count(one.corrected.n)} corrected, {count(one.raw.n)} raw"
    document.table(
        f"Percentiles of the heights of the {words.TARGETS[name]}, with 95 % intervals; vehicles: {counts}.",
        [
            Column("Percentile", align="right"),
            Column("Corrected", 0.0, "right", mine.sign),
            Column("95 % interval", 0.0, "right", mine.sign),
            Column("Corrected", 0.0, "right", other.sign),
            Column("Raw, inset 0", 0.0, "right", mine.sign),
            Column("95 % interval", 0.0, "right", mine.sign),
        ],
        [
            [
                f"{p:g}\u00a0%",
                mine.number(_value(corrected.get(p))),
                _percentile_range(corrected.get(p), mine),
                other.number(_value(corrected.get(p))),
                mine.number(_value(raw.get(p))),
                _percentile_range(raw.get(p), mine),
            ]
            for p in raw | corrected
        ],
    )
    document.note(_without_interval(list((raw | corrected).values())))


def _without_interval(found: Sequence[Percentile]) -> str:
    """Why some percentiles have no interval, each reason once."""
    alike: dict[str, list[str]] = {}
    for one in found:
        if one.reason:
            alike.setdefault(one.reason, []).append(f"{one.percent:g}\u00a0%")
    return " ".join(f"{', '.join(which)}: {reason}." for reason, which in alike.items())


def _value(found: Percentile | None) -> float | None:
    return None if found is None else found.value


def _percentile_range(found: Percentile | None, scale: Scale) -> str:
    if found is None or found.low is None or found.high is None:
        return NONE
    return f"{scale.number(found.low)} to {scale.number(found.high)}"


def _share_table(document: Document, facts: ReportFacts, name: str, one: Target) -> None:
    standards = standards_of(facts.statistics.standards, name)  # type: ignore[arg-type]
    if not standards or not one.corrected.shares:
        return
    who = words.MANY[name]
    document.table(
        f"Standards, and the share of {who} below them (corrected heights), with 95 % intervals.",
        [
            Column("Standard", 1.0),
            Column("Height", align="right"),
            Column("Below", align="right"),
            Column("Share", align="right"),
            Column("95 % interval", align="right"),
            Column("Source", 1.6),
        ],
        [_share(*both, facts.unit) for both in zip(standards, one.corrected.shares, strict=True)],
    )


def _share(standard: Standard, found: Share, unit: Unit) -> Sequence[str]:
    return [
        standard.name,
        limit(standard.height_m, unit),
        f"{count(found.below)} of {count(found.n)}",
        percent(found.share),
        f"{fixed(100 * found.low, 1)} to {fixed(100 * found.high, 1)}\u00a0%",
        standard.source,
    ]
