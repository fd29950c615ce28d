"""The contact assistant: where a wheel near the pointer seems to stand. Nothing is stored here."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np
from pydantic import Field

from sightline.enums import Point
from sightline.geometry.contact import propose
from sightline.infra.services import Services
from sightline.measurements.click_context_query import click_context
from sightline.measurements.service import pose_in_force
from sightline.recordings.frames.stills import stills_of

PERSON_PX = 1.0  # what a careful click is worth


@dataclass(frozen=True)
class ContactProposal:
    """A proposal with the wheel that speaks for it, or why there is none (then the rest is None)."""

    contact: Point | None
    outline: Annotated[list[Point], Field(description="The wheel's outline, px.")]
    radius_m: float | None
    expected_px: Annotated[float | None, Field(description="How far off the proposal may be.")]
    words: str
    reason: str | None


def contact_near(services: Services, recording_id: int, n: int, pointer: Point) -> ContactProposal:
    """Raises NotFound, Conflict without a road pose, Damaged for a frame that fails its checksum."""
    with services.reading() as session:
        context = click_context(session, recording_id, None)
        pose, _, _ = pose_in_force(session, context)
    found = propose(stills_of(services).gray(recording_id, n), pose, pointer)
    if isinstance(found, str):
        words = f"No proposal: {found[:1].lower()}{found[1:]} Click the contact yourself."
        return ContactProposal(
            contact=None, outline=[], radius_m=None, expected_px=None, words=words, reason=found
        )
    x, y = found.contact_px
    return ContactProposal(
        contact=(round(x, 2), round(y, 2)),
        outline=[(across, down) for across, down in np.round(found.outline_px, 2).tolist()],
        radius_m=found.radius_m,
        expected_px=found.expected_px,
        words=words_of(found.expected_px),
        reason=None,
    )


def words_of(expected_px: float) -> str:
    """What to expect of it, beside the proposal."""
    worse = ", worse than a careful click" if expected_px > PERSON_PX else ""
    return f"proposal: expect about {expected_px:.1f} px{worse}"
