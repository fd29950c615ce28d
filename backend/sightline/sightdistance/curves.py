"""Curves that keep a sight distance: crest and sag parabolas, and the room beside a horizontal curve.

Grades are in percent, A is the absolute difference of the two grades, K = L / A the length of the curve per
percent (metres), S the sight distance along the horizontal. A line of sight runs from the eye to the
object, both vertically above the road. The forms are the Green Book's (AASHTO 2018, chapter 3); for
parabolas they are exact, not approximations, and the tests trace lines of sight to show it.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from sightline.arrays import Floats
from sightline.enums import CurveCase
from sightline.errors import BadInput

HEADLIGHT_M = 0.60
BEAM_RAD = math.radians(1.0)
TALLEST_M = 10.0


@dataclass(frozen=True)
class CurveLength:
    """The least length of a vertical curve; case "none": the grades alone already keep the sight distance."""

    length_m: float
    case: CurveCase


@dataclass(frozen=True)
class CrestConstant:
    """What two heights mean for every crest: `constant_m`, and its standard uncertainty if both are known."""

    constant_m: float
    u_constant_m: float | None


def crest_constants_m(eye_m: ArrayLike, object_m: ArrayLike) -> Floats:
    """C = 100 (sqrt(2 h1) + sqrt(2 h2))^2 in metres, of the broadcast (N,) of both heights.

    eye_m (N,) and object_m (N,) are metres above the road.

    The Green Book prints 658 for 1.08 and 0.60 m, 864 for 1.08 and 1.08 m (AASHTO 2018); its US customary
    2158 is the same in feet. Own derivation: a line that touches the parabola y = -x^2 / (200 K) is y = h
    above it at x = sqrt(200 K h) from the point of contact, so S = sqrt(200 K) (sqrt(h1) + sqrt(h2)) and K
    = S^2 / C. Raises BadInput for heights that cannot be.
    """
    eye, target = np.asarray(eye_m, dtype=np.float64), np.asarray(object_m, dtype=np.float64)
    if not (np.all((eye > 0.0) & (eye <= TALLEST_M)) and np.all((target >= 0.0) & (target <= TALLEST_M))):
        raise BadInput("sightdistance-heights")
    return np.asarray(200.0 * (np.sqrt(eye) + np.sqrt(target)) ** 2, dtype=np.float64)


def crest_constant(
    eye_m: float, object_m: float, u_eye_m: float | None = None, u_object_m: float | None = None
) -> CrestConstant:
    """The constant C of two heights for crest curves, K = S^2 / C (AASHTO 2018), with its uncertainty.

    C = 100 (sqrt(2 h1) + sqrt(2 h2))^2, dC/dh = 200 (sqrt(h1) + sqrt(h2)) / sqrt(h), linear, independent
    heights (JCGM 100:2008, 5.1.2).

    Parameters
    ----------
    eye_m, object_m : float
        Heights above the road, metres.
    u_eye_m, u_object_m : float, optional
        Their standard uncertainties, metres. Without any there is none; one alone takes the other height as
        exact. An object at 0 has no linear u.

    Returns
    -------
    CrestConstant
        `constant_m` and `u_constant_m`, metres.

    Raises
    ------
    BadInput
        For heights or uncertainties that cannot be.

    Examples
    --------
    >>> import sightline
    >>> found = sightline.crest_constant(1.08, 0.60, u_eye_m=0.01, u_object_m=0.02)
    >>> round(found.constant_m), round(found.u_constant_m)
    (658, 10)
    """
    constant = float(crest_constants_m(eye_m, object_m))
    if u_eye_m is None and u_object_m is None:
        return CrestConstant(constant, None)
    parts = []
    for height, u in ((eye_m, u_eye_m or 0.0), (object_m, u_object_m or 0.0)):
        if not 0.0 <= u <= TALLEST_M or (u > 0.0 and height <= 0.0):
            raise BadInput("sightdistance-uncertainty")
        parts.append(math.sqrt(200.0 * constant / height) * u if u else 0.0)
    return CrestConstant(constant, math.hypot(*parts))


def crest_k_m(distance_m: float, constant_m: float) -> float:
    """K = S^2 / C for S < L: metres of crest per percent of A (AASHTO 2018). Raises BadInput."""
    return _distance(distance_m) ** 2 / _positive(constant_m)


def crest_length(distance_m: float, difference_percent: float, constant_m: float) -> CurveLength:
    """The least length of a crest (AASHTO 2018).

    S < L: A S^2 / C; S > L: 2 S - C / A, which is nothing where the grades alone keep the distance. Both
    meet at S = L.

    Parameters
    ----------
    distance_m : float
        The sight distance S, metres.
    difference_percent : float
        Difference A of the grades, per cent.
    constant_m : float
        C of `crest_constant`, metres.

    Returns
    -------
    CurveLength
        Metres, and which case it is.

    Raises
    ------
    BadInput
        For values that cannot be.

    Examples
    --------
    >>> import sightline
    >>> found = sightline.crest_length(distance_m=185.0, difference_percent=5.0, constant_m=658.0)
    >>> round(found.length_m), found.case
    (260, 'S < L')
    """
    grades = _difference(difference_percent)
    return _length(_distance(distance_m), grades * distance_m / _positive(constant_m), constant_m / grades)


def crest_distance_m(length_m: float, difference_percent: float, constant_m: float) -> float:
    """How far one sees on a crest of this length: the inverse of `crest_length`.

    The shortest over all positions of the eye; length 0 is a sharp break of the grade. Raises BadInput.
    """
    grades = _difference(difference_percent)
    sharp_m = _positive(constant_m) / grades
    if _room(length_m) >= sharp_m:
        return math.sqrt(sharp_m * length_m)
    return 0.5 * (length_m + sharp_m)


def sag_k_m(distance_m: float, headlight_m: float = HEADLIGHT_M, beam_rad: float = BEAM_RAD) -> float:
    """K = S^2 / (200 (h + S tan b)) for S < L: metres of sag per percent that headlights light S ahead.

    With 0.60 m and 1 degree the Green Book prints S^2 / (120 + 3.5 S) (AASHTO 2018); 200 tan 1 degree is
    3.491. The beam rises by tan b over the road under the vehicle, slopes added as the Green Book adds
    them. Raises BadInput.
    """
    return _distance(distance_m) ** 2 / _lit(distance_m, headlight_m, beam_rad)


def sag_length(
    distance_m: float, difference_percent: float, headlight_m: float = HEADLIGHT_M, beam_rad: float = BEAM_RAD
) -> CurveLength:
    """The least length of a sag by the headlight rule (AASHTO 2018).

    S < L: A S^2 / (200 (h + S tan b)); S > L: 2 S - 200 (h + S tan b) / A. Raises BadInput.
    """
    grades = _difference(difference_percent)
    lit = _lit(_distance(distance_m), headlight_m, beam_rad)
    return _length(distance_m, grades * distance_m / lit, lit / grades)


def sightline_offset_m(radius_m: float, distance_m: float) -> float:
    """The room needed at the middle of a horizontal curve: R (1 - cos(S / 2R)), for S up to the curve's
    length.

    R is that of the line along which S is measured, the inside lane's middle (AASHTO 2018, which prints
    28.65 for 90 / pi). Raises BadInput where S is more than half the circle, or for values that cannot be.
    """
    if not (math.isfinite(radius_m) and 0.0 < _distance(distance_m) <= math.pi * radius_m):
        raise BadInput("sightdistance-radius")
    return 2.0 * radius_m * math.sin(0.25 * distance_m / radius_m) ** 2


def _length(distance_m: float, share: float, sharp_m: float) -> CurveLength:
    """Both cases at once: S < L with `share` = L / S, and S > L with `sharp_m` = 2 S - L."""
    if share >= 1.0:
        return CurveLength(share * distance_m, "S < L")
    beyond = 2.0 * distance_m - sharp_m
    return CurveLength(beyond, "S > L") if beyond > 0.0 else CurveLength(0.0, "none")


def _lit(distance_m: float, headlight_m: float, beam_rad: float) -> float:
    if not (
        0.0 <= headlight_m <= TALLEST_M and 0.0 <= beam_rad < 0.5 * math.pi and headlight_m + beam_rad > 0.0
    ):
        raise BadInput("sightdistance-headlight")
    return 200.0 * (headlight_m + distance_m * math.tan(beam_rad))


def _distance(value: float) -> float:
    if not (math.isfinite(value) and 0.0 < value <= 1e5):
        raise BadInput("sightdistance-distance")
    return value


def _difference(percent: float) -> float:
    if not (math.isfinite(percent) and 0.0 < percent <= 100.0):
        raise BadInput("sightdistance-difference")
    return percent


def _positive(constant_m: float) -> float:
    if not (math.isfinite(constant_m) and constant_m > 0.0):
        raise BadInput("sightdistance-heights")
    return constant_m


def _room(length_m: float) -> float:
    if not (math.isfinite(length_m) and length_m >= 0.0):
        raise BadInput("sightdistance-distance")
    return length_m
