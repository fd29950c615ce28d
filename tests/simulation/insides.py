"""Wheels, driver, seats and the far side of the cabin: the plates behind the near side."""

import cv2
import numpy as np

from tests.simulation.camera import Floats
from tests.simulation.light import Light
from tests.simulation.paint import Layer, Plate, Stencil, body_outline, pane_area
from tests.simulation.shape import Shape


def spoke_count(shape: Shape) -> int:
    """5, 7 or 9, by the vehicle."""
    return 5 + shape.vehicle.seed % 3 * 2


def wheel_plates(shape: Shape, light: Light, ppm: float, turns: int, spin_blur: float) -> tuple[Plate, ...]:
    """A wheel seen square on, its centre at (0, 0), in `turns` steps from one spoke to the next."""
    r, tone = shape.radius_m, np.array([1.02, 1.0, 0.98]) * (0.30 if light.low else 1.0)
    stencil = Stencil(-r - 0.03, r + 0.03, -r - 0.03, r + 0.03, ppm)
    tyre = Layer(stencil.size)
    along, z = stencil.grid()
    radius, angle = np.hypot(along, z), np.arctan2(z, along)
    rubber = 36 + 16 * np.clip(z / r, -0.3, 1) + 9 * np.exp(-(((radius - 0.87 * r) / 0.012) ** 2))
    tyre.lay(stencil.disc((0, 0), r), rubber[..., None] * tone)
    rim = r * (0.70 if shape.vehicle.style.name != "lorry" else 0.62)
    inner, hub = stencil.disc((0, 0), rim), stencil.disc((0, 0), 0.13 * rim)
    tyre.lay(inner, 46.0 * tone)
    silver = (128 + 62 * np.clip(z / rim * 0.8 + 0.2, -0.6, 1))[..., None] * tone
    ring = np.clip(1 - np.abs(radius - 0.93 * rim) / (0.075 * rim), 0, 1)
    count, out = spoke_count(shape), []
    for turn in np.arange(turns) * (2 * np.pi / count / turns):
        spokes = np.zeros_like(angle)
        for part in (-0.33, 0.0, 0.33):
            spokes += np.clip(np.cos(count * (angle + turn + part * spin_blur)) * 3 + 0.6, 0, 1) / 3
        spokes = np.where(radius < 0.24 * rim, 1, spokes) * (radius < 0.95 * rim)
        layer = tyre.copy()
        layer.lay((np.clip(np.maximum(spokes, ring * 1.4), 0, 1) * inner).astype(np.float32), silver)
        layer.tint(hub, 0.62)
        out.append(layer.plate(stencil))
    return tuple(out)


def tyre_plate(shape: Shape, light: Light, ppm: float) -> Plate:
    """The tyre's inner shoulder, seen behind the wheel when looking obliquely: a plain dark disc."""
    r = shape.radius_m
    stencil = Stencil(-r - 0.03, r + 0.03, -r - 0.03, r + 0.03, ppm)
    layer = Layer(stencil.size)
    layer.lay(stencil.disc((0, 0), r), np.array([30.0, 29.0, 29.0]) * (0.30 if light.low else 1.0))
    return layer.plate(stencil)


