"""Where a contact click snaps to: the tyre's contact that the contact assistant finds about the click.

The assistant looks within `contact.REACH_PX` of where it is pointed; people also click on the wheel, above
where it stands. It is therefore asked at the click and at places below it, and believed only if it finds the
same place again when it is pointed right there, within reach of the click, with a small expected error.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sightline.arrays import Floats
from sightline.geometry.contact import Proposal, propose
from sightline.geometry.road_pose import RoadPose

# Set on sites 503 to 507 and 509, other surveys than the assistant's (tests/bench/bench_snap.py): what was
# wrong there was not found again, or expected to be off by more. Reach: how far a snap may take a click to
# either side, up and down.
ACROSS_PX, UP_PX, DOWN_PX = 8.0, 6.0, 32.0
LARGEST_EXPECTED_PX = 0.9
AGAIN_PX = 0.5
_BELOW_PX = (0.0, 10.0, 20.0, 30.0)


@dataclass(frozen=True)
class Snap:
    """Where the click goes: pixels, and how far off that may be."""

    contact_px: tuple[float, float]
    expected_px: float


def snap(picture: NDArray[np.uint8], pose: RoadPose, click_px: ArrayLike) -> Snap | str:
    """The contact that a click snaps to, or a key of the catalogue of messages that says why it stays.
    `picture` (H, W): luminance; `click_px` (2,).

    Own method: the contact assistant, asked at and below the click; what it finds twice within reach.
    """
    click = np.asarray(click_px, dtype=np.float64).reshape(2)
    reasons = set()
    for below in _BELOW_PX:
        found = propose(picture, pose, click + np.array([0.0, below]))
        reason = "snap-no-tyre" if not isinstance(found, Proposal) else _doubt(picture, pose, click, found)
        if reason is None and isinstance(found, Proposal):
            return Snap(found.contact_px, found.expected_px)
        reasons.add(reason)
    return next(one for one in ("snap-not-sure", "snap-out-of-reach", "snap-no-tyre") if one in reasons)


def within_reach(click_px: ArrayLike, contact_px: ArrayLike) -> bool:
    """Whether a click `click_px` (2,) may be taken to `contact_px` (2,), x and y. Limits: DECISIONS.md 53."""
    across, down = _difference(contact_px, click_px)
    return bool(abs(across) <= ACROSS_PX and -UP_PX <= down <= DOWN_PX)


def _doubt(picture: NDArray[np.uint8], pose: RoadPose, click: Floats, proposal: Proposal) -> str | None:
    """Why a click does not go to what was found; None: it does."""
    if not within_reach(click, proposal.contact_px):
        return "snap-out-of-reach"
    if proposal.expected_px > LARGEST_EXPECTED_PX:
        return "snap-not-sure"
    again = propose(picture, pose, proposal.contact_px)
    same = isinstance(again, Proposal) and _apart_px(again.contact_px, proposal.contact_px) <= AGAIN_PX
    return None if same else "snap-not-sure"


def _difference(one: ArrayLike, other: ArrayLike) -> Floats:
    return np.asarray(one, dtype=np.float64) - np.asarray(other, dtype=np.float64)


def _apart_px(one: ArrayLike, other: ArrayLike) -> float:
    return float(np.hypot(*_difference(one, other)))
