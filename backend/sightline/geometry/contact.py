"""A proposal for where a tyre meets the road, near a pointer.

The picture is laid out on the side plane through the pointer's place on the road. A wheel that stands there,
or on a parallel plane nearer or farther, is a circle in this layout: a central projection between parallel
planes is a similarity. Looked for is the circle whose lower arc goes from the dark tyre to the lighter road,
together with the rim round the same centre, a brighter disc within the dark tyre. A shadow beside the tyre
takes away a part of the arc, and no more: each part counts alike, however strong its edge.
"""

from dataclasses import dataclass

import cv2
import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from sightline.arrays import Floats
from sightline.geometry.camera import project
from sightline.geometry.road import road_point
from sightline.geometry.road_pose import RoadPose
from sightline.messages.said import Said
from sightline.robust import robust_scale

REACH_PX = 12.0  # how far from the pointer a proposal may lie
RADIUS_M = (0.25, 0.56)  # of car and lorry wheels
RIM = (0.52, 0.80)  # radius of the rim over that of the wheel
_FINE = 0.7  # size of the layout's cells over that of a pixel
_ARC_RAD = np.deg2rad(62.0)
_ARC = np.linspace(-_ARC_RAD, _ARC_RAD, 41)
_ROUND = np.linspace(-np.pi, np.pi, 72, endpoint=False)
_RIM_WEIGHT = 0.8
_BLUR_PX = 1.0
_FEWEST_ANGLES = 12
# Below these, what was found on the demonstration was wrong or no wheel; nearly all that was right is above.
_RIM_SHARE, _RIM_AGREEMENT = 0.80, 0.65
_ARC_SHARE, _ARC_AGREEMENT = 0.42, 0.45
_WIDEST_PX = 1.3
# What the edge is off by where it scatters little. The dark road at the tyre's foot draws it down: drawn
# wheels come out 0.26 px too low with their shadow and 0.09 px without; on twelve surveys drawn with other
# cameras and light 0.31 px by day and 0.32 px in low light (bench_contact --sites), where the error is as
# large as expected by this. It is not taken off: how dark the road is there differs from site to site
# (0.23 to 0.52 px).
SYSTEMATIC_PX = 0.3


@dataclass(frozen=True)
class Proposal:
    """A contact point in pixels and the wheel that speaks for it. `expected_px`: how far off it may be, from
    the scatter of the tyre's edge; `outline_px` (n, 2) is the wheel's circle, to be drawn.
    """

    contact_px: tuple[float, float]
    radius_m: float
    expected_px: float
    outline_px: Floats


@dataclass(frozen=True)
class _Edges:
    """How much of arc and rim was found as an edge (0 to 1), and how far the arc's points scatter."""

    arc: float
    rim: float
    scatter_px: float


@dataclass(frozen=True, eq=False)
class _Layout:
    """The side plane as a picture: slopes (h, w) of luminance along X and up Z, in grey levels per cell."""

    along: NDArray[np.float32]
    up: NDArray[np.float32]
    unit: float  # slope that counts as a clear edge
    cell_m: float
    origin_m: Floats  # (X, Z) of cell (0, 0)
    y_m: float
    pixel_m: float
    clean: Floats  # angles of the arc where only the near face of the tyre is seen against the road


def propose(picture: NDArray[np.uint8], pose: RoadPose, pointer_px: ArrayLike) -> Proposal | Said:
    """The contact of the wheel near a pointer, or the reason why there is none. `picture` (H, W): luminance;
    `pointer_px` (2,).

    Own method: the circle, in the picture laid out on the side plane, whose lower arc goes from dark to light
    and whose rim from light to dark; the module says why.
    """
    pointer = np.asarray(pointer_px, dtype=np.float64).reshape(2)
    at = road_point(pose, pointer)
    if isinstance(at, Said):
        return at
    layout = _layout(picture, pose, at)
    if isinstance(layout, Said):
        return layout
    best = _search(layout, at)
    found, edges = _refined(layout, best)
    return _judge_wheel(layout, pose, found, edges, pointer)


