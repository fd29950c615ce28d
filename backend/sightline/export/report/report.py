"""The report of a survey as PDF: a few pages that say what was measured, how, how well, and how to check it.

Set by Typst from fonts that come along, so that the same facts give the same bytes on every machine.
"""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime
from typing import Any

import typst

from sightline.export.report import end, results, setup
from sightline.export.report import scans as report_scans
from sightline.export.report.blocks import Document, text
from sightline.export.report.canvas import Drawing
from sightline.export.report.facts import ReportFacts
from sightline.export.report.figures import drawings
from sightline.export.report.fonts import FOLDER
from sightline.export.report.template import TEMPLATE

Drawn = Mapping[str, Drawing | str]
# Archives keep PDF/A; screen readers want the tags and alternative texts of PDF/UA.
_STANDARDS = ["a-2a", "ua-1"]
_SHORT = 70  # signs of a name in the running head


def report(facts: ReportFacts, drawn: Drawn | None = None) -> bytes:
    """The report as PDF (PDF/A-2a, PDF/UA-1); the same facts give the same bytes.

    `drawn`: figures by name where they are drawn already (`figures.drawings`, the same unit).
    """
    files = sources(facts, drawn)
    stamp = _stamp(facts.as_of)
    try:
        return _compiled(files, stamp, _STANDARDS)
    except typst.TypstError:
        # A sign in a name that no font at hand can show: not for the archive, but still to be read.
        return _compiled(files, stamp, [])


def sources(facts: ReportFacts, drawn: Drawn | None = None) -> dict[str, bytes]:
    """The files that Typst compiles: template, blocks, pictures."""
    document, name = Document(), facts.survey.strip() or "Survey"
    scans = None if facts.scans is None else facts.scans.statistics
    figures = drawings(facts.statistics, facts.unit, scans) if drawn is None else drawn
    setup.title(document, facts)
    results.glance(document, facts)
    setup.setup(document, facts)
    setup.calibration(document, facts)
    setup.method(document, facts)
    results.errors(document, facts, figures)
    results.heights(document, facts, figures)
    report_scans.line_scans(document, facts, figures)
    end.exclusions(document, facts)
    end.verification(document, facts)
    head = document.as_json(
        title=text(name),
        short=text(name if len(name) <= _SHORT else f"{name[:_SHORT]}…"),
        site=text(facts.site),
        as_of=setup.moment(facts.as_of),
        head=facts.audit_head[:16],
    )
    return {"main.typ": TEMPLATE.encode("utf-8"), "report.json": head, **document.files}


def _compiled(files: dict[str, bytes], stamp: int, standards: list[Any]) -> bytes:
    compiler: Any = typst.compile  # its types leave out the dictionary of files
    made: bytes = compiler(
        files,
        font_paths=[str(FOLDER)],
        ignore_system_fonts=True,
        format="pdf",
        pdf_standards=standards,
        timestamp=stamp,
    )
    return made


def _stamp(as_of: datetime | None) -> int:
    return 0 if as_of is None else int(as_of.timestamp())
