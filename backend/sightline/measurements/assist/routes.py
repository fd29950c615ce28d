"""The contact assistant: a proposal that is drawn, and a click that goes to the tyre; nothing is stored."""

from fastapi import APIRouter
from pydantic import Field

from sightline.infra.web.bodies import In, Point
from sightline.infra.web.deps import PathFrame, PathId, Viewer, Wired
from sightline.infra.web.named import VehicleId
from sightline.measurements.assist import service

router = APIRouter()


class ContactClick(In):
    click: Point = Field(description="Where the contact was clicked, px.")


class Pointer(In):
    pointer: Point = Field(description="Where the pointer stands, px; the wheel is looked for around it.")
    vehicle_id: VehicleId | None = Field(
        default=None, description="The vehicle that is measured; of one measured free nothing is proposed."
    )


@router.post("/recordings/{recording_id}/frames/{n}/contact")
def propose_contact(
    recording_id: PathId, n: PathFrame, body: Pointer, who: Viewer, services: Wired
) -> service.ContactProposal:
    """A proposal for the tyre's contact near the pointer; nothing is stored."""
    return service.contact_near(services, recording_id, n, body.pointer, vehicle_id=body.vehicle_id)


@router.post("/vehicles/{vehicle_id}/frames/{n}/snap")
def snap_contact(
    vehicle_id: PathId, n: PathFrame, body: ContactClick, who: Viewer, services: Wired
) -> service.SnappedContact:
    """Where a contact click goes to: the tyre's contact found within reach, or why it stays; nothing is
    stored. A measurement on it names the click as `snapped_from`.
    """
    return service.snap_contact(services, vehicle_id, n, body.click)
