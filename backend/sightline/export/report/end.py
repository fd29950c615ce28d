"""The report's end: what was left out, and how to check the rest."""

from __future__ import annotations

from sightline.export.report import words
from sightline.export.report.blocks import Column, Document
from sightline.export.report.facts import ReportFacts
from sightline.export.report.units import NONE, count, plural


def exclusions(document: Document, facts: ReportFacts) -> None:
    """What counts for no result, and why."""
    document.section("What was left out")
    total = len(facts.exclusions) if facts.exclusions_total is None else facts.exclusions_total
    if total == 0:
        document.words("Nothing was left out: every measurement stands in the results.")
        return
    shown = (
        ""
        if total == len(facts.exclusions)
        else f" The first {count(len(facts.exclusions))} of them stand here."
    )
    document.words(
        f"{plural(total, 'measurement counts', 'measurements count')} for no result.{shown} All of them "
        f"are listed "
        "in the package’s CSV files."
    )
    document.table(
        "Measurements that count for no result, with the reason.",
        [
            Column("Number", align="right"),
            Column("Vehicle", 1.0),
            Column("Target"),
            Column("State"),
            Column("Reason", 1.6),
        ],
        [
            [
                str(one.measurement),
                one.vehicle,
                words.TARGETS.get(one.target, one.target),
                one.state,
                one.reason or NONE,
            ]
            for one in facts.exclusions
        ],
    )


def verification(document: Document, facts: ReportFacts) -> None:
    """How a reader checks all this without believing anyone."""
    document.section("How to check this report")
    document.words(
        "This report is part of a package of CSV and JSON files. The command below checks the package’s "
        "checksums and "
        "its audit trail, and computes every height again from clicks, pose and camera, and every "
        "statistic from the "
        "rows. Columns, units and meanings are described in datapackage.json."
    )
    document.code("sightline verify PACKAGE", "sha256sum --check SHA256SUMS")
    if facts.audit_head:
        document.words(
            f"The audit trail has {plural(facts.audit_events, 'event', 'events')}. Each carries the hash "
            f"of the one "
            "before; whoever kept the last hash elsewhere can see that nothing was changed or cut off since:"
        )
        document.code(facts.audit_head)
    else:
        document.words("The audit trail is empty.")
    if facts.checksums:
        document.table(
            "SHA-256 of the package’s files.",
            [Column("File", 1.0), Column("SHA-256", 0.0, "hash")],
            [[one.path, one.sha256] for one in facts.checksums],
        )
