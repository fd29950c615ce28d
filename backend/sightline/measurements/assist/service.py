"""The contact assistant: where a wheel near the pointer seems to stand, and where a contact click goes to.

Nothing is stored here. A click is taken to a tyre only where `geometry.snap` is sure of it.
"""

from dataclasses import dataclass
from typing import Annotated

import numpy as np
from pydantic import Field

from sightline.enums import Point
from sightline.geometry.contact import propose
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.snap import Snap, snap, within_reach
from sightline.infra.database import Session
from sightline.infra.services import Services
from sightline.measurements.click_context_query import click_context
from sightline.measurements.service import pose_in_force
from sightline.messages.said import Said
from sightline.recordings.frames.stills import stills_of
from sightline.vehicles.proposing.records import PointProposal
from sightline.vehicles.proposing.store import proposals_of_vehicle
from sightline.vehicles.store import get_vehicle

PERSON_PX = 1.0  # what a careful click is worth


@dataclass(frozen=True)
class ContactProposal:
    """A proposal with the wheel that speaks for it, or why there is none (then the rest is None)."""

    contact: Point | None
    outline: Annotated[list[Point], Field(description="The wheel's outline, px.")]
    radius_m: float | None
    expected_px: Annotated[float | None, Field(description="How far off the proposal may be.")]
    words: Said
    reason: Said | None


@dataclass(frozen=True)
class SnappedContact:
    """Where a contact click goes to, or a key of the catalogue of messages that says why it stays."""

    contact: Point | None
    expected_px: Annotated[float | None, Field(description="How far off the place may be.")]
    reason: str | None


def contact_near(
    services: Services, recording_id: int, n: int, pointer: Point, *, vehicle_id: int | None = None
) -> ContactProposal:
    """Nothing for a vehicle measured free. Raises NotFound, Conflict (no road pose), Damaged (frame)."""
    with services.reading() as session:
        pose = _pose(session, recording_id)
        if vehicle_id is not None and _is_free(proposals_of_vehicle(session, vehicle_id)):
            return _no_proposal(Said("snap-measured-free"))
    proposal = propose(stills_of(services).gray(recording_id, n), pose, pointer)
    if isinstance(proposal, Said):
        return _no_proposal(proposal)
    return ContactProposal(
        contact=_stored_as(proposal.contact_px),
        outline=[(across, down) for across, down in np.round(proposal.outline_px, 2).tolist()],
        radius_m=proposal.radius_m,
        expected_px=proposal.expected_px,
        words=words_of(proposal.expected_px),
        reason=None,
    )


def snap_contact(services: Services, vehicle_id: int, n: int, click: Point) -> SnappedContact:
    """Where a contact click on frame n of a vehicle's recording goes to: what is proposed of the pass there,
    else the tyre that is found.

    Raises NotFound, Conflict without a road pose, Damaged for a frame that fails its checksum.
    """
    with services.reading() as session:
        recording_id = get_vehicle(session, vehicle_id).recording_id
        pose = _pose(session, recording_id)
        proposals = proposals_of_vehicle(session, vehicle_id)
    if _is_free(proposals):
        return SnappedContact(contact=None, expected_px=None, reason="snap-measured-free")
    proposed = _proposed_contact(proposals, n, click)
    if proposed is not None:
        return SnappedContact(contact=proposed.point_px, expected_px=proposed.expected_px, reason=None)
    found = snap(stills_of(services).gray(recording_id, n), pose, click)
    if not isinstance(found, Snap):
        return SnappedContact(contact=None, expected_px=None, reason=found)
    return SnappedContact(contact=_stored_as(found.contact_px), expected_px=found.expected_px, reason=None)


def is_from(services: Services, vehicle_id: int, n: int, click: Point, contact: Point) -> bool:
    """Whether Sightline answers a click, or a proposal's pointer, with this contact. Raises as
    `snap_contact`.
    """
    if snap_contact(services, vehicle_id, n, click).contact == contact:
        return True
    with services.reading() as session:
        recording_id = get_vehicle(session, vehicle_id).recording_id
    return contact_near(services, recording_id, n, click, vehicle_id=vehicle_id).contact == contact


def words_of(expected_px: float) -> Said:
    """What to expect of it, beside the proposal."""
    shown_px = round(expected_px, 1)
    if expected_px > PERSON_PX:
        return Said("contact-found-rough", expected_px=shown_px)
    return Said("contact-found", expected_px=shown_px)


def _no_proposal(reason: Said) -> ContactProposal:
    words = Said("contact-none", reason=reason)
    return ContactProposal(
        contact=None, outline=[], radius_m=None, expected_px=None, words=words, reason=reason
    )


def _is_free(proposals: tuple[PointProposal, ...]) -> bool:
    return any(one.withheld for one in proposals)


def _pose(session: Session, recording_id: int) -> RoadPose:
    return pose_in_force(session, click_context(session, recording_id, None))[0]


def _proposed_contact(proposals: tuple[PointProposal, ...], n: int, click: Point) -> PointProposal | None:
    """The contact proposed on frame n within reach of a click; of two the surer."""
    placed = [
        one
        for one in proposals
        if one.point.startswith("contact") and one.frame == n and one.point_px is not None
    ]
    near = [one for one in placed if one.point_px is not None and within_reach(click, one.point_px)]
    return min(near, key=lambda one: one.expected_px or 0.0, default=None)


def _stored_as(contact_px: tuple[float, float]) -> Point:
    """To a hundredth of a pixel, as it is answered and stored."""
    return round(contact_px[0], 2), round(contact_px[1], 2)
