"""Simulated vehicles for the cells of a coverage table: every body once at every speed and noise.

A body is painted once and passes at all speeds, one after the other; what is seen is read with every noise.
So the vehicles of one cell are independent of each other, those of different cells are not. Gaps in a cell
are set afterwards, by moving one passage against another by whole lines.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import numpy as np

from sightline.linescan.finding import Finder
from sightline.linescan.parts import Passage, Rig
from tests.simulation.models import MODELS
from tests.simulation.scan_strips import recordings
from tests.simulation.scan_traffic import (
    Photograph,
    ScanSite,
    ScanTruth,
    ScanVehicle,
    scan_body,
    truths,
)

BODIES = {"car": ("hatchback", "saloon", "estate", "suv"), "van": ("van",), "lorry": ("lorry",)}
RIG = Rig(0.593, 4882.8)


@dataclass(frozen=True, eq=False)
class Seen:
    """One vehicle at one speed and noise; `passage` None: not found, or not once."""

    number: int
    speed_mps: float
    noise_dn: float
    true: ScanTruth
    passage: Passage | None


def body_at(body: str, number: int, seed: int, photographs: tuple[Path, ...]) -> ScanVehicle:
    """Body `number` of a class, drawn, or covered with a part of one of the photographs, if any."""
    rng = np.random.default_rng((seed, number, len(body)))
    models = [one for one in MODELS if one.category in BODIES[body]]
    model = models[int(rng.integers(len(models)))]
    by = float(rng.uniform(0.91, 1.088))
    model = replace(model, length_m=model.length_m * by, wheelbase_m=model.wheelbase_m * by)
    vehicle = scan_body(int(rng.integers(1000)), model, rng)
    vehicle = replace(vehicle, ends_seed=int(rng.integers(1 << 30)))
    skin = None
    if photographs:
        path = photographs[int(rng.integers(len(photographs)))]
        height, width = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE).shape
        # at this scale the picture's height is the vehicle's
        scale = height / model.height_m * float(rng.uniform(0.5, 1.0))
        left = int(rng.integers(max(int(width - scale * model.length_m), 1)))
        top = int(rng.integers(max(int(height - scale * model.height_m), 1)))
        skin = Photograph(str(path), left, top, scale)
    return ScanVehicle(vehicle, 1.0, 10.0, 0.0, skin=skin)


def seen(
    body: str,
    number: int,
    seed: int,
    speeds: list[float],
    noises: list[float],
    photographs: tuple[Path, ...] = (),
) -> Iterator[Seen]:
    """Body `number` within 7 % of every speed; slow ones change theirs by a quarter at most in passing."""
    cv2.setNumThreads(1)
    rng = np.random.default_rng((seed, number, 992, len(body)))
    still = body_at(body, number, seed, photographs)
    shift = float(rng.uniform(-1.0, 1.0))
    site = ScanSite(seed=seed + 1000 * number, misalignment_px=shift)
    sites = tuple(replace(site, read_noise_dn=noise) for noise in noises)
    cars, clear = list[ScanVehicle](), 0.7
    for speed in speeds:
        v = speed * float(rng.uniform(0.93, 1.07))
        most = min(1.5, v * v / (4 * (still.length_m + 1)))
        front = clear + float(rng.uniform(0.3, 0.5))
        car = replace(still, front_s=front, speed_mps=v, acceleration_mps2=float(rng.uniform(-most, most)))
        cars.append(car)
        clear = car.clear_s(site.baseline_m)
    found = _found(sites, tuple(cars))
    for speed, true in zip(speeds, truths(site, tuple(cars)), strict=True):
        reach = 0.2 * RIG.line_rate_hz / true.vehicle.speed_mps + 60
        for noise, passages in zip(noises, found, strict=True):
            near = [p for p in passages if abs(p.crossings.front_line_1 - true.front_line_1) < reach]
            yield Seen(number, speed, noise, true, near[0] if len(near) == 1 else None)


def _found(sites: tuple[ScanSite, ...], cars: tuple[ScanVehicle, ...]) -> list[list[Passage]]:
    finders = [Finder(site.rows, RIG) for site in sites]
    found = [list[Passage]() for _ in sites]
    for chunks in recordings(sites, cars):
        for finder, out, pair in zip(finders, found, chunks, strict=True):
            out += finder.push(*pair)
    for finder, out in zip(finders, found, strict=True):
        out += finder.finish()
    return found
