"""Values of the report about results: at a glance, errors against reference heights, distributions."""

from __future__ import annotations

from collections.abc import Sequence

from sightline.enums import LengthUnit, StatisticsTarget
from sightline.export.report import words
from sightline.export.report.facts import ReportFacts
from sightline.export.report.pictures import Pictures
from sightline.export.report.said import said, told
from sightline.export.report.settable import Json, Values
from sightline.export.report.sight import consequence
from sightline.export.report.units import (
    HEIGHT,
    OTHER,
    SMALL,
    SQUARE,
    Scale,
    decimal,
    fixed,
    limit,
    percent,
)
from sightline.results.survey_statistics import standards_of
from sightline.statistics.agreement import BlandAltman, ReferencePart
from sightline.statistics.distributions import Percentile, Share
from sightline.statistics.errors import ALL_FIGURES, GROUPS, ErrorGroup, Interval
from sightline.statistics.figures import Figure, TotalFigure, TotalPercentile
from sightline.statistics.known_errors import KnownErrors
from sightline.statistics.paper import PAPER
from sightline.statistics.rules import RuleToday
from sightline.statistics.standards import Standard
from sightline.statistics.summary import Distribution, Target
from sightline.statistics.total_uncertainty import TotalFigures

_GLANCE = (5.0, 15.0, 50.0, 85.0, 95.0)
_SURE = (10.0, 50.0)
_PLAIN = Scale(1.0, "", 2)
_WITHIN_MM = (10, 15, 20, 30, 40)
_KNOWN_FIGURES = ("bias_m", "mae_m", "rmse_m", "sd_m")
_ERROR_FIGURES = (
    "absolute-error-ecdf",
    "relative-error-ecdf",
    "signed-error-density",
    "error-against-height",
)
_GROUPINGS = ("category", "class_set", "site", "operator")


def glance(facts: ReportFacts) -> Values:
    """The few numbers that most readers came for."""
    result = facts.statistics
    eyes = result.targets.get("driver_eye")
    return {
        "correction": words.CORRECTIONS[facts.choices.correction],
        "percents": [fixed(at, 0) for at in _GLANCE],
        "targets": [
            _glance(name, target.corrected, HEIGHT[facts.unit])
            for name, target in result.targets.items()
            if target.corrected.n and name != "roof"
        ],
        "sure": [
            _sure(name, target.total, HEIGHT[facts.unit])
            for name, target in result.targets.items()
            if target.total is not None and name != "roof"
        ],
        "rules": [rule_values(one, HEIGHT[facts.unit], SMALL[facts.unit]) for one in result.rules if one.n],
        "errors": _errors_in_short(result.errors.groups["overall"], SMALL[facts.unit]),
        "consequence": consequence(facts),
        "standards": [] if eyes is None else _standards(facts, "driver_eye", eyes),
    }


def _glance(name: StatisticsTarget, heights: Distribution, scale: Scale) -> Values:
    values = {one.percent: one.value for one in heights.percentiles}
    return {
        "name": words.TARGETS[name],
        "n": heights.n,
        "mean": scale.number(heights.mean_m),
        "sd": scale.number(heights.sd_m),
        "percentiles": [scale.number(values.get(at)) for at in _GLANCE],
    }


def _sure(name: StatisticsTarget, total: TotalFigures, scale: Scale) -> Values:
    """How sure the 10th percentile and the median of a target are."""
    at = {one.percent: one for one in total.percentiles}
    return {
        "name": words.TARGETS[name],
        "holds": told(total.words),
        "percentiles": [
            {
                "percent": decimal(f"{percent:g}"),
                "value": scale.number(at[percent].value),
                "ci95": total_interval(at[percent], scale),
            }
            for percent in _SURE
        ],
    }


def rule_values(one: RuleToday, scale: Scale, small: Scale) -> Values:
    """The rule of a standard on the survey's heights, with its verdict."""
    standard = one.standard
    ends = [scale.number(end) for end in (one.U95_low_m, one.U95_high_m)]
    return {
        "name": told(standard.name),
        "of": told(standard.vehicle_class) if one.by_class else said("report-all-vehicles"),
        "percent": decimal(f"{standard.percent:g}"),
        "standard": scale.number(standard.height_m),
        "value": scale.number(one.value_m),
        "ci95": None if one.U95_low_m is None else {"low": ends[0], "high": ends[1]},
        "difference": small.number(one.difference_m, signed=True),
        "verdict": _verdict(one),
    }


def _verdict(one: RuleToday) -> str:
    if one.verdict == "unknown" or one.lower is None:
        return said("report-no-verdict", reason=told(one.reason or ""))
    if one.verdict == "alike":
        return said("report-alike", percent=percent(one.lower))
    key = "report-lower" if one.verdict == "lower" else "report-higher"
    return said(key, risk=_risk(one.risk))


