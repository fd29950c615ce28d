"""The statistics of an export as tables: what each figure and each percentile of the report rests on."""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from itertools import chain
from typing import get_args

from sightline.enums import Category, Correction, Direction, Rounding, RuleVerdict, StatisticsTarget
from sightline.export import scans, traffic
from sightline.export.measured import AS_PAPER, PackageStatistics
from sightline.export.statistics_rows import (
    BAND,
    INTERVAL,
    INTERVAL_M,
    REASON,
    TOTAL_M,
    Cells,
    curve_rows,
    error_rows,
    said_of,
    statistics_table,
)
from sightline.infra.csv_package.columns import flag, integer, metres, number, text
from sightline.infra.csv_package.schema import Column, Row
from sightline.messages.said import Said
from sightline.results.survey_statistics import Statistics, standards_of
from sightline.statistics.figures import TotalFigure
from sightline.statistics.known_errors import KnownErrors
from sightline.statistics.summary import Distribution, Errors

_PAPER = "as_in_the_paper"
_INSET = "inset: heights corrected by each measurement's inset"
_HEIGHTS = text(
    "heights",
    f"{_INSET}; as_in_the_paper: with an inset of 0, both heights of an error to whole centimetres",
    required=True,
    enum=("inset", _PAPER),
)
_ROUNDING = text("rounding", "column-error-table-rounding", required=True, enum=get_args(Rounding))
_CORRECTION = text("correction", "column-corrections-correction", required=True)
_TARGET = text("target", "what was measured", required=True)
_N = integer("n", "number of measurements", required=True, minimum=0)
_GROUPING = text("grouping", "what divides the measurements; all: nothing", required=True)
_GROUP = text("group", "group", required=True)
_HOLDS = text("holds", "components of its interval, separated by spaces")
_BAND_PER_M = tuple(replace(one, unit="1/m") for one in BAND)

