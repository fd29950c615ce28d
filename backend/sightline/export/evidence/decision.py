"""The decision of an evidence file, from its own document: made and verified by the same function.

A document holds what a decision rests on (`measurement`, `before`, `gap`, `review`, rigs). Where that does
not carry one, there is no answer, and the reason is said.
"""

from collections.abc import Mapping
from dataclasses import asdict
from math import floor, log10
from typing import Any

from sightline.enums import JsonObject, JudgedQuantity
from sightline.export.evidence.records import SIDES, UNITS, Rule
from sightline.messages import SOURCE, decimal_sign, say
from sightline.messages.said import Said, SaidDocument
from sightline.statistics.conformity import decide, require_risk

KMH_PER_MPS = 3.6
#: What a reader is told in, and how many of them the document's unit is.
_SHOWN: dict[JudgedQuantity, tuple[str, float]] = {
    "speed": ("km/h", KMH_PER_MPS),
    "time_gap": ("s", 1.0),
    "distance_gap": ("m", 1.0),
}
_FEWEST_CHANCE = 1e-4

Document = Mapping[str, Any]


def decision_of(document: Document, rule: Rule | None, language: str = SOURCE) -> JsonObject:
    """What a file says of conformity: rule, value, answer, words. Raises BadInput for a risk of no rule."""
    if rule is None:
        return {"rule": None, "answer": None, "words": say("evidence-no-rule", {}, language)}
    require_risk(rule.risk)
    decision: JsonObject = {
        "rule": {**asdict(rule), "side": SIDES[rule.quantity], "unit": UNITS[rule.quantity]}
    }
    value, u = _judged_value(document, rule)
    decision |= {"value": value, "u": u}
    why = _why_none(document, rule, value, u)
    if why is not None or value is None or u is None:
        return {**decision, "answer": None, "words": why and why.sentence(language)}
    found = decide(value, u, rule.limit, SIDES[rule.quantity], rule.risk)
    return {**decision, **asdict(found), "words": _word_decision(rule, value, u, found, language)}


def rule_of(decision: Document) -> Rule | None:
    """The rule that a document states."""
    told = decision["rule"]
    return None if told is None else Rule(told["quantity"], told["limit"], told["risk"], told["source"])


def _judged_value(document: Document, rule: Rule) -> tuple[float | None, float | None]:
    if rule.quantity == "speed":
        return document["measurement"]["speed_mps"], document["measurement"]["u_speed_mps"]
    gap = document["gap"] or {}
    name = "time_gap_s" if rule.quantity == "time_gap" else "distance_gap_m"
    return gap.get(name), gap.get(f"u_{name}")


def _why_none(document: Document, rule: Rule, value: float | None, u: float | None) -> Said | None:
    """Why there is no decision; None where one can be made."""
    measured, before, gap = document["measurement"], document["before"], document["gap"]
    if measured["status"] != "ok":
        return Said("evidence-none-refused", reason=_reason(measured["reason"]))
    if measured["rig"] != document["rig_now"]:
        return Said("evidence-none-rig")
    if document["review"]["verdict"] != "accepted":
        return Said("evidence-none-review", verdict=document["review"]["verdict"])
    if rule.quantity != "speed":
        if before is None or gap is None:
            return Said("evidence-none-first")
        if before["status"] != "ok" or before["rig"] != document["rig_now"]:
            return Said("evidence-none-before", number=before["number"])
        if before["review"]["verdict"] != "accepted":
            verdict = before["review"]["verdict"]
            return Said("evidence-none-before-review", number=before["number"], verdict=verdict)
    if value is None or u is None or not u > 0:
        return Said("evidence-none-value", reason=_reason((gap or {}).get("reason")))
    return None


def _reason(stored: SaidDocument | None) -> Said | str:
    return "" if stored is None else Said.read(stored)


def _word_decision(rule: Rule, value: float, u: float, decided: Any, language: str) -> str:
    unit, factor = _SHOWN[rule.quantity]
    decimals = max(0, 1 - floor(log10(u * factor)))
    chance = decided.chance_false

    def written(number: str) -> str:
        return number.replace(".", decimal_sign(language))

    def number(of: float) -> str:
        return written(f"{of * factor:.{decimals}f}")

    return say(
        "evidence-decided",
        {
            "answer": decided.answer,
            "quantity": rule.quantity,
            "unit": unit,
            "value": number(value),
            "u": number(u),
            "limit": written(f"{rule.limit * factor:.10g}"),
            "side": SIDES[rule.quantity],
            "guard": number(decided.guard_band),
            "factor": written(f"{decided.factor:.3g}"),
            "risk": written(f"{100 * rule.risk:.3g}"),
            "chance": written(f"{100 * max(chance, _FEWEST_CHANCE):.2g}"),
            "least": "under" if chance < _FEWEST_CHANCE else "about",
        },
        language,
    )
