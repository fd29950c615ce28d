"""What the report of an export says of its line scans, read from the export's own files."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping
from dataclasses import replace

from sightline.export.chosen import chosen_scanned
from sightline.export.report.facts import RigFacts, ScanFacts
from sightline.export.scans import scan_heights_in
from sightline.infra.csv_package.files import Files, number, read_columns, read_rows, unsafe, whole
from sightline.scans.statistics.service import ScanStatistics


def scan_facts(files: Files, found: ScanStatistics) -> ScanFacts | None:
    """Rigs and statistics of the line scans; None where the survey has none."""
    rigs = tuple(one for row in read_rows(files, "line_scans.csv") for one in _lanes_of(_rig(row), row))
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


def _lanes_of(rig: RigFacts, row: Mapping[str, str]) -> tuple[RigFacts, ...]:
    """A rig that has lanes is one line for each."""
    lanes = json.loads(unsafe(row["lanes"])) if row["lanes"] else []
    return tuple(
        replace(rig, name=f"{rig.name}, {one['name']}", distance_m=one["distance_m"]) for one in lanes
    ) or (rig,)


def _rig(row: Mapping[str, str]) -> RigFacts:
    def value(name: str) -> float:
        return number(row[name]) or 0.0

    return RigFacts(
        name=unsafe(row["name"]),
        source=row["source"],
        lighting=row["lighting"],
        lines=whole(row["lines"]),
        rows_px=whole(row["rows_px"]),
        baseline_m=value("baseline_m"),
        u_baseline_m=value("u_baseline_m"),
        line_rate_hz=value("line_rate_hz"),
        u_line_rate_ratio=value("u_line_rate_ratio"),
        divergence_rad=value("divergence_rad"),
        u_divergence_rad=value("u_divergence_rad"),
        distance_m=number(row["distance_m"]),
        misalignment_px=number(row["misalignment_px"]),
        u_misalignment_px=value("u_misalignment_px"),
    )
