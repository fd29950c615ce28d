"""The one sentence that says what a study's heights change on the road."""

from collections.abc import Sequence

from sightline.enums import LengthUnit
from sightline.export.report.crest import crest_sentence, question_of
from sightline.results.sightdistance.service import case_of, exact_height, height_of_rule
from sightline.statistics.rules import RuleToday


def consequence(rules: Sequence[RuleToday], unit: LengthUnit) -> str | None:
    """Of the first standard with rules for eye and object on heights of the study; where too few, that."""
    known = [one for one in rules if one.n]
    eyes = {one.standard.name: one for one in known if one.standard.what == "eye_car"}
    objects = {one.standard.name: one for one in known if one.standard.what == "object_stopping"}
    name = next((one for one in eyes if one in objects), None)
    if name is None:
        return None
    eye, thing = eyes[name], objects[name]
    question = question_of(eye.standard, thing.standard, unit)
    standard = case_of(
        question, "standard", exact_height(eye.standard.height_m), exact_height(thing.standard.height_m)
    )
    study = case_of(question, "survey", height_of_rule(eye), height_of_rule(thing))
    return crest_sentence(question, standard, study, "study")
