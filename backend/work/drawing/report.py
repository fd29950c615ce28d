"""The report of a survey as PDF: a few pages that say what was measured, how, how well, and how to check it.

Set by Typst from fonts that come along, so that the same facts give the same bytes on every machine.
"""

from __future__ import annotations

from collections.abc import Mapping
from datetime import datetime
from typing import Any

import typst

from backend.work.drawing import report_end, report_results, report_scans, report_setup
from backend.work.drawing.blocks import Document, text
from backend.work.drawing.canvas import Drawing
from backend.work.drawing.facts import ReportFacts
from backend.work.drawing.figures import drawings
from backend.work.drawing.fonts import FOLDER
from backend.work.drawing.template import TEMPLATE

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
    report_setup.title(document, facts)
    report_results.glance(document, facts)
    report_setup.setup(document, facts)
    report_setup.calibration(document, facts)
    report_setup.method(document, facts)
    report_results.errors(document, facts, figures)
    report_results.heights(document, facts, figures)
    report_scans.line_scans(document, facts, figures)
    report_end.exclusions(document, facts)
    report_end.verification(document, facts)
    head = document.as_json(
        title=text(name),
        short=text(name if len(name) <= _SHORT else f"{name[:_SHORT]}…"),
        site=text(facts.site),
        as_of=report_setup.moment(facts.as_of),
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
