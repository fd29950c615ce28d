"""Records the traffic with both line cameras: chunks of lines, eight bits, nothing kept beyond a chunk.

Left out: mirrored surroundings that stand still while the paint moves, planes that lean, motion blur of rain.
"""

from collections.abc import Iterator
from functools import lru_cache

import cv2
import numpy as np

from tests.simulation.camera import Array, Floats, Image
from tests.simulation.scan_art import MARGIN_M, Wheel, body_of, row_edges_m
from tests.simulation.scan_rod import HeldRod, lay_rods
from tests.simulation.scan_traffic import ScanSite, ScanVehicle, baseline_at

CHUNK = 1024
_NOISE = 1 << 20


@lru_cache(maxsize=4)
def empty_line(site: ScanSite, camera: int) -> Floats:
    """The empty road (rows,) at full light: asphalt, kerb, rail, hedge, house, sky; one per camera."""
    edges = row_edges_m(site, camera)
    z = (edges[:-1] + edges[1:]) / 2
    rng = np.random.default_rng((site.seed, camera, 5))
    shift = 0.03 if camera == 2 else 0.0
    stops = (
        np.array([-0.5, 0.10, 0.115, 0.20, 0.215, 0.42, 0.44, 0.74, 0.76, 1.38, 1.44, 1.95, 2.1, 2.6]) + shift
    )
    tones = np.array([112.0, 118, 168, 164, 96, 104, 158, 146, 74, 66, 150, 162, 186, 196])
    line = np.interp(z, stops, tones)
    for scale_m, weight in ((0.012, 4.0), (0.05, 6.0), (0.2, 5.0)):
        knots = rng.standard_normal(int(4 / scale_m))
        line += weight * np.interp(z, np.arange(len(knots)) * scale_m - 0.6, knots)
    return np.asarray(line, np.float32)


@lru_cache(maxsize=4)
def _fixed_gain(site: ScanSite, camera: int) -> Floats:
    rng = np.random.default_rng((site.seed, camera, 6))
    return (1 + site.row_gain * rng.standard_normal(site.rows)).astype(np.float32)


@lru_cache(maxsize=1)
def _noise_pool(seed: int) -> Floats:
    return np.random.default_rng((seed, 7)).standard_normal(_NOISE, dtype=np.float32)


def _noise(site: ScanSite, rng: np.random.Generator, lines: int) -> Floats:
    """Normal noise (lines, rows); tall strips cut it from a pool at random places."""
    if site.rows <= 512:
        return rng.standard_normal((lines, site.rows), dtype=np.float32)
    pool = _noise_pool(site.seed)
    starts = rng.integers(0, _NOISE - site.rows, lines)
    signs = rng.choice(np.array([-1.0, 1.0], np.float32), lines)
    return np.stack(
        [pool[start : start + site.rows] * sign for start, sign in zip(starts, signs, strict=True)]
    )


def _illumination(site: ScanSite, time_s: Array) -> Floats:
    slow = site.drift * np.sin(2 * np.pi * time_s / site.drift_period_s + site.seed)
    lamps = site.flicker * np.sin(2 * np.pi * site.flicker_hz * time_s) ** 2
    return np.asarray((1 + slow) * (1 + lamps) * site.exposure, np.float32)


def _lay_vehicle(site: ScanSite, car: ScanVehicle, camera: int, edge_s: Array, scene: Floats) -> None:
    """Puts a vehicle over the scene (lines, rows) in place; `edge_s`: (lines + 1,) ends of the exposures."""
    first = camera == (2 if car.against else 1)
    behind = car.travelled_m(edge_s) - (0.0 if first else baseline_at(site, car))
    seen = np.flatnonzero((behind[1:] > -MARGIN_M) & (behind[:-1] < car.length_m + MARGIN_M))
    if not len(seen):
        return
    at = slice(int(seen[0]), int(seen[-1]) + 1)
    start, end = behind[at], behind[1:][at]
    # a vehicle that stands still is seen through a window of a tenth of a millimetre
    still = np.maximum(1e-4 - (end - start), 0) / 2
    start, end = start - still, end + still
    body = body_of(car, site, camera)
    light, through = body.ribbon.mean(start, end)
    scene[at] = light + through * scene[at]
    turned_m = car.travelled_m((edge_s[:-1] + edge_s[1:]) / 2)[at]
    for wheel in body.wheels:
        _lay_wheel(wheel, start, end, turned_m, scene[at])


def _lay_wheel(wheel: Wheel, start: Array, end: Array, turned_m: Array, scene: Floats) -> None:
    """A wheel over the scene, turned as far as the vehicle has rolled."""
    near = np.flatnonzero((end > wheel.hub_m - wheel.half_m) & (start < wheel.hub_m + wheel.half_m))
    if not len(near):
        return
    at = slice(int(near[0]), int(near[-1]) + 1)
    count = wheel.light.shape[1] - 1
    scale = count / (2 * wheel.half_m)
    lo, hi = (np.clip((e[at] - wheel.hub_m) * scale + count / 2, 0, count) for e in (start, end))
    width = ((end - start)[at] * scale)[:, None]
    turn = np.mod(turned_m[at] / wheel.radius_m / wheel.step_rad, len(wheel.light))
    light, cover = (
        (_turned(sums, turn, hi) - _turned(sums, turn, lo)) / width for sums in (wheel.light, wheel.cover)
    )
    band = slice(wheel.row_0, wheel.row_0 + wheel.light.shape[2])
    scene[at, band] = light + (1 - cover) * scene[at, band]


