"""The contact assistant: a proposal that is drawn, and stored only when a person clicks."""

from fastapi import APIRouter
from pydantic import Field

from sightline.infra.web.bodies import In, Out, Point
from sightline.infra.web.deps import PathFrame, PathId, Viewer, Wired
from sightline.measurements.assist import service

router = APIRouter()


class Pointer(In):
    pointer: Point = Field(description="Where the pointer stands, px; the wheel is looked for around it.")


class ContactProposalBody(Out):
    """Where the tyre seems to meet the road; `contact` is None with a `reason` where it cannot be told."""

    contact: tuple[float, float] | None
    outline: list[tuple[float, float]] = Field(description="The wheel's outline, px.")
    radius_m: float | None
    expected_px: float | None = Field(description="How far off the proposal may be.")
    words: str
    reason: str | None


@router.post("/recordings/{recording_id}/frames/{n}/contact")
def propose_contact(
    recording_id: PathId, n: PathFrame, body: Pointer, who: Viewer, services: Wired
) -> ContactProposalBody:
    """A proposal for the tyre's contact near the pointer; nothing is stored."""
    return ContactProposalBody.model_validate(service.contact_near(services, recording_id, n, body.pointer))
