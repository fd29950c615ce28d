"""Roof, lamps and eye of a vehicle, each from all frames that show it, laid on each other by its motion.

On the side plane a point keeps its height from frame to frame wherever it lies behind that plane, and goes
along it evenly: so heights are averaged, and places along are a straight line over the frames.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from sightline.arrays import Floats
from sightline.enums import ProposedPoint, ProposedTarget
from sightline.geometry.road_pose import RoadPose
from sightline.proposals.canvas import Canvas, lay_on_canvas
from sightline.proposals.keypoints import (
    FINE_POINTS,
    Networks,
    Seen,
    coarse_canvas,
    coarse_places,
    fine_canvas,
    fine_places,
    moved_to_plane,
)
from sightline.proposals.motion import Motion
from sightline.proposals.seen import FrameSeen
from sightline.robust import robust_scale

LEAST_SURE = 0.25  # of the first look, to be looked at closely
LEAST_FINE = 0.5  # of the second, to be believed
TOGETHER_M = {"roof": (0.8, 0.12)}  # how far frames may differ along and up at first
TOGETHER = (0.25, 0.12)
FEWEST = 2
FEWEST_CLOSELY = {"driver_eye": 3}  # FEWEST of the others
MOST_APART_M = 0.02  # spread of frames about their mean: a body is rigid, so they did not see one thing
MOST_OFF = 4.0  # of a frame's standard error: what is farther off is left out
# Looked for by the networks, but too far off at times on drawn sites that nothing was set on (DECISIONS 78).
BY_HAND: dict[str, str] = {"headlight": "proposals-headlight-by-hand"}
BY_POINT: dict[str, str] = {
    "roof": "proposals-roof-not-seen",
    "taillight": "proposals-taillight-not-seen",
    "driver_eye": "proposals-eye-not-seen",
}


@dataclass(frozen=True)
class Place:
    """A point about the rear wheel (or the only one) on the side plane: `along_m` in the vehicle's way on
    frame n is `along_m` + `drift` (X of that wheel on frame n), Z, its standard error; how sure each frame
    is.
    """

    along_m: float
    drift: float
    z_m: float
    u_z_m: float
    sure: Mapping[int, float]

    def along(self, wheel_m: float) -> float:
        """Along the vehicle's way from the wheel, where that stands at X = `wheel_m`."""
        return self.along_m + self.drift * wheel_m


@dataclass(frozen=True, eq=False)
class Look:
    """What the first look saw on a frame, on the plane of its canvas."""

    canvas: Canvas
    places: Mapping[ProposedPoint, Seen]


def first_look(networks: Networks, frame: FrameSeen, pose: RoadPose, y_m: float, ahead: int) -> Look | None:
    """Where points may be on a frame, the side plane taken to be Y = `y_m`; None: the box is off it."""
    canvas = coarse_canvas(pose, frame.box, y_m, ahead)
    if canvas is None:
        return None
    return Look(
        canvas, coarse_places(networks, canvas, lay_on_canvas(canvas, frame.picture, frame.change, pose))
    )


def targets_of(
    networks: Networks,
    frames: Sequence[FrameSeen],
    looks: Mapping[int, Look],
    pose: RoadPose,
    motion: Motion,
    ahead: int,
) -> dict[ProposedPoint, Place | str]:
    """Each target from all `frames`, or the key of why it is not proposed.

    Own method, as the module says; what the frames differ by enters the standard error.
    """
    out: dict[ProposedPoint, Place | str] = {}
    for name in FINE_POINTS:
        if name in BY_HAND:
            out[name] = BY_HAND[name]
            continue
        start = _together(name, _coarse(name, frames, looks, pose, motion, ahead))
        if start is None:
            out[name] = BY_POINT[name]
        else:
            out[name] = _closely(networks, name, frames, start, pose, motion, ahead)
    return out