ERROR_TABLE = statistics_table(
    "error_table",
    "Errors (measured minus manufacturer's height) of accepted roofs by lighting and overall, pooled from "
    "the raw errors; figures named _m are in metres, _m2 in square metres, correlations have no unit. "
    "Intervals are total, but for correlations and skewness: the column holds says what each holds.",
    _HEIGHTS,
    _ROUNDING,
    _GROUP,
    text("figure", "name of the value", required=True),
    _N,
    number("value", "value"),
    *INTERVAL,
    _HOLDS,
    *REASON,
    primary=("heights", "rounding", "group", "figure"),
)
ERRORS_BY_TARGET = statistics_table(
    "errors_by_target",
    "Errors (measured minus known height) of accepted heights by target, of the traffic and of check "
    "targets, not rounded, of all and by lighting and class. Intervals are total: the column holds says what "
    "each holds. inside_u95: the share of differences that are not larger than their own U95; about 0.95 "
    "should be. It is stated of heights corrected by their inset alone, as their U95 is.",
    replace(_HEIGHTS, says=f"{_INSET}; as_in_the_paper: with an inset of 0"),
    _TARGET,
    flag("check_target", "true: of check targets, which count nowhere else", required=True),
    _GROUPING,
    _GROUP,
    text("figure", "name of the value", required=True),
    _N,
    number("value", "value"),
    *INTERVAL,
    _HOLDS,
    *REASON,
    primary=("heights", "target", "check_target", "grouping", "group", "figure"),
)
AGREEMENT = statistics_table(
    "agreement",
    "Bland and Altman's limits of agreement, the regression of signed and absolute error on the "
    "manufacturer's height, and the share of the errors' variance that the manufacturers' heights themselves "
    "explain. Intervals of the limits are total; those of the regression include sampling only.",
    _HEIGHTS,
    _ROUNDING,
    text("figure", "which figure; _m, and intercepts: metres", required=True),
    number("value", "value"),
    *INTERVAL,
    *REASON,
    primary=("heights", "rounding", "figure"),
)
ERROR_TREND = statistics_table(
    "error_trend",
    "The regression lines of agreement.csv with their 95 % bands, at heights over the range of the data.",
    _HEIGHTS,
    _ROUNDING,
    text("of", "signed or absolute error", required=True),
    metres("reference_m", "manufacturer's height"),
    metres("error_m", "error on the line"),
    metres("low_m", "lower edge of the line's 95 % band, which includes sampling only"),
    metres("high_m", "upper edge of the line's 95 % band, which includes sampling only"),
)
ERROR_ECDF = statistics_table(
    "error_ecdf",
    "Cumulative distributions of the absolute error (in metres) and of the relative error (absolute error "
    "over the manufacturer's height, no unit); at most 600 points of each.",
    _HEIGHTS,
    _ROUNDING,
    text("of", "absolute or relative error", required=True),
    _GROUP,
    number("value", "the error"),
    number("share", "share of the errors that are not larger"),
    *BAND,
)
ERROR_DENSITY = statistics_table(
    "error_density",
    "Densities of the signed error with their 95 % bands.",
    _HEIGHTS,
    _ROUNDING,
    _GROUP,
    metres("error_m", "signed error"),
    number("density", "density at that error", "1/m"),
    *_BAND_PER_M,
)
CORRECTION_TABLE = statistics_table(
    "corrections",
    "What each correction did to the heights of each target, in words, and the mean and spread that it left.",
    _TARGET,
    _CORRECTION,
    _N,
    metres("mean_m", "mean of the corrected heights"),
    metres("sd_m", "standard deviation of the corrected heights (n - 1)"),
    *said_of("words", "description of the correction"),
    *said_of("warning", "warning"),
    *REASON,
    primary=("target", "correction"),
)
PERCENTILE_TABLE = statistics_table(
    "percentiles",
    "Percentiles of the heights of each target with distribution-free 95 % intervals, under each correction, "
    "and under the headline's (inset) by group.",
    _TARGET,
    _CORRECTION,
    _GROUPING,
    _GROUP,
    _N,
    number("percent", "which percentile", "%"),
    metres("height_m", "the percentile"),
    *INTERVAL_M,
    *REASON,
    primary=("target", "correction", "grouping", "group", "percent"),
)
TOTAL_TABLE = statistics_table(
    "total_uncertainty",
    "Figures of the true heights of each target, each corrected by its inset, random error taken out of "
    "their spread; 95 % intervals hold what `holds` says.",
    _TARGET,
    text("figure", "name of the value", required=True, enum=("percentile", "mean", "sd", "share_below")),
    number("percent", "of a percentile: which", "%"),
    metres("limit_m", "of a share: below which height"),
    _N,
    number("value", "the figure: a height or SD in metres, a share from 0 to 1"),
    *INTERVAL,
    metres("raw_m", "of a percentile: the plain one of the measured heights"),
    text("holds", "components of the interval, separated by spaces", required=True),
    *REASON,
)
RULE_TABLE = statistics_table(
    "same_rule",
    "The rule of each standard that states one (a percentile of a class of vehicles) on the survey's, "
    "and the verdict: lower or higher where the probability that it is not so is at most 2.5 % (JCGM 106).",
    text("what", "what the standard's height is of", required=True),
    text("standard", "name of the standard", required=True),
    metres("standard_m", "the standard's height"),
    number("percent", "the percentile of its rule", "%"),
    text("class", "of which vehicles, as the standard says"),
    flag("by_class", "false: no class is known, all vehicles count", required=True),
    _N,
    metres("height_m", "the same percentile today, of true heights"),
    *TOTAL_M,
    metres("difference_m", "today's percentile minus the standard's height"),
    number("lower", "probability that today's percentile is below the standard's height"),
    text("verdict", "verdict", required=True, enum=get_args(RuleVerdict)),
    number("risk", "probability that the verdict is wrong"),
    *REASON,
)
HEIGHT_ECDF = statistics_table(
    "height_ecdf",
    "Cumulative distributions of the heights of each target with 95 % bands; at most 600 points of each.",
    _TARGET,
    _CORRECTION,
    _GROUPING,
    _GROUP,
    metres("height_m", "height"),
    number("share", "share of the heights that are not larger"),
    *BAND,
)
HEIGHT_DENSITY = statistics_table(
    "height_density",
    "Densities of the heights of each target with 95 % bands.",
    _TARGET,
    _CORRECTION,
    metres("height_m", "height"),
    number("density", "density at that height", "1/m"),
    *_BAND_PER_M,
)
SHARES = statistics_table(
    "shares",
    "Which share of the heights lies below the value of each standard, with its 95 % interval.",
    _TARGET,
    _CORRECTION,
    _GROUPING,
    _GROUP,
    text("standard", "name of the standard", required=True),
    metres("limit_m", "the standard's height"),
    text("source", "where the standard's value is from"),
    integer("below", "number of heights below it", required=True),
    _N,
    number("share", "share of the heights below: below divided by n"),
    *INTERVAL,
)
LATERAL_TABLE = statistics_table(
    "lateral_positions",
    "Where vehicles drive: the distance of the tyre's contact from the camera across the road, one of each "
    "vehicle (the median of its contacts), by lane (the way it goes in the picture) and class.",
    text("lane", "travel direction in the image; empty: all", enum=get_args(Direction)),
    text("class", "body of the vehicles; empty: all", enum=get_args(Category)),
    text("figure", "name of the value", required=True, enum=("percentile", "mean", "sd")),
    number("percent", "of a percentile: which", "%"),
    _N,
    metres("value_m", "value"),
    *INTERVAL_M,
    *REASON,
)
TABLES = (
    ERROR_TABLE,
    ERRORS_BY_TARGET,
    AGREEMENT,
    ERROR_TREND,
    ERROR_ECDF,
    ERROR_DENSITY,
    CORRECTION_TABLE,
    PERCENTILE_TABLE,
    TOTAL_TABLE,
    RULE_TABLE,
    HEIGHT_ECDF,
    HEIGHT_DENSITY,
    SHARES,
    LATERAL_TABLE,
    *scans.TABLES,
    *traffic.TABLES,
)


