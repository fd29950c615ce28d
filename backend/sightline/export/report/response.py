"""Values of the report about the sample: the rule in words, and what became of the passes."""

from __future__ import annotations

from sightline.export.report.facts import ReportFacts
from sightline.export.report.said import Called, said
from sightline.export.report.settable import Values
from sightline.export.report.units import decimal, fixed
from sightline.export.report.words import CLASS_SETS, LIGHTING, TARGETS, heading
from sightline.statistics.sampling import Response, Sampling

_GROUPS = Called({"all": "report-all", "none": "report-no-set", "unknown": "report-unknown"})


def rule_words(rule: Sampling) -> str:
    """The rule as a sentence."""
    words, free = _drawn(rule), rule.free_flowing_s
    if free is None:
        return said("report-rule", rule=words)
    return said("report-rule-free", rule=words, seconds=decimal(f"{free:g}"))


def _drawn(rule: Sampling) -> str:
    if rule.method == "nth":
        return said("report-nth", step=rule.step, start=rule.start)
    if rule.method == "share":
        return said("report-share-drawn", share=decimal(f"{rule.share_percent:g}"), seed=rule.seed)
    return said("report-every")


def _group(name: str) -> str:
    return next(
        words for known in (_GROUPS, LIGHTING, CLASS_SETS) for of, words in known.items() if of == name
    )


def response(facts: ReportFacts) -> Values:
    """Rule and table; by target only over all classes."""
    shown = [one for one in facts.response if _is_shown(one)]
    return {
        "rule": rule_words(facts.sampling),
        "rows": [_row(one) for one in shown],
        "outside_counts": "yes" if facts.sampling.outside_counts else "no",
    }


def _is_shown(one: Response) -> bool:
    if one.lighting == "all":
        return one.class_set == "all" and one.target is None
    return one.class_set == "all" or one.target is None


def _row(one: Response) -> Values:
    has = one.rate is not None and one.low is not None and one.high is not None
    return {
        "lighting": heading(_group(one.lighting)),
        "class_set": _group(one.class_set),
        "target": said("report-vehicle") if one.target is None else TARGETS[one.target],
        "passes": one.passes,
        "discarded": one.discarded,
        "out_of_sample": one.out_of_sample,
        "outside": one.outside,
        "in_sample": one.in_sample,
        "measured": one.measured,
        "not_visible": one.not_visible,
        "open": one.open,
        "rate": fixed(100 * one.rate, 1) if one.rate is not None else None,
        "ci95": {"low": fixed(100 * one.low, 1), "high": fixed(100 * one.high, 1)}
        if has and one.low is not None and one.high is not None
        else None,
    }
