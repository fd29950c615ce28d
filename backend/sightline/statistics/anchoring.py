"""How far people lean on proposals that they are shown: the shift of heights that showing them makes.

Of each vehicle d is the height that a person stored minus the height that the proposed points give; the
proposals of some vehicles, drawn at random, were shown to nobody. With the draw, both kinds of vehicles
differ by nothing but the showing, so mean d of those shown minus mean d of those free estimates by how much
showing a proposal moves a stored height, on average over the vehicles of which something is proposed. Taking
the proposal's height away first removes how vehicles differ in height, and what lens, pose, board and inset
do to both alike. It says nothing of how right a proposal is.

The interval is Welch's for two means of unequal variance (Welch 1938; Satterthwaite 1946): u^2 is the sum of
s^2/n of both, with their degrees of freedom. A vehicle counts once. Left out: that a person's vehicles are
more alike than those of two; with few people the interval is theirs, and of no other.
"""

from dataclasses import dataclass
from math import sqrt
from typing import Any

import numpy as np
import scipy
from numpy.typing import ArrayLike

from sightline.enums import GoalVerdict

LEAST_VEHICLES = 5  # of each kind; below this the interval of a mean is a guess


@dataclass(frozen=True)
class Shift:
    """Mean d (m) of vehicles shown and free, their difference `shift_m` with its 95 % half-width; None with
    `reason`, a key of the catalogue of messages, where too few vehicles tell.
    """

    shown: int
    free: int
    shown_m: float | None
    free_m: float | None
    shift_m: float | None
    U95_shift_m: float | None
    reason: str | None = None


def shift(shown_m: ArrayLike, free_m: ArrayLike) -> Shift:
    """What showing proposals does. `shown_m` (m,), `free_m` (n,): d of each vehicle, metres.

    Welch 1938; the module says what it estimates.
    """
    of_shown, of_free = (np.asarray(values, dtype=np.float64).ravel() for values in (shown_m, free_m))
    shown, free = (float(values.mean()) if len(values) else None for values in (of_shown, of_free))
    counts: dict[str, Any] = {"shown": len(of_shown), "free": len(of_free), "shown_m": shown, "free_m": free}
    if min(len(of_shown), len(of_free)) < LEAST_VEHICLES or shown is None or free is None:
        return Shift(**counts, shift_m=None, U95_shift_m=None, reason="anchoring-too-few")
    parts = [float(values.var(ddof=1)) / len(values) for values in (of_shown, of_free)]
    variance = sum(parts)
    weights = [part**2 / (len(values) - 1) for part, values in zip(parts, (of_shown, of_free), strict=True)]
    freedom = variance**2 / sum(weights) if variance > 0 else float(len(of_shown) + len(of_free) - 2)
    half = float(scipy.stats.t.ppf(0.975, freedom)) * sqrt(variance)
    return Shift(**counts, shift_m=shown - free, U95_shift_m=half)


def verdict(effect: Shift, goal_m: float) -> GoalVerdict | None:
    """Whether the whole interval lies within the goal, outside, or neither; None without one."""
    if effect.shift_m is None or effect.U95_shift_m is None:
        return None
    if abs(effect.shift_m) + effect.U95_shift_m < goal_m:
        return "met"
    return "missed" if abs(effect.shift_m) - effect.U95_shift_m > goal_m else "undecided"
