"""Exposure and frames of a pass at a planned site: how fast a vehicle crosses the picture, how long."""

from dataclasses import dataclass
from math import ceil, floor, log10

import numpy as np

from sightline.geometry.camera import project
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.site import Site

#: The speeds that are planned for: 30, 50, 80, 110 and 130 km/h.
SPEEDS_MPS = tuple(kmh / 3.6 for kmh in (30.0, 50.0, 80.0, 110.0, 130.0))
#: More motion blur than this and clicks are less sure than they are taken to be.
MOST_BLUR_PX = 2.0
FRAME_RATES_HZ = (30.0, 60.0)
_STEP_M = 0.05


@dataclass(frozen=True)
class Passing:
    """A vehicle of `speed_mps` on the planned wheel track.

    `blur_px`: its motion in the picture during 1/1000 s; `longest_exposure_s`: until that is MOST_BLUR_PX;
    `shutter`: n of the 1/n s to set for it, on the safe side; `frames`: whole ones in
    which road and a driver's eye are seen, for each of FRAME_RATES_HZ.
    """

    speed_mps: float
    blur_px: float
    longest_exposure_s: float
    shutter: int
    frames: tuple[int, ...]


def passings(pose: RoadPose, site: Site, height_m: float, shown_m: float) -> tuple[Passing, ...]:
    """What each of SPEEDS_MPS means at a site for a target of `height_m` above the wheel track.

    pose: the camera as planned, its board at the wheel track or elsewhere across the road. shown_m: length of
    the wheel track in view. Motion is taken where the camera's axis meets the wheel track.
    """
    px_per_m = _px_per_m(pose, site, height_m)
    return tuple(_passing(speed, px_per_m, shown_m) for speed in SPEEDS_MPS)


def _passing(speed_mps: float, px_per_m: float, shown_m: float) -> Passing:
    longest_s = MOST_BLUR_PX / (speed_mps * px_per_m)
    return Passing(
        speed_mps=speed_mps,
        blur_px=1e-3 * speed_mps * px_per_m,
        longest_exposure_s=longest_s,
        shutter=_shutter(longest_s),
        frames=tuple(int(shown_m / speed_mps * rate) for rate in FRAME_RATES_HZ),
    )


def _shutter(longest_s: float) -> int:
    """The n of an exposure of 1/n s that is not longer, of two significant digits."""
    parts = 1.0 / longest_s
    step = 10.0 ** max(0, floor(log10(parts)) - 1)
    return int(step * ceil(parts / step))


def _px_per_m(pose: RoadPose, site: Site, height_m: float) -> float:
    """How far a point moves in the picture for a metre along the traffic, at the middle of the view."""
    centre = -pose.rotation.T @ pose.translation_m
    axis = pose.rotation[2]
    across = site.distance_m
    along = float(centre[0] + axis[0] / axis[1] * across)
    ahead = np.array([along - _STEP_M, along + _STEP_M])
    points = np.column_stack([ahead, np.full(2, centre[1] + across), np.full(2, height_m)])
    before, after = project(pose.camera, pose.to_camera(points))
    return float(np.hypot(*(after - before))) / (2.0 * _STEP_M)
