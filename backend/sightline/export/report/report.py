"""The report of a survey as PDF: a few pages that say what was measured, how, how well, and how to check it.

Typst sets it from the templates beside this file (`report.typ` first), which hold the layout, from the
sentences of the catalogue (`said.py`), and from fonts that come along, so that the same facts in the same
language give the same bytes on every machine.
"""

import json
from collections.abc import Mapping
from datetime import UTC, datetime
from functools import cache
from pathlib import Path

from sightline.export.report.canvas import Drawing
from sightline.export.report.conclusion import conclusion
from sightline.export.report.facts import ReportFacts
from sightline.export.report.figures import drawings
from sightline.export.report.fonts import LACKING
from sightline.export.report.lateral import lateral
from sightline.export.report.pictures import Pictures
from sightline.export.report.response import response
from sightline.export.report.results import as_in_the_paper, errors, heights, known_errors
from sightline.export.report.said import catalogue_json, speaking, spoken_language
from sightline.export.report.scans import line_scans
from sightline.export.report.settable import Values, make_settable
from sightline.export.report.setup import exclusions, title
from sightline.export.report.sight import FIGURE, crest_of, sight
from sightline.export.report.units import unit_words
from sightline.infra.typesetting import pdf
from sightline.surveys.records import note_in

Drawn = Mapping[str, Drawing | str]
_TEMPLATES = Path(__file__).parent
_FIRST = "report.typ"
#: What reports of other things are laid out from too.
SHARED = ("blocks.typ", "sheet.typ", "rules.typ")


def report(facts: ReportFacts, drawn: Drawn | None = None) -> bytes:
    """The report as PDF (PDF/A-2a, PDF/UA-1); the same facts give the same bytes.

    `drawn`: figures by name where they are drawn already (`figures.drawings`, the same unit).
    """
    return set_pdf(sources(facts, drawn), facts.as_of)


def set_pdf(files: dict[str, bytes], as_of: datetime | None) -> bytes:
    """What Typst makes of templates, values and pictures; it begins at main.typ."""
    return pdf.set_pdf(files, 0 if as_of is None else int(as_of.timestamp()))


def sources(facts: ReportFacts, drawn: Drawn | None = None) -> dict[str, bytes]:
    """The files that Typst compiles: templates, values, pictures."""
    scans = None if facts.scans is None else facts.scans.statistics
    with speaking(facts.language):
        pictures = Pictures(drawings(facts.statistics, facts.unit, scans) if drawn is None else drawn)
        values = _values(facts, pictures)
        return {**templates(_TEMPLATES, _FIRST), "values.json": values, **pictures.files}


def _values(facts: ReportFacts, pictures: Pictures) -> bytes:
    """What the templates show, as JSON: texts that can be set, numbers as they are: templates round them."""
    values: Values = {
        "as_of": None if facts.as_of is None else facts.as_of.astimezone(UTC),
        "head": facts.audit_head[:16],
        "unit": unit_words(facts.unit),
        "title": title(facts),
        "conclusion": conclusion(facts),
        "figures": pictures.figures(_first(facts)),
        "photos": pictures.photos(facts.photos),
        "recordings": facts.recordings,
        "response": response(facts),
        "lenses": facts.calibrations,
        "poses": facts.poses,
        "insets": [{**row, "note": note_in(row["note"] or "", spoken_language())} for row in facts.insets],
        "errors": errors(facts, pictures),
        "known_errors": known_errors(facts),
        "heights": heights(facts, pictures),
        "lateral": lateral(facts, pictures),
        "sight": sight(facts),
        "as_in_the_paper": as_in_the_paper(facts),
        "scans": line_scans(facts, pictures),
        "exclusions": exclusions(facts),
        "events": facts.audit_events,
        "audit_head": facts.audit_head,
        "checksums": [{"path": path, "sha256": sum_} for path, sum_ in facts.checksums.items()],
    }
    return values_json(values)


def _first(facts: ReportFacts) -> list[str]:
    """The figures that stand beside the conclusion: of what there are heights, and the crest."""
    targets = facts.statistics.targets.items()
    there = [f"{name}-ecdf" for name, one in targets if name != "roof" and one.corrected.n]
    return [*there, FIGURE] if crest_of(facts) else there


def values_json(values: Values) -> bytes:
    """What templates show, fit to be set; `lacking` stands for characters that no font has."""
    fit = make_settable(values)
    lacking = LACKING if LACKING in json.dumps(fit, ensure_ascii=False) else None
    return json.dumps({**fit, "lacking": lacking}, ensure_ascii=False, allow_nan=False).encode("utf-8")


def templates(folder: Path, first: str) -> dict[str, bytes]:
    """The templates of a folder and those that every report shares, by name, and what they say in the
    language that is spoken; `first` is main.typ.
    """
    return {**_templates(folder, first), "messages.json": catalogue_json(spoken_language())}


@cache
def _templates(folder: Path, first: str) -> dict[str, bytes]:
    files = sorted({*(_TEMPLATES / name for name in SHARED), *folder.glob("*.typ")})
    return {"main.typ" if file.name == first else file.name: file.read_bytes() for file in files}
