"""The contact assistant: a proposal that is drawn, and stored only when a person clicks."""

from fastapi import APIRouter
from pydantic import Field

from sightline.infra.web.bodies import In, Point
from sightline.infra.web.deps import PathFrame, PathId, Viewer, Wired
from sightline.measurements.assist import service

router = APIRouter()


class Pointer(In):
    pointer: Point = Field(description="Where the pointer stands, px; the wheel is looked for around it.")


@router.post("/recordings/{recording_id}/frames/{n}/contact")
def propose_contact(
    recording_id: PathId, n: PathFrame, body: Pointer, who: Viewer, services: Wired
) -> service.ContactProposal:
    """A proposal for the tyre's contact near the pointer; nothing is stored."""
    return service.contact_near(services, recording_id, n, body.pointer)
