"""Values of the report about the sample: the rule in words, and what became of the passes."""

from sightline.export.report.facts import ReportFacts
from sightline.export.report.said import sentence_of_key
from sightline.export.report.settable import Values
from sightline.export.report.units import decimal
from sightline.statistics.sampling import Response, Sampling


def rule_words(rule: Sampling) -> str:
    """The rule as a sentence."""
    words, free = _describe_sampling(rule), rule.free_flowing_s
    if free is None:
        return sentence_of_key("report-rule", rule=words)
    return sentence_of_key("report-rule-free", rule=words, seconds=decimal(f"{free:g}"))


def _describe_sampling(rule: Sampling) -> str:
    if rule.method == "nth":
        return sentence_of_key("report-nth", step=rule.step, start=rule.start)
    if rule.method == "share":
        return sentence_of_key("report-share-drawn", share=decimal(f"{rule.share_percent:g}"), seed=rule.seed)
    return sentence_of_key("report-every")


def response(facts: ReportFacts) -> Values:
    """Rule and table; by target only over all classes."""
    return {
        "rule": rule_words(facts.sampling),
        "rows": [one for one in facts.response if _is_shown(one)],
        "outside_counts": "yes" if facts.sampling.outside_counts else "no",
    }


def _is_shown(shown_response: Response) -> bool:
    if shown_response.lighting == "all":
        return shown_response.class_set == "all" and shown_response.target is None
    return shown_response.class_set == "all" or shown_response.target is None
