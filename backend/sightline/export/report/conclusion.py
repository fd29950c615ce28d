"""What came out of a survey, in words: figures of rules with interval and verdict, what they change on a
crest, how well heights are known, what was not covered. The report opens with it, and so do README and page.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from sightline.enums import LengthUnit
from sightline.export.report import words
from sightline.export.report.crest import consequence
from sightline.export.report.facts import ReportFacts
from sightline.export.report.said import sentence_of_key, sentence_of_said, spoken_language
from sightline.export.report.units import HEIGHT, SMALL, Scale, decimal, format_fixed, limit, percent
from sightline.results.survey_statistics import RULE_OF, Statistics
from sightline.results.usual_standards import in_language
from sightline.statistics.errors import Interval
from sightline.statistics.rules import RuleToday


@dataclass(frozen=True)
class Conclusion:
    """Sentences in the language that is spoken."""

    found: tuple[str, ...]
    not_covered: tuple[str, ...]


def conclusion(facts: ReportFacts) -> Conclusion:
    """The sentences of a survey."""
    return Conclusion(conclude(facts.statistics, facts.unit), tuple(_not_covered(facts)))


def conclude(result: Statistics, unit: LengthUnit) -> tuple[str, ...]:
    """What came out, a sentence each: of how many, each rule's figure, what it changes, how good it is."""
    asked = _rules_to_state(result)
    stated = all(one.value_m is not None for one in asked)  # else its own sentence says what is missing
    changes = consequence(result, unit) if stated else None
    return (
        sentence_of_key(
            "report-concluded-of", measurements=result.counted.measurements, vehicles=result.counted.vehicles
        ),
        *(_of_rule(one, unit, result.of_chosen) for one in asked),
        *(() if changes is None else (changes,)),
        _errors(result, unit),
    )


def _rules_to_state(result: Statistics) -> tuple[RuleToday, ...]:
    """The eye and the object that a crest rests on; else every rule that has heights."""
    pair = tuple(one for one in result.sight or () if one.n)
    return pair or tuple(one for one in result.rules if one.n)


def whose_words(one: RuleToday, of_chosen: bool) -> str:
    """Whose heights the percentile of a rule is read on."""
    return sentence_of_key("statistics-rule-whose", whose=one.whose, chosen="yes" if of_chosen else "no")


def _of_rule(rule: RuleToday, unit: LengthUnit, of_chosen: bool) -> str:
    standard, scale = in_language(rule.standard, spoken_language()), HEIGHT[unit]
    target = RULE_OF[standard.what][0]
    key: dict[str, str | int] = {
        "of": words.MANY[target],
        "classes": whose_words(rule, of_chosen),
        "percent": decimal(f"{standard.percent:g}"),
        "n": rule.n,
    }
    if rule.value_m is None:
        return sentence_of_key("report-concluded-none", **key, reason=sentence_of_said(rule.reason or ""))
    return sentence_of_key(
        "report-concluded-rule",
        **key,
        value=scale.length(rule.value_m),
        interval=in_brackets(rule.U95_low_m, rule.U95_high_m, scale),
        standard=standard.name,
        limit=limit(standard.height_m, unit),
        verdict=verdict_of(rule),
    )


def verdict_of(rule: RuleToday) -> str:
    """What may be said of today's percentile against the standard's height."""
    if rule.verdict == "unknown" or rule.lower is None:
        return sentence_of_key("report-no-verdict", reason=sentence_of_said(rule.reason or ""))
    if rule.verdict == "alike":
        return sentence_of_key("report-alike", percent=percent(rule.lower))
    key = "report-lower" if rule.verdict == "lower" else "report-higher"
    return sentence_of_key(key, risk=_risk(rule.risk))


def _risk(risk: float | None) -> str:
    """A risk in per cent; none is said to be smaller than draws can tell."""
    if risk is None or risk < 0.001:
        return sentence_of_key("report-less-than", percent=decimal("0.1 %"))
    return f"{format_fixed(100 * risk, 1)} %"


def in_brackets(low: float | None, high: float | None, scale: Scale) -> str:
    """ " (95 %: 1.060 to 1.103)" behind a figure; nothing where it has no interval."""
    if low is None or high is None:
        return ""
    between = sentence_of_key("report-between", low=scale.number(low), high=scale.number(high))
    return " " + sentence_of_key("report-brackets", interval=between)


def _errors(result: Statistics, unit: LengthUnit) -> str:
    overall = result.errors.groups["overall"]
    mae, bias = overall.figures["mae_m"], overall.figures["bias_m"]
    if mae is None or bias is None:
        return sentence_of_key("report-error-none")
    small = SMALL[unit]
    ends = {name: overall.ci95[name] for name in ("mae_m", "bias_m")}
    return sentence_of_key(
        "report-error-short",
        n=overall.n,
        mae=small.length(mae),
        mae_interval=in_brackets(*_ends(ends["mae_m"]), small),
        bias=f"{small.number(bias, signed=True)}\u00a0{small.sign}",
        bias_interval=in_brackets(*_ends(ends["bias_m"]), small),
    )


def _ends(found: Interval | None) -> tuple[float | None, float | None]:
    return (None, None) if found is None else (found.low, found.high)


def _not_covered(facts: ReportFacts) -> Iterator[str]:
    """What a reader may not take from the figures, most of it counted."""
    result = facts.statistics
    if facts.selection is not None:
        yield sentence_of_key("report-uncovered-selection", selection=facts.selection)
    absent = [
        words.MANY[name]
        for name in ("driver_eye", "taillight")
        if name in result.targets and not result.targets[name].corrected.n
    ]
    if absent:
        yield sentence_of_key("report-absent", targets=", ".join(absent))
    if any(one.n and not one.by_class for one in result.rules):
        yield sentence_of_key("report-uncovered-classes")
    excluded = len(facts.exclusions) if facts.exclusions_total is None else facts.exclusions_total
    if excluded:
        yield sentence_of_key("report-uncovered-excluded", n=excluded)
    if facts.not_visible:
        yield sentence_of_key("report-uncovered-not-visible", n=facts.not_visible)
    if facts.out_of_date:
        yield sentence_of_key("report-uncovered-out-of-date", n=facts.out_of_date)
    of_scans = sum(one.n for one in facts.scans.heights) if facts.scans is not None else 0
    if of_scans:
        yield sentence_of_key("report-uncovered-line-heights", n=of_scans)
    if facts.verdicts.by_lot:
        yield sentence_of_key("report-uncovered-by-lot", n=facts.verdicts.by_lot)
    yield sentence_of_key("report-uncovered-others")
