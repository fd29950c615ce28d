"""What a person changes of scanned vehicles: boundaries, wheels, facts, a vehicle by hand."""

from __future__ import annotations

from sqlalchemy.orm import Session

from backend.errors import SightlineError
from backend.linescan.parts import Crossings, Method
from backend.storage import catalogue, scans_vehicles
from backend.storage.scans_records import ScanVehicle, ScanVehicleChanges
from backend.work.services import Services

_NOT_YET = "Measuring is not connected yet; try again later."


def place_boundaries(
    services: Services, vehicle_id: int, crossings: Crossings, method: Method | None, version: int, actor: int
) -> None:
    """Measure a vehicle from boundaries that a person placed, as a new revision."""
    raise SightlineError(_NOT_YET)


def place_wheels(
    services: Services, vehicle_id: int, lines: tuple[float, float] | None, version: int, actor: int
) -> None:
    """The wheelbase from both wheels' lines in strip 1 (None: none), as a new revision."""
    raise SightlineError(_NOT_YET)


def add_vehicle(
    services: Services,
    scan_id: int,
    first: tuple[float, float],
    second: tuple[float, float] | None,
    method: Method,
    actor: int,
) -> int:
    """A vehicle by hand, measured; its id."""
    raise SightlineError(_NOT_YET)


def fill_in(
    session: Session,
    vehicle_id: int,
    changes: ScanVehicleChanges,
    *,
    catalogue_id: int | None,
    version: int,
    actor: int,
) -> ScanVehicle:
    """Store what is known of a vehicle; what is not given comes from the catalogue's entry, if one is named.

    Raises NotFound, Conflict for another version, BadInput.
    """
    if catalogue_id is not None:
        entry = catalogue.get(session, catalogue_id)
        known = ScanVehicleChanges(
            make=entry.make,
            model=entry.model,
            category=entry.category,
            true_length_m=entry.length_m,
            true_wheelbase_m=entry.wheelbase_m,
            facts_source=entry.source or "catalogue",
        )
        changes = {**known, **changes}
    return scans_vehicles.change_facts(session, vehicle_id, changes, version=version, actor=actor)
