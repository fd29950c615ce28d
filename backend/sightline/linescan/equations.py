"""The paper's equations as printed and as they have to be, and the exact motion of four crossings.

Douxchamps, Macq, Chihara: High accuracy traffic monitoring using road-side line-scan cameras. All line
numbers as in `parts`: front and rear in strip 1 and strip 2; f: line rate in Hz; b: baseline in m. A point d
behind the front crosses camera 1 when v t + a t^2 / 2 = d and camera 2 when it equals d + b.
"""

from dataclasses import dataclass

import numpy as np

from sightline.linescan.parts import Crossings


@dataclass(frozen=True)
class PaperMotion:
    """Speed (m/s), length (m), acceleration (m/s^2) of equations (3) and (4)."""

    speed_mps: float
    length_m: float
    acceleration_mps2: float


@dataclass(frozen=True)
class ExactMotion:
    """Speed and acceleration as the front reaches camera 1, and the length; m/s, m/s^2, m."""

    speed_mps: float
    acceleration_mps2: float
    length_m: float


def solve_as_printed(crossings: Crossings, baseline_m: float, line_rate_hz: float) -> PaperMotion:
    """Equations (3) and (4) as printed. (4) lacks f^2, so what it gives is no acceleration (its unit is m).

    For comparison with the paper only: use `solve_corrected` or `solve_crossings`.
    """
    speed, length = _equation_3(crossings, baseline_m, line_rate_hz)
    slower = 1 / _transit(crossings.rear_line_1, crossings.rear_line_2)
    faster = 1 / _transit(crossings.front_line_1, crossings.front_line_2)
    over = crossings.rear_line_1 - crossings.front_line_1
    return PaperMotion(speed, length, baseline_m * (slower - faster) / over)


def solve_corrected(crossings: Crossings, baseline_m: float, line_rate_hz: float) -> PaperMotion:
    """Equations (3) and (4) with what (4) lacks: f^2, and the mean crossing times as its time base.

    The two speeds of (4) are means over the baseline, so they hold midway between the cameras: at the mean
    of a point's two crossings. The printed time base B_r1 - B_f1 is that of camera 1. Corrected, (4) is
    exact for a constant acceleration. (3) needs no correction but care: its speed is the one midway between
    the cameras, and its length neglects the acceleration.
    """
    speed, length = _equation_3(crossings, baseline_m, line_rate_hz)
    front = _transit(crossings.front_line_1, crossings.front_line_2)
    rear = _transit(crossings.rear_line_1, crossings.rear_line_2)
    rear_middle = (crossings.rear_line_1 + crossings.rear_line_2) / 2
    over = rear_middle - (crossings.front_line_1 + crossings.front_line_2) / 2
    acceleration = line_rate_hz**2 * baseline_m * (1 / rear - 1 / front) / over
    return PaperMotion(speed, length, acceleration)


def solve_crossings(crossings: Crossings, baseline_m: float, line_rate_hz: float) -> ExactMotion:
    """Constant acceleration through all four crossings: b = v D + a (t2^2 - t1^2) / 2 for front and rear.

    Linear in (v, a), so without iteration. Own derivation: the module has it.

    Parameters
    ----------
    crossings : Crossings
        Line numbers of front and rear at both cameras.
    baseline_m : float
        Between both scanning planes, metres.
    line_rate_hz : float
        Lines a second.

    Returns
    -------
    ExactMotion
        Speed (m/s) and acceleration (m/s^2) as the front reaches camera 1, and length (m).

    Raises
    ------
    ValueError
        Where a crossing order gives no motion.

    Examples
    --------
    >>> import sightline
    >>> crossings = sightline.Crossings(0.0, 400.0, 80.0, 480.0)
    >>> motion = sightline.solve_crossings(crossings, baseline_m=1.0, line_rate_hz=2000.0)
    >>> round(motion.speed_mps, 3), round(motion.length_m, 3)
    (25.0, 5.0)
    """
    start = crossings.front_line_1
    rear_1, front_2, rear_2 = (
        (line - start) / line_rate_hz
        for line in (crossings.rear_line_1, crossings.front_line_2, crossings.rear_line_2)
    )
    if not (rear_1 > 0 and front_2 > 0 and rear_2 > rear_1):
        raise ValueError("The front must cross before the rear, and camera 1 before camera 2.")
    rows = np.array([[front_2, front_2**2 / 2], [rear_2 - rear_1, (rear_2**2 - rear_1**2) / 2]])
    speed, acceleration = np.linalg.solve(rows, np.full(2, baseline_m))
    length = speed * rear_1 + acceleration * rear_1**2 / 2
    return ExactMotion(float(speed), float(acceleration), float(length))


def travelled_m(
    speed_mps: float, acceleration_mps2: float, seconds: float | np.ndarray
) -> float | np.ndarray:
    """How far the front is beyond camera 1 after `seconds`, any shape: v t + a t^2 / 2, metres, of the same
    shape.

    CONVENTIONS.md, Line scan.
    """
    return speed_mps * seconds + acceleration_mps2 * seconds**2 / 2


def _equation_3(crossings: Crossings, baseline_m: float, line_rate_hz: float) -> tuple[float, float]:
    speed = baseline_m * line_rate_hz / _transit(crossings.front_line_1, crossings.front_line_2)
    return speed, speed * (crossings.rear_line_1 - crossings.front_line_1) / line_rate_hz


def _transit(first: float, second: float) -> float:
    if second <= first:
        raise ValueError("A point must cross camera 1 before camera 2: are the cameras swapped?")
    return second - first
