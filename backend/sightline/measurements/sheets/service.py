"""Changing a vehicle's record, and what follows from it for its heights."""

from __future__ import annotations

from sightline.infra.database import Session
from sightline.measurements.query import measurements_of_vehicles
from sightline.measurements.service import revise_with_what_holds_now
from sightline.measurements.tables import measurement_series
from sightline.vehicles.records import VehicleChanges
from sightline.vehicles.store import get_vehicle, update_vehicle


def change_vehicle(
    session: Session, vehicle_id: int, changes: VehicleChanges, *, version: int, actor: int
) -> None:
    """Change fields; where the driver's side becomes another, a standing eye is computed again by it.

    An eye with an inset of its own stays. Raises Conflict, naming who and when, if `version` is not current.
    """
    before = get_vehicle(session, vehicle_id)
    after = update_vehicle(session, vehicle_id, changes, version=version, actor=actor)
    if (before.side, before.side_from) == (after.side, after.side_from):
        return
    of_vehicle = [measurement_series.c.vehicle_id == vehicle_id]
    for one in measurements_of_vehicles(session, of_vehicle).get(vehicle_id, ()):
        if one.values.target == "driver_eye" and one.values.inset_from == "usual":
            revise_with_what_holds_now(session, one, actor=actor)
