"""What is drawn over the picture: axes, ladders, grids and iso-height lines, bent as the lens bends them."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from sightline.arrays import Floats
from sightline.geometry.camera import project, undistort
from sightline.geometry.ray_intersection import (
    CAMERA_BELOW,
    CONTACT_OUTSIDE,
    CONTACT_RADIUS,
    HORIZON,
    MIN_DEPRESSION,
    NOT_FINITE,
    REASONS,
)
from sightline.geometry.road_pose import RoadPose
from sightline.messages.said import Said

_SAMPLES = 193
_CLIP_ROUNDS = 12
_THINNED_PX = 0.05
_LADDER_STEPS, _LADDER_STEP_M, _RUNG_HALF_M = 30, 0.1, 0.4
_GRID_STEP_M, _GRID_FAR_M, _LEVEL_HALF_M = 1.0, 12.0, 10.0


@dataclass(frozen=True, eq=False)
class Overlay:
    """The road's axes through a contact point, as polylines (n, 2) in pixels; empty where out of sight."""

    longitudinal: Floats
    vertical: Floats
    transversal: Floats
    origin_px: Floats
    contact_m: Floats


@dataclass(frozen=True, eq=False)
class Rung:
    """One height on the side plane; `label` on every half metre."""

    height_m: float
    polyline_px: Floats
    label: bool


def road_point(pose: RoadPose, contact_px: ArrayLike) -> Floats | Said:
    """The point (3,), metres, on the road under a click, `contact_px` (2,), or the reason why there is none.

    C - w C_z / w_z, w = R' (m_x, m_y, 1): p_l of Dupuis et al. 2019, section 2, between (12) and (13), where
    it has no number.
    """
    click = np.asarray(contact_px, dtype=np.float64).reshape(1, 2)
    if not np.isfinite(click).all():
        return REASONS[NOT_FINITE]
    if not pose.camera.inside(click)[0]:
        return REASONS[CONTACT_OUTSIDE]
    seen = undistort(pose.camera, click)
    if not seen.ok[0]:
        return REASONS[CONTACT_RADIUS]
    direction = pose.rotation.T @ np.array([*seen.points[0], 1.0])
    if pose.centre_m[2] <= 0:
        return REASONS[CAMERA_BELOW]
    if direction[2] >= -MIN_DEPRESSION * float(np.linalg.norm(direction)):
        return REASONS[HORIZON]
    point = pose.centre_m - direction * (pose.centre_m[2] / direction[2])
    point[2] = 0.0
    return np.asarray(point, dtype=np.float64)


def _visible(pose: RoadPose, points_m: Floats) -> tuple[Floats, np.ndarray[tuple[int], np.dtype[np.bool_]]]:
    pixels = project(pose.camera, pose.to_camera(points_m))
    return pixels, np.isfinite(pixels).all(axis=1) & pose.camera.inside(pixels)


def _edge(pose: RoadPose, inside: Floats, outside: Floats) -> Floats:
    """The last visible point on the way from a visible to an invisible one, by halving."""
    for _ in range(_CLIP_ROUNDS):
        middle = 0.5 * (inside + outside)
        if _visible(pose, middle[None])[1][0]:
            inside = middle
        else:
            outside = middle
    return inside


def visible_polyline(pose: RoadPose, start_m: ArrayLike, end_m: ArrayLike, samples: int = _SAMPLES) -> Floats:
    """The longest part of a straight road-frame segment that the picture shows, (n, 2) pixels, n may be 0;
    `start_m`, `end_m` (3,).

    Cut at the picture's border and at the lens model's valid radius: beyond it a polynomial lens would fold
    the line back into the picture. Projected with Dupuis et al. 2019, eq. (3), corrected.
    """
    start, end = np.asarray(start_m, dtype=np.float64), np.asarray(end_m, dtype=np.float64)
    points_m = start + np.linspace(0.0, 1.0, samples)[:, None] * (end - start)
    pixels, shown = _visible(pose, points_m)
    if not shown.any():
        return np.empty((0, 2))
    edges = np.flatnonzero(np.diff(np.concatenate([[0], shown.astype(np.int8), [0]])))
    first, last = max(zip(edges[::2], edges[1::2], strict=True), key=lambda run: run[1] - run[0])
    line = [pixels[first:last]]
    if first > 0:
        line.insert(0, _visible(pose, _edge(pose, points_m[first], points_m[first - 1])[None])[0])
    if last < samples:
        line.append(_visible(pose, _edge(pose, points_m[last - 1], points_m[last])[None])[0])
    return _thinned(np.concatenate(line))


