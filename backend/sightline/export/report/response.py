"""Values of the report about the sample: the rule in words, and what became of the passes."""

from __future__ import annotations

from sightline.enums import SamplingMethod
from sightline.export.report.facts import ReportFacts
from sightline.export.report.settable import Values
from sightline.export.report.units import fixed
from sightline.export.report.words import CLASS_SETS, LIGHTING, TARGETS, heading
from sightline.statistics.sampling import Response, Sampling

_GROUPS: dict[str, str] = {"all": "all", "none": "no set", "unknown": "unknown"}
_GROUPS.update(LIGHTING)
_GROUPS.update({str(name): words for name, words in CLASS_SETS.items()})


def rule_words(rule: Sampling) -> str:
    """The rule as a sentence."""
    what: dict[SamplingMethod, str] = {
        "every": "Every pass was to be measured",
        "nth": f"One pass in {rule.step} was to be measured, from number {rule.start} on",
        "share": (
            f"A random share of {rule.share_percent:g} % of the passes (seed {rule.seed}) was to be measured"
        ),
    }
    said, free = what[rule.method], rule.free_flowing_s
    return f"{said}." if free is None else f"{said}, of vehicles at least {free:g} s behind the one before."


def response(facts: ReportFacts) -> Values:
    """Rule and table; by target only over all classes."""
    shown = [one for one in facts.response if _is_shown(one)]
    return {"rule": rule_words(facts.sampling), "rows": [_row(one) for one in shown]}


def _is_shown(one: Response) -> bool:
    if one.lighting == "all":
        return one.class_set == "all" and one.target is None
    return one.class_set == "all" or one.target is None


def _row(one: Response) -> Values:
    has = one.rate is not None and one.low is not None and one.high is not None
    return {
        "lighting": heading(_GROUPS[one.lighting]),
        "class_set": _GROUPS[one.class_set],
        "target": "vehicle" if one.target is None else TARGETS[one.target],
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