def statistics_rows(package: PackageStatistics) -> dict[str, Iterator[Cells]]:
    """The rows of every table by its path."""
    made = [
        ({"heights": heights, "rounding": one.errors.rounding}, one)
        for heights, one in (("inset", package.headline), (_PAPER, package.of[AS_PAPER]))
    ]
    errors = [(key, one.errors) for key, one in made]
    heights = [(correction, one) for (correction, rounding), one in package.of.items() if rounding == "none"]
    return {
        ERROR_TABLE.key: chain.from_iterable(error_rows(key, one.groups) for key, one in errors),
        ERRORS_BY_TARGET.key: chain.from_iterable(
            _known_rows({"heights": heights}, one.known_errors)
            for heights, one in (("inset", package.headline), (_PAPER, package.of["none", "none"]))
        ),
        AGREEMENT.key: chain.from_iterable(_agreement_rows(key, one) for key, one in errors),
        ERROR_TREND.key: chain.from_iterable(_trend_rows(key, one) for key, one in errors),
        ERROR_ECDF.key: chain.from_iterable(_error_ecdf_rows(key, one) for key, one in errors),
        ERROR_DENSITY.key: chain.from_iterable(_error_density_rows(key, one) for key, one in errors),
        CORRECTION_TABLE.key: chain.from_iterable(_correction_rows(*one) for one in heights),
        PERCENTILE_TABLE.key: chain.from_iterable(_percentile_rows(*one) for one in heights),
        TOTAL_TABLE.key: chain.from_iterable(_total_rows(one) for _, one in heights),
        RULE_TABLE.key: _rule_rows(package.headline),
        HEIGHT_ECDF.key: chain.from_iterable(_height_ecdf_rows(*one) for one in heights),
        HEIGHT_DENSITY.key: chain.from_iterable(_height_density_rows(*one) for one in heights),
        SHARES.key: chain.from_iterable(_share_rows(*one) for one in heights),
        LATERAL_TABLE.key: _lateral_rows(package.headline),
        **scans.scan_rows(package.scans, package.scan_heights),
        **traffic.traffic_rows(package.scan_traffic),
    }


