"""Values of the report about results: at a glance, errors against reference heights, distributions."""

from __future__ import annotations

from collections.abc import Sequence

from sightline.enums import LengthUnit, StatisticsTarget
from sightline.export.report import words
from sightline.export.report.conclusion import verdict_of
from sightline.export.report.facts import ReportFacts
from sightline.export.report.pictures import Pictures
from sightline.export.report.said import said, told
from sightline.export.report.settable import Json, Values
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
from sightline.messages.said import Said
from sightline.results.survey_statistics import RULE_OF, standards_of
from sightline.statistics.agreement import BlandAltman, ReferencePart
from sightline.statistics.distributions import Percentile, Share
from sightline.statistics.errors import ALL_FIGURES, GROUPS, LENGTHS, ErrorGroup, Interval
from sightline.statistics.figures import Figure, TotalFigure
from sightline.statistics.known_errors import KnownErrors, KnownGroup, shown_groups
from sightline.statistics.paper import PAPER
from sightline.statistics.rules import RuleToday
from sightline.statistics.standards import Standard
from sightline.statistics.summary import Target
from sightline.statistics.total_uncertainty import TotalFigures

_PLAIN = Scale(1.0, "", 2)
_WITHIN_MM = (10, 15, 20, 30, 40)
_ERROR_FIGURES = (
    "absolute-error-ecdf",
    "relative-error-ecdf",
    "signed-error-density",
    "error-against-height",
)
_GROUPINGS = ("category", "class_set", "site", "operator")


def rule_values(one: RuleToday, scale: Scale, small: Scale) -> Values:
    """The rule of a standard on the survey's heights, with its verdict."""
    standard = one.standard
    ends = [scale.number(end) for end in (one.U95_low_m, one.U95_high_m)]
    return {
        "name": told(standard.name),
        "rule": said(
            "statistics-rule-of",
            what=words.heading(words.TARGETS[RULE_OF[standard.what][0]]),
            percent=decimal(f"{standard.percent:g}"),
            **{"class": told(standard.vehicle_class) if one.by_class else said("report-all-vehicles")},
        ),
        "standard": scale.number(standard.height_m),
        "value": scale.number(one.value_m),
        "ci95": None if one.U95_low_m is None else {"low": ends[0], "high": ends[1]},
        "difference": small.number(one.difference_m, signed=True),
        "verdict": verdict_of(one),
    }


def _interval(found: Interval | None, scale: Scale) -> Values | None:
    return None if found is None else {"low": scale.number(found.low), "high": scale.number(found.high)}


def known_errors(facts: ReportFacts) -> list[Values]:
    """The errors of each target with known heights, of the traffic and of check targets."""
    small = SMALL[facts.unit]
    return [
        {
            "name": _known_group(one, part),
            "of": part.grouping,
            "check": one.check_target,
            "n": part.errors.n,
            "figures": [
                _with_interval(value, part.errors.ci95[key], small)
                if (value := part.errors.figures[key]) is not None
                else None
                for key in LENGTHS
            ],
            "inside": _inside(one) if part.grouping == "all" else "",
        }
        for one in facts.statistics.known_errors
        for part in shown_groups(one.groups)
    ]


def _known_group(one: KnownErrors, part: KnownGroup) -> str:
    for known in (words.LIGHTING, words.CATEGORIES):
        for name, called in known.items():
            if name == part.group:
                return called
    word = words.TARGETS[one.target]
    return said("report-check-targets", target=word) if one.check_target else word


def _inside(one: KnownErrors) -> str:
    if isinstance(one.inside, Said):
        return told(one.inside)
    return said("report-of-all", part=one.inside.inside, all=one.inside.n)


