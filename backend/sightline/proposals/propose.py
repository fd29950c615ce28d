"""What a person would click of a passing vehicle, proposed from several frames of its pass.

A first look at each frame says about where its points are. The contact assistant finds the wheels there, and
what most of them agree on says where the vehicle stands on every frame and how long its wheelbase is. With
that, roof, lamps and eye are looked at closely on every frame and put together. Nothing here is a
measurement.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sightline.enums import Direction, ProposedPoint, ProposedTarget, WheelEnd
from sightline.geometry.height import measure_height
from sightline.geometry.road import road_point
from sightline.geometry.road_pose import RoadPose
from sightline.messages.said import Said
from sightline.proposals.keypoints import FINE_POINTS, POINTS, Networks
from sightline.proposals.motion import LEAST_FRAMES, Motion, motion_of
from sightline.proposals.seen import FrameSeen
from sightline.proposals.side_view import pixel_of
from sightline.proposals.targets import LEAST_FINE, Look, Place, first_look, targets_of
from sightline.proposals.wheels import Wheel, Wheels, wheels_at, wheels_on

__all__ = ["POINTS", "FrameSeen", "Proposals", "Proposed", "propose_points"]

ENDS: tuple[tuple[ProposedPoint, WheelEnd], ...] = (("contact_rear", "rear"), ("contact_front", "front"))
# Where about each target lies behind the side plane, for what its height's error becomes; metres.
INSETS_M: dict[ProposedTarget, float] = {
    "roof": 0.25,
    "taillight": 0.10,
    "headlight": 0.10,
    "driver_eye": 0.80,
}
# By how much the standard errors that the networks give are too small or too large, and the least that
# remains, px: set on drawn development sites, of which one wants 1.5 times as much as another
# (bench_proposals --training).
TRUST: dict[ProposedTarget, float] = {"roof": 0.6, "taillight": 0.7, "headlight": 0.6, "driver_eye": 0.6}
REST_PX = 0.1
MOST_OFF_M = 0.02  # of a height: what may be off by more is not proposed
BY_MOTION_PX = 0.6  # of a contact that the wheels on other frames give
EDGE_PX = 6.0
LEAST_CONTACT = 0.3
LEAST_AWAY_M = 1.0


@dataclass(frozen=True)
class Proposed:
    """A point on the best frame, px, and its predicted standard error; `expected_m` of its height, from its
    own and the contact's error, None for a contact.
    """

    point_px: tuple[float, float]
    expected_px: float
    expected_m: float | None


@dataclass(frozen=True)
class Proposals:
    """What is proposed of a vehicle on `frame`, seen on `frames` frames; of each point a place, or why there
    is none, as a key of the catalogue of messages. `wheelbase_m` None: only one wheel was seen.
    """

    frame: int
    frames: int
    wheelbase_m: float | None
    points: Mapping[ProposedPoint, Proposed | str]


def propose_points(
    networks: Networks, frames: Sequence[FrameSeen], pose: RoadPose, direction: Direction, usual_frame: int
) -> Proposals | str:
    """All that can be proposed of a vehicle that goes in `direction` through the frames `frames`; or the key
    (of the catalogue of messages) of why nothing can. `usual_frame`: where it is best seen, as far as known.

    Own method, as the module says.
    """
    ahead = 1 if direction == "right" else -1
    looks = _first_looks(networks, frames, pose, ahead)
    wheels: dict[int, Wheels] = {}
    for frame in frames:
        pair = _wheels(frame, looks.get(frame.n), pose, direction)
        if isinstance(pair, Wheels):
            wheels[frame.n] = pair
    if len(wheels) < LEAST_FRAMES:
        return "proposals-wheels-on-few-frames"
    motion = motion_of(wheels, ahead)
    if isinstance(motion, str):
        return motion
    places = targets_of(networks, frames, looks, pose, motion, ahead)
    best = _Best(seen=frames, looks=looks, pose=pose, motion=motion, found=wheels, places=places, ahead=ahead)
    return best.proposals(usual_frame)


def _first_looks(
    networks: Networks, frames: Sequence[FrameSeen], pose: RoadPose, ahead: int
) -> dict[int, Look]:
    """The first look at each frame, on the side plane that the boxes' lower edges give."""
    sides = []
    for one in frames:
        at = road_point(pose, (0.5 * (one.box[0] + one.box[2]), one.box[3]))
        if not isinstance(at, Said):
            sides.append(float(at[1]))
    if not sides:
        return {}
    y = max(float(np.median(sides)), float(pose.centre_m[1]) + LEAST_AWAY_M)
    looks = {one.n: first_look(networks, one, pose, y, ahead) for one in frames}
    return {n: look for n, look in looks.items() if look is not None}


