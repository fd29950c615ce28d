"""Both wheels of a passing vehicle on one frame: the contact assistant along the lower edge of what moves."""

from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from sightline.enums import Direction
from sightline.geometry.contact import SYSTEMATIC_PX, Proposal, propose
from sightline.geometry.road import road_point
from sightline.geometry.road_pose import RoadPose
from sightline.messages.said import Said

Box = tuple[float, float, float, float]
EVERY_PX = 14.0
SAME_PX = 8.0
WHEELBASE_M = (1.7, 7.5)
ASIDE_M = 0.12  # how far apart across the road both wheels may stand, beside their clicks' part
RADII_M = 0.06
NO_WHEEL = "proposals-no-wheel"
# The dark road at a tyre's foot draws its edge down. The contact assistant states that and leaves it there
# (contact.py); here its mean on drawn development sites 451 to 453 is taken off (0.37 to 0.47 px, by site).
# What is left, and by how much less than the arc's points the contact scatters, is of the same sites.
FOOT_PX, U_FOOT_PX, OF_SCATTER = 0.42, 0.11, 0.25


@dataclass(frozen=True)
class Wheel:
    """A wheel found: its contact in pixels and on the road, metres."""

    contact_px: tuple[float, float]
    x_m: float
    y_m: float
    radius_m: float
    expected_px: float


@dataclass(frozen=True)
class Wheels:
    """Rear and front wheel of a vehicle; one of them may be None."""

    rear: Wheel | None
    front: Wheel | None

    @property
    def found(self) -> tuple[Wheel, ...]:
        return tuple(one for one in (self.rear, self.front) if one is not None)

    @property
    def y_m(self) -> float:
        """The side plane: mean of both."""
        return float(np.mean([one.y_m for one in self.found]))


def wheels_at(
    gray: NDArray[np.uint8],
    pose: RoadPose,
    box: Box,
    rear_px: tuple[float, float] | None,
    front_px: tuple[float, float] | None,
) -> Wheels | str:
    """The wheels of a frame `gray` (H, W) near to where they are expected (px; None: not seen) or why none.

    Own method: the contact assistant at both places; two that do not belong together leave the surer one.
    """
    wheels: list[Wheel | None] = []
    for pointer in (rear_px, front_px):
        one = None if pointer is None else propose(gray, pose, np.array(pointer))
        wheel = _wheel(pose, one) if isinstance(one, Proposal) else None
        wheels.append(wheel if wheel is not None and _within(wheel, box) else None)
    rear, front = wheels
    if rear is not None and front is not None and not _belong(rear, front):
        rear, front = (rear, None) if rear.expected_px <= front.expected_px else (None, front)
    if rear is None and front is None:
        return NO_WHEEL
    return Wheels(rear, front)


def wheels_on(
    gray: NDArray[np.uint8], standing: NDArray[np.bool_], pose: RoadPose, box: Box, direction: Direction
) -> Wheels | str:
    """The wheels of the vehicle in `box` (left, top, right, bottom) px on a frame `gray` (H, W), of which
    `standing` (H, W) stands before the road; or why none is seen.

    Own method: the contact assistant is asked along the lower edge of what stands there; of what it finds,
    the pair that stands on one line along the road, with like radii, farthest apart.
    """
    wheels: list[Wheel] = []
    for pointer in _pointers(standing, box):
        if any(
            np.hypot(pointer[0] - w.contact_px[0], pointer[1] - w.contact_px[1]) < SAME_PX for w in wheels
        ):
            continue
        one = propose(gray, pose, np.array(pointer))
        if isinstance(one, Proposal):
            wheels = _add_wheel(wheels, _wheel(pose, one), box)
    if not wheels:
        return NO_WHEEL
    return _paired(wheels, box, direction)


def _pointers(standing: NDArray[np.bool_], box: Box) -> list[tuple[float, float]]:
    """Places along the lower edge of what stands before the road."""
    height, width = standing.shape
    left, right = max(0, int(box[0])), min(width - 1, int(box[2]))
    top, bottom = max(0, int(box[1])), min(height - 1, int(box[3] + 14))
    part = standing[top : bottom + 1, left : right + 1]
    if part.size == 0:
        return []
    lowest = top + part.shape[0] - 1 - np.argmax(part[::-1], axis=0)
    some = np.asarray(part.any(axis=0), dtype=np.bool_).reshape(-1)
    out = []
    for at in np.arange(EVERY_PX / 2, right - left, EVERY_PX):
        near = slice(max(0, int(at - EVERY_PX / 2)), int(at + EVERY_PX / 2) + 1)
        if some[near].any():
            out.append((left + float(at), float(np.median(lowest[near][some[near]]))))
    return out


def _wheel(pose: RoadPose, proposal: Proposal) -> Wheel | None:
    contact = proposal.contact_px[0], proposal.contact_px[1] - FOOT_PX
    at = road_point(pose, contact)
    if isinstance(at, Said):
        return None
    scatter = float(np.sqrt(max(proposal.expected_px**2 - SYSTEMATIC_PX**2, 0.0)))
    expected = float(np.hypot(U_FOOT_PX, OF_SCATTER * scatter))
    return Wheel(contact, float(at[0]), float(at[1]), proposal.radius_m, expected)


def _add_wheel(wheels: list[Wheel], wheel: Wheel | None, box: Box) -> list[Wheel]:
    """The list with a wheel more, the surer one of two at the same place."""
    if wheel is None or not _within(wheel, box):
        return wheels
    for i, other in enumerate(wheels):
        if np.hypot(*np.subtract(wheel.contact_px, other.contact_px)) < SAME_PX:
            return [*wheels[:i], min(wheel, other, key=lambda w: w.expected_px), *wheels[i + 1 :]]
    return [*wheels, wheel]


def _within(one: Wheel, box: Box) -> bool:
    return box[0] - 4 <= one.contact_px[0] <= box[2] + 4


def _paired(wheels: list[Wheel], box: Box, direction: Direction) -> Wheels:
    pairs = [(one, two) for one, two in combinations(wheels, 2) if _belong(one, two)]
    if pairs:
        first, second = max(pairs, key=lambda pair: abs(pair[0].x_m - pair[1].x_m))
        behind = (first.x_m < second.x_m) == (direction == "right")
        return Wheels(first, second) if behind else Wheels(second, first)
    one = min(wheels, key=lambda w: w.expected_px)
    left = one.contact_px[0] < (box[0] + box[2]) / 2
    return Wheels(one, None) if left == (direction == "right") else Wheels(None, one)


def _belong(one: Wheel, two: Wheel) -> bool:
    base, aside = abs(one.x_m - two.x_m), abs(one.y_m - two.y_m)
    alike = abs(one.radius_m - two.radius_m) <= RADII_M
    return WHEELBASE_M[0] <= base <= WHEELBASE_M[1] and aside <= ASIDE_M and alike
