"""Which vehicles a package is of: those of its selection, out of its own tables."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import get_args

from sightline.enums import AcceptedVerdict
from sightline.infra.csv_package.files import Files, read_columns
from sightline.measurements.sheets.csv import counting_in
from sightline.results.csv import selection_in
from sightline.surveys.csv import class_sets_in


@dataclass(frozen=True, slots=True)
class ChosenVehicles:
    """Vehicles by number as text: those a package is `of`, those it would be of whenever they were filmed,
    and those of them whose time of filming is asked for and not known.
    """

    of: frozenset[str]
    of_kind: frozenset[str]
    without_time: frozenset[str]


def chosen_vehicles(files: Files) -> ChosenVehicles:
    """The vehicles of the videos; one without lighting has its recording's."""
    names = ("id", "recording_id", "lighting", "category", "filmed_at")
    return _choose_vehicles(files, "recordings.csv", read_columns(files, "vehicles.csv", names))


def chosen_scanned(files: Files) -> ChosenVehicles:
    """The vehicles of the line scans, likewise."""
    names = ("id", "scan_id", "lighting", "category", "filmed_at")
    return _choose_vehicles(files, "line_scans.csv", read_columns(files, "scan_vehicles.csv", names))


def counting_vehicles(files: Files) -> frozenset[str]:
    """Those of `chosen_vehicles` whose heights count in results: of the traffic, and in the sample."""
    counts = counting_in(files)
    return frozenset(id_ for id_ in chosen_vehicles(files).of if counts[id_])


def is_accepted(withdrawn: str, status: str, verdict: str) -> bool:
    """Whether there is a height that stands and is accepted, by the cells of its row."""
    return withdrawn == "false" and status == "ok" and verdict in get_args(AcceptedVerdict)


def _choose_vehicles(files: Files, filmed: str, vehicles: Iterable[Sequence[str]]) -> ChosenVehicles:
    selection, sets = selection_in(files), class_sets_in(files)
    lit = dict(read_columns(files, filmed, ("id", "lighting")))
    of_kind = {
        id_: filmed_at
        for id_, recording, lighting, category, filmed_at in vehicles
        if selection.is_of_kind(lighting or lit.get(recording, ""), category, sets.get(category, ""))
    }
    return ChosenVehicles(
        frozenset(id_ for id_, filmed_at in of_kind.items() if selection.holds(filmed_at)),
        frozenset(of_kind),
        frozenset(id_ for id_, filmed_at in of_kind.items() if selection.limits_time and not filmed_at),
    )
