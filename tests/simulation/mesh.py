"""Rear, bonnet, screens, roof and front of a vehicle: its outline swept across, as shaded facets."""

from dataclasses import dataclass
from itertools import pairwise

import cv2
import numpy as np

from tests.simulation.camera import Array, DemoCamera, Floats
from tests.simulation.compose import Place, blend, box_of
from tests.simulation.light import Light, shade
from tests.simulation.shape import Shape
from tests.simulation.sideart import tail_lamp_box

ACROSS = np.array([0.0, 0.03, 0.09, 0.17, 0.27, 0.38, 0.5, 0.62, 0.73, 0.83, 0.91, 0.97, 1.0])


@dataclass(frozen=True, eq=False)
class Facets:
    """Quads in the local frame: corners (N, 4, 3) as l, inset, z; colour, opacity, gloss, own light."""

    corners: Array
    base: Array
    opacity: Array
    gloss: Array
    glow: Array


def build_facets(shape: Shape, light: Light) -> Facets:
    """Sweeps the outline from the near edge to the far edge."""
    outline = _dense(shape.outline)
    near = shape.inset(outline[:, 0], outline[:, 1])
    across = near[:, None] + (shape.width_m - 2 * near[:, None]) * ACROSS[None, :]
    step = np.gradient(outline, axis=0)
    upright = np.abs(step[:, 1]) / np.maximum(np.hypot(step[:, 0], step[:, 1]), 1e-9)
    bulge = 4 * ACROSS * (1 - ACROSS)
    out = np.where(outline[:, 0] < shape.length_m / 2, -1.0, 1.0) * upright
    lead = np.where(outline[:, 0] < shape.length_m / 2, 0.05, 0.10) if shape.vehicle.style.smooth else 0.0
    along = outline[:, :1] + (out * lead)[:, None] * bulge[None, :]
    z = np.broadcast_to(outline[:, 1:], along.shape)
    grid = np.stack([along, across, z], -1)
    corners = np.stack([grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]], 2).reshape(-1, 4, 3)
    return _materials(shape, light, corners)


def _dense(outline: Array) -> Array:
    """Cuts long segments so that facets stay below 12 cm."""
    parts = []
    for p, q in pairwise(outline):
        n = max(1, int(np.ceil(np.linalg.norm(q - p) / 0.10)))
        parts.append(p + (q - p) * (np.arange(n) / n)[:, None])
    return np.vstack([*parts, outline[-1:]])


def _materials(shape: Shape, light: Light, corners: Array) -> Facets:
    style, n = shape.vehicle.style, len(corners)
    dim = 0.32 if light.low else 1.0
    mid = corners.mean(1)
    along, z = mid[:, 0], mid[:, 2]
    v = np.clip((mid[:, 1] - 0.1) / (shape.width_m - 0.2), 0, 1)
    base = np.tile(np.array(shape.vehicle.paint, float), (n, 1))
    opacity, gloss, glow = np.ones(n), np.full(n, 0.5), np.zeros((n, 3))

    def put(where: Array, colour: tuple[float, float, float], shine: float = 0.2) -> None:
        base[where], gloss[where] = colour, shine

    rear, front = along < 0.35 * shape.length_m, along > 0.62 * shape.length_m
    if style.name == "lorry":
        put(along < 5.4 * shape.sl, (205, 205, 200), 0.15)
        put((along < 5.4 * shape.sl) & (z < 1.05 * shape.sz), (60, 58, 56), 0.1)
    low = z < (style.sill_m + (0.17 if style.name == "suv" else 0.10)) * shape.sz
    put(low & (rear | front), (42, 40, 40), 0.2)
    put(
        front
        & (z < 0.66 * shape.sz)
        & (z > 0.36 * shape.sz)
        & (np.abs(v - 0.5) < 0.3)
        & (along > 0.93 * shape.length_m),
        (26, 26, 26),
        0.3,
    )
    for base_l, top_l in (style.rear_glass, style.windscreen):
        a, b = sorted((base_l * shape.sl, top_l * shape.sl))
        belt = shape.belt(along) + 0.07
        pane = (
            (along > a - 0.02)
            & (along < b + 0.01)
            & (z > belt)
            & (v > 0.05)
            & (v < 0.95)
            & (z < shape.vehicle.roof_height_m - 0.045)
        )
        put(pane, (34, 32, 28), 1.0)
        opacity[pane] = 0.88
    _, _, z0, z1 = tail_lamp_box(shape)
    lamp = (along < 0.25) & (z > z0) & (z < z1) & ((v < 0.16) | (v > 0.84))
    glow[lamp] = (55, 45, 190) if not light.low else (60, 52, 225)
    head = (
        (along > shape.length_m - 0.45)
        & (z > style.head_lamp[1] * shape.sz)
        & (z < style.head_lamp[2] * shape.sz)
    )
    head &= (v < 0.20) | (v > 0.80)
    glow[head] = (215, 212, 205) if not light.low else (250, 250, 245)
    tag = (np.abs(v - 0.5) < 0.16) & (np.abs(z - 0.60 * shape.sz) < 0.055) & (along < 0.2)
    tag |= (np.abs(v - 0.5) < 0.16) & (np.abs(z - 0.42 * shape.sz) < 0.05) & (along > shape.length_m - 0.25)
    glow[tag] = np.array([190, 205, 205]) * (0.5 if light.low else 1.0) * dim**0.3
    return Facets(corners, base, opacity, gloss, glow)


