"""Which vehicles a package is of: those of its selection, out of its own tables."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from sightline.infra.csv_package.files import Files, read_columns
from sightline.results.csv import selection_in
from sightline.surveys.csv import class_sets_in


def chosen_vehicles(files: Files) -> frozenset[str]:
    """The vehicles of the videos, by number as text; one without lighting has its recording's."""
    names = ("id", "recording_id", "lighting", "category", "filmed_at")
    return _chosen(files, "recordings.csv", read_columns(files, "vehicles.csv", names))


def chosen_scanned(files: Files) -> frozenset[str]:
    """The vehicles of the line scans, likewise."""
    names = ("id", "scan_id", "lighting", "category", "filmed_at")
    return _chosen(files, "line_scans.csv", read_columns(files, "scan_vehicles.csv", names))


def _chosen(files: Files, filmed: str, vehicles: Iterable[Sequence[str]]) -> frozenset[str]:
    selection, sets = selection_in(files), class_sets_in(files)
    lit = dict(read_columns(files, filmed, ("id", "lighting")))
    return frozenset(
        id_
        for id_, recording, lighting, category, filmed_at in vehicles
        if selection.holds(lighting or lit.get(recording, ""), category, sets.get(category, ""), filmed_at)
    )
