"""What stands beyond the road: houses, trees, a hedge, a guard rail, lamp posts, and the sky above."""

import cv2
import numpy as np

from backend.demonstration.camera import Array, Floats
from backend.demonstration.light import Light
from backend.demonstration.paint import Plate

Canvas = Floats


def sky_colours(light: Light, seed: int, a: Floats, b: Floats) -> Floats:
    """Sky (h, w, 3): a gradient with soft clouds by day, deep blue above an afterglow in low light."""
    up = np.clip(b / 0.6, 0, 1)[..., None]
    low, high = np.array(light.horizon, np.float32), np.array(light.zenith, np.float32)
    colour = low + (high - low) * up**0.8
    rng = np.random.default_rng(seed + 77)
    small = np.zeros((96, 160), np.float32)
    for sigma, weight in ((3, 0.5), (7, 1.0), (15, 1.1)):
        white = cv2.GaussianBlur(rng.standard_normal((96, 160)).astype(np.float32), (0, 0), sigma)
        small += weight * white / white.std()
    u, v = (a * 28 + 50).astype(np.float32), (30 - b * 60).astype(np.float32) % 95
    cloud = np.clip(cv2.remap(small, u, v, cv2.INTER_CUBIC, borderMode=cv2.BORDER_REFLECT) * 0.45 + 0.1, 0, 1)
    white = np.array([250, 249, 247] if not light.low else [96, 74, 66], np.float32)
    return np.asarray(colour * (1 - 0.75 * cloud[..., None]) + white * 0.75 * cloud[..., None], np.float32)


def _canvas(left: float, right: float, top: float, ppm: float) -> Canvas:
    return np.zeros((int(top * ppm), int((right - left) * ppm), 4), np.float32)


def _rect(
    canvas: Canvas,
    ppm: float,
    left: float,
    top: float,
    box: tuple[float, float, float, float],
    ink: tuple[float, float, float],
) -> None:
    x0, z0, x1, z1 = box
    p, q = (
        (round((x0 - left) * ppm), round((top - z1) * ppm)),
        (round((x1 - left) * ppm), round((top - z0) * ppm)),
    )
    cv2.rectangle(canvas, p, q, (*ink, 255.0), -1)


def _shift(ink: tuple[float, float, float], by: float) -> tuple[float, float, float]:
    return (ink[0] + by, ink[1] + by, ink[2] + by)


