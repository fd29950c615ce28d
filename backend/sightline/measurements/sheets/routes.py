"""Vehicle records of a survey."""

from typing import Annotated

from fastapi import APIRouter, Query

from sightline.errors import Conflict
from sightline.infra.database import Session
from sightline.infra.web.deps import Operator, PathId, Reading, Viewer, Writing
from sightline.infra.web.named import RecordingId
from sightline.measurements.bodies import VehicleBody, vehicle_body
from sightline.measurements.sheets import query, service
from sightline.vehicles import store
from sightline.vehicles.bodies import ChangedVehicle, NewVehicle, VehicleFields
from sightline.vehicles.records import VehicleChanges

router = APIRouter()


def changes_of(body: VehicleFields) -> VehicleChanges:
    """What the body says; keys left out stay as they are, null clears."""
    given = body.model_dump(exclude_unset=True, exclude={"version"})
    for needed, empty in (("first_frame", None), ("last_frame", None), ("notes", "")):
        if needed in given and given[needed] is None:
            given.pop(needed) if empty is None else given.update({needed: empty})
    return given


def sheet_body(session: Session, vehicle_id: int) -> VehicleBody:
    """A vehicle with its standing measurements, as it goes out."""
    return vehicle_body(query.get_sheet(session, vehicle_id))


@router.get("/surveys/{survey_id}/vehicles")
def list_vehicles(
    survey_id: PathId,
    who: Viewer,
    session: Reading,
    recording_id: Annotated[RecordingId | None, Query(description="Only passes of this recording.")] = None,
) -> list[VehicleBody]:
    """The vehicles of a survey by number, with their standing measurements."""
    found = query.list_sheets(session, survey_id, recording_id=recording_id)
    return [vehicle_body(one) for one in found]


@router.post("/recordings/{recording_id}/vehicles", status_code=201)
def add_vehicle(recording_id: PathId, body: NewVehicle, who: Operator, session: Writing) -> VehicleBody:
    """A pass in a recording; its number counts up in the survey."""
    made = store.create_vehicle(session, recording_id, changes_of(body), actor=who.id)
    return sheet_body(session, made.id)


@router.get("/vehicles/{vehicle_id}")
def get_vehicle(vehicle_id: PathId, who: Viewer, session: Reading) -> VehicleBody:
    """One vehicle with its standing measurements."""
    return sheet_body(session, vehicle_id)


@router.put("/vehicles/{vehicle_id}")
def change_vehicle(vehicle_id: PathId, body: ChangedVehicle, who: Operator, session: Writing) -> VehicleBody:
    """Change a record; an eye is computed again where the driver's side becomes another.

    If somebody was quicker, the conflict says who and when and carries the record.
    """
    try:
        service.change_vehicle(session, vehicle_id, changes_of(body), version=body.version, actor=who.id)
    except Conflict as error:
        error.current = sheet_body(session, vehicle_id)
        raise
    return sheet_body(session, vehicle_id)


@router.delete("/vehicles/{vehicle_id}", status_code=204)
def remove_vehicle(
    vehicle_id: PathId,
    who: Operator,
    session: Writing,
    version: Annotated[int | None, Query(ge=1, le=2**31 - 1)] = None,
) -> None:
    """Take a record out of all lists; nothing of it is erased."""
    store.remove_vehicle(session, vehicle_id, version=version, actor=who.id)


@router.post("/vehicles/{vehicle_id}/restore")
def restore_vehicle(vehicle_id: PathId, who: Operator, session: Writing) -> VehicleBody:
    """Bring a record back that was taken out."""
    store.restore_vehicle(session, vehicle_id, actor=who.id)
    return sheet_body(session, vehicle_id)