def _wheels(frame: FrameSeen, look: Look | None, pose: RoadPose, direction: Direction) -> Wheels | str:
    """The wheels where the first look saw them; where it saw none, along the vehicle's lower edge."""
    if look is None:
        return wheels_on(frame.gray, frame.change > 1, pose, frame.box, direction)
    at: list[tuple[float, float] | None] = []
    for name, _ in ENDS:
        place = look.places[name]
        x = look.canvas.ahead * place.along_m
        pixel = pixel_of(pose, x, look.canvas.y_m, place.z_m)
        at.append(pixel if place.sure >= LEAST_CONTACT and _inside(pixel, frame, 0.0) else None)
    if at == [None, None]:
        return wheels_on(frame.gray, frame.change > 1, pose, frame.box, direction)
    return wheels_at(frame.gray, pose, frame.box, at[0], at[1])


def _inside(at: tuple[float, float], one: FrameSeen, edge_px: float = EDGE_PX) -> bool:
    height, width = one.gray.shape
    across = edge_px <= at[0] <= width - 1 - edge_px
    return bool(across and edge_px <= at[1] <= height - 1 - edge_px)


@dataclass(frozen=True, eq=False)
class _Best:
    """All that was found of a vehicle, put on one frame."""

    seen: Sequence[FrameSeen]
    looks: Mapping[int, Look]
    pose: RoadPose
    motion: Motion
    found: Mapping[int, Wheels]
    places: Mapping[ProposedPoint, Place | str]
    ahead: int

    def proposals(self, usual_frame: int) -> Proposals:
        def score(frame: FrameSeen) -> tuple[float, float]:
            contacts = [self.contact(frame, name, end) for name, end in ENDS]
            if all(isinstance(contact, str) for contact in contacts):
                return 0.0, -abs(frame.n - usual_frame)
            found = sum(0.5 if isinstance(contact, Proposed) else 0.0 for contact in contacts)
            targets = sum(not isinstance(self.pixel(name, frame), str) for name in FINE_POINTS)
            return found + targets, -abs(frame.n - usual_frame)

        best = max(self.seen, key=score)
        points = {name: self.contact(best, name, end) for name, end in ENDS}
        contacts = [one for one in points.values() if isinstance(one, Proposed)]
        base = min(contacts, key=lambda one: one.expected_px, default=None)
        for name in FINE_POINTS:
            points[name] = "proposals-no-contact" if base is None else self.target(name, best, base)
        points = {name: points[name] for name in POINTS}
        return Proposals(best.n, len(self.motion.used), self.motion.wheelbase_m, points)

    def contact(self, frame: FrameSeen, name: ProposedPoint, end: WheelEnd) -> Proposed | str:
        """A wheel's contact on a frame: as found there, or where those on the other frames say that it is."""
        pair = self.found.get(frame.n)
        wheel: Wheel | None = None if pair is None else pair.rear if end == "rear" else pair.front
        x = self.motion.wheel_at(frame.n, end, self.ahead)
        if x is None:
            return "proposals-wheel-on-best-frame"
        at = pixel_of(self.pose, x, self.motion.y_m, 0.0)
        if wheel is not None and np.hypot(*np.subtract(at, wheel.contact_px)) < 4.0:
            return Proposed(wheel.contact_px, wheel.expected_px, None)
        look = self.looks.get(frame.n)
        if not _inside(at, frame) or look is None or look.places[name].sure < LEAST_CONTACT:
            return "proposals-wheel-on-best-frame"
        return Proposed(at, BY_MOTION_PX, None)

    def pixel(self, name: ProposedPoint, frame: FrameSeen) -> tuple[float, float] | str:
        """Where a target is on a frame, or why it is not to be clicked there."""
        place = self.places[name]
        if isinstance(place, str):
            return place
        at = self._project_place(place, frame, place.z_m)
        if not _inside(at, frame):
            return "proposals-not-in-picture"
        return at if place.sure.get(frame.n, 0.0) >= LEAST_FINE else "proposals-hidden-here"

    def _project_place(self, place: Place, one: FrameSeen, z_m: float) -> tuple[float, float]:
        wheel = self.motion.at(one.n)
        x = wheel + self.ahead * place.along(wheel)
        return pixel_of(self.pose, x, self.motion.y_m, z_m)

    def target(self, name: ProposedTarget, best: FrameSeen, base: Proposed) -> Proposed | str:
        """A target's place on the best frame with its predicted error, and that of its height."""
        place, at = self.places[name], self.pixel(name, best)
        if isinstance(place, str) or isinstance(at, str):
            return str(at)
        above = self._project_place(place, best, place.z_m + place.u_z_m)
        sigma = float(np.hypot(REST_PX, TRUST[name] * np.hypot(*np.subtract(above, at))))
        height = measure_height(self.pose, base.point_px, at, 1.0, INSETS_M[name])
        if height.status != "ok":
            return "proposals-no-height"
        u_m = {entry.source: entry.u_m for entry in height.budget}
        expected_m = float(np.hypot(u_m["click, target"] * sigma, u_m["click, contact"] * base.expected_px))
        if expected_m > MOST_OFF_M:
            return "proposals-too-uncertain"
        return Proposed(at, sigma, expected_m)