def _layout(picture: NDArray[np.uint8], pose: RoadPose, at_m: Floats) -> _Layout | Said:
    """Lay the picture out on the side plane through `at_m`."""
    away = float(at_m[1] - pose.centre_m[1])
    pixel_m = abs(away) / (0.5 * (pose.camera.fx_px + pose.camera.fy_px))
    cell = _FINE * pixel_m
    x = np.arange(-0.72, 0.72, cell) + at_m[0]
    z = np.arange(-0.25, 1.10, cell)
    if not 40 <= len(x) <= 1500:
        return Said("contact-wrong-distance")
    grid_x, grid_z = np.meshgrid(x, z)
    points = np.stack([grid_x, np.full_like(grid_x, at_m[1]), grid_z], axis=-1).reshape(-1, 3)
    pixels = project(pose.camera, pose.to_camera(points)).reshape(*grid_x.shape, 2)
    maps = np.nan_to_num(pixels, nan=-9.0, posinf=-9.0, neginf=-9.0).astype(np.float32)
    smooth = cv2.GaussianBlur(picture.astype(np.float32), (0, 0), _BLUR_PX)
    laid = cv2.remap(smooth, maps[..., 0], maps[..., 1], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    slopes = np.gradient(np.asarray(laid, np.float32))
    up, along = np.asarray(slopes[0], np.float32), np.asarray(slopes[1], np.float32)
    size = np.hypot(along, up)
    unit = max(0.35 * float(np.percentile(size, 96.0)), 0.15)
    origin = np.array([x[0], z[0]])
    clean = _clean(pose, at_m)
    if len(clean) < _FEWEST_ANGLES:
        return Said("contact-oblique")
    return _Layout(
        along=along,
        up=up,
        unit=unit,
        cell_m=cell,
        origin_m=origin,
        y_m=float(at_m[1]),
        pixel_m=pixel_m,
        clean=clean,
    )


def _clean(pose: RoadPose, at_m: Floats) -> Floats:
    """Angles of the arc where what lies behind the tyre's near face does not stick out beyond it.

    In the layout, what is deeper moves towards the camera's foot point; where that is outwards, the tread and
    the inner shoulder are the outline, not the face that stands on the contact point.
    """
    toward = pose.centre_m[[0, 2]] - at_m[[0, 2]]
    outward = np.sin(_ARC) * toward[0] - np.cos(_ARC) * (toward[1] - 0.3 * (1 - np.cos(_ARC)))
    seen = np.asarray(outward < -0.1 * float(np.hypot(*toward)), dtype=np.bool_)
    return np.asarray(_ARC[seen], dtype=np.float64)


def _agreement(layout: _Layout, x: Floats, z: Floats, r: Floats, angles: Floats) -> Floats:
    """Outward slope on circles (N,) about (x, z) at angles from the lowest point (M,): (N, M), -1 to 1."""
    sine, cosine = np.sin(angles), -np.cos(angles)
    u = (x[:, None] + r[:, None] * sine - layout.origin_m[0]) / layout.cell_m
    v = (z[:, None] + r[:, None] * cosine - layout.origin_m[1]) / layout.cell_m
    u, v = u.astype(np.float32), v.astype(np.float32)
    gx = _sampled(layout.along, u, v)
    gz = _sampled(layout.up, u, v)
    return np.asarray(np.tanh((gx * sine + gz * cosine) / layout.unit), dtype=np.float64)


def _sampled(values: NDArray[np.float32], u: NDArray[np.float32], v: NDArray[np.float32]) -> Floats:
    """Bilinear values at (u, v), in rows that OpenCV takes; 0 outside."""
    shape, width = u.shape, 4096
    flat_u, flat_v = u.reshape(-1), v.reshape(-1)
    rest = -len(flat_u) % width
    rows = (
        np.pad(flat_u, (0, rest)).reshape(-1, width),
        np.pad(flat_v, (0, rest)).reshape(-1, width),
    )
    out = cv2.remap(values, *rows, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=0)
    return np.asarray(out.reshape(-1)[: len(flat_u)].reshape(shape), dtype=np.float64)


def _score(layout: _Layout, x: Floats, bottom: Floats, r: Floats, rim: Floats) -> tuple[Floats, Floats]:
    """(arc, rim): mean agreement of the outlines of N wheels standing with their lowest point at `bottom`."""
    centre = bottom + r
    arc = _agreement(layout, x, centre, r, layout.clean).mean(axis=1)
    disc = -_agreement(layout, x, centre, r * rim, _ROUND).mean(axis=1)
    return arc, disc


def _search(layout: _Layout, at_m: Floats) -> Floats:
    """The best wheel (x, bottom, r, rim) on a grid round the pointer."""
    reach, step = REACH_PX * layout.pixel_m, 1.5 * layout.pixel_m
    steps = np.arange(-reach, reach + 0.5 * step, step)
    radii = np.arange(RADIUS_M[0], RADIUS_M[1], max(0.012, layout.pixel_m))
    rims = np.arange(RIM[0], RIM[1] + 0.01, 0.04)
    x, bottom, r = (a.ravel() for a in np.meshgrid(at_m[0] + steps, steps, radii, indexing="ij"))
    arc = _agreement(layout, x, bottom + r, r, layout.clean[::2]).mean(axis=1)
    likely = np.argsort(arc)[-400:]
    x, bottom, r = (np.repeat(a[likely], len(rims)) for a in (x, bottom, r))
    rim = np.tile(rims, len(likely))
    arcs, discs = _score(layout, x, bottom, r, rim)
    best = int(np.argmax(arcs + _RIM_WEIGHT * discs))
    return np.array([x[best], bottom[best], r[best], rim[best]])


def _refined(layout: _Layout, start: Floats) -> tuple[Floats, _Edges]:
    """(x, bottom, r, rim) fitted to the edges round `start`, to a fraction of a pixel."""
    wheel = start
    edges = _Edges(0.0, 0.0, np.inf)
    for reach in (4.0, 2.5, 2.0):
        x, bottom, r, rim = (float(value) for value in wheel)
        arc = _edges(layout, x, bottom + r, r, layout.clean, 1.0, reach)
        disc = _edges(layout, x, bottom + r, r * rim, _ROUND, -1.0, reach)
        if len(arc) < 6 or len(disc) < 12:
            return wheel, _Edges(len(arc) / len(layout.clean), len(disc) / len(_ROUND), np.inf)
        wheel, scatter = _two_circles(layout, arc, disc, wheel)
        edges = _Edges(len(arc) / len(layout.clean), len(disc) / len(_ROUND), scatter)
    return wheel, edges


def _edges(
    layout: _Layout, x: float, z: float, r: float, angles: Floats, sign: float, reach_px: float
) -> Floats:
    """Points (n, 2) where the outward slope is steepest, within `reach_px` of the circle about (x, z)."""
    steps = np.arange(-reach_px, reach_px + 0.01, 0.25) * layout.pixel_m
    sine, cosine = np.sin(angles)[:, None], -np.cos(angles)[:, None]
    u = ((x + (r + steps) * sine - layout.origin_m[0]) / layout.cell_m).astype(np.float32)
    v = ((z + (r + steps) * cosine - layout.origin_m[1]) / layout.cell_m).astype(np.float32)
    slope = sign * (_sampled(layout.along, u, v) * sine + _sampled(layout.up, u, v) * cosine)
    peak = np.argmax(slope, axis=1)
    rows = np.arange(len(angles))
    inner = (peak > 0) & (peak < len(steps) - 1) & (slope[rows, peak] > 0.3 * layout.unit)
    rows, peak = rows[inner], peak[inner]
    before, top, after = slope[rows, peak - 1], slope[rows, peak], slope[rows, peak + 1]
    shift = 0.5 * (before - after) / np.minimum(before - 2 * top + after, -1e-9)
    away = r + (peak + np.clip(shift, -1, 1) - (len(steps) - 1) / 2) * 0.25 * layout.pixel_m
    return np.stack([x + away * np.sin(angles[rows]), z - away * np.cos(angles[rows])], axis=1)


def _two_circles(layout: _Layout, arc: Floats, disc: Floats, start: Floats) -> tuple[Floats, float]:
    """Two circles about one centre, by least squares with a soft loss; with the scatter of the arc, px."""

    def rest(free: Floats) -> Floats:
        x, z, r, inner = free
        one = np.hypot(arc[:, 0] - x, arc[:, 1] - z) - r
        two = np.hypot(disc[:, 0] - x, disc[:, 1] - z) - inner
        return np.asarray(np.concatenate([one, two]) / layout.pixel_m, dtype=np.float64)

    x, bottom, r, rim = start
    fit = scipy.optimize.least_squares(rest, [x, bottom + r, r, r * rim], loss="soft_l1", f_scale=0.4)
    x, z, r, inner = fit.x
    scatter = robust_scale(rest(fit.x)[: len(arc)])
    return np.array([x, z - r, r, inner / r]), scatter


def _judge_wheel(
    layout: _Layout, pose: RoadPose, found: Floats, edges: _Edges, pointer: Floats
) -> Proposal | Said:
    """The wheel as a proposal, or why it is not believed."""
    x, bottom, r, _ = (float(value) for value in found)
    arcs, discs = _score(layout, *(np.array([value]) for value in found))
    contact = project(pose.camera, pose.to_camera(np.array([[x, layout.y_m, bottom]])))[0]
    on_road = road_point(pose, contact)
    if isinstance(on_road, Said):
        return on_road
    if edges.rim < _RIM_SHARE or float(discs[0]) < _RIM_AGREEMENT:
        return Said("contact-no-rim")
    if edges.arc < _ARC_SHARE or float(arcs[0]) < _ARC_AGREEMENT or edges.scatter_px > _WIDEST_PX:
        return Said("contact-no-edge")
    radius = r * float((on_road[1] - pose.centre_m[1]) / (layout.y_m - pose.centre_m[1]))
    if not RADIUS_M[0] <= radius <= RADIUS_M[1]:
        return Said("contact-radius", radius_m=round(radius, 2))
    if float(np.hypot(*(contact - pointer))) > 1.5 * REACH_PX:
        return Said("contact-far-from-pointer")
    turn = np.linspace(0.0, 2 * np.pi, 49)
    circle = np.stack([x + r * np.sin(turn), np.full(49, layout.y_m), bottom + r - r * np.cos(turn)], axis=1)
    outline = project(pose.camera, pose.to_camera(circle))
    expected = float(np.hypot(SYSTEMATIC_PX, edges.scatter_px))
    return Proposal((float(contact[0]), float(contact[1])), radius, expected, outline)