def _risk(risk: float | None) -> str:
    """A risk in per cent; none is said to be smaller than draws can tell."""
    if risk is None or risk < 0.001:
        return said("report-less-than", percent=decimal("0.1 %"))
    return decimal(f"{100 * risk:.1f} %")


def _errors_in_short(overall: ErrorGroup, small: Scale) -> Values | None:
    mae, bias = overall.figures["mae_m"], overall.figures["bias_m"]
    if mae is None or bias is None:
        return None
    return {
        "n": overall.n,
        "mae": small.number(mae),
        "mae_ci95": _interval(overall.ci95["mae_m"], small),
        "bias": small.number(bias, signed=True),
        "bias_ci95": _interval(overall.ci95["bias_m"], small),
    }


def _interval(found: Interval | None, scale: Scale) -> Values | None:
    return None if found is None else {"low": scale.number(found.low), "high": scale.number(found.high)}


def known_errors(facts: ReportFacts) -> list[Values]:
    """The errors of each target with known heights, of the traffic and of check targets."""
    small = SMALL[facts.unit]
    return [
        {
            "name": _known_target(one),
            "n": one.groups["overall"].n,
            "figures": [
                _with_interval(value, one.groups["overall"].ci95[key], small)
                if (value := one.groups["overall"].figures[key]) is not None
                else None
                for key in _KNOWN_FIGURES
            ],
            "bias": total_interval(one.bias, small),
            "inside": told(one.inside)
            if isinstance(one.inside, str)
            else said("report-of-all", part=one.inside.inside, all=one.inside.n),
        }
        for one in facts.statistics.known_errors
    ]


def _known_target(one: KnownErrors) -> str:
    word = words.TARGETS[one.target]
    return said("report-check-targets", target=word) if one.check_target else word


def errors(facts: ReportFacts, pictures: Pictures) -> Values | None:
    """The error table and its figures; None where no vehicle has a reference height."""
    found, unit = facts.statistics.errors, facts.unit
    if found.groups["overall"].n == 0:
        return None
    return {
        "inset": facts.choices.correction == "inset",
        "whole_cm": found.rounding == "cm",
        "groups": [_error_group(name, found.groups[name], unit) for name in GROUPS],
        "within": [[mm, fixed(mm / 10, 1 if mm % 10 else 0)] for mm in _WITHIN_MM],
        "reasons": sorted({told(one.reason) for one in found.groups.values() if one.reason and one.n}),
        "reference_part": _reference_part(found.reference_part, unit),
        "limits": _limits(found.bland_altman, unit),
        "figures": pictures.figures(_ERROR_FIGURES),
        "paper": _paper(unit),
        "holds": told(found.groups["overall"].words),
    }


def _error_group(name: str, group: ErrorGroup, unit: LengthUnit) -> Values:
    figures: Values = {key: _error_figure(group, key, unit) for key in ALL_FIGURES}
    return {"name": words.GROUPS[name], "n": group.n, "figures": figures}


def _error_figure(group: ErrorGroup, key: str, unit: LengthUnit) -> Values | None:
    """One figure with its interval in the reader's unit and, of a length, in the other."""
    value, interval = group.figures[key], group.ci95[key]
    if value is None:
        return None
    if not key.endswith(("_m", "_m2")):
        return {"mine": _with_interval(value, interval, _PLAIN), "other": None}
    scales = SQUARE if key == "mse_m2" else SMALL
    mine, other = scales[unit], scales[OTHER[unit]]
    return {"mine": _with_interval(value, interval, mine), "other": _with_interval(value, interval, other)}


def _with_interval(value: float, interval: Interval | None, scale: Scale) -> Values:
    return {"value": scale.number(value), "ci95": _interval(interval, scale)}


def _reference_part(part: ReferencePart | str, unit: LengthUnit) -> Json:
    if isinstance(part, str):
        return told(part)
    return {
        "words": told(part.words),
        "correlation": fixed(part.correlation_alone, 2),
        "u_reference": SMALL[unit].number(part.u_reference_m),
    }


def _limits(found: BlandAltman | str, unit: LengthUnit) -> Json:
    if isinstance(found, str):
        return told(found)
    small = SMALL[unit]
    return {
        "lower": small.number(found.lower_m),
        "lower_ci95": _interval(found.lower_ci95, small),
        "upper": small.number(found.upper_m),
        "upper_ci95": _interval(found.upper_ci95, small),
    }


def _paper(unit: LengthUnit) -> list[Json]:
    small, square = SMALL[unit], SQUARE[unit]
    return [
        {
            "group": words.GROUPS[column.group],
            "n": column.n,
            "mae": small.number(column.mae_m),
            "rmse": small.number(column.rmse_m),
            "mse": square.number(column.mse_m2),
            "sd": small.number(column.sd_m),
            "note": told(column.note),
        }
        for column in PAPER
    ]


