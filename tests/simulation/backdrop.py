"""The empty road: asphalt, markings, verge, scenery, sky; drawn once per scene, twice as fine."""

from functools import lru_cache

import cv2
import numpy as np

from tests.simulation.camera import Array, DemoCamera, Floats, slope_maps
from tests.simulation.light import Light
from tests.simulation.paint import around
from tests.simulation.scene import Scene
from tests.simulation.scenery import sky_colours, street_plates

TILE_PPM, TILE_M = 96, 8.0


def noise_tile(seed: int, octaves: tuple[tuple[float, float], ...], size: int) -> Floats:
    """A tile that wraps around: sum of blurred white noises (sigma in pixels, weight)."""
    rng = np.random.default_rng(seed)
    total = np.zeros((size, size), np.float32)
    for sigma, weight in octaves:
        white: Floats = rng.standard_normal((size, size)).astype(np.float32)
        if sigma > 0:
            pad = int(4 * sigma) + 1
            white = cv2.GaussianBlur(np.pad(white, pad, mode="wrap"), (0, 0), sigma)[pad:-pad, pad:-pad]
        total += weight * white / max(float(white.std()), 1e-9)
    return total


def _sample(tile: Floats, x: Floats, y: Floats, ppm: float) -> Floats:
    size = tile.shape[0]
    u = np.mod(x * ppm, size).astype(np.float32)
    v = np.mod(y * ppm, size).astype(np.float32)
    return np.asarray(cv2.remap(tile, u, v, cv2.INTER_LINEAR, borderMode=cv2.BORDER_WRAP), np.float32)


def _band(y: Floats, low: float, high: float, soft: Floats) -> Floats:
    """1 inside low..high with edges as soft as a pixel is long."""
    return np.asarray(np.clip((y - low) / soft + 0.5, 0, 1) * np.clip((high - y) / soft + 0.5, 0, 1))


def ground_colour(camera: DemoCamera, seed: int, low: bool, a: Floats, b: Floats) -> tuple[Floats, Floats]:
    """Colour of the ground (h, w, 3) for rays below the horizon, and the mask of those rays."""
    mask = b < -0.004
    away = np.where(mask, -camera.centre_m[2] / np.minimum(b, -0.004), 300).astype(np.float32)
    x = (camera.centre_m[0] + away * a).astype(np.float32)
    y = (camera.centre_m[1] + away).astype(np.float32)
    soft = (away * away / (camera.centre_m[2] * 480 * 2) + 0.004).astype(np.float32)
    size = int(TILE_PPM * TILE_M)
    grain = noise_tile(seed, ((0.0, 0.4), (1.0, 0.55), (2.2, 0.35)), size)
    cloud = noise_tile(seed + 1, ((18.0, 0.6), (60.0, 0.8)), size)
    fade = np.clip(1.6 / (1 + soft * 28), 0, 1)
    rough, patch = _sample(grain, x, y, TILE_PPM) * fade, _sample(cloud, x, y, TILE_PPM)
    tone = 127 + 8.5 * rough + 5.0 * patch
    tone -= 7 * np.exp(-(((y - 0.28) / 0.28) ** 2)) + 7 * np.exp(-(((y - 1.72) / 0.28) ** 2))
    tone -= 6 * np.exp(-(((y - 2.75) / 0.28) ** 2)) + 6 * np.exp(-(((y - 4.2) / 0.28) ** 2))
    tone -= 5 * np.exp(-(((y - 1.0) / 0.22) ** 2)) * (1 + 0.5 * patch)
    colour = np.asarray(tone[..., None] * np.array([0.985, 1.0, 1.012], np.float32), np.float32)
    _cracks(colour, x, y, soft, seed)
    _markings(colour, x, y, soft, rough, patch)
    _verges(colour, x, y, soft, seed, rough, patch)
    return colour, mask


def _lay(colour: Floats, mask: Floats, paint: object) -> None:
    """Covers with a colour, or a picture of colours, where the mask is."""
    at = around(mask)
    m, ink = mask[at][..., None], np.asarray(paint, np.float32)
    colour[at] = colour[at] * (1 - m) + (ink[at] if ink.ndim == 3 else ink) * m


def _cracks(colour: Floats, x: Floats, y: Floats, soft: Floats, seed: int) -> None:
    """Tar lines that wander along and across the road, and a repair patch."""
    rng = np.random.default_rng(seed + 5)
    for _ in range(5):
        x0, y0, bend = rng.uniform(-1, 9), rng.uniform(-0.4, 4.5), rng.uniform(0.05, 0.2)
        path = y0 + bend * np.sin(1.9 * (x - x0)) + 0.05 * np.sin(7 * x + x0)
        near = np.exp(-(((y - path) / (0.012 + 0.5 * soft)) ** 2)) * (np.abs(x - x0) < rng.uniform(0.6, 1.9))
        _lay(colour, (near * 0.55 * np.clip(0.02 / soft, 0, 1)).astype(np.float32), (58, 58, 60))
    patch = _band(y, 2.62, 3.9, soft) * _band(x, 3.3, 5.9, soft)
    _lay(colour, (patch * 0.22).astype(np.float32), (78, 78, 80))


