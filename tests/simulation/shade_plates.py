"""Dark plates of a vehicle: its shadow on the road, and the underbody behind arches and sill."""

import cv2
import numpy as np

from tests.simulation.light import Light
from tests.simulation.paint import Layer, Plate, Stencil
from tests.simulation.shape import Shape


def shadow_plate(shape: Shape, light: Light) -> Plate:
    """The shadow on the road: the key light's silhouette and the dark of what is close."""
    ppm, w, length = 64.0, shape.width_m, shape.length_m
    reach = 0.75 if not light.low else 0.9
    tall = shape.vehicle.roof_height_m
    key = np.array(light.key) / np.linalg.norm(light.key)
    dl, dy = -key[0] / key[2] * shape.vehicle.direction, -key[1] / key[2]
    left, right = -1.0 - abs(dl) * tall, length + 1.0 + abs(dl) * tall
    stencil = Stencil(left, right, -0.9, w + 0.6 + dy * tall, ppm)
    fine = stencil.fine()
    for z in np.linspace(0.22, tall, 14):
        inside = shape.outline[shape.outline[:, 1] >= min(z, tall - 0.02)]
        if z < 0.62:
            inside = np.array([[0.03, z], [length - 0.03, z]])
        l0, l1 = inside[:, 0].min() + dl * z, inside[:, 0].max() + dl * z
        lean = 0.05 + 0.16 * max(0.0, z / tall - 0.6)
        y0, y1 = lean + dy * z, w - lean + dy * z
        box = np.array([[l0, y0], [l1, y0], [l1, y1], [l0, y1]])
        cv2.fillPoly(fine, [stencil.to_fine(box)], 1.0, shift=4)
    cast = cv2.GaussianBlur(stencil.shrink(fine), (0, 0), 0.035 * ppm)
    core = stencil.area(
        np.array([[0.1, 0.20], [length - 0.1, 0.20], [length - 0.1, w - 0.10], [0.1, w - 0.10]])
    )
    core = cv2.GaussianBlur(core, (0, 0), 0.09 * ppm)
    tread = [
        np.array([[a - 0.12, 0.03], [a + 0.12, 0.03], [a + 0.13, 0.2], [a - 0.13, 0.2]]) for a in shape.axles
    ]
    foot = cv2.GaussianBlur(stencil.area(*tread), (0, 0), 0.010 * ppm)
    dark = 1 - (1 - reach * 0.62 * cast) * (1 - 0.80 * core) * (1 - 0.85 * foot)
    rgba = np.zeros((*dark.shape, 4), np.float32)
    rgba[..., 3] = dark * 255
    rgba[..., :3] = dark[..., None] * np.array([24.0, 20.0, 18.0]) * (0.4 if light.low else 1.0)
    return Plate(np.round(rgba).astype(np.uint8), ppm, stencil.left_m, stencil.top_m)


def under_plate(shape: Shape, light: Light, ppm: float) -> Plate:
    """Underbody and wheel wells, nearly black."""
    stencil = Stencil(0.0, shape.length_m, 0.05, 1.1, ppm)
    layer = Layer(stencil.size)
    dim = 0.4 if light.low else 1.0
    low, high = (0.17, 0.85) if shape.vehicle.style.name != "lorry" else (0.42, 1.0)
    floor = np.array(
        [
            [0.35, low],
            [shape.length_m - 0.35, low],
            [shape.length_m - 0.25, 0.5],
            [shape.length_m - 0.5, high],
            [0.4, high],
            [0.2, 0.5],
        ]
    )
    layer.lay(stencil.area(floor), np.array([17.0, 16.0, 16.0]) * dim)
    return layer.plate(stencil)
