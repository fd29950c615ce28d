"""Everything on a vehicle's near side: panels, windows, seams, lamps; and its wheels and occupants."""

import cv2
import numpy as np

from tests.simulation.camera import Array, Floats
from tests.simulation.light import Light
from tests.simulation.paint import (
    Layer,
    Plate,
    Stencil,
    around,
    body_outline,
    glass_area,
    less_pillars,
    painted_body,
)
from tests.simulation.shape import Shape


def _rect(l0: float, z0: float, l1: float, z1: float) -> np.ndarray:
    return np.array([[l0, z0], [l1, z0], [l1, z1], [l0, z1]])


def tail_lamp_box(shape: Shape) -> tuple[float, float, float, float]:
    """The tail lamp on the near side: l0, l1 from the rear, its LOWER EDGE (of the lit area), its top."""
    style = shape.vehicle.style
    wide, high = style.tail_lamp
    lower = shape.vehicle.tail_lamp_m
    start = 0.12 if style.name == "lorry" else 0.0
    return start, start + wide * shape.sl, lower, lower + high


def tail_lamp_area(shape: Shape) -> np.ndarray:
    """The lamp's polygon: a level lower edge, an upper edge that tapers forward."""
    l0, l1, z0, z1 = tail_lamp_box(shape)
    if shape.vehicle.style.name in ("van", "lorry"):
        return _rect(l0, z0, l1, z1)
    return np.array(
        [[l0 - 0.05, z0], [l1 * 0.80, z0], [l1, z0 + 0.62 * (z1 - z0)], [l1 * 0.72, z1], [l0 - 0.05, z1]]
    )


def head_lamp_area(shape: Shape) -> np.ndarray:
    """The headlamp's polygon, swept back."""
    style = shape.vehicle.style
    l0, z0, z1 = style.head_lamp
    low, high = shape.at(l0, z0), shape.at(l0, z1)
    end = shape.length_m + 0.02
    return np.array([[low[0] + 0.10, low[1]], [end, low[1] - 0.01], [end, low[1] + 0.07], [high[0], high[1]]])


def side_plate(shape: Shape, light: Light, ppm: float, eye_m: float, near_m: float, smear_m: float) -> Plate:
    """The near side as a texture; windows are partly see-through, arches are cut out."""
    stencil = Stencil(-0.08, shape.length_m + 0.08, 0.0, shape.vehicle.roof_height_m + 0.06, ppm)
    layer = Layer(stencil.size)
    body = stencil.area(body_outline(shape))
    layer.lay(body, painted_body(shape, light, stencil, eye_m, near_m))
    if shape.vehicle.style.name == "lorry":
        _lorry_side(shape, light, stencil, layer, body)
    else:
        _car_side(shape, light, stencil, layer, body)
    _windows(shape, light, stencil, layer)
    _lamps(shape, light, stencil, layer, body)
    for axle in shape.axles:
        layer.cut(stencil.disc((axle, shape.radius_m + 0.005), shape.radius_m + 0.045))
    rgba = layer.plate(stencil)
    return Plate(_smear(rgba.rgba, smear_m * ppm), ppm, stencil.left_m, stencil.top_m)


