"""Small recordings for the tests of finding and measuring, from the demonstration's generator."""

from dataclasses import replace
from functools import lru_cache

import numpy as np

from sightline.linescan.finding import Finder
from sightline.linescan.parts import Passage, Rig
from tests.simulation.models import MODELS
from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import (
    Halt,
    Photograph,
    ScanSite,
    ScanTruth,
    ScanVehicle,
    scan_body,
    traffic,
    truths,
)

RIG = Rig(0.593, 4882.8)
SLOW_RIG = Rig(0.593, 1220.7)
SITE = ScanSite(rows=128, misalignment_px=0.4)
Strips = tuple[np.ndarray, np.ndarray]


@lru_cache(maxsize=1)
def cars() -> tuple[ScanVehicle, ...]:
    """Three vehicles at town speed, well apart."""
    return traffic(4, 3, speeds_mps=(11.0, 24.0), gaps_s=(0.4, 0.6))


@lru_cache(maxsize=1)
def plain() -> Strips:
    return strips(SITE, cars())


@lru_cache(maxsize=1)
def plain_truth() -> tuple[ScanTruth, ...]:
    return truths(SITE, cars())


def at(car: ScanVehicle, front_s: float, speed_mps: float, **changes: object) -> ScanVehicle:
    """The same body on another trip."""
    return replace(car, front_s=front_s, speed_mps=speed_mps, acceleration_mps2=0.0, **changes)


def touching() -> tuple[Strips, tuple[ScanTruth, ...]]:
    """The second vehicle's front 0.45 m behind the first one's rear."""
    first = at(cars()[0], 0.6, 12.0)
    second = at(cars()[1], first.time_s(first.length_m + 0.45), 12.0)
    return strips(SITE, (first, second)), truths(SITE, (first, second))


def side_by_side(against: bool) -> Strips:
    """A far vehicle is passed by, or meets, a near one in front of the cameras."""
    near = at(cars()[0], 0.7, 20.0)
    far = at(cars()[1], 0.62, 13.0, far=True, against=against)
    return strips(SITE, (near, far))


def stopping(wait_s: float) -> Strips:
    """A vehicle stops with its front 1.6 m beyond camera 1, waits and drives on."""
    return strips(SITE, (at(cars()[0], 0.9, 7.0, halt=Halt(1.6, wait_s)),))


@lru_cache(maxsize=3)
def standing(at_m: float, far: bool = False, wait_s: float = 7.0) -> tuple[Strips, tuple[float, float]]:
    """A vehicle stands for `wait_s` with its front so far beyond camera 1, another passes on the other lane,
    and the next one comes 1.8 s after its rear; the seconds of that rear and of the next front. Of a slower
    rig.
    """
    stands = at(cars()[1], 1.2, 7.0, halt=Halt(at_m, wait_s), far=far)
    rear_s = stands.clear_s(0.0)
    beside = at(cars()[0], 7.0, 14.0, far=not far)
    site = replace(SITE, rows=64, line_rate_hz=SLOW_RIG.line_rate_hz)
    return strips(site, (stands, beside, at(cars()[2], rear_s + 1.8, 12.0))), (rear_s, rear_s + 1.8)


@lru_cache(maxsize=1)
def two_standing(wait_s: float, bodies: tuple[int, int] = (1, 0)) -> tuple[Strips, tuple[float, float]]:
    """One stands on the far lane from 1.2 s on for 20 s; another stops before it at 7.0 s, for `wait_s`; the
    seconds of both rears. Of a slower rig. `bodies`: theirs, of the cars.
    """
    behind = at(cars()[bodies[0]], 1.2, 7.0, halt=Halt(1.6, 20.0), far=True)
    before = at(cars()[bodies[1]], 7.0, 7.0, halt=Halt(1.6, wait_s))
    rears_s = behind.clear_s(0.0), before.clear_s(0.0)
    site = replace(SITE, rows=64, line_rate_hz=SLOW_RIG.line_rate_hz)
    return strips(site, (behind, before, at(cars()[2], max(rears_s) + 1.8, 12.0))), rears_s


def creeping(
    seed: int, *, back_m: float = 0.0, noise_dn: float = 2.0, skin: Photograph | None = None
) -> tuple[Strips, tuple[float, float]]:
    """A lorry of 12 to 16 m stands with its front part in view, creeps on by some metres and rests, twice,
    and each time `back_m` back again; the next vehicle comes 1.8 s after its rear. Of a slower rig; the
    seconds of that rear and of the next front. `skin`: on its side.
    """
    rng = np.random.default_rng((seed, 34))
    long_m, at_m = float(rng.uniform(12.0, 16.0)), float(rng.uniform(1.0, 2.5))
    by_m = rng.uniform(3.0, min(6.0, (long_m - at_m) / 2), 2)
    rests = [((float(by), 4.5), (-back_m, 4.0)) if back_m else ((float(by), 4.5),) for by in by_m]
    model = next(one for one in MODELS if one.category == "lorry")
    model = replace(model, length_m=long_m, wheelbase_m=0.6 * long_m)
    halt = Halt(at_m, 5.0, creeps=tuple(one for rest in rests for one in rest))
    lorry = ScanVehicle(scan_body(seed, model, rng), 1.2, 7.0, 0.0, halt=halt, skin=skin)
    rear_s = lorry.clear_s(0.0)
    site = replace(SITE, rows=64, line_rate_hz=SLOW_RIG.line_rate_hz, seed=seed, read_noise_dn=noise_dn)
    return strips(site, (lorry, at(cars()[2], rear_s + 1.8, 12.0))), (rear_s, rear_s + 1.8)


def found(pair: Strips, rig: Rig = RIG, piece: int = 1500) -> tuple[list[Passage], Finder]:
    """All vehicles of a pair, pushed in pieces."""
    finder = Finder(pair[0].shape[1], rig)
    out: list[Passage] = []
    for start in range(0, len(pair[0]), piece):
        out += finder.push(pair[0][start : start + piece], pair[1][start : start + piece])
    return out + finder.finish(), finder


@lru_cache(maxsize=1)
def plain_found() -> tuple[list[Passage], Finder]:
    """The three vehicles, found once for all tests; nobody changes them."""
    return found(plain())