def driver_plate(shape: Shape, light: Light, ppm: float) -> Plate:
    """The driver, in profile: the eye is a dark spot whose centre is at the true eye height."""
    vehicle = shape.vehicle
    eye_l, eye_z = eye_point(shape)
    stencil = Stencil(eye_l - 0.75, eye_l + 0.75, eye_z - 0.85, eye_z + 0.24, ppm)
    layer = Layer(stencil.size)
    dim = 0.62 if light.low else 1.0
    rng = np.random.default_rng(vehicle.seed)
    skin = (
        np.array([(128, 158, 205), (112, 140, 190), (70, 96, 140), (136, 166, 214)][int(rng.integers(4))])
        * dim
    )
    hair = np.array([(30, 40, 58), (24, 24, 26), (70, 96, 120), (120, 124, 128)][int(rng.integers(4))]) * dim
    coat = np.array(
        [(120, 70, 40), (60, 60, 64), (70, 70, 150), (150, 150, 150), (60, 90, 70)][int(rng.integers(5))]
    )
    e = np.array([eye_l, eye_z])

    def poly(points: list[tuple[float, float]]) -> np.ndarray:
        return np.asarray(e + np.array(points))

    seat = poly([(-0.42, -0.9), (-0.36, -0.35), (-0.40, -0.12), (-0.30, -0.08), (-0.18, -0.42), (0.0, -0.9)])
    layer.lay(stencil.area(seat), np.array([52.0, 50.0, 50.0]) * dim)
    rest = poly([(-0.38, -0.13), (-0.38, 0.07), (-0.30, 0.10), (-0.25, 0.06), (-0.26, -0.12)])
    layer.lay(stencil.area(rest), np.array([44.0, 42.0, 42.0]) * dim)
    torso = poly([(-0.32, -0.9), (-0.30, -0.38), (-0.22, -0.23), (-0.10, -0.18), (0.0, -0.28), (0.06, -0.9)])
    layer.lay(stencil.area(torso), coat * dim)
    arm = poly([(-0.16, -0.30), (0.10, -0.50), (0.38, -0.36)])
    layer.lay(stencil.line(arm, 0.085), coat * dim * 0.84)
    wheel = poly([(0.37, -0.58), (0.48, -0.24)])
    layer.lay(stencil.line(wheel, 0.03), np.array([22.0, 22.0, 22.0]) * dim)
    layer.lay(stencil.disc((eye_l + 0.40, eye_z - 0.36), 0.045), skin)
    neck = poly([(-0.155, -0.26), (-0.15, -0.06), (-0.02, -0.10), (-0.035, -0.24)])
    layer.lay(stencil.area(neck), skin * 0.86)
    head = poly(
        [(-0.165, 0.04), (-0.15, 0.10), (-0.08, 0.135), (0.0, 0.12), (0.03, 0.06), (0.035, 0.01),
         (0.06, -0.035),
         (0.045, -0.05), (0.04, -0.09), (0.01, -0.118), (-0.05, -0.10), (-0.12, -0.07), (-0.16, -0.02)]
    )  # fmt: skip
    layer.lay(stencil.area(head), skin)
    mane = poly(
        [(-0.17, -0.03), (-0.175, 0.06), (-0.15, 0.12), (-0.08, 0.15), (0.0, 0.135), (0.035, 0.085),
         (0.0, 0.075),
         (-0.055, 0.06), (-0.065, 0.0), (-0.10, -0.045), (-0.14, -0.07)]
    )  # fmt: skip
    layer.lay(stencil.area(mane), hair)
    layer.lay(stencil.disc((eye_l - 0.075, eye_z - 0.012), 0.022), skin * 0.88)
    layer.lay(stencil.disc((eye_l, eye_z), 0.021), np.array([225.0, 228.0, 230.0]) * dim)
    layer.lay(stencil.disc((eye_l, eye_z), 0.015), np.array([18.0, 18.0, 20.0]) * dim)
    return layer.plate(stencil)


def eye_point(shape: Shape) -> tuple[float, float]:
    """(l, z) of the driver's eye, metres."""
    return shape.vehicle.style.eye_at_m * shape.sl, shape.vehicle.eye_height_m


def _seat_parts(shape: Shape) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """Backs and head rests of the empty seats, polygons in the local plane."""
    eye_l = eye_point(shape)[0]
    shoulder = shape.vehicle.model.eye_height_m - 0.20
    rows = (0.40,) if shape.vehicle.style.name in ("van", "lorry") else (0.40, 1.20)
    back = [(-0.06, 0.3), (-0.06, shoulder), (0.02, shoulder + 0.03), (0.12, 0.62), (0.5, 0.5), (0.5, 0.3)]
    rest = [
        (-0.05, shoulder + 0.04),
        (-0.04, shoulder + 0.15),
        (0.02, shoulder + 0.15),
        (0.03, shoulder + 0.04),
    ]
    shift = [np.array([eye_l - behind, 0.0]) for behind in rows]
    return [np.array(back) + s for s in shift], [np.array(rest) + s for s in shift]


