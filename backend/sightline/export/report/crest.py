"""What heights change on a crest, in one sentence: the same on page, report, package and study."""

from collections.abc import Mapping

from sightline.enums import CrestVerdict, LengthUnit
from sightline.export.report.said import sentence_of_key, sentence_of_said
from sightline.export.report.units import HEIGHT, Scale, percent
from sightline.export.report.words import TARGETS, join_with_semicolons
from sightline.results.sightdistance.records import CaseOfHeights, SightQuestion
from sightline.results.sightdistance.service import case_of, distance_of, exact_height, height_of_rule
from sightline.results.survey_statistics import Filter, Statistics
from sightline.statistics.standards import Standard

_SPEED_MPS: dict[LengthUnit, float] = {"m": 100 / 3.6, "ft": 60 * 0.44704}
_SENTENCES: dict[CrestVerdict, str] = {
    "alike": "sight-verdict-alike",
    "shorter": "sight-verdict-shorter",
    "longer": "sight-verdict-longer",
    "unknown": "sight-verdict-unknown",
}


def consequence(result: Statistics, unit: LengthUnit) -> str | None:
    """The one sentence that says what the heights change on the road, where there is one."""
    found = cases_of(result, unit)
    return None if found is None else crest_sentence(*found[2:])


Cases = tuple[Standard, Standard, SightQuestion, CaseOfHeights, CaseOfHeights]


def cases_of(result: Statistics, unit: LengthUnit) -> Cases | None:
    """The standard that is compared with, what is asked, its case and the survey's."""
    if result.sight is None:
        return None
    eye, thing = (one.standard for one in result.sight)
    question = question_of(eye, thing, unit)
    standard = case_of(question, "standard", exact_height(eye.height_m), exact_height(thing.height_m))
    survey = case_of(question, "survey", *map(height_of_rule, result.sight))
    return eye, thing, question, standard, survey


def question_of(eye: Standard, thing: Standard, unit: LengthUnit) -> SightQuestion:
    """What a standard's eye and object are asked on a crest, each read by the percentile that it states."""
    assert eye.percent is not None and thing.percent is not None
    return SightQuestion(
        chosen=Filter(),
        eye_m=eye.height_m,
        object_m=thing.height_m,
        eye_percent=eye.percent,
        object_percent=thing.percent,
        object_target="taillight",
        speed_mps=_SPEED_MPS[unit],
        unit=unit,
    )


def crest_sentence(
    question: SightQuestion, standard: CaseOfHeights, survey: CaseOfHeights, whose: str = "survey"
) -> str | None:
    """The same as on the page, in the report's unit; why there is no crest where heights are too few for one.
    whose: a survey's heights, or a study's.
    """
    if survey.too_few:
        each = [
            sentence_of_key(
                "sight-too-few-of", target=TARGETS[one.target], reason=sentence_of_said(one.reason)
            )
            for one in survey.too_few
        ]
        return sentence_of_key("sight-too-few", targets=join_with_semicolons(each))
    if survey.crest is None or survey.comparison is None or standard.crest is None:
        return None
    scale = HEIGHT[question.unit]
    crest, before = survey.crest, standard.crest
    far = Scale(scale.factor, scale.sign, 0)
    plain = Scale(scale.factor, "", 1)
    told_apart = survey.comparison.verdict in ("shorter", "longer")  # then words say which
    sign = "" if told_apart else "\N{MINUS SIGN}" if survey.comparison.k_change < 0 else "+"
    values: Mapping[str, str] = {
        "case": whose,
        "eye": scale.length(crest.eye_m.value),
        "object": scale.length(crest.object_m.value),
        "constant": plain.number(crest.constant_m.value),
        "standard": plain.number(before.constant_m.value),
        "change": sign + percent(abs(survey.comparison.k_change)),
        "k": plain.number(crest.k_m.value),
        "k_standard": plain.number(before.k_m.value),
        "distance": far.length(distance_of(question, question.speed_mps).design_m),
        "seen": far.length(crest.seen_m.value),
        "reason": sentence_of_said(crest.constant_m.reason or ""),
    }
    return sentence_of_key(_SENTENCES[survey.comparison.verdict], **values)
