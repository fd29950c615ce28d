"""The one sentence that says what a study's heights change on the road."""

from __future__ import annotations

from collections.abc import Sequence

from sightline.enums import LengthUnit
from sightline.export.report.sight import crest_sentence, question_of
from sightline.results.sightdistance.service import case_of
from sightline.sightdistance.workbench import Bounded
from sightline.statistics.rules import RuleToday
from sightline.studies.records import StudyRule


def consequence(rules: Sequence[StudyRule], unit: LengthUnit) -> str | None:
    """Of the first standard whose eye and object both have a rule that the study has a percentile of."""
    known = [one for one in rules if one.rule.value_m]
    eyes = {one.rule.standard.name: one for one in known if one.rule.standard.what == "eye_car"}
    objects = {one.rule.standard.name: one for one in known if one.rule.standard.what == "object_stopping"}
    name = next((one for one in eyes if one in objects), None)
    if name is None:
        return None
    eye, thing = eyes[name].rule, objects[name].rule
    by_pose_m = eyes[name].by_pose_m, objects[name].by_pose_m
    question = question_of(eye.standard, thing.standard, unit)
    standard = case_of(question, "standard", Bounded(eye.standard.height_m), Bounded(thing.standard.height_m))
    study = case_of(question, "survey", _bounded(eye), _bounded(thing), by_pose_m)
    return crest_sentence(question, standard, study, "study")


def _bounded(rule: RuleToday) -> Bounded | None:
    if rule.value_m is None:
        return None
    return Bounded(rule.value_m, rule.U95_low_m, rule.U95_high_m, rule.reason)
