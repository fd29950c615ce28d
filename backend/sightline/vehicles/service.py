"""Vehicle records: two people at one record, and the second one is told."""

from __future__ import annotations

from sightline.errors import Conflict
from sightline.infra.database import Session
from sightline.vehicles.records import Vehicle, VehicleChanges
from sightline.vehicles.store import get_vehicle, update_vehicle


class StaleVersion(Conflict):
    """Somebody changed the record in between; `current` is what it holds now (the answer carries it)."""

    def __init__(self, code: str, current: object, **values: object) -> None:
        super().__init__(code, **values)
        self.current = current


def change_vehicle(
    session: Session, vehicle_id: int, changes: VehicleChanges, *, version: int, actor: int
) -> Vehicle:
    """Change the fields given. Raises StaleVersion, with the record as it is now, for an old version."""
    try:
        return update_vehicle(session, vehicle_id, changes, version=version, actor=actor)
    except Conflict as error:
        raise StaleVersion(error.code, get_vehicle(session, vehicle_id), **error.values) from error
