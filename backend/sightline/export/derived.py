"""What is made of an export's own tables: exclusions, statistics, figures, report. A check makes it again."""

from sightline.export.exclusions import EXCLUSIONS, exclusion_rows
from sightline.export.measured import PackageStatistics, statistics_of
from sightline.export.readme import README, readme
from sightline.export.report.canvas import Drawing
from sightline.export.report.figures import drawings
from sightline.export.report.package_facts import report_facts
from sightline.export.report.report import report
from sightline.export.report.said import speaking
from sightline.export.response import RESPONSE, response_rows
from sightline.export.seal import AUDIT_SCRIPT, CHECKPOINT, FIGURES, PAGE, REPORT
from sightline.export.statistics_csv import TABLES, statistics_rows
from sightline.infra.csv_package.audit import AUDIT
from sightline.infra.csv_package.files import Files, Staging
from sightline.infra.csv_package.schema import PARQUET, Written

# What the report lists no sums of: itself, what comes after it, and what there may be thousands of.
_UNLISTED = (
    *("crops/", PARQUET, FIGURES, AUDIT.path, CHECKPOINT, "SHA256SUMS", "datapackage.json", REPORT, README),
    *(PAGE, AUDIT_SCRIPT),
)


def derive_tables(staging: Staging) -> PackageStatistics:
    """Write exclusions and statistics."""
    files = staging.files()
    staging.fill(EXCLUSIONS, exclusion_rows(files))
    staging.fill(RESPONSE, response_rows(files))
    found = statistics_of(files)
    rows = statistics_rows(found)
    for table in TABLES:
        staging.fill(table, rows[table.key])
    return found


def draw_derived_files(
    files: Files, found: PackageStatistics, written: dict[str, Written], language: str
) -> list[tuple[str, bytes]]:
    """Figures and report by path, in a language, from tables that are written already."""
    with speaking(language):
        return _draw_as_spoken(files, found, written)


def _draw_as_spoken(
    files: Files, found: PackageStatistics, written: dict[str, Written]
) -> list[tuple[str, bytes]]:
    done = drawings(found.headline, scans=found.scans)
    figures = sorted((name, one.svg) for name, one in done.items() if isinstance(one, Drawing))
    listed = {path: one for path, one in written.items() if not path.startswith(_UNLISTED)}
    facts = report_facts(files, found, listed)
    drawings_of = ((f"{FIGURES}{name}.svg", svg) for name, svg in figures)
    return [*drawings_of, (REPORT, report(facts, done)), (README, readme(facts))]
