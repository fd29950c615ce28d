"""The report of a study as PDF: percentile, total U95, rule, verdict and consequence on its first two pages.

Set as a survey's report is (`export.report`), from a template of its own beside this file.
"""

from datetime import UTC, datetime
from pathlib import Path

from sightline import messages
from sightline.enums import LengthUnit
from sightline.export.report.pictures import Pictures
from sightline.export.report.report import set_pdf, templates, values_json
from sightline.export.report.results import rule_values
from sightline.export.report.said import sentence_of_key, sentence_of_said, speaking
from sightline.export.report.settable import Values
from sightline.export.report.units import unit_words
from sightline.export.report.words import GROUPINGS
from sightline.results.standards_store import joined_standards
from sightline.results.survey_statistics import standards_of
from sightline.statistics.standards import Standard
from sightline.studies.consequence import consequence
from sightline.studies.records import StoredStudy, Study
from sightline.studies.report.drawing import curve_drawing
from sightline.studies.stored import Computed, plan_of

_FOLDER, _FIRST = Path(__file__).parent, "study.typ"
_UNIT: LengthUnit = "m"
_COMPARED = (10.0, 50.0)  # of years, on the first pages; all stand in the package
_SHORT = 60


def study_report(
    stored: StoredStudy, found: Computed, sha256: str, as_of: datetime, language: str = messages.SOURCE
) -> bytes:
    """The report as PDF in a language; the same figures give the same bytes. sha256: of the package."""
    with speaking(language):
        return set_pdf(_sources(stored, found, sha256, as_of), as_of)


def _sources(stored: StoredStudy, computed: Computed, sha256: str, as_of: datetime) -> dict[str, bytes]:
    """The files that Typst compiles."""
    pictures = Pictures(
        {
            curve.target: curve_drawing(curve, standards_of(_standards(computed.study), curve.target), _UNIT)
            for curve in computed.study.curves
        }
    )
    values = values_json(_values(stored, computed, sha256, as_of, pictures))
    return {**templates(_FOLDER, _FIRST), "values.json": values, **pictures.files}


def _standards(study: Study) -> tuple[Standard, ...]:
    return joined_standards([one.standards for one in study.surveys])


def _values(stored: StoredStudy, found: Computed, sha256: str, as_of: datetime, pictures: Pictures) -> Values:
    study, facts = found.study, stored.facts
    return {
        "as_of": as_of.astimezone(UTC),
        "unit": unit_words(_UNIT),
        "simulated": stored.simulated,
        "title": {
            "study": facts.name,
            "short": facts.name if len(facts.name) <= _SHORT else facts.name[: _SHORT - 1] + "…",
            "description": [one for one in facts.description.splitlines() if one.strip()],
        },
        "sites": len({one.site for one in study.surveys}),
        "heights": study.heights,
        "vehicles": study.vehicles,
        "fleet": _fleet(stored),
        "code": study.surveys[0].made_with,
        "targets": [
            {
                "found": target,
                "figures": pictures.figures([target.target]) or [sentence_of_key("report-no-distribution")],
            }
            for target in study.targets
            if target.n
        ],
        "rules": [rule_values(one, of_chosen=False) for one in study.rules if one.n],
        "consequence": consequence(study.rules, _UNIT),
        "years": [one for one in study.years if one.percent in (None, *_COMPARED)],
        "errors": study.errors,
        "surveys": _surveys(stored, study),
        "notes": [sentence_of_said(one) for one in study.notes],
        "classes": [one for one in study.classes if one.group == "all"],
        "goal_m": facts.goal_m,
        "plans": study.plans,
        "sha256": sha256,
    }


def _fleet(stored: StoredStudy) -> str | None:
    fleet = plan_of(stored.facts).fleet
    if fleet is None:
        return None
    return sentence_of_key("report-fleet-by", margins=", ".join(GROUPINGS[one] for one in fleet.margins))


def _surveys(stored: StoredStudy, study: Study) -> list[Values]:
    rows = zip(stored.facts.surveys, study.surveys, study.counted, study.out_of_sample, strict=True)
    strata = {site: one.stratum for site, one in (plan_of(stored.facts).sites or {}).items()}
    return [
        {
            "name": survey.name,
            "site": survey.site,
            "stratum": strata.get(survey.site) or None,
            "year": None if facts.year is None else str(facts.year),
            "counted": counted,
            "out_of_sample": outside,
            "head": survey.head,
        }
        for facts, survey, counted, outside in rows
    ]
