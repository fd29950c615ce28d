"""Lines of sight over a road's profile, traced without any of the closed forms that they are to check.

A profile has two straight grades and a parabola between them. Distances are along the horizontal, heights
vertical.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq, minimize_scalar

Floats = NDArray[np.float64]
FAR_M = 20_000.0


@dataclass(frozen=True)
class Profile:
    """Grade `first` up to x = 0, grade `second` from x = length on (rise over run); a parabola between."""

    first: float
    second: float
    length_m: float

    def z(self, x: Floats | float) -> Floats:
        on_curve = np.clip(x, 0.0, self.length_m)
        bent = (self.second - self.first) * on_curve**2 / (2 * self.length_m) if self.length_m else 0.0
        return np.asarray(
            self.first * np.minimum(x, self.length_m)
            + bent
            + np.maximum(np.asarray(x) - self.length_m, 0.0) * self.second
        )

    def slope(self, x: float) -> float:
        part = min(max(x / self.length_m, 0.0), 1.0) if self.length_m else float(x > 0)
        return self.first + part * (self.second - self.first)


def clearance(profile: Profile, eye: float, eye_m: float, thing: float, object_m: float) -> float:
    """How far the line from eye to object stays above the road, at its closest."""
    start, end = float(profile.z(eye)) + eye_m, float(profile.z(thing)) + object_m
    low, high = eye, thing
    for _ in range(5):  # closer and closer around the closest point
        x = np.linspace(low, high, 101)
        above = start + (end - start) * (x - eye) / (thing - eye) - profile.z(x)
        at = int(np.argmin(above))
        low, high = float(x[max(at - 1, 0)]), float(x[min(at + 1, 100)])
    return float(above.min())


def seen_over_crest(profile: Profile, eye: float, eye_m: float, object_m: float) -> float:
    """How far ahead of this eye the object vanishes behind the crest."""

    def gap(distance: float) -> float:
        return clearance(profile, eye, eye_m, eye + distance, object_m)

    return float(brentq(gap, 0.1, FAR_M, xtol=1e-10, rtol=1e-14)) if gap(FAR_M) < 0 else FAR_M


def lit_in_sag(profile: Profile, lamp: float, headlight_m: float, rise: float) -> float:
    """How far ahead of this headlight its upper beam meets the road."""
    start, slope = float(profile.z(lamp)) + headlight_m, profile.slope(lamp) + rise

    def above(distance: float) -> float:
        return start + slope * distance - float(profile.z(lamp + distance))

    return float(brentq(above, 0.0, FAR_M, xtol=1e-10, rtol=1e-14)) if above(FAR_M) < 0 else FAR_M


def shortest(seen: Callable[[float], float], low: float, high: float) -> float:
    """The shortest distance seen from any place between: a grid, then closer around its best."""
    places = np.linspace(low, high, 41)
    found = [seen(float(place)) for place in places]
    at = int(np.argmin(found))
    bounds = (float(places[max(at - 1, 0)]), float(places[min(at + 1, 40)]))
    best = minimize_scalar(seen, bounds=bounds, method="bounded", options={"xatol": 1e-6})
    return min(float(best.fun), found[at])


def hidden_inside_curve(radius_m: float, distance_m: float) -> float:
    """How far inside a circle lines between two of its points, this far apart along it, reach across one
    radius.
    """
    half = 0.5 * distance_m / radius_m
    middle = np.linspace(-0.999 * half, 0.999 * half, 200_001)
    ends = [radius_m * np.array([np.cos(middle + s * half), np.sin(middle + s * half)]) for s in (-1, 1)]
    part = ends[0][1] / (ends[0][1] - ends[1][1])  # where the chord crosses the radius at angle 0
    crossing = ends[0][0] + part * (ends[1][0] - ends[0][0])
    return float(radius_m - crossing.min())
