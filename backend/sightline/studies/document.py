"""What is stored of a study's result: the rows of its package's tables, and what its page draws and says."""

from collections.abc import Sequence
from typing import get_args

from sightline.enums import JsonObject, LengthUnit
from sightline.export.report.said import speaking
from sightline.messages import languages
from sightline.statistics.rules import RuleToday
from sightline.studies.consequence import consequence
from sightline.studies.csv import RULES, TABLES, study_rows
from sightline.studies.records import Curve
from sightline.studies.stored import Computed


def document_of(computed: Computed) -> JsonObject:
    """Plain JSON; the rows are those of the package, to the last digit; rules have their standard's code."""
    written = study_rows(computed.study)
    rows = {table.name: list(written[table.path]) for table in TABLES}
    for row, rule in zip(rows[RULES.name], computed.study.rules, strict=True):
        row["standard_code"] = rule.standard.code
    return {
        "heights": computed.study.heights,
        "vehicles": computed.study.vehicles,
        "notes": computed.study.notes,
        "consequence": _consequences(computed.study.rules),
        "curves": [_curve(one) for one in computed.study.curves],
        **rows,
    }


def _consequences(rules: Sequence[RuleToday]) -> dict[str, dict[LengthUnit, str]] | None:
    """The sentence by language and unit: its numbers are written as each writes them."""
    sentences: dict[str, dict[LengthUnit, str]] = {}
    for language in languages():
        with speaking(language):
            found = {unit: consequence(rules, unit) for unit in get_args(LengthUnit)}
        sentences[language] = {unit: sentence for unit, sentence in found.items() if sentence is not None}
    return sentences if all(sentences.values()) else None


def consequence_in(document: JsonObject, language: str) -> dict[LengthUnit, str] | None:
    """What was stored, by unit; earlier results have the sentence in metres alone."""
    said = (document["consequence"] or {}).get(language)
    return {"m": said} if isinstance(said, str) else said


def _curve(curve: Curve) -> JsonObject:
    points = [
        {
            "percent": point.percent,
            "value_m": point.value,
            "raw_m": point.raw,
            "low_m": point.U95_low,
            "high_m": point.U95_high,
        }
        for point in curve.points
    ]
    return {"target": curve.target, "points": points}