def _known_rows(key: Row, found: Iterable[KnownErrors]) -> Iterator[Cells]:
    for known in found:
        of: Cells = {**key, "target": known.target, "check_target": known.check_target}
        for part in known.groups:
            yield from error_rows({**of, "grouping": part.grouping}, {part.group: part.errors})
        inside = known.inside
        row: Cells = {**of, "grouping": "all", "group": "all", "figure": "inside_u95"}
        if isinstance(inside, Said):
            yield {**row, "n": 0, "reason": inside}
        else:
            yield {**row, "n": inside.n, "value": inside.share, "low": inside.low, "high": inside.high}


def _agreement_rows(key: Row, errors: Errors) -> Iterator[Cells]:
    for name, part, figures in (
        ("bland_altman", errors.bland_altman, ("lower_m", "upper_m")),
        ("trend", errors.trend, ("slope", "intercept")),
        ("absolute_trend", errors.absolute_trend, ("slope", "intercept")),
        ("reference", errors.reference_part, _OF_REFERENCE),
    ):
        if isinstance(part, Said):
            yield {**key, "figure": name, "reason": part}
            continue
        for figure in figures:
            interval = getattr(part, f"{figure.removesuffix('_m')}_ci95", None)
            row = {**key, "figure": f"{name}_{figure}", "value": getattr(part, figure)}
            yield row if interval is None else {**row, **vars(interval)}


_OF_REFERENCE = ("u_reference_m", "share_of_variance", "rounding_share", "camera_sd_m", "correlation_alone")


_ECDF = {"share": "share", "low": "low", "high": "high"}
_DENSITY = {"density": "density", "low": "low", "high": "high"}


def _trend_rows(key: Row, errors: Errors) -> Iterator[Cells]:
    cells = {"reference_m": "at", "error_m": "value", "low_m": "low", "high_m": "high"}
    for of, part in (("signed", errors.trend), ("absolute", errors.absolute_trend)):
        yield from curve_rows({**key, "of": of}, part, **cells)


def _error_ecdf_rows(key: Row, errors: Errors) -> Iterator[Cells]:
    for of, groups in (("absolute", errors.absolute), ("relative", errors.relative)):
        for group, found in groups.items():
            yield from curve_rows({**key, "of": of, "group": group}, found, value="value", **_ECDF)


def _error_density_rows(key: Row, errors: Errors) -> Iterator[Cells]:
    for group, found in errors.density.items():
        yield from curve_rows({**key, "group": group}, found, error_m="value", **_DENSITY)


def _correction_rows(correction: Correction, found: Statistics) -> Iterator[Cells]:
    for target, result in found.targets.items():
        done = result.correction
        stated: Cells = {"reason": done} if isinstance(done, Said) else {"words": done.words}
        if not isinstance(done, Said):
            stated["warning"] = done.warning
        left = result.corrected
        row: Cells = {"target": target, "correction": correction, "n": left.n}
        yield {**row, "mean_m": left.mean_m, "sd_m": left.sd_m, **stated}


def _distributions(
    correction: Correction, found: Statistics
) -> Iterator[tuple[StatisticsTarget, Cells, Distribution]]:
    """Each target's heights under a correction, and under the headline's by group, with what names them."""
    for target, result in found.targets.items():
        key: Cells = {"target": target, "correction": correction}
        yield target, {**key, "grouping": "all", "group": "all"}, result.corrected
        if correction == "inset":
            for grouping, groups in result.groups.items():
                for word, part in groups.of.items():
                    yield target, {**key, "grouping": grouping, "group": word}, part


