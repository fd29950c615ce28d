"""The exact motion of four crossings; the paper's equations (3) and (4) stand with their tests.

Douxchamps, Macq, Chihara: High accuracy traffic monitoring using road-side line-scan cameras. All line
numbers as in `parts`: front and rear in strip 1 and strip 2; f: line rate in Hz; b: baseline in m. A point d
behind the front crosses camera 1 when v t + a t^2 / 2 = d and camera 2 when it equals d + b.
"""

from dataclasses import dataclass

import numpy as np

from sightline.linescan.parts import Crossings


@dataclass(frozen=True)
class ExactMotion:
    """Speed and acceleration as the front reaches camera 1, and the length; m/s, m/s^2, m."""

    speed_mps: float
    acceleration_mps2: float
    length_m: float


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
