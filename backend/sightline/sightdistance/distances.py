"""How far a driver must see: stopping, decision, passing and intersection sight distance.

The formulas are those that AASHTO prints (A Policy on Geometric Design of Highways and Streets, 2018, the
"Green Book": chapter 3, sight distance; chapter 9, intersection sight distance), in metric and in US
customary units. Their printed factors are rounded (0.278 for 1/3.6, 0.039 for 1/(2 x 3.6^2), 11.2 ft/s^2 for
3.4 m/s^2), so the two systems differ from each other and from first principles by up to 1.7 %: each answer
names its formula. Speeds and lengths go in and out in SI.
"""

import math
from dataclasses import dataclass

import numpy as np

from sightline.enums import Crossing, Manoeuvre
from sightline.errors import BadInput

GREEN_BOOK = "AASHTO, A Policy on Geometric Design of Highways and Streets, 2018"
GRAVITY_MPS2 = 9.81  # the Green Book's
FASTEST_MPS = 300.0 / 3.6 * (1.0 + 1e-9)  # 300 km/h, in whichever unit it was written


@dataclass(frozen=True)
class UnitSystem:
    """One of the Green Book's two sets of formulas: its units in SI, and the factors that it prints.

    travel: speed unit times seconds to length unit; braking: speed squared over deceleration to length unit;
    gradient_braking: the same as a divisor, in the form with a gradient; step: to which lengths are rounded
    up.
    """

    name: str
    speed_mps: float
    length_m: float
    travel: float
    braking: float
    deceleration: float
    gradient_braking: float
    gravity: float
    step: float
    stopping_formula: str
    gradient_formula: str
    time_formula: str


METRIC = UnitSystem(
    name="metric",
    speed_mps=1.0 / 3.6,
    length_m=1.0,
    travel=0.278,
    braking=0.039,
    deceleration=3.4,
    gradient_braking=254.0,
    gravity=GRAVITY_MPS2,
    step=5.0,
    stopping_formula="0.278 V t + 0.039 V² / a",
    gradient_formula="0.278 V t + V² / (254 (a / 9.81 + G))",
    time_formula="0.278 V t",
)
US_CUSTOMARY = UnitSystem(
    name="US customary",
    speed_mps=0.44704,
    length_m=0.3048,
    travel=1.47,
    braking=1.075,
    deceleration=11.2,
    gradient_braking=30.0,
    gravity=32.2,
    step=5.0,
    stopping_formula="1.47 V t + 1.075 V² / a",
    gradient_formula="1.47 V t + V² / (30 (a / 32.2 + G))",
    time_formula="1.47 V t",
)


@dataclass(frozen=True)
class SightDistance:
    """A distance that has to be seen; `design_m` is rounded up to the unit system's step (5 m or 5 ft)."""

    distance_m: float
    design_m: float
    formula: str
    source: str


REACTION_S = 2.5
_STOPPING_AFTER_S: dict[Manoeuvre, float] = {"A": 3.0, "B": 9.1}
# Before and during a change of speed, path or direction, at the longest.
_CHANGING_S: dict[Manoeuvre, float] = {"C": 11.2, "D": 12.9, "E": 14.5}
# Of a passenger car.
_GAP_S: dict[Crossing, float] = {
    "left_from_stop": 7.5,
    "right_from_stop": 6.5,
    "crossing": 6.5,
    "left_from_major": 5.5,
}
# No formula stands behind these: a car passes a slower one, or gives up.
_PASSING_KMH = (30.0, 40.0, 50.0, 60.0, 70.0, 80.0, 90.0, 100.0, 110.0, 120.0, 130.0)
_PASSING_M = (120.0, 140.0, 160.0, 180.0, 210.0, 245.0, 280.0, 320.0, 355.0, 395.0, 440.0)


