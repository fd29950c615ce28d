"""Values of the report about the sample: the rule in words, and what became of the passes."""

from sightline.export.report.facts import ReportFacts
from sightline.export.report.said import said
from sightline.export.report.settable import Values
from sightline.export.report.units import decimal
from sightline.statistics.sampling import Response, Sampling


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


def response(facts: ReportFacts) -> Values:
    """Rule and table; by target only over all classes."""
    return {
        "rule": rule_words(facts.sampling),
        "rows": [one for one in facts.response if _is_shown(one)],
        "outside_counts": "yes" if facts.sampling.outside_counts else "no",
    }


def _is_shown(one: Response) -> bool:
    if one.lighting == "all":
        return one.class_set == "all" and one.target is None
    return one.class_set == "all" or one.target is None
