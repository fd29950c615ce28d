"""Where a point of strip 1 is to be found in strip 2 under a motion of constant acceleration.

A point that crosses camera 1 at t1 crosses camera 2 at t2 with b = v (t2 - t1) + a/2 (t2^2 - t1^2): exact,
where b / (t2 - t1) would be the speed half the way between the two.
"""

from dataclasses import dataclass

import numpy as np

from sightline.arrays import Floats


@dataclass(frozen=True)
class Course:
    """Speed and acceleration at time 0, when the front reaches camera 1, and the baseline."""

    speed_mps: float
    acceleration_mps2: float
    baseline_m: float

    def travelled_m(self, time_s: Floats) -> Floats:
        """How far the front is beyond camera 1 at `time_s`, any shape: v t + a t^2 / 2, m, same shape."""
        return np.asarray(self.speed_mps * time_s + self.acceleration_mps2 / 2 * time_s**2)

    def speed_at_mps(self, time_s: Floats) -> Floats:
        """The speed at `time_s`, any shape: v + a t, m/s, of the same shape."""
        return np.asarray(self.speed_mps + self.acceleration_mps2 * time_s)

    def second_s(self, first_s: Floats) -> Floats:
        """t2 of t1, `first_s` of any shape, seconds, of the same shape; the root of the quadratic that stays
        exact as the acceleration goes to 0.

        A vehicle that would stop before camera 2 gets the time at which it stops.
        """
        v, a = self.speed_mps, self.acceleration_mps2
        to_go = self.baseline_m + self.travelled_m(first_s)
        under = np.maximum(v * v + 2 * a * to_go, 0.0)
        return np.asarray(2 * to_go / np.maximum(v + np.sqrt(under), 1e-6))

    def derivatives(self, first_s: Floats, second_s: Floats) -> tuple[Floats, Floats]:
        """d t2 / d speed and d t2 / d acceleration, (n,) each, at t1 and t2, `first_s`, `second_s` (n,):
        minus (t2 - t1) / v(t2) and (t2^2 - t1^2) / (2 v(t2)).
        """
        now = np.maximum(self.speed_at_mps(second_s), 1e-3)
        return (
            np.asarray(-(second_s - first_s) / now),
            np.asarray(-(second_s**2 - first_s**2) / (2 * now)),
        )


def solved_by_boundaries(crossed_s: Floats, baseline_m: float) -> Course:
    """Speed and acceleration from the four crossings alone (two linear equations): where a search begins.

    `crossed_s` (4,): front and rear at camera 1, front and rear at camera 2; seconds, the first one 0.

    CONVENTIONS.md, Line scan: b = v (t2 - t1) + a (t2^2 - t1^2) / 2 for front and rear, in the place of
    Douxchamps et al., eqs. (3) and (4), of which (4) lacks f^2. Where that is singular or no motion of a
    vehicle: the mean speed, a = 0.
    """
    f1, r1, f2, r2 = (float(value) for value in crossed_s)
    left = np.array([[f2 - f1, (f2**2 - f1**2) / 2], [r2 - r1, (r2**2 - r1**2) / 2]])
    if abs(np.linalg.det(left)) < 1e-12 or f2 <= f1 or r2 <= r1:
        mean = max((f2 - f1 + r2 - r1) / 2, 1e-6)
        return Course(baseline_m / mean, 0.0, baseline_m)
    v, a = np.linalg.solve(left, [baseline_m, baseline_m])
    if not (v > 0 and abs(a) < 6 and v + a * r2 > 0.3 * v):
        v, a = 2 * baseline_m / (f2 - f1 + r2 - r1), 0.0
    return Course(float(v), float(a), baseline_m)
