"""Motion by either method, of vehicles of either direction and any lane: the default's warped registration,
or the paper's block matching.

What either computes is refused where no road vehicle moves so: a number with an uncertainty beside it is
believed, whatever it says.
"""

from collections.abc import Callable
from dataclasses import replace
from math import hypot, inf, isfinite

from sightline.coverage import expanded
from sightline.enums import ScanMethod
from sightline.linescan.direct import measure_direct
from sightline.linescan.either_way import WOULD_STOP, either_way
from sightline.linescan.finding import LENGTHS_M, SPEEDS_MPS
from sightline.linescan.fineness import too_coarse
from sightline.linescan.lanes import in_its_lane
from sightline.linescan.paper import measure_paper
from sightline.linescan.parts import Motion, Passage, Rig
from sightline.linescan.wheels import wheels_in
from sightline.messages.said import Said

# Brakes on a dry road give 11 m/s2 at most, and no road engine more than that.
MOST_ACCELERATION_MPS2 = 11.5
MOST_U95_SHARE = 0.25


def unlikely_motion_reason(motion: Motion, rig: Rig) -> Said | None:
    """Why a computed motion is no road vehicle's or too unsure to be one; None where it may be.

    Speed within 1 to 85 m/s as the front reaches camera 1, still forward as the rear leaves it; acceleration
    of either sign up to 11.5 m/s^2; length 1 to 32 m; a U95 of speed and length, up to a quarter of them;
    of the direct method's acceleration, up to 11.5 m/s^2.
    """
    v, a, length = motion.speed_mps, motion.acceleration_mps2, motion.length_m
    u_v, u_a, u_length = motion.u_speed_mps, motion.u_acceleration_mps2, motion.u_length_m
    if v is None or a is None or length is None or u_v is None or u_length is None:
        return None
    seen = motion.crossings
    leaving = v + a * (seen.rear_line_1 - seen.front_line_1) / rig.line_rate_hz
    for what, value, (low, high), unit in (
        ("speed", v, SPEEDS_MPS, "m/s"),
        ("length", length, LENGTHS_M, "m"),
        ("acceleration", a, (-MOST_ACCELERATION_MPS2, MOST_ACCELERATION_MPS2), "m/s²"),
    ):
        if not isfinite(value):
            return Said("scan-motion-not-finite", what=what)
        if not low <= value <= high:
            return Said(
                "scan-motion-implausible", what=what, value=round(value, 1), unit=unit, low=low, high=high
            )
    if u_v <= 0 or u_length <= 0 or not u_v + u_length < inf:
        return Said("scan-motion-no-uncertainty")
    if leaving <= 0:
        return WOULD_STOP
    for what, u, value in (("speed", u_v, v), ("length", u_length, length)):
        if expanded(u) > MOST_U95_SHARE * value:
            return Said("scan-motion-u-large", what=what, percent=round(100 * expanded(u) / value))
    # of the paper's method the acceleration is often as unsure; its speed is none the worse for it
    if motion.method == "direct" and u_a is not None and expanded(u_a) > MOST_ACCELERATION_MPS2:
        return Said("scan-motion-u-acceleration-large", U95_mps2=round(expanded(u_a)))
    return None


def refuse_unlikely(measure: Callable[[Passage, Rig], Motion]) -> Callable[[Passage, Rig], Motion]:
    """A method whose unlikely results are refusals, as are vehicles for which the lines are too slow."""

    def measured(passage: Passage, rig: Rig) -> Motion:
        motion = measure(passage, rig)
        judged = passage.reason is None or passage.reason.code == "scan-motion-few-lines"
        coarse = too_coarse(passage, rig) if judged else None
        if coarse is not None:
            return Motion(motion.method, motion.crossings, "not_measurable", coarse)
        reason = unlikely_motion_reason(motion, rig)
        return motion if reason is None else Motion(motion.method, motion.crossings, "not_measurable", reason)

    return measured


def with_doubt(measure: Callable[[Passage, Rig], Motion]) -> Callable[[Passage, Rig], Motion]:
    """A method whose motions keep what the doubt about their boundaries brought to the length's u."""

    def measured(passage: Passage, rig: Rig) -> Motion:
        return replace(measure(passage, rig), u_boundaries_m=hypot(*passage.u_ends_m))

    return measured


def with_axle_lines(measure: Callable[[Passage, Rig], Motion]) -> Callable[[Passage, Rig], Motion]:
    """A method whose motions tell the wheels that strip 1 shows."""

    def measured(passage: Passage, rig: Rig) -> Motion:
        motion = measure(passage, rig)
        if motion.status != "ok":
            return motion
        return replace(motion, axle_lines=wheels_in(passage.first, passage.start_1, motion, rig).lines)

    return measured


MEASURE: dict[ScanMethod, Callable[[Passage, Rig], Motion]] = {
    "direct": with_doubt(in_its_lane(with_axle_lines(either_way(refuse_unlikely(measure_direct))))),
    "paper": with_doubt(in_its_lane(with_axle_lines(either_way(refuse_unlikely(measure_paper))))),
}
