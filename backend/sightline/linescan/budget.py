"""The uncertainty of a measured motion, source by source: baseline, clock, misalignment, fit, front, rear."""

from collections.abc import Iterable
from dataclasses import dataclass
from math import hypot, sqrt

import numpy as np

from sightline.arrays import Floats
from sightline.linescan.boundaries import SAME_END, U_LINE_LINES
from sightline.linescan.parts import Entry, Passage, Rig
from sightline.linescan.registration import Clock, Fit

# what the half-way rule and the outline leave of a usual boundary, metres, standard u: where nothing else is
# known of it, for it was placed by hand or is planned
U_EDGE_M = 0.0006
# by how many standard deviations both cameras may disagree about an end before that says more than its bands,
# and how many times its u half of that is, for their errors correlate by SAME_END
DISAGREE = 3.0
DISAGREE_OVER_U = DISAGREE * sqrt((1 - SAME_END) / (1 + SAME_END))
# entries of earlier versions' budgets, of either method, that hold front and rear together
_BOTH_ENDS = "boundaries", "front and rear"


@dataclass(frozen=True)
class Budget:
    """Length, and the standard uncertainties with their entries.

    `apart_m`: by how much the cameras disagree about the front or the rear, whichever is worse. `correlation`
    of speed and acceleration, over all entries.
    """

    length_m: float
    u_speed_mps: float
    u_acceleration_mps2: float
    u_length_m: float
    entries: tuple[Entry, ...]
    apart_m: float
    correlation: float


def budget_of(
    passage: Passage,
    rig: Rig,
    clock: Clock,
    fit: Fit,
    spread: Floats,
    u_shift: float,
    baseline: tuple[float, float],
) -> Budget:
    """All entries; length is the mean of what the boundaries say at either camera.

    `spread` (2, 2): covariance of speed and acceleration (m/s, m/s^2) that the fit itself has; u_shift: rows
    of the sheets; baseline: (value, u), m.

    CONVENTIONS.md, Line scan; entries add as squares, the fit's two with their covariance (JCGM 100:2008,
    5.1.2 and 5.2.2). A longer baseline scales speed, acceleration and length alike; a faster line rate the
    speed, twice as much the acceleration, and the length not at all. The speed is that at the front's
    crossing of camera 1, so of a vehicle that gains speed it errs as the front is misplaced: by
    a u_front / v.
    """
    course = fit.state.course
    c = passage.crossings
    f2, r1, r2 = (
        float(clock.seconds(np.array(line))) for line in (c.front_line_2, c.rear_line_1, c.rear_line_2)
    )
    v, a = course.speed_mps, course.acceleration_mps2

    def gone(seconds: float) -> float:
        return float(course.travelled_m(np.array(seconds)))

    lengths = (gone(r1), gone(r2) - gone(f2))
    length = sum(lengths) / 2
    by_speed = (r1 + r2 - f2) / 2
    by_acceleration = (r1**2 + r2**2 - f2**2) / 4
    answer = _answer_to_shift(fit) * u_shift
    due = np.outer(answer, answer)
    apart = gone(f2) - course.baseline_m, gone(r2) - gone(r1) - course.baseline_m
    u_line = U_LINE_LINES * v / rig.line_rate_hz
    u_front, u_rear = (_u_end(*one, u_line) for one in zip(apart, passage.u_ends_m, strict=True))
    between = 0.0 if passage.u_ends_m[0] else u_line
    at_front = hypot(u_at_one_camera(u_front, between), between)
    gradient = np.array([by_speed, by_acceleration])

    def entry(source: str, spread: Floats) -> Entry:
        u = np.sqrt(np.maximum([spread[0, 0], spread[1, 1], gradient @ spread @ gradient], 0.0))
        return Entry(source, float(u[0]), float(u[1]), float(u[2]))

    ratio = baseline[1] / baseline[0]
    clock_ratio = rig.u_line_rate_ratio
    entries = (
        Entry("baseline", v * ratio, abs(a) * ratio, length * ratio),
        Entry("clock", v * clock_ratio, 2 * abs(a) * clock_ratio, 0.0),
        entry("misalignment", due),
        entry("fit", spread),
        Entry("front", abs(a) / v * at_front, 0.0, u_front),
        Entry("rear", 0.0, 0.0, u_rear),
    )
    u = [
        float(np.sqrt(sum(getattr(e, name) ** 2 for e in entries)))
        for name in ("u_speed_mps", "u_acceleration_mps2", "u_length_m")
    ]
    return Budget(
        length_m=length,
        u_speed_mps=u[0],
        u_acceleration_mps2=u[1],
        u_length_m=u[2],
        entries=entries,
        apart_m=max(map(abs, apart)),
        correlation=correlation_of(float((spread + due)[0, 1]), (v, a), (u[0], u[1]), (ratio, clock_ratio)),
    )


def correlation_of(
    fitted: float, motion: tuple[float, float], u: tuple[float, float], ratios: tuple[float, float]
) -> float:
    """Correlation of the errors of speed and acceleration over a whole budget; 0 where either has none.

    `fitted`: covariance of both by what was fitted, m^2/s^3; `motion`, `u`: speed, m/s, and acceleration,
    m/s^2, and the u of each; `ratios`: relative u of baseline and clock. A longer baseline scales both alike,
    a faster clock the acceleration twice as much (JCGM 100:2008, 5.2.2).
    """
    if not u[0] * u[1] > 0:
        return 0.0
    together = fitted + motion[0] * motion[1] * (ratios[0] ** 2 + 2 * ratios[1] ** 2)
    return float(np.clip(together / (u[0] * u[1]), -1.0, 1.0))


def _answer_to_shift(fit: Fit) -> Floats:
    """How speed and acceleration (2,) answer to a row of shift: the fit held the shift where it was found."""
    weighted = fit.look.jacobian * fit.weight[:, None]
    normal = weighted[:, :2].T @ fit.look.jacobian[:, :2]
    size = np.sqrt(np.maximum(np.diag(normal), 1e-12))
    right = weighted[:, :2].T @ fit.look.jacobian[:, 2]
    return np.asarray(-np.linalg.lstsq(normal / np.outer(size, size), right / size, rcond=1e-12)[0] / size)


def _u_end(apart_m: float, u_found_m: float, u_line_m: float) -> float:
    """Of an end, as the mean of both cameras, metres: as its bands say it was found, or half of what the
    cameras disagree about it (`apart_m`) where that is more than errors by such u do; where a person placed
    it, a usual end's, that half, and what lies between two lines (`u_line_m`).
    """
    half_m = abs(apart_m) / 2
    if u_found_m:
        return half_m if half_m > DISAGREE_OVER_U * u_found_m else u_found_m
    return hypot(U_EDGE_M, half_m, u_line_m / sqrt(2))


def u_at_one_camera(u_mean_m: float, u_line_m: float) -> float:
    """Of an end at one camera, metres, of which the mean of both is known to `u_mean_m`, without the
    `u_line_m` that lie between two lines, which either camera does for itself.
    """
    return sqrt(max(u_mean_m**2 - u_line_m**2 / 2, 0.0) * 2 / (1 + SAME_END))


def u_end_of(budget: Iterable[Entry], end: str) -> float:
    """What the front or the rear (`end`) brings to the length's u, metres. Earlier versions told both in one
    entry, of which either has half the variance; of a budget without any, an end has all that there is.
    """
    of_length = {one.source: one.u_length_m for one in budget}
    both = next((of_length[one] / sqrt(2) for one in _BOTH_ENDS if one in of_length), None)
    return of_length.get(end, hypot(*of_length.values()) if both is None else both)
