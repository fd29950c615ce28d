"""What is made of an export's own tables: exclusions, statistics, figures, report. A check makes it again."""

from __future__ import annotations

from backend.work.drawing.canvas import Drawing
from backend.work.drawing.figures import drawings
from backend.work.drawing.report import report
from backend.work.exporting_contents import FIGURES, REPORT
from backend.work.exporting_exclusions import EXCLUSIONS, exclusion_rows
from backend.work.exporting_measured import PackageStatistics, statistics_of
from backend.work.exporting_statistics import TABLES, statistics_rows
from backend.work.packaging import Written
from backend.work.packaging_files import Files, Staging, Tick
from backend.work.reporting import report_facts

# What the report lists the sums of: not itself, nor what there may be thousands of.
_UNLISTED = ("crops/", FIGURES, "SHA256SUMS", "datapackage.json", REPORT)


def derive(staging: Staging, tick: Tick) -> None:
    """Write everything that follows from the tables in the folder."""
    found = derive_tables(staging)
    tick(0.5)
    for path, content in drawn(staging.files(), found, staging.written):
        staging.add(path, content)


def derive_tables(staging: Staging) -> PackageStatistics:
    """Write exclusions and statistics."""
    files = staging.files()
    staging.fill(EXCLUSIONS, exclusion_rows(files))
    found = statistics_of(files)
    rows = statistics_rows(found)
    for table in TABLES:
        staging.fill(table, rows[table.path])
    return found


def drawn(files: Files, found: PackageStatistics, written: dict[str, Written]) -> list[tuple[str, bytes]]:
    """Figures and report by path, from tables that are written already."""
    done = drawings(found.headline, scans=found.scans)
    figures = sorted((name, one.svg) for name, one in done.items() if isinstance(one, Drawing))
    listed = {path: one for path, one in written.items() if not path.startswith(_UNLISTED)}
    facts = report_facts(files, found, listed)
    return [*((f"{FIGURES}{name}.svg", svg) for name, svg in figures), (REPORT, report(facts, done))]