def _house(
    canvas: Canvas,
    ppm: float,
    left: float,
    top: float,
    at: float,
    wide: float,
    eaves: float,
    ink: tuple[float, float, float],
    rng: np.random.Generator,
) -> None:
    """A plastered or brick front with a tiled roof, windows with frames and sills, and a door."""
    roof = (62 + rng.uniform(-8, 8), 72 + rng.uniform(-8, 8), 128 + rng.uniform(-30, 20))
    ridge = eaves + wide * 0.28
    pts = np.array(
        [[at - 0.3, eaves], [at + wide + 0.3, eaves], [at + wide * 0.86, ridge], [at + wide * 0.14, ridge]]
    )
    px = np.round(np.stack([(pts[:, 0] - left) * ppm, (top - pts[:, 1]) * ppm], -1)).astype(np.int32)
    cv2.fillPoly(canvas, [px], (*roof, 255.0))
    for z in np.arange(eaves, ridge, 0.3):
        t = (z - eaves) / (ridge - eaves)
        x0, x1 = at - 0.3 + t * (0.3 + wide * 0.14), at + wide + 0.3 - t * (0.3 + wide * 0.14)
        _rect(canvas, ppm, left, top, (x0 + 0.1, z, x1 - 0.1, z + 0.05), _shift(roof, -14))
    _rect(canvas, ppm, left, top, (at, 0, at + wide, eaves), ink)
    _rect(canvas, ppm, left, top, (at, 0, at + wide, 0.5), _shift(ink, -38))
    _rect(canvas, ppm, left, top, (at, eaves - 0.18, at + wide, eaves), _shift(ink, -48))
    chimney = at + wide * rng.uniform(0.25, 0.7)
    _rect(canvas, ppm, left, top, (chimney, ridge - 0.4, chimney + 0.6, ridge + 0.8), (58, 66, 104))
    columns = max(2, int(wide / 2.4))
    for storey in range(int(eaves // 2.7)):
        for column in range(columns):
            x = at + (column + 0.5) * wide / columns
            z = 0.95 + 2.75 * storey
            if storey == 0 and column == columns // 2:
                _rect(canvas, ppm, left, top, (x - 0.55, 0, x + 0.55, 2.2), _shift(ink, -20))
                _rect(canvas, ppm, left, top, (x - 0.45, 0, x + 0.45, 2.1), (52, 60, 58))
                continue
            _rect(canvas, ppm, left, top, (x - 0.6, z - 0.1, x + 0.6, z + 1.42), (214, 216, 216))
            _rect(canvas, ppm, left, top, (x - 0.52, z, x + 0.52, z + 1.34), (92, 82, 74))
            _rect(canvas, ppm, left, top, (x - 0.48, z + 0.7, x + 0.1, z + 1.3), (142, 128, 114))
            _rect(canvas, ppm, left, top, (x - 0.03, z, x + 0.03, z + 1.34), (206, 208, 208))


def _tree(
    canvas: Canvas,
    ppm: float,
    left: float,
    top: float,
    at: float,
    height: float,
    wide: float,
    rng: np.random.Generator,
) -> None:
    """A trunk and some hundreds of leaf clumps, lighter toward the sun at the upper left."""
    trunk = (46.0, 62.0, 78.0)
    _rect(canvas, ppm, left, top, (at - 0.13, 0, at + 0.13, height * 0.5), trunk)
    hue = rng.uniform(-12, 12)
    count = int(260 * wide / 3)
    turn, reach = rng.uniform(0, 2 * np.pi, count), np.sqrt(rng.uniform(0, 1, count))
    x = at + np.cos(turn) * reach * wide / 2 * rng.uniform(0.85, 1.1, count)
    z = height * 0.66 + np.sin(turn) * reach * height * 0.33
    light = 0.55 * (z - height * 0.66) / (height * 0.33) - 0.35 * (x - at) / (wide / 2)
    for i in np.argsort(light + rng.normal(0, 0.25, count)):
        tone = 30 * light[i] + rng.normal(0, 8)
        ink = (44 + 0.6 * tone, 88 + tone + hue * 0.4, 72 + 0.9 * tone + hue)
        centre = (round((x[i] - left) * ppm), round((top - z[i]) * ppm))
        axes = (max(1, round(rng.uniform(0.14, 0.34) * ppm)), max(1, round(rng.uniform(0.10, 0.24) * ppm)))
        cv2.ellipse(canvas, centre, axes, float(rng.uniform(0, 180)), 0, 360, (*ink, 255.0), -1)


def _hedge(
    canvas: Canvas, ppm: float, left: float, right: float, top: float, height: float, rng: np.random.Generator
) -> None:
    _rect(canvas, ppm, left, top, (left, 0, right, height * 0.86), (40, 70, 58))
    count = int((right - left) * 46)
    x, z = rng.uniform(left, right, count), height * rng.uniform(0.02, 1.0, count)
    for i in np.argsort(z + rng.normal(0, 0.3 * height, count)):
        tone = 34 * (z[i] / height - 0.45) + rng.normal(0, 8)
        ink = (42 + 0.5 * tone, 86 + tone, 70 + tone)
        centre = (round((x[i] - left) * ppm), round((top - z[i]) * ppm))
        cv2.ellipse(
            canvas,
            centre,
            (max(1, round(0.11 * ppm)), max(1, round(0.07 * ppm))),
            float(rng.uniform(0, 180)),
            0,
            360,
            (*ink, 255.0),
            -1,
        )


def _rail(canvas: Canvas, ppm: float, left: float, right: float, top: float) -> None:
    """A steel guard rail: posts and a beam with its two waves."""
    for x in np.arange(left + 0.6, right, 2.0):
        _rect(canvas, ppm, left, top, (x - 0.05, 0, x + 0.05, 0.62), (112, 114, 114))
    for z, tone in (
        (0.44, 150),
        (0.475, 182),
        (0.51, 160),
        (0.545, 118),
        (0.58, 150),
        (0.615, 190),
        (0.65, 168),
        (0.685, 132),
    ):
        _rect(canvas, ppm, left, top, (left, z, right, z + 0.035), (tone + 2.0, tone, tone - 2.0))


def _post(canvas: Canvas, ppm: float, left: float, top: float, at: float, height: float) -> None:
    _rect(canvas, ppm, left, top, (at - 0.06, 0, at + 0.06, height), (108, 112, 110))
    _rect(canvas, ppm, left, top, (at - 0.9, height - 0.10, at + 0.04, height), (108, 112, 110))
    _rect(canvas, ppm, left, top, (at - 1.35, height - 0.14, at - 0.75, height + 0.02), (150, 154, 154))


def _finish(canvas: Canvas, left: float, top: float, ppm: float, light: Light, haze: float) -> Plate:
    """Premultiplies, softens, adds haze with distance, and turns day into dusk."""
    soft = cv2.GaussianBlur(canvas, (0, 0), 0.6)
    alpha = soft[..., 3:] / 255
    if light.low:
        soft[..., :3] *= np.array([0.20, 0.155, 0.13], np.float32)
    else:
        air = np.array([232, 226, 214], np.float32)
        soft[..., :3] = soft[..., :3] * (1 - haze) + air * alpha * haze
    soft.flags.writeable = False
    return Plate(np.asarray(soft, np.float32), ppm, left, top)


def street_plates(light: Light, seed: int) -> list[tuple[Plate, float]]:
    """Plates and the Y they stand at, the farthest first."""
    rng = np.random.default_rng(1000 + seed // 100)
    left, right = -14.0, 62.0
    far = _canvas(left, right, 16.0, 16)
    for x in np.arange(left, right, 1.6):
        _tree(far, 16, left, 16.0, x + rng.uniform(-0.8, 0.8), rng.uniform(4.0, 8.5), rng.uniform(3, 5), rng)
    out = [(_finish(far, left, 16.0, 16, light, 0.34), 34.0)]
    row = _canvas(left, 46.0, 13.0, 28)
    x = left
    while x < 44:
        wide = rng.uniform(6.5, 10)
        ink = [(178, 200, 214), (196, 204, 206), (112, 128, 168), (168, 190, 200)][int(rng.integers(4))]
        if rng.uniform() < 0.78:
            _house(
                row,
                28,
                left,
                13.0,
                x,
                wide,
                float(rng.choice([3.2, 5.8, 5.8])),
                (float(ink[0]), float(ink[1]), float(ink[2])),
                rng,
            )
        else:
            for k in range(3):
                _tree(row, 28, left, 13.0, x + 1 + 2.4 * k, rng.uniform(4.5, 7.5), 3.2, rng)
        x += wide + rng.uniform(0.6, 3.5)
    out.append((_finish(row, left, 13.0, 28, light, 0.16), 19.0))
    trees = _canvas(left, 34.0, 9.0, 42)
    for x in (-6.0, 1.4, 8.2, 13.0, 21.5, 29.0):
        _tree(
            trees,
            42,
            left,
            9.0,
            x + rng.uniform(-0.6, 0.6),
            rng.uniform(4.2, 6.4),
            rng.uniform(2.6, 3.6),
            rng,
        )
    out.append((_finish(trees, left, 9.0, 42, light, 0.07), 12.5))
    hedge = _canvas(-9.0, 26.0, 2.0, 56)
    _hedge(hedge, 56, -9.0, 26.0, 2.0, 1.05, rng)
    out.append((_finish(hedge, -9.0, 2.0, 56, light, 0.04), 9.4))
    rail = _canvas(-7.0, 24.0, 7.0, 64)
    _rail(rail, 64, -7.0, 24.0, 7.0)
    _post(rail, 64, -7.0, 7.0, 5.2, 6.2)
    _post(rail, 64, -7.0, 7.0, 19.0, 6.2)
    out.append((_finish(rail, -7.0, 7.0, 64, light, 0.02), 7.6))
    return out


def lit_windows(seed: int) -> Array:
    """Road points (N, 3) of lit house windows in low light."""
    rng = np.random.default_rng(seed + 31)
    return np.stack([rng.uniform(-8, 34, 12), np.full(12, 18.9), rng.choice([1.6, 4.3], 12)], -1)