def _turned(sums: Floats, turn: Array, place: Array) -> Floats:
    """Running sums (lines, band) between the two nearest angles, smoothly between columns, as a body's."""
    low, part = turn.astype(int) % len(sums), (turn % 1)[:, None]
    column = np.clip(np.rint(place).astype(int), 1, sums.shape[1] - 2)
    inner = (place - column)[:, None]
    weights = (0.5 - inner) ** 2 / 2, 0.75 - inner**2, (0.5 + inner) ** 2 / 2
    nearer, farther = (
        sum(weight * sums[angle, column + by] for weight, by in zip(weights, (-1, 0, 1), strict=True))
        for angle in (low, (low + 1) % len(sums))
    )
    return np.asarray(nearer * (1 - part) + farther * part, np.float32)


def _rain(site: ScanSite, rng: np.random.Generator, scene: Floats) -> None:
    """Drops cross the plane: bright upright dashes a few lines wide."""
    for _ in range(rng.poisson(site.rain_per_s * len(scene) / site.line_rate_hz)):
        line, row = int(rng.integers(len(scene))), int(rng.integers(site.rows))
        tall = int(rng.uniform(0.03, 0.12) / site.field_m * site.rows) + 1
        scene[line : line + int(rng.integers(1, 4)), row : row + tall] += rng.uniform(25, 60)


def _lit(
    site: ScanSite,
    camera: int,
    first_line: int,
    lines: int,
    cars: list[ScanVehicle],
    rods: tuple[HeldRod, ...],
    rng: np.random.Generator,
) -> Floats:
    """One chunk (lines, rows) of one camera before its noise."""
    edge_s = (first_line - 0.5 + np.arange(lines + 1)) / site.line_rate_hz
    scene: Floats = np.tile(empty_line(site, camera), (lines, 1))
    if camera == 1:
        lay_rods(site, rods, edge_s, scene)
    for car in sorted(cars, key=lambda one: not one.far):
        _lay_vehicle(site, car, camera, edge_s, scene)
    _rain(site, rng, scene)
    gain, offset = (site.gain_2, site.offset_2_dn) if camera == 2 else (1.0, 0.0)
    light = gain * _illumination(site, (edge_s[:-1] + edge_s[1:]) / 2)
    scene *= light[:, None] * _fixed_gain(site, camera)[None]
    scene += offset
    return scene


def _read_out(site: ScanSite, scene: Floats, rng: np.random.Generator) -> Image:
    """Noise of the light and of reading, and the rounding to eight bits."""
    sigma = np.sqrt(site.read_noise_dn**2 + site.shot_dn2_per_dn * np.maximum(scene, 0))
    scene = scene + sigma * _noise(site, rng, len(scene))
    # rounds and saturates; negative values must not come back mirrored
    return np.asarray(cv2.convertScaleAbs(np.maximum(scene, 0)), np.uint8)


def _exposed(
    sites: tuple[ScanSite, ...],
    camera: int,
    first_line: int,
    lines: int,
    cars: list[ScanVehicle],
    rods: tuple[HeldRod, ...],
) -> list[Image]:
    """One chunk (lines, rows) of one camera, as each site reads it."""
    rng = np.random.default_rng((sites[0].seed, camera, first_line))
    scene = _lit(sites[0], camera, first_line, lines, cars, rods, rng)
    return [_read_out(site, scene, rng) for site in sites]


def recording(
    site: ScanSite,
    vehicles: tuple[ScanVehicle, ...],
    seconds: float | None = None,
    rods: tuple[HeldRod, ...] = (),
) -> Iterator[tuple[Image, Image]]:
    """Chunks (lines, rows) of strip 1 and strip 2, CHUNK lines each, the last one shorter.

    `seconds`: length of the recording; None ends it 0.4 s after the last vehicle. `rods`: held in camera 1's
    plane, which needs a site that has a `plane_m`.
    """
    for chunks in recordings((site,), vehicles, seconds, rods):
        yield chunks[0]


def recordings(
    sites: tuple[ScanSite, ...],
    vehicles: tuple[ScanVehicle, ...],
    seconds: float | None = None,
    rods: tuple[HeldRod, ...] = (),
) -> Iterator[list[tuple[Image, Image]]]:
    """As `recording`, the same light read by sites that differ in noise alone: a pair of chunks each."""
    site = sites[0]
    clear = {car: car.clear_s(site.baseline_m) for car in vehicles}
    if seconds is None:
        seconds = max(clear.values(), default=0.6) + 0.4
    total = round(seconds * site.line_rate_hz)
    slack_s = 0.5
    for start in range(0, total, CHUNK):
        lines = min(CHUNK, total - start)
        lo, hi = start / site.line_rate_hz, (start + lines) / site.line_rate_hz
        cars = [car for car in vehicles if car.front_s - slack_s < hi and clear[car] + slack_s > lo]
        pairs = [_exposed(sites, camera, start, lines, cars, rods) for camera in (1, 2)]
        yield list(zip(*pairs, strict=True))


def strips(
    site: ScanSite,
    vehicles: tuple[ScanVehicle, ...],
    seconds: float | None = None,
    rods: tuple[HeldRod, ...] = (),
) -> tuple[Image, Image]:
    """Both strips whole (lines, rows): for short recordings."""
    first, second = whole_strips(site, vehicles, seconds, rods)
    return first, second


def whole_strips(
    site: ScanSite, vehicles: tuple[ScanVehicle, ...], seconds: float | None, rods: tuple[HeldRod, ...]
) -> Image:
    """(2, lines, rows); some seconds to draw (`tests/support/drawn.py`)."""
    return np.stack(
        [np.concatenate(one) for one in zip(*recording(site, vehicles, seconds, rods), strict=True)]
    )