def _thinned(line: Floats) -> Floats:
    """Drop points within _THINNED_PX of the line between their kept neighbours (Douglas-Peucker)."""
    keep = np.zeros(len(line), dtype=bool)
    keep[[0, -1]] = True
    stack = [(0, len(line) - 1)]
    while stack:
        a, b = stack.pop()
        if b - a < 2:
            continue
        chord, offset = line[b] - line[a], line[a + 1 : b] - line[a]
        length = float(np.hypot(*chord))
        away = np.abs(chord[0] * offset[:, 1] - chord[1] * offset[:, 0]) / length if length > 0 else None
        away = np.hypot(offset[:, 0], offset[:, 1]) if away is None else away
        worst = int(np.argmax(away))
        if away[worst] > _THINNED_PX:
            keep[a + 1 + worst] = True
            stack += [(a, a + 1 + worst), (a + 1 + worst, b)]
    return line[keep]


def axes_at_contact(
    pose: RoadPose, contact_px: ArrayLike, length_m: float = 3.0, height_m: float = 2.5
) -> Overlay | Said:
    """The road's axes through a contact click, `contact_px` (2,), or the reason why there are none.

    The longitudinal and transversal axes reach `length_m` to both sides, the vertical one `height_m` up: the
    lines of Dupuis et al. 2019, Figure 5.
    """
    at = road_point(pose, contact_px)
    if isinstance(at, Said):
        return at
    x, y, z = np.eye(3)
    return Overlay(
        visible_polyline(pose, at - length_m * x, at + length_m * x),
        visible_polyline(pose, at, at + height_m * z),
        visible_polyline(pose, at - length_m * y, at + length_m * y),
        np.asarray(contact_px, dtype=np.float64).reshape(2),
        at,
    )


def ladder_at_contact(pose: RoadPose, contact_px: ArrayLike, inset_m: float = 0.0) -> tuple[Rung, ...] | Said:
    """Rungs of equal height over a contact click, `contact_px` (2,), in the plane `inset_m` behind its side
    plane, or a reason. Drawn with Dupuis et al. 2019, eq. (3), corrected.
    """
    at = road_point(pose, contact_px)
    if isinstance(at, Said):
        return at
    at = at + np.array([0.0, inset_m, 0.0])
    rungs = []
    for index in range(1, _LADDER_STEPS + 1):
        height = round(index * _LADDER_STEP_M, 9)
        label = abs(height * 2 - round(height * 2)) < 1e-6
        half = np.array([_RUNG_HALF_M if label else 0.5 * _RUNG_HALF_M, 0.0, 0.0])
        level = at + np.array([0.0, 0.0, height])
        line = visible_polyline(pose, level - half, level + half, 17)
        if len(line):
            rungs.append(Rung(height, line, label))
    return tuple(rungs)


def road_grid(pose: RoadPose, half_length_m: float = 8.0) -> tuple[Floats, ...]:
    """Lines, (n, 2) pixels each, of a square grid on the road, round the point of the road nearest to what
    the camera looks at. Drawn with Dupuis et al. 2019, eq. (3), corrected.
    """
    x0, y0 = _grid_origin(pose, _GRID_STEP_M)
    across = np.arange(0.0, _GRID_FAR_M + 1e-9, _GRID_STEP_M)
    along = np.arange(-half_length_m, half_length_m + 1e-9, _GRID_STEP_M)
    lines = [
        visible_polyline(pose, (x0 - half_length_m, y0 + y, 0.0), (x0 + half_length_m, y0 + y, 0.0))
        for y in across
    ]
    lines += [
        visible_polyline(pose, (x0 + x, y0 + across[0], 0.0), (x0 + x, y0 + across[-1], 0.0)) for x in along
    ]
    return tuple(line for line in lines if len(line) > 1)


def _grid_origin(pose: RoadPose, step_m: float) -> tuple[float, float]:
    """Grid node nearest to the camera's foot, shifted along the traffic to where the camera looks."""
    forward = pose.rotation.T @ np.array([0.0, 0.0, 1.0])
    lead = float(np.clip(forward[0] / max(abs(float(forward[1])), 0.2), -3.0, 3.0)) * 4.0
    x, y = float(pose.centre_m[0]) + lead, float(pose.centre_m[1])
    return round(x / step_m) * step_m, round(y / step_m) * step_m


def iso_heights(
    pose: RoadPose, distance_m: float, heights_m: Sequence[float] = (0.5, 1.0, 1.5, 2.0)
) -> tuple[tuple[float, Floats], ...]:
    """Lines of equal height above the road, (n, 2) pixels each, on the vertical plane `distance_m` across
    from the camera. Drawn with Dupuis et al. 2019, eq. (3), corrected.
    """
    x, y = _grid_origin(pose, 0.01)[0], float(pose.centre_m[1]) + distance_m
    ends = x - _LEVEL_HALF_M, x + _LEVEL_HALF_M
    lines = ((h, visible_polyline(pose, (ends[0], y, h), (ends[1], y, h))) for h in heights_m)
    return tuple((h, line) for h, line in lines if len(line) > 1)
