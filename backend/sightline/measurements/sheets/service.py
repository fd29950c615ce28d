"""Changing a vehicle's record, and what follows from it for its heights."""

from sightline.enums import Target
from sightline.errors import BadInput
from sightline.geometry.insets import inset_name
from sightline.infra.database import Session
from sightline.measurements.query import measurements_of_vehicles
from sightline.measurements.service import revise_with_what_holds_now
from sightline.measurements.tables import measurement_series
from sightline.vehicles.records import VehicleChanges
from sightline.vehicles.store import get_vehicle, update_vehicle


def change_vehicle(
    session: Session, vehicle_id: int, changes: VehicleChanges, *, version: int, actor: int
) -> None:
    """Change fields; where the driver's side becomes another, a standing eye is computed again by it, and a
    roof where the class becomes one of another inset.

    What has an inset of its own stays. Raises Conflict, naming who and when, if `version` is not current,
    BadInput for a target that is measured and said not to be visible, and for a measured vehicle that is said
    to be none.
    """
    before = get_vehicle(session, vehicle_id)
    after = update_vehicle(session, vehicle_id, changes, version=version, actor=actor)
    of_vehicle = [measurement_series.c.vehicle_id == vehicle_id]
    if set(after.not_visible) - set(before.not_visible):
        standing = measurements_of_vehicles(session, of_vehicle).get(vehicle_id, ())
        measured = {one.values.target for one in standing} & set(after.not_visible)
        if measured:
            raise BadInput("measurements-invisible-measured", target=min(measured))
    if after.discarded and measurements_of_vehicles(session, of_vehicle).get(vehicle_id):
        raise BadInput("measurements-discard-measured", number=after.number)
    targets = set[Target]()
    if (before.side, before.side_from) != (after.side, after.side_from):
        targets.add("driver_eye")
    if inset_name("roof", None, before.category) != inset_name("roof", None, after.category):
        targets.add("roof")
    for one in measurements_of_vehicles(session, of_vehicle).get(vehicle_id, ()) if targets else ():
        if one.values.target in targets and one.values.inset_from == "usual":
            revise_with_what_holds_now(session, one, actor=actor)
