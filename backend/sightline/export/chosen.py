"""Which vehicles a package is of: those of its selection, out of its own tables."""

from __future__ import annotations

from sightline.infra.csv_package.files import Files, read_columns
from sightline.results.csv import selection_in
from sightline.surveys.csv import class_sets_in


def chosen_vehicles(files: Files) -> frozenset[str]:
    """The vehicles of the videos, by number as text; one without lighting has its recording's."""
    return _chosen(files, "recordings.csv", "vehicles.csv", "recording_id")


def chosen_scanned(files: Files) -> frozenset[str]:
    """The vehicles of the line scans."""
    return _chosen(files, "line_scans.csv", "scan_vehicles.csv", "scan_id")


def _chosen(files: Files, filmed: str, vehicles: str, of: str) -> frozenset[str]:
    selection, sets = selection_in(files), class_sets_in(files)
    lit = dict(read_columns(files, filmed, ("id", "lighting")))
    return frozenset(
        id_
        for id_, recording, lighting, category in read_columns(
            files, vehicles, ("id", of, "lighting", "category")
        )
        if selection.holds(lighting or lit.get(recording, ""), category, sets.get(category, ""))
    )