def stopping_distance(
    speed_mps: float,
    units: UnitSystem = METRIC,
    *,
    gradient: float = 0.0,
    reaction_s: float = REACTION_S,
    deceleration_mps2: float | None = None,
) -> SightDistance:
    """Stopping sight distance: travelled during the reaction, then braking (AASHTO 2018).

    Parameters
    ----------
    speed_mps : float
        Design speed, m/s.
    units : UnitSystem
        Whose rounded coefficients are used.
    gradient : float
        Rise over run in the direction of travel, negative downhill; where it is not 0 the form with a
        gradient is used, whose factor 254 is not quite that of 0.039.
    reaction_s : float
        Seconds.
    deceleration_mps2 : float, optional
        None for 3.4 m/s^2 (11.2 ft/s^2).

    Returns
    -------
    SightDistance
        `distance_m`, and `design_m` as the book rounds it.

    Raises
    ------
    BadInput
        For a speed or a gradient that cannot be.

    Examples
    --------
    >>> import sightline
    >>> sightline.stopping_distance(100 / 3.6).design_m
    185.0
    """
    speed = _speed(speed_mps, units)
    braking = units.deceleration if deceleration_mps2 is None else deceleration_mps2 / units.length_m
    if not (math.isfinite(reaction_s) and reaction_s >= 0.0 and math.isfinite(braking) and braking > 0.0):
        raise BadInput("sightdistance-reaction-deceleration")
    travelled = units.travel * speed * reaction_s
    if gradient == 0.0:
        stopped = units.braking * speed**2 / braking
        return _distance(travelled + stopped, units, units.stopping_formula, "stopping sight distance")
    friction = braking / units.gravity + gradient
    if not (abs(gradient) <= 0.25 and friction > 0.0):
        raise BadInput("sightdistance-gradient", gradient_percent=f"{100 * gradient:g}")
    stopped = speed**2 / (units.gradient_braking * friction)
    return _distance(travelled + stopped, units, units.gradient_formula, "stopping sight distance")


def decision_distance(speed_mps: float, manoeuvre: Manoeuvre, units: UnitSystem = METRIC) -> SightDistance:
    """Decision sight distance for an avoidance manoeuvre (AASHTO 2018).

    A, B: stopping on a rural, an urban road after 3.0, 9.1 s. C, D, E: a change of speed, path or direction
    on a rural, suburban, urban road; the Green Book names only the ends of the time that it takes
    (10.2-11.2, 12.1-12.9, 14.0-14.5 s), of which the longer one is taken; its own table lies up to 10 %
    below. Raises BadInput for a speed that cannot be.
    """
    if manoeuvre in _STOPPING_AFTER_S:
        found = stopping_distance(speed_mps, units, reaction_s=_STOPPING_AFTER_S[manoeuvre])
        return _distance(found.distance_m / units.length_m, units, found.formula, "decision sight distance")
    travelled = units.travel * _speed(speed_mps, units) * _CHANGING_S[manoeuvre]
    return _distance(travelled, units, units.time_formula, "decision sight distance")


def passing_distance(speed_mps: float) -> SightDistance:
    """Passing sight distance on a two-lane road (AASHTO 2018, metric), straight between the rows of its
    table.

    The table has no formula behind it (it rests on NCHRP Report 605, Harwood et al. 2008). Raises BadInput
    for a speed outside its 30 to 130 km/h.
    """
    speed = _speed(speed_mps, METRIC)
    if not _PASSING_KMH[0] - 1e-9 <= speed <= _PASSING_KMH[-1] + 1e-9:
        raise BadInput("sightdistance-passing-speed", speed_kmh=f"{speed:g}")
    seen = float(np.interp(speed, _PASSING_KMH, _PASSING_M))
    return _distance(seen, METRIC, "table of design speeds", "passing sight distance")


def intersection_distance(speed_mps: float, manoeuvre: Crossing, units: UnitSystem = METRIC) -> SightDistance:
    """Sight distance along the major road for a passenger car that enters or crosses it (AASHTO 2018).

    The speed is the major road's; the time gaps are those of a two-lane major road and gradients up to 3 %
    (cases B1, B2, B3, F). Raises BadInput for a speed that cannot be.
    """
    travelled = units.travel * _speed(speed_mps, units) * _GAP_S[manoeuvre]
    return _distance(travelled, units, units.time_formula, "intersection sight distance")


def _speed(speed_mps: float, units: UnitSystem) -> float:
    """In the unit of the formulas."""
    if not (math.isfinite(speed_mps) and 0.0 < speed_mps <= FASTEST_MPS):
        raise BadInput("sightdistance-speed", speed_kmh=f"{3.6 * speed_mps:g}")
    return speed_mps / units.speed_mps


def _distance(length: float, units: UnitSystem, formula: str, topic: str) -> SightDistance:
    rounded = units.step * math.ceil(length / units.step - 1e-9)
    return SightDistance(length * units.length_m, rounded * units.length_m, formula, f"{GREEN_BOOK}: {topic}")