def _percentile_rows(correction: Correction, found: Statistics) -> Iterator[Cells]:
    for _, key, distribution in _distributions(correction, found):
        for each in distribution.percentiles:
            ends = {"height_m": each.value, "low_m": each.low, "high_m": each.high}
            yield {**key, "n": distribution.n, **vars(each), **ends}


def _total_rows(statistics: Statistics) -> Iterator[Cells]:
    for target, one in statistics.targets.items():
        total = one.total
        if total is None:
            continue
        key: Cells = {"target": target, "n": total.n, "holds": " ".join(total.holds)}
        for each in total.percentiles:
            of: Cells = {"figure": "percentile", "percent": each.percent, "raw_m": each.raw}
            yield {**key, **of, **_total_cells(each)}
        yield {**key, "figure": "mean", **_total_cells(total.mean)}
        yield {**key, "figure": "sd", **_total_cells(total.sd)}
        for standard, share in zip(standards_of(statistics.standards, target), total.shares, strict=True):
            yield {**key, "figure": "share_below", "limit_m": standard.height_m, **_total_cells(share)}


def _rule_rows(found: Statistics) -> Iterator[Cells]:
    for rule in found.rules:
        standard = rule.standard
        named: Cells = {"standard": standard.name, "standard_m": standard.height_m}
        named |= {"class": standard.vehicle_class, "by_class": rule.by_class}
        ends = {"height_m": rule.value_m, "low_m": rule.U95_low_m, "high_m": rule.U95_high_m}
        yield {"what": standard.what, "percent": standard.percent, **vars(rule), **named, **ends}


def _total_cells(one: TotalFigure) -> Cells:
    return {"value": one.value, "low": one.U95_low, "high": one.U95_high, "reason": one.reason}


def _height_ecdf_rows(correction: Correction, found: Statistics) -> Iterator[Cells]:
    for _, key, one in _distributions(correction, found):
        yield from curve_rows(key, one.ecdf, height_m="value", **_ECDF)


def _height_density_rows(correction: Correction, found: Statistics) -> Iterator[Cells]:
    for target, one in found.targets.items():
        key: Cells = {"target": target, "correction": correction}
        yield from curve_rows(key, one.density, height_m="value", **_DENSITY)


def _share_rows(correction: Correction, found: Statistics) -> Iterator[Cells]:
    for target, key, one in _distributions(correction, found):
        for standard, share in zip(standards_of(found.standards, target), one.shares, strict=False):
            row = {**key, "standard": standard.name, "limit_m": standard.height_m, "source": standard.source}
            yield {**row, **vars(share)}


def _lateral_rows(found: Statistics) -> Iterator[Cells]:
    if found.lateral is None:
        return
    lateral = found.lateral
    parts: list[tuple[str | None, str | None, Distribution]] = [(None, None, lateral.all)]
    parts += [(lane, None, one) for lane, one in lateral.lanes.of.items()]
    parts += [
        (lane, of, one) for lane, found_of in lateral.classes.items() for of, one in found_of.of.items()
    ]
    for lane, category, distribution in parts:
        key: Cells = {"lane": lane, "class": category, "n": distribution.n}
        yield {**key, "figure": "mean", "value_m": distribution.mean_m}
        yield {**key, "figure": "sd", "value_m": distribution.sd_m}
        for each in distribution.percentiles:
            ends = {"value_m": each.value, "low_m": each.low, "high_m": each.high}
            yield {**key, "figure": "percentile", **vars(each), **ends}


def same_cell(column: Column, stored: str, recomputed: str) -> bool:
    """Whether two cells say the same; numbers to a millionth: machines differ in the last bits."""
    if stored == recomputed:
        return True
    if column.type != "number" or not stored or not recomputed:
        return False
    a, b = float(stored), float(recomputed)
    return abs(a - b) <= 1.1e-6 * max(1.0, abs(a), abs(b))