def heights(facts: ReportFacts, pictures: Pictures) -> Values:
    """Each target's distribution, percentiles, and who sits below the standards."""
    targets = facts.statistics.targets
    there = [name for name, target in targets.items() if target.raw.n or target.corrected.n]
    return {
        "targets": [_target(facts, name, targets[name], pictures) for name in there],
        "absent": [words.TARGETS[name] for name in targets if name not in there],
    }


def _target(facts: ReportFacts, name: StatisticsTarget, target: Target, pictures: Pictures) -> Values:
    mine, other = HEIGHT[facts.unit], HEIGHT[OTHER[facts.unit]]
    raw = {one.percent: one for one in target.raw.percentiles}
    corrected = {one.percent: one for one in target.corrected.percentiles}
    total = {} if target.total is None else {one.percent: one for one in target.total.percentiles}
    done = target.correction
    (ecdf,) = pictures.figures([f"{name}-ecdf"])
    return {
        "name": words.TARGETS[name],
        "many": words.MANY[name],
        "correction": told(done)
        if isinstance(done, str)
        else {"words": told(done.words), "warning": told(done.warning or "") or None},
        "ecdf": ecdf,
        "n_corrected": target.corrected.n,
        "n_raw": target.raw.n,
        "percentiles": [
            _percentile(at, total.get(at), corrected.get(at), raw.get(at), mine, other)
            for at in raw | corrected
        ],
        "holds": None if target.total is None else told(target.total.words),
        "without_interval": without_interval(list((raw | corrected).values())),
        "standards": _standards(facts, name, target),
        "groupings": [] if name == "roof" else pictures.figures(f"{name}-by-{word}" for word in _GROUPINGS),
    }


def _percentile(
    at: float,
    total: TotalPercentile | None,
    corrected: Percentile | None,
    raw: Percentile | None,
    mine: Scale,
    other: Scale,
) -> Values:
    return {
        "percent": decimal(f"{at:g}"),
        "total": None if total is None else mine.number(total.value),
        "total_ci95": total_interval(total, mine),
        "total_other": None if total is None else other.number(total.value),
        "corrected": None if corrected is None else mine.number(corrected.value),
        "corrected_ci95": percentile_interval(corrected, mine),
        "raw": None if raw is None else mine.number(raw.value),
    }


def percentile_interval(found: Percentile | None, scale: Scale) -> Values | None:
    """The interval of a percentile, where it has one."""
    if found is None or found.low is None or found.high is None:
        return None
    return {"low": scale.number(found.low), "high": scale.number(found.high)}


def total_interval(found: Figure | None, scale: Scale) -> Values | None:
    """The total interval of a figure, where it has one."""
    if found is None or found.U95_low is None or found.U95_high is None:
        return None
    return {"low": scale.number(found.U95_low), "high": scale.number(found.U95_high)}


def without_interval(found: Sequence[Percentile]) -> list[Json]:
    """Why some percentiles have no interval, each reason once with its percents."""
    alike: dict[str, list[str]] = {}
    for one in found:
        if one.reason:
            alike.setdefault(one.reason, []).append(decimal(f"{one.percent:g}"))
    return [
        {"reason": told(reason), "percents": list(dict.fromkeys(percents))}
        for reason, percents in alike.items()
    ]


def _standards(facts: ReportFacts, name: StatisticsTarget, target: Target) -> list[Json]:
    """The standards that speak of a target, with the share below each."""
    if not target.corrected.shares:
        return []
    standards = standards_of(facts.statistics.standards, name)
    totals = [None] * len(standards) if target.total is None else target.total.shares
    each = zip(standards, target.corrected.shares, totals, strict=True)
    return [_standard(standard, share, total, facts.unit) for standard, share, total in each]


def _source(standard: Standard) -> str:
    """Where a value comes from, by what rule, and who cites it."""
    edition = standard.edition or (str(standard.year) if standard.year else "")
    rule = told(standard.vehicle_class)
    if standard.percent is not None:
        percentile = decimal(f"{standard.percent:g}")
        rule = said("report-percentile-of", percent=percentile, of=rule) if rule else f"P{percentile}"
    cited = said("report-cited-by", who=told(standard.cited_by)) if standard.cited_by else ""
    source, edition = told(standard.source), told(edition)
    return "; ".join(
        one
        for one in (
            f"{source}{f', {edition}' if edition and edition not in source else ''}",
            rule,
            cited,
        )
        if one
    )


def _standard(standard: Standard, share: Share, total: TotalFigure | None, unit: LengthUnit) -> Values:
    """A share of the true heights with its total interval; of the corrected ones where that has none."""
    value, low, high = share.share, share.low, share.high
    if total is not None and total.U95_low is not None and total.U95_high is not None:
        value, low, high = total.value, total.U95_low, total.U95_high
    return {
        "name": told(standard.name),
        "height": limit(standard.height_m, unit),
        "below": share.below,
        "n": share.n,
        "share": percent(value),
        "ci95": {"low": fixed(100 * low, 1), "high": fixed(100 * high, 1)},
        "source": _source(standard),
    }