def _coarse(
    name: ProposedTarget,
    frames: Sequence[FrameSeen],
    looks: Mapping[int, Look],
    pose: RoadPose,
    motion: Motion,
    ahead: int,
) -> Floats:
    """X of the wheel, along from it, Z, and how sure, (k, 4): of each frame that may show the point."""
    rows = []
    for frame in frames:
        look = looks.get(frame.n)
        if look is None or look.places[name].sure < LEAST_SURE:
            continue
        at = look.places[name]
        x, z = moved_to_plane(pose, (ahead * at.along_m, at.z_m), look.canvas.y_m, motion.y_m)
        wheel = motion.at(frame.n)
        rows.append((wheel, ahead * (x - wheel), z, at.sure))
    return np.array(rows, dtype=np.float64).reshape(-1, 4)


def _together(name: str, at: Floats) -> Place | None:
    """Where most frames see the point at first."""
    if len(at) < FEWEST:
        return None
    reach = TOGETHER_M.get(name, TOGETHER)
    best, most = None, 0.0
    for row in at:
        near = (np.abs(at[:, 1] - row[1]) < reach[0]) & (np.abs(at[:, 2] - row[2]) < reach[1])
        weight = float(at[near, 3].sum())
        best, most = (near, weight) if weight > most else (best, most)
    if best is None or best.sum() < FEWEST:
        return None
    drift, along = _drift(at[best, 0], at[best, 1])
    return Place(along, drift, float(np.median(at[best, 2])), 0.1, {})


def _drift(wheel: Floats, along: Floats) -> tuple[float, float]:
    """Slope and start of the place along over where the wheel stands; no slope from few or near frames."""
    if len(wheel) < 3 or np.ptp(wheel) < 1.0:
        return 0.0, float(np.median(along))
    slope = float(np.clip(np.polyfit(wheel, along, 1)[0], -0.35, 0.35))
    return slope, float(np.median(along - slope * wheel))


def _closely(
    networks: Networks,
    name: ProposedTarget,
    frames: Sequence[FrameSeen],
    start: Place,
    pose: RoadPose,
    motion: Motion,
    ahead: int,
) -> Place | str:
    """The point from close looks at every frame, the second about where the first found it."""
    for _ in range(2):
        canvases: list[Canvas] = []
        views, about = [], []
        for frame in frames:
            wheel = motion.at(frame.n)
            along = ahead * wheel + start.along(wheel)
            canvas = fine_canvas(name, along, start.z_m, motion.y_m, ahead)
            view = lay_on_canvas(canvas, frame.picture, frame.change, pose)
            if (view[3] >= 0).mean() > 0.6:
                canvases.append(canvas)
                views.append(view)
                about.append((frame.n, wheel))
        seen = fine_places(networks, [name] * len(views), canvases, views)
        # frame, X of the wheel, and what is seen about `start`, along from the wheel
        found = [
            (n, wheel, Seen(one.along_m - ahead * wheel, one.z_m, one.u_along_m, one.u_z_m, one.sure))
            for (n, wheel), one in zip(about, seen, strict=True)
        ]
        place = _combined(name, found)
        if place is None:
            return BY_POINT[name]
        start = place
    return start


def _combined(name: str, sightings: Sequence[tuple[int, float, Seen]]) -> Place | None:
    """The weighted mean of the frames that see the point, what strays left out."""
    some = [one for one in sightings if one[2].sure >= LEAST_FINE]
    fewest = FEWEST_CLOSELY.get(name, FEWEST)
    if len(some) < fewest:
        return None
    z = np.array([one.z_m for _, _, one in some])
    u = np.array([one.u_z_m for _, _, one in some])
    weight = u**-2
    middle = float(np.median(z))
    scatter = robust_scale(z - middle)
    keep = np.abs(z - middle) <= MOST_OFF * np.maximum(u, max(scatter, 0.002))
    if keep.sum() < fewest or keep.mean() < 0.5:
        return None
    mean = float((weight * z)[keep].sum() / weight[keep].sum())
    drift, along = _drift(
        np.array([wheel for _, wheel, _ in some])[keep], np.array([one.along_m for _, _, one in some])[keep]
    )
    spread = float(np.sqrt((weight * (z - mean) ** 2)[keep].sum() / weight[keep].sum()))
    if spread > MOST_APART_M:
        return None
    own = float(np.sqrt(keep.sum() / weight[keep].sum()))
    return Place(along, drift, mean, float(np.hypot(own, spread)), {n: one.sure for n, _, one in sightings})