def lay_facets(frame: Floats, camera: DemoCamera, facets: Facets, light: Light, place: Place) -> None:
    """Draws the facets that face the camera, the farthest first, at twice the resolution."""
    road = place.road(facets.corners[..., 0], facets.corners[..., 1], facets.corners[..., 2])
    normal = np.cross(road[:, 2] - road[:, 0], road[:, 3] - road[:, 1])
    normal /= np.maximum(np.linalg.norm(normal, axis=-1, keepdims=True), 1e-12)
    normal *= place.direction
    ray = road.mean(1) - np.array(camera.centre_m)
    far = np.linalg.norm(ray, axis=-1)
    view = ray / far[:, None]
    seen = np.flatnonzero(
        (np.sum(view * normal, -1) < -0.004) & (road[..., 1].min(1) > camera.centre_m[1] + 0.3)
    )
    if not len(seen):
        return
    seen = seen[np.argsort(-far[seen])]
    box = box_of(camera, road[seen].reshape(-1, 3), 2)
    if box is None:
        return
    colour = _lit(light, facets, seen, normal, view)
    _fill(frame, camera, road[seen], np.clip(colour, 0, 255), facets.opacity[seen], box)


def _lit(light: Light, facets: Facets, seen: Array, normal: Array, view: Array) -> Array:
    matte = shade(light, normal[seen], facets.base[seen], view[seen], 0.12)
    shiny = shade(light, normal[seen], facets.base[seen], view[seen], 0.75)
    g = facets.gloss[seen][:, None]
    glow = facets.glow[seen]
    out: Array = np.where(glow.sum(1, keepdims=True) > 0, glow, matte * (1 - g) + shiny * g)
    return out


def _fill(
    frame: Floats,
    camera: DemoCamera,
    road: Array,
    colour: Array,
    opacity: Array,
    box: tuple[int, int, int, int],
) -> None:
    x0, y0, x1, y1 = box
    canvas = np.zeros(((y1 - y0) * 2, (x1 - x0) * 2, 4), np.uint8)
    px = camera.project(road)
    fixed = np.round(((px - (x0, y0) + 0.5) * 2 - 0.5) * 16).astype(np.int32)
    bgra = np.concatenate([colour * opacity[:, None], opacity[:, None] * 255], 1)
    for quad, ink in zip(fixed, bgra.tolist(), strict=True):
        cv2.fillConvexPoly(canvas, quad, ink, shift=4)
    small = cv2.resize(canvas, (x1 - x0, y1 - y0), interpolation=cv2.INTER_AREA)
    blend(frame, box, small)
