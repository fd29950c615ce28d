"""The straight, even motion of a vehicle that the wheels found on several frames agree on."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.enums import WheelEnd
from sightline.proposals.wheels import Wheels

LEAST_FRAMES = 3
STRAY_M = 0.06
NOT_ONE_VEHICLE = "proposals-not-one-vehicle"


@dataclass(frozen=True, eq=False)
class Motion:
    """Where the rear wheel (or the only one) stands on frame n: X = `x_m` + `step_m` (n - `n0`), on the side
    plane Y = `y_m`; `wheelbase_m` is None where one end only was found, `only`. `used`: frames that agree.
    """

    x_m: float
    step_m: float
    n0: int
    y_m: float
    wheelbase_m: float | None
    only: WheelEnd | None
    used: tuple[int, ...]

    def at(self, n: int) -> float:
        """X on frame n, metres."""
        return self.x_m + self.step_m * (n - self.n0)

    def wheel_at(self, n: int, end: WheelEnd, ahead: int) -> float | None:
        """X of a wheel on frame n; `ahead` is 1 where the vehicle goes to larger X. None: never found."""
        if self.only is not None:
            return self.at(n) if end == self.only else None
        return self.at(n) + (ahead * (self.wheelbase_m or 0.0) if end == "front" else 0.0)


def motion_of(wheels: Mapping[int, Wheels], ahead: int) -> Motion | str:
    """The motion that most wheels of `wheels` (by frame) agree on, or why there is none.

    Own method: the line through two of the places that most others lie on, then least squares through those.
    """
    bases = [abs(p.front.x_m - p.rear.x_m) for p in wheels.values() if p.front and p.rear]
    base = float(np.median(bases)) if bases else None
    if base is not None:
        near = sum(abs(one - base) < STRAY_M for one in bases)
        base = base if near * 2 > len(bases) else None
    only = _more_seen_end(wheels) if base is None else None
    at = _stands(wheels, ahead, base, only)
    line = _line(at[:, 0], at[:, 1])
    if line is None:
        return NOT_ONE_VEHICLE
    start, step, keep = line
    if ahead * step <= 0:
        return NOT_ONE_VEHICLE
    return Motion(
        x_m=start,
        step_m=step,
        n0=int(at[0, 0]),
        y_m=float(np.median(at[keep, 2])),
        wheelbase_m=base,
        only=only,
        used=tuple(sorted({int(n) for n in at[keep, 0]})),
    )


def _stands(found: Mapping[int, Wheels], ahead: int, base: float | None, only: WheelEnd | None) -> Floats:
    """Frame, X and Y (k, 3) of the rear wheel, also by way of the front one; of the only end where one is."""
    at: list[tuple[float, float, float]] = []
    for n, pair in found.items():
        if pair.rear is not None and only != "front":
            at.append((n, pair.rear.x_m, pair.rear.y_m))
        if pair.front is not None and only != "rear" and (base is not None or only == "front"):
            at.append((n, pair.front.x_m - ahead * (base or 0.0), pair.front.y_m))
    return np.array(at, dtype=np.float64).reshape(-1, 3)


def _more_seen_end(found: Mapping[int, Wheels]) -> WheelEnd:
    rears = sum(pair.rear is not None for pair in found.values())
    return "rear" if rears * 2 >= len(found) else "front"


def _line(n: Floats, x: Floats) -> tuple[float, float, NDArray[np.bool_]] | None:
    """X at the first n, step a frame, and which agree: the line through two of them that most lie on."""
    if len(np.unique(n)) < LEAST_FRAMES:
        return None
    best: NDArray[np.bool_] = np.zeros(len(n), np.bool_)
    for i in range(len(n)):
        for j in range(i + 1, len(n)):
            if n[i] == n[j]:
                continue
            step = (x[j] - x[i]) / (n[j] - n[i])
            on = np.abs(x - x[i] - step * (n - n[i])) < STRAY_M
            best = on if on.sum() > best.sum() else best
    if len(np.unique(n[best])) < LEAST_FRAMES or best.sum() * 2 < len(n):
        return None
    step, start = np.polyfit(n[best] - n[0], x[best], 1)
    return float(start), float(step), best