def _markings(colour: Floats, x: Floats, y: Floats, soft: Floats, rough: Floats, patch: Floats) -> None:
    worn = np.clip(0.80 + 0.10 * rough + 0.10 * patch, 0, 0.95)
    dash = _band(np.mod(x + 1.2, 4.5).astype(np.float32), 0.0, 2.2, np.full_like(soft, 0.02))
    centre = _band(y, 2.16, 2.28, soft) * dash
    edges = _band(y, -0.52, -0.40, soft) + _band(y, 4.92, 5.04, soft)
    _lay(colour, np.clip((centre + edges) * worn, 0, 1).astype(np.float32), (218, 221, 222))


def _verges(
    colour: Floats, x: Floats, y: Floats, soft: Floats, seed: int, rough: Floats, patch: Floats
) -> None:
    size = int(TILE_PPM * TILE_M)
    blades = noise_tile(seed + 9, ((0.8, 0.6), (2.5, 0.6), (9.0, 0.7)), size)
    turf = _sample(blades, x, y * 0.6, TILE_PPM * 0.8) * np.clip(0.7 / (1 + soft * 5), 0.12, 1)
    green = np.stack([58 + 11 * turf, 104 + 20 * turf + 6 * patch, 92 + 20 * turf + 8 * patch], -1)
    stone = (148 + 7 * rough + 6 * patch)[..., None] * np.array([0.985, 1.0, 1.01], np.float32)
    slab = _band(np.mod(x, 1.0).astype(np.float32), 0.0, 0.025, soft * 0.6 + 0.006)
    kerb = (176 + 5 * rough)[..., None] * np.array([1.0, 1.0, 0.995], np.float32)
    far = np.full_like(soft, 400)
    _lay(colour, _band(y, 5.28, 5.40, soft), (64, 66, 68))
    _lay(colour, _band(y, 5.40, 5.58, soft), kerb)
    _lay(colour, _band(y, 5.58, 7.3, soft), stone)
    _lay(colour, (_band(y, 5.40, 7.3, soft) * slab * 0.35).astype(np.float32), (96, 98, 100))
    _lay(colour, np.minimum(_band(y, 7.3, 400, soft), far), green)
    _lay(colour, _band(y, -3, -0.86, soft), green * 0.96)


def lamp_pool(camera: DemoCamera, a: Floats, b: Floats) -> Floats:
    """Gain (h, w, 3) of a street lamp over the road for rays that meet the ground."""
    away = np.where(b < -0.004, -camera.centre_m[2] / np.minimum(b, -0.004), 300)
    x, y = camera.centre_m[0] + away * a, camera.centre_m[1] + away
    near = np.exp(-(((x - 1.6) / 3.4) ** 2) - ((y - 1.4) / 3.0) ** 2)
    second = np.exp(-(((x - 15.0) / 4.0) ** 2) - ((y - 4.0) / 3.5) ** 2)
    gain = 0.16 + 0.58 * near + 0.36 * second
    warm = np.array([0.72, 0.90, 1.06], np.float32)
    cold = np.array([0.235, 0.190, 0.162], np.float32)
    out: Array = cold + (gain - 0.16)[..., None] * warm
    return out.astype(np.float32)


def _finish(picture: Floats, low: bool) -> Floats:
    """By day a little more contrast and colour; in low light the bloom of lamps and lit windows."""
    if low:
        bright = np.clip(picture - 120, 0, None)
        halo = cv2.GaussianBlur(bright, (0, 0), 3) * 0.35 + cv2.GaussianBlur(bright, (0, 0), 14) * 0.9
        return np.asarray(picture + halo, np.float32)
    grey = picture.mean(-1, keepdims=True)
    out = (grey + (picture - grey) * 1.09 - 110) * 1.07 + 112
    return np.asarray(np.clip(out, 0, 252), np.float32)


def backdrop(scene: Scene) -> Floats:
    """The empty road (480, 640, 3) float32 BGR, without sensor effects."""
    out = empty_road(scene.camera, scene.light, scene.seed)
    out.flags.writeable = False
    return out


@lru_cache(maxsize=4)
def empty_road(camera: DemoCamera, light: Light, seed: int) -> Floats:
    """The same whatever drives on it: some seconds to draw (`tests/support/drawn.py`)."""
    low = light.low
    a, b = slope_maps(camera, 2)
    ground, mask = ground_colour(camera, seed, low, a, b)
    if low:
        ground *= lamp_pool(camera, a, b)
    picture: Floats = np.where(mask[..., None], ground, sky_colours(light, seed, a, b)).astype(np.float32)
    for plate, y_m in street_plates(light, seed):
        away = np.float32(y_m - camera.centre_m[1])
        u = (camera.centre_m[0] + away * a - plate.left_m) * np.float32(plate.ppm) - np.float32(0.5)
        v = (plate.top_m - camera.centre_m[2] - away * b) * np.float32(plate.ppm) - np.float32(0.5)
        rgba = cv2.remap(plate.rgba, u, v, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=0)
        picture = picture * (1 - rgba[..., 3:] / 255) + rgba[..., :3]
    small = cv2.resize(picture, (camera.width_px, camera.height_px), interpolation=cv2.INTER_AREA)
    return _finish(np.asarray(small, np.float32), low)
