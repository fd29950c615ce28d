"""Holding the vehicles of a package against the audit chain."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from sightline.errors import Damaged
from sightline.infra.csv_package.files import Files, read_rows
from sightline.infra.csv_package.verify import says
from sightline.measurements.sheets.csv import VEHICLES


def check_vehicles(
    files: Files, vehicles: Mapping[int, Mapping[str, Any]], is_gone: Callable[[int], bool]
) -> None:
    """Vehicles are what their events made of them, by number; deleted ones are gone. Raises Damaged."""
    missing = {id_ for id_ in vehicles if not is_gone(id_)}
    for row in read_rows(files, VEHICLES.path):
        id_ = int(row["id"])
        made = vehicles.get(id_)
        if made is None or is_gone(id_) or not says(VEHICLES, row, made):
            raise Damaged("measurements-vehicles-csv-not-what-audit-events", id=id_)
        missing.discard(id_)
    if missing:
        raise Damaged("measurements-vehicles-csv-missing-though-audit-event", missing=min(missing))