def errors(facts: ReportFacts, pictures: Pictures) -> Values | None:
    """The error table and its figures; None where no vehicle has a reference height."""
    found, unit = facts.statistics.errors, facts.unit
    if found.groups["overall"].n == 0:
        return None
    return {
        "groups": [_error_group(name, found.groups[name], unit) for name in GROUPS],
        "within": [[mm, fixed(mm / 10, 1 if mm % 10 else 0)] for mm in _WITHIN_MM],
        "reasons": sorted({told(one.reason) for one in found.groups.values() if one.reason and one.n}),
        "reference_part": _reference_part(found.reference_part, unit),
        "limits": _limits(found.bland_altman, unit),
        "figures": pictures.figures(_ERROR_FIGURES),
        "holds": told(found.groups["overall"].words or ""),
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


def _reference_part(part: ReferencePart | Said, unit: LengthUnit) -> Json:
    if isinstance(part, Said):
        return told(part)
    return {
        "words": told(part.words),
        "correlation": fixed(part.correlation_alone, 2),
        "u_reference": SMALL[unit].number(part.u_reference_m),
    }


def _limits(found: BlandAltman | Said, unit: LengthUnit) -> Json:
    if isinstance(found, Said):
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


def as_in_the_paper(facts: ReportFacts) -> Values | None:
    """What stands apart, for comparison with the paper alone; None where nothing of it is known."""
    if facts.as_in_the_paper is None:
        return None
    unit, found = facts.unit, facts.as_in_the_paper.errors
    targets = facts.statistics.targets.items()
    return {
        "errors": None
        if found.groups["overall"].n == 0
        else {
            "groups": [_error_group(name, found.groups[name], unit) for name in GROUPS],
            "within": [],
            "reasons": [],
        },
        "printed": _paper(unit),
        "targets": [_as_in_the_paper(name, one, HEIGHT[unit]) for name, one in targets if one.raw.n],
    }


def _as_in_the_paper(name: StatisticsTarget, target: Target, scale: Scale) -> Values:
    corrected = {one.percent: one for one in target.corrected.percentiles}
    return {
        "name": words.TARGETS[name],
        "n_corrected": target.corrected.n,
        "n_raw": target.raw.n,
        "percentiles": [
            {
                "percent": decimal(f"{one.percent:g}"),
                "raw": scale.number(one.value),
                "raw_ci95": percentile_interval(one, scale),
                "corrected": scale.number(corrected[one.percent].value) if one.percent in corrected else None,
                "corrected_ci95": percentile_interval(corrected.get(one.percent), scale),
            }
            for one in target.raw.percentiles
        ],
        "without_interval": without_interval([*corrected.values(), *target.raw.percentiles]),
    }


def heights(facts: ReportFacts, pictures: Pictures) -> Values:
    """The rules of standards, then each target's percentiles, and who sits below the standards."""
    targets = facts.statistics.targets
    there = [name for name, target in targets.items() if target.raw.n or target.corrected.n]
    rules = [one for one in facts.statistics.rules if one.n]
    return {
        "rules": [rule_values(one, HEIGHT[facts.unit], SMALL[facts.unit]) for one in rules],
        "targets": [_target(facts, name, targets[name], pictures) for name in there],
        "absent": [words.TARGETS[name] for name in targets if name not in there],
    }


def _target(facts: ReportFacts, name: StatisticsTarget, target: Target, pictures: Pictures) -> Values:
    mine, other = HEIGHT[facts.unit], HEIGHT[OTHER[facts.unit]]
    total, done = target.total, target.correction
    return {
        "name": words.TARGETS[name],
        "many": words.MANY[name],
        "correction": told(done)
        if isinstance(done, Said)
        else {"words": told(done.words), "warning": told(done.warning) if done.warning else None},
        "n": target.corrected.n,
        "figures": [] if total is None else _total_figures(total, mine, other),
        "holds": None if total is None else told(total.words),
        "standards": _standards(facts, name, target),
        "groupings": [] if name == "roof" else pictures.figures(f"{name}-by-{word}" for word in _GROUPINGS),
    }


def _total_figures(total: TotalFigures, mine: Scale, other: Scale) -> list[Json]:
    """Mean, SD and percentiles of the true heights, each with its one interval."""
    named: list[tuple[str, Figure]] = [(said("report-mean"), total.mean), (said("report-sd"), total.sd)]
    named += [(f"P{decimal(f'{one.percent:g}')}", one) for one in total.percentiles]
    return [
        {
            "name": name,
            "value": mine.number(one.value),
            "ci95": total_interval(one, mine),
            "other": other.number(one.value),
            "reason": told(one.reason) if one.reason else None,
        }
        for name, one in named
    ]


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
    alike: dict[Said, list[str]] = {}
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
    named = f"{source}{f', {edition}' if edition and edition not in source else ''}"
    return words.apart([one for one in (named, rule, cited) if one])


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