def seats_area(shape: Shape, stencil: Stencil) -> Floats:
    """Coverage of the empty seats."""
    backs, rests = _seat_parts(shape)
    return stencil.area(*backs, *rests)


def seats_plate(shape: Shape, light: Light, ppm: float) -> Plate:
    """The empty seats beside and behind the driver, with head rests."""
    stencil = Stencil(0.0, shape.length_m, 0.3, shape.vehicle.roof_height_m, ppm)
    layer = Layer(stencil.size)
    dim = 0.34 if light.low else 1.0
    backs, rests = _seat_parts(shape)
    layer.lay(stencil.area(*backs), np.array([58.0, 56.0, 56.0]) * dim)
    layer.lay(stencil.area(*rests), np.array([50.0, 48.0, 48.0]) * dim)
    return layer.plate(stencil)


def far_side_plate(shape: Shape, light: Light, ppm: float) -> Plate:
    """The inner face of the far side: dark trim below the belt, open windows above it."""
    stencil = Stencil(-0.05, shape.length_m + 0.05, 0.1, shape.vehicle.roof_height_m + 0.05, ppm)
    layer = Layer(stencil.size)
    dim = 0.30 if light.low else 1.0
    body = stencil.area(body_outline(shape))
    if shape.vehicle.style.name == "lorry":
        layer.lay(
            stencil.area(
                np.array([[0.1, 0.62], [7.2 * shape.sl, 0.62], [7.2 * shape.sl, 0.95], [0.1, 0.95]])
            ),
            (30 * dim, 30 * dim, 30 * dim),
        )
    layer.lay(body, np.array([46.0, 45.0, 44.0]) * dim)
    glass = pane_area(shape, stencil)
    layer.cut(glass * 0.86)
    soft = cv2.GaussianBlur(layer.alpha[..., 0], (0, 0), 1.0)
    layer.colour *= (0.9 + 0.1 * soft)[..., None]
    return layer.plate(stencil)


def mirror_plate(shape: Shape, light: Light, ppm: float) -> Plate:
    """The door mirror on the near side, a rounded shell in the car's paint."""
    style = shape.vehicle.style
    at, _ = shape.at(style.windscreen[0], 0)
    lorry = style.name == "lorry"
    at = at - (0.02 if lorry else 0.42 * shape.sl)
    z = float(shape.belt(np.array(at))) + (0.22 if lorry else 0.085)
    stencil = Stencil(at - 0.25, at + 0.3, z - 0.3, z + 0.4, ppm)
    layer = Layer(stencil.size)
    dim = 0.36 if light.low else 1.0
    if lorry:
        layer.lay(
            stencil.area(
                np.array([[at, z - 0.22], [at + 0.2, z - 0.22], [at + 0.2, z + 0.32], [at, z + 0.32]])
            ),
            np.array([36.0, 35.0, 34.0]) * dim,
        )
        return layer.plate(stencil)
    shell = np.array(
        [[-0.10, -0.06], [0.06, -0.075], [0.10, -0.02], [0.07, 0.06], [-0.04, 0.085], [-0.11, 0.06]]
    )
    layer.lay(stencil.area(shell + np.array([at, z])), np.array(shape.vehicle.paint) * 0.82 * dim)
    layer.lay(stencil.area(shell * (1, 0.45) + (at, z - 0.04)), np.array(shape.vehicle.paint) * 0.55 * dim)
    layer.lay(
        stencil.area(
            np.array([[0.05, -0.06], [0.12, -0.11], [0.16, -0.11], [0.09, -0.03]]) + np.array([at, z])
        ),
        np.array([30.0] * 3) * dim,
    )
    return layer.plate(stencil)
