"""What the report of an export says of its line scans, read from the export's own files."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping
from dataclasses import replace

from sightline.export.chosen import chosen_scanned
from sightline.export.report.facts import RigFacts, ScanFacts
from sightline.export.scans import scan_heights_in
from sightline.infra.csv_package.files import Files, read_columns, read_rows, record_in, unsafe
from sightline.scans.statistics.service import ScanStatistics


def scan_facts(files: Files, found: ScanStatistics) -> ScanFacts | None:
    """Rigs and statistics of the line scans; None where the survey has none."""
    rigs = tuple(one for row in read_rows(files, "line_scans.csv") for one in _rigs(row))
    if not rigs:
        return None
    names, chosen = ("id", "method", "status", "verdict"), chosen_scanned(files).of
    used = {
        id_: method
        for id_, method, status, verdict in read_columns(files, "scan_vehicles.csv", names)
        if (status, verdict) == ("ok", "accepted") and id_ in chosen
    }
    methods = tuple(sorted(Counter(used.values()).items()))
    return ScanFacts(rigs, found, methods, scan_heights_in(files))


def _rigs(row: Mapping[str, str]) -> tuple[RigFacts, ...]:
    """The rig of a line scan; one that has lanes is one line for each."""
    rig = record_in(RigFacts, row)
    lanes = json.loads(unsafe(row["lanes"])) if row["lanes"] else []
    return tuple(
        replace(rig, name=f"{rig.name}, {one['name']}", distance_m=one["distance_m"]) for one in lanes
    ) or (rig,)
