"""A vehicle that reaches camera 2 first: measured with the cameras' roles exchanged, told as of camera 1.

A method takes the camera that is reached first as camera 1. Its answer for exchanged roles holds when the
front reaches camera 2; what is told holds when it reaches camera 1, b further on, as of every other vehicle,
so that times, gaps and flows of both directions are those of one place. With v, a at camera 2:
v1^2 = v^2 + 2 a b.
"""

from collections.abc import Callable
from dataclasses import replace
from math import hypot, sqrt

import numpy as np

from sightline.arrays import Floats
from sightline.linescan.equations import ExactMotion, solve_crossings
from sightline.linescan.parts import Crossings, Entry, Motion, Passage, Profile, Rig
from sightline.linescan.rig import baseline_of
from sightline.linescan.warp import Course
from sightline.messages.said import Said

Measure = Callable[[Passage, Rig], Motion]
WOULD_STOP = Said("scan-motion-would-stop")
# sources of a budget that scale every speed of a motion alike
_BASELINE, _CLOCK = "baseline", "clock"


def either_way(measure: Measure) -> Measure:
    """A method that takes vehicles of both directions; those that reach camera 1 first as it always did."""

    def measured(passage: Passage, rig: Rig) -> Motion:
        if passage.crossings.direction == "camera_1_first":
            return measure(passage, rig)
        motion = measure(exchange_cameras(passage), _exchanged_rig(rig))
        return seen_from_camera_1(motion, rig)

    return measured


def exchange_cameras(passage: Passage) -> Passage:
    """The same vehicle with camera 2 as camera 1."""
    return replace(
        passage,
        crossings=_exchanged_lines(passage.crossings),
        first=passage.second,
        second=passage.first,
        start_1=passage.start_2,
        start_2=passage.start_1,
        background_1=passage.background_2,
        background_2=passage.background_1,
    )


def seen_from_camera_1(motion: Motion, rig: Rig) -> Motion:
    """A motion that was measured with exchanged roles, when the front reaches camera 1.

    The covariance of speed and acceleration goes along (JCGM 100:2008, 5.2.2); baseline and clock scale the
    speed there as they do the speed at camera 2. Of the budget's other entries each keeps its share.
    """
    lines = _exchanged_lines(motion.crossings)
    v, a = motion.speed_mps, motion.acceleration_mps2
    if v is None or a is None:
        return replace(motion, crossings=lines)
    baseline_m, u_baseline_m = baseline_of(rig)
    square = v * v + 2 * a * baseline_m
    if square <= 0:
        return Motion(motion.method, lines, "not_measurable", WOULD_STOP)
    there = sqrt(square)
    covariance, entries = _carried(motion, there, baseline_m, u_baseline_m / baseline_m)
    u_v, u_a = (sqrt(max(float(covariance[k, k]), 0.0)) for k in (0, 1))
    shift = motion.misalignment_px
    return replace(
        motion,
        crossings=lines,
        speed_mps=there,
        u_speed_mps=u_v,
        misalignment_px=None if shift is None else -shift,
        gain=1 / motion.gain if motion.gain else None,
        budget=entries,
        profile=_profile(motion.profile, lines, Course(v, a, baseline_m), rig.line_rate_hz),
        correlation=float(np.clip(covariance[0, 1] / (u_v * u_a), -1.0, 1.0)) if u_v * u_a > 0 else 0.0,
    )


def exact_at_camera_1(lines: Crossings, baseline_m: float, line_rate_hz: float) -> ExactMotion:
    """As `solve_crossings`, of either direction; raises ValueError where that does."""
    if lines.direction == "camera_1_first":
        return solve_crossings(lines, baseline_m, line_rate_hz)
    found = solve_crossings(_exchanged_lines(lines), baseline_m, line_rate_hz)
    square = found.speed_mps**2 + 2 * found.acceleration_mps2 * baseline_m
    if square <= 0:
        raise ValueError(WOULD_STOP)
    return replace(found, speed_mps=sqrt(square))


def _carried(
    motion: Motion, there: float, baseline_m: float, baseline_ratio: float
) -> tuple[Floats, tuple[Entry, ...]]:
    """Covariance (2, 2) of speed and acceleration at camera 1, and the budget whose squares give it."""
    v, a = motion.speed_mps or 0.0, motion.acceleration_mps2 or 0.0
    u_v, u_a = motion.u_speed_mps or 0.0, motion.u_acceleration_mps2 or 0.0
    together = (motion.correlation or 0.0) * u_v * u_a
    of_baseline = baseline_ratio**2 * np.array([[v * v, v * a], [v * a, a * a]])
    rest = np.array([[u_v**2, together], [together, u_a**2]]) - of_baseline
    onward = np.array([[v / there, baseline_m / there], [0.0, 1.0]])
    rest = onward @ rest @ onward.T
    rest[0, 0] = max(rest[0, 0], 0.0)
    covariance = rest + baseline_ratio**2 * np.array([[there * there, there * a], [there * a, a * a]])
    scaling = there / v
    fixed = {_BASELINE: scaling, _CLOCK: scaling}
    of_clock = hypot(*(one.u_speed_mps * scaling for one in motion.budget if one.source == _CLOCK))
    others = hypot(*(one.u_speed_mps for one in motion.budget if one.source not in fixed))
    share = sqrt(max(rest[0, 0] - of_clock**2, 0.0)) / others if others > 0 else 1.0
    entries = tuple(
        replace(one, u_speed_mps=one.u_speed_mps * fixed.get(one.source, share)) for one in motion.budget
    )
    covariance[0, 0] = hypot(*(one.u_speed_mps for one in entries)) ** 2 if entries else covariance[0, 0]
    return np.asarray(covariance, np.float64), entries


def _profile(
    profile: Profile | None, lines: Crossings, course: Course, line_rate_hz: float
) -> Profile | None:
    """Its lines are those of strip 2; each point reached camera 1 when the motion says."""
    if profile is None:
        return None
    since_s = (profile.line_1 - lines.front_line_2) / line_rate_hz
    at = lines.front_line_2 + course.second_s(since_s) * line_rate_hz
    return replace(profile, line_1=np.asarray(at, np.float64))


def _exchanged_rig(rig: Rig) -> Rig:
    shift = rig.misalignment_px
    return rig if shift is None else replace(rig, misalignment_px=-shift)


def _exchanged_lines(lines: Crossings) -> Crossings:
    return Crossings(lines.front_line_2, lines.rear_line_2, lines.front_line_1, lines.rear_line_1)
