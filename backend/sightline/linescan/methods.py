"""Motion by either method: the default's warped registration, or the paper's block matching.

What either computes is refused where no road vehicle moves so: a number with an uncertainty beside it is
believed, whatever it says.
"""

from collections.abc import Callable

from sightline.coverage import expanded
from sightline.enums import ScanMethod
from sightline.linescan.direct import measure_direct
from sightline.linescan.finding import LENGTHS_M, SPEEDS_MPS
from sightline.linescan.paper import measure_paper
from sightline.linescan.parts import Motion, Passage, Rig

# Brakes on a dry road give 11 m/s2 at most, and no road engine more than that.
MOST_ACCELERATION_MPS2 = 11.5
MOST_U95_SHARE = 0.25


def unlikely(motion: Motion, rig: Rig) -> str | None:
    """Why a computed motion is no road vehicle's or too unsure to be one, in words; None where it may be.

    Speed within 1 to 85 m/s as the front reaches camera 1, still forward as the rear leaves it; acceleration
    of either sign up to 11.5 m/s^2; length 1 to 32 m; the U95 of speed and length up to a quarter of them.
    """
    v, a, length = motion.speed_mps, motion.acceleration_mps2, motion.length_m
    u_v, u_length = motion.u_speed_mps, motion.u_length_m
    if v is None or a is None or length is None or u_v is None or u_length is None:
        return None
    seen = motion.crossings
    leaving = v + a * (seen.rear_line_1 - seen.front_line_1) / rig.line_rate_hz
    for what, value, (low, high), unit in (
        ("speed", v, SPEEDS_MPS, "m/s"),
        ("length", length, LENGTHS_M, "m"),
        ("acceleration", a, (-MOST_ACCELERATION_MPS2, MOST_ACCELERATION_MPS2), "m/s²"),
    ):
        if not low <= value <= high:
            return (
                f"The computed {what}, {value:.1f} {unit}, is no road vehicle's ({low:g} to {high:g} "
                f"{unit}): look at the boundaries, the baseline and the line rate."
            )
    if leaving <= 0:
        return "By the computed motion the vehicle would have stopped in view; look at the boundaries."
    for what, u, value in (("speed", u_v, v), ("length", u_length, length)):
        if expanded(u) > MOST_U95_SHARE * value:
            return (
                f"The {what} is unsure by {100 * expanded(u) / value:.0f} % (95 %), too much to be of use: "
                "the vehicle shows too little, or the boundaries are wrong."
            )
    return None


def believed(measure: Callable[[Passage, Rig], Motion]) -> Callable[[Passage, Rig], Motion]:
    """A method whose unlikely results are refusals."""

    def measured(passage: Passage, rig: Rig) -> Motion:
        motion = measure(passage, rig)
        reason = unlikely(motion, rig)
        return motion if reason is None else Motion(motion.method, motion.crossings, "not_measurable", reason)

    return measured


MEASURE: dict[ScanMethod, Callable[[Passage, Rig], Motion]] = {
    "direct": believed(measure_direct),
    "paper": believed(measure_paper),
}