def _smear(rgba: Array, width_px: float) -> Array:
    """Motion during the exposure: a centred box along l."""
    size = max(1, round(width_px) // 2 * 2 + 1)
    return rgba if size < 3 else cv2.blur(rgba, (size, 1), borderType=cv2.BORDER_CONSTANT)


def _car_side(shape: Shape, light: Light, stencil: Stencil, layer: Layer, body: Floats) -> None:
    style, dim = shape.vehicle.style, 0.32 if light.low else 1.0
    black = np.array([40.0, 38.0, 37.0]) * dim
    _along, z = stencil.grid()
    sill = style.sill_m * shape.sz
    cladding = 0.16 if style.name == "suv" else 0.055
    layer.lay(body * np.clip((sill + cladding - z) * stencil.ppm + 0.5, 0, 1).astype(np.float32), black)
    for axle in shape.axles:
        ring = 0.10 if style.name == "suv" else 0.062
        arch = stencil.disc((axle, shape.radius_m + 0.005), shape.radius_m + ring) * body
        if style.name == "suv":
            layer.lay(arch, black)
        else:
            layer.tint(arch, 0.72)
    for shut in style.shuts:
        at_l, _ = shape.at(shut, 0)
        low, high = sill + 0.05, float(shape.belt(np.array(at_l)))
        seam = np.array([[at_l - 0.03, low], [at_l, low + 0.25], [at_l + 0.01, high]])
        layer.tint(stencil.line(seam, 0.012) * body, 0.35)
        layer.tint(stencil.line(seam + np.array([0.012, 0.0]), 0.008) * body, 1.18)
    for shut in style.shuts[:-1]:
        at_l, _ = shape.at(shut, 0)
        handle_z = float(shape.belt(np.array(at_l))) - 0.115
        layer.tint(
            stencil.area(_rect(at_l + 0.07, handle_z - 0.030, at_l + 0.24, handle_z - 0.012)) * body, 0.55
        )
        layer.tint(
            stencil.area(_rect(at_l + 0.07, handle_z - 0.012, at_l + 0.24, handle_z + 0.012)) * body, 1.22
        )
    if style.name == "van":
        _livery(shape, stencil, layer, body, dim)
        rail = np.array([[0.3, 1.06 * shape.sz], [2.6 * shape.sl, 1.06 * shape.sz]])
        layer.tint(stencil.line(rail, 0.03) * body, 0.5)
    bumper = stencil.line(np.array([[0.0, 0.50 * shape.sz], [0.22, 0.50 * shape.sz]]), 0.012)
    layer.tint(bumper * body, 0.45)


_FIRMS = ("NORDAL FRISK", "BRODVIK & CO", "TESMER BAD", "LUMO ELEKTRO", "OKSEN TRANSPORT", "VELDA MOBEL")


def _livery(shape: Shape, stencil: Stencil, layer: Layer, body: Floats, dim: float) -> None:
    """A firm's name and a stripe; drawn mirrored for vehicles whose front is at the left."""
    seed = shape.vehicle.seed
    lorry = shape.vehicle.style.name == "lorry"
    dark = not lorry and sum(shape.vehicle.paint) < 420
    inks = (
        ((236, 236, 234), (120, 220, 240))
        if dark
        else ((150, 60, 20), (30, 90, 20), (40, 40, 150), (20, 90, 170))
    )
    ink = np.array(inks[seed % len(inks)], float) * dim
    box = (0.5, 1.25, 5.0, 3.0) if lorry else (0.5, 1.15, 2.65, 1.6)
    l0, z0 = shape.at(box[0], box[1])
    l1, z1 = shape.at(box[2], box[3])
    fine = stencil.fine()
    text = _FIRMS[shape.vehicle.number % len(_FIRMS)]
    scale = stencil.ppm * 3
    face, thick = cv2.FONT_HERSHEY_DUPLEX, max(1, round(0.022 * (2.2 if lorry else 1) * scale))
    (w, _), _ = cv2.getTextSize(text, face, 1.0, thick)
    size = (l1 - l0) * 0.86 * scale / w
    at = (
        round((l0 - stencil.left_m + 0.07 * (l1 - l0)) * scale),
        round((stencil.top_m - (z0 + z1) / 2) * scale),
    )
    cv2.putText(fine, text, at, face, size, 1.0, thick, cv2.LINE_AA)
    if shape.vehicle.direction < 0:
        middle = round(((l0 + l1) / 2 - stencil.left_m) * scale)
        half = min(middle, fine.shape[1] - middle)
        fine[:, middle - half : middle + half] = fine[:, middle - half : middle + half][:, ::-1]
    layer.lay(stencil.shrink(fine) * body, ink, 0.92)
    stripe = np.array([[l0, z0 + 0.04], [l1, z0 + 0.10], [l1, z0 + 0.20], [l0, z0 + 0.08]])
    layer.lay(stencil.area(stripe) * body, ink, 0.85)


def _lorry_side(shape: Shape, light: Light, stencil: Stencil, layer: Layer, body: Floats) -> None:
    dim = 0.34 if light.low else 1.0
    at, rect = shape.at, _rect
    dark = np.array([44.0, 42.0, 40.0]) * dim
    box_end, box_low = at(5.35, 0.98)
    chassis = stencil.area(rect(0.10, 0.62 * shape.sz, at(7.2, 0)[0], 0.92 * shape.sz))
    layer.lay(chassis * (1 - body), dark)
    guard = stencil.area(rect(*at(2.75, 0.50), *at(4.9, 0.58)), rect(*at(2.75, 0.68), *at(4.9, 0.76)))
    layer.lay(guard, np.array([150.0, 150.0, 150.0]) * dim)
    layer.lay(stencil.area(rect(*at(4.55, 0.45), *at(5.25, 0.86))), np.array([62.0, 60.0, 58.0]) * dim)
    along, z = stencil.grid()
    box = stencil.area(rect(0.0, box_low, box_end, shape.vehicle.roof_height_m))
    shine = 190.0 + 26.0 * np.clip((z - 0.9) / 2.3, 0, 1) + 3.0 * np.sin(along * 2 * np.pi / 0.62)
    tone = np.array([1.0, 1.0, 0.985]) * (0.30 if light.low else 1.0)
    layer.lay(box, shine[..., None] * tone)
    for z_edge in (box_low + 0.03, shape.vehicle.roof_height_m - 0.03):
        layer.lay(
            stencil.line(np.array([[0, z_edge], [box_end, z_edge]]), 0.06) * box,
            (130 * dim, 128 * dim, 126 * dim),
        )
    for l_edge in (0.03, box_end - 0.03):
        layer.lay(
            stencil.line(np.array([[l_edge, box_low], [l_edge, 9]]), 0.06) * box,
            (120 * dim, 118 * dim, 116 * dim),
        )
    _livery(shape, stencil, layer, box, dim)
    for shut in shape.vehicle.style.shuts:
        at_l, _ = at(shut, 0)
        layer.tint(
            stencil.line(np.array([[at_l, at(0, 0.95)[1]], [at_l, at(0, 2.4)[1]]]), 0.016) * body * (1 - box),
            0.4,
        )
    layer.lay(stencil.area(rect(*at(6.02, 1.26), *at(6.2, 1.30))) * body, dark)
    layer.lay(stencil.area(rect(*at(6.9, 0.42), *at(7.4, 0.60))) * body, dark)


def _windows(shape: Shape, light: Light, stencil: Stencil, layer: Layer) -> None:
    """Glass: most of what is behind comes through, a little sky is mirrored, the rim is black."""
    style = shape.vehicle.style
    glass = glass_area(shape, stencil)
    rim = np.clip(cv2.GaussianBlur(glass, (0, 0), 0.012 * stencil.ppm) * 2.6, 0, 1)
    dim = 0.3 if light.low else 1.0
    layer.lay(np.asarray(rim, np.float32) * (layer.alpha[..., 0] > 0.5), (26 * dim, 25 * dim, 25 * dim))
    panes = less_pillars(shape, stencil, glass)
    layer.cut(panes)
    at = around(panes)
    along, z = (part[at] for part in stencil.grid())
    belt = shape.belt(along)
    rise = np.clip((z - belt) / 0.42, 0, 1)
    sky = np.array(light.horizon) * 0.42 + np.array(light.zenith) * 0.58
    bank = np.clip(0.5 + 0.5 * np.sin(3.1 * along - 1.4 * z + shape.vehicle.seed % 7), 0, 1)
    mirror = (0.07 + 0.15 * rise**1.3 + 0.05 * bank * rise)[..., None] * sky
    streak = np.exp(-((((along - 0.55 * z) % 1.6) - 0.7) ** 2) / 0.02)[..., None] * sky * 0.07
    see = np.clip(0.50 - 0.10 * rise, 0, 1).astype(np.float32)
    m = panes[at][..., None]
    tint = np.array([20.0, 22.0, 18.0]) * dim
    layer.colour[at] += m * (mirror + streak + tint * see[..., None]).astype(np.float32)
    layer.alpha[at] += m * see[..., None]
    sill = stencil.line(np.stack([stencil.along, shape.belt(stencil.along)], -1), 0.016)
    trim = np.clip(cv2.GaussianBlur(glass, (0, 0), 0.03 * stencil.ppm) * 4, 0, 1) * sill
    bright = style.name in ("saloon", "estate") and shape.vehicle.seed % 2 == 0
    layer.lay(
        np.asarray(trim, np.float32),
        np.array([196.0, 198.0, 200.0] if bright else [24.0, 24.0, 24.0]) * dim,
        0.85,
    )


def _lamps(shape: Shape, light: Light, stencil: Stencil, layer: Layer, body: Floats) -> None:
    lorry = shape.vehicle.style.name == "lorry"
    along, _z = stencil.grid()
    lamp = stencil.area(tail_lamp_area(shape)) * (1.0 if lorry else body)
    _tail_lamp(shape, light, stencil, layer, np.asarray(lamp, np.float32))
    head = stencil.area(head_lamp_area(shape)) * body
    glow = np.array([238.0, 236.0, 228.0]) if not light.low else np.array([250.0, 252.0, 250.0])
    shell = np.array([170.0, 165.0, 160.0]) if not light.low else np.array([205.0, 215.0, 220.0])
    tip = np.clip((along - shape.length_m + 0.34) / 0.16, 0, 1)[..., None]
    layer.lay(np.asarray(head, np.float32), shell * (1 - tip) + glow * tip)
    side = stencil.disc((shape.length_m - 0.95 * shape.sl, 0.72 * shape.sz), 0.022)
    layer.lay(side * body, (40, 150, 235) if not light.low else (60, 140, 250), 0.9)


def _tail_lamp(shape: Shape, light: Light, stencil: Stencil, layer: Layer, lamp: Floats) -> None:
    """Red lens, lit down to its lower edge; a dark rim above and ahead, a clear band, two bright cores."""
    along, z = stencil.grid()
    l0, l1, z0, z1 = tail_lamp_box(shape)
    u, v = (along - l0) / (l1 - l0), (z - z0) / (z1 - z0)
    red = np.array([44.0, 32.0, 186.0]) if not light.low else np.array([62.0, 52.0, 226.0])
    layer.lay(lamp, red)
    if shape.vehicle.style.name == "lorry":
        return
    rim = np.clip((u - 0.80) / 0.08, 0, 1) + np.clip((v - 0.90) / 0.05, 0, 1)
    layer.lay(lamp * np.clip(rim, 0, 1).astype(np.float32), red * 0.42)
    clear = np.clip(1 - np.abs(v - 0.72) / 0.10, 0, 1) * np.clip((0.62 - u) / 0.06, 0, 1)
    shell = np.array([176.0, 176.0, 200.0]) * (0.42 if light.low else 1.0)
    layer.lay(lamp * np.clip(clear * 2, 0, 1).astype(np.float32), shell)
    bar = np.clip(1.6 - np.abs(v - 0.28) / 0.15, 0, 1) * np.clip((0.74 - u) / 0.08, 0, 1)
    hot = np.array([92.0, 92.0, 252.0]) if not light.low else np.array([150.0, 158.0, 255.0])
    layer.lay(lamp * (0.75 * bar).astype(np.float32), hot)
