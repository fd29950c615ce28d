"""Time gap, distance gap and headway between successive vehicles at camera 1.

Definitions. Time gap: from the rear of the vehicle before to this front, both at camera 1 (equation (5)).
Headway: from its front to this front. Distance gap: between the same two points at the moment this front
reaches camera 1, so the leader is carried on by its own motion from where its rear left camera 1. The paper's
D, the time gap times the mean of the two speeds, is kept beside it by name: it is exact at mid-time only for
equal or constant speeds, and far off where neighbours differ strongly.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from math import hypot, sqrt

from sightline.linescan.parts import Crossings, Gap, Motion, Rig

# Of a motion's budget what its boundaries bring to the length, by method; one of both is their share of it.
_BOUNDARIES = ("boundaries", "front and rear")
# What a line's own exposure leaves of the moment of a crossing: even over one line.
U_LINE_LINES = 1 / sqrt(12)
# How far a driver's acceleration after camera 1 is from the one measured there; an assumption, stated.
U_LATER_ACCELERATION_MPS2 = 0.3


def gaps(vehicles: Sequence[tuple[Crossings, Motion]], rig: Rig) -> list[Gap]:
    """One gap a vehicle, in the order given (by front at camera 1); the first has nothing before it."""
    out = [Gap(None, None, None, reason="No vehicle was seen before this one.")] if vehicles else []
    for before, this in pairwise(vehicles):
        out.append(_gap(before, this, rig))
    return out


def _gap(before: tuple[Crossings, Motion], this: tuple[Crossings, Motion], rig: Rig) -> Gap:
    (ahead, leader), (behind, follower) = before, this
    rate = rig.line_rate_hz
    time_s = (behind.front_line_1 - ahead.rear_line_1) / rate
    headway_s = (behind.front_line_1 - ahead.front_line_1) / rate
    if time_s <= 0 or headway_s <= 0:
        return Gap(None, None, None, reason="The two vehicles overlap at camera 1, so there is no gap.")
    known = Gap(time_s, None, headway_s)
    if leader.speed_mps is None or leader.acceleration_mps2 is None:
        return replace(known, reason="The vehicle before has no measured motion.")
    since_front_s = (ahead.rear_line_1 - ahead.front_line_1) / rate
    leaving_mps = leader.speed_mps + leader.acceleration_mps2 * since_front_s
    u_rear_s = _u_crossing_s(leader, leaving_mps, rate)
    paper_m = u_time_s = None
    if follower.speed_mps is not None:
        paper_m = time_s * (leader.speed_mps + follower.speed_mps) / 2
        u_front_s = _u_crossing_s(follower, follower.speed_mps, rate)
        u_time_s = hypot(u_rear_s, u_front_s, time_s * rig.u_line_rate_ratio)
    known = replace(known, u_time_gap_s=u_time_s)
    now_mps = leaving_mps + leader.acceleration_mps2 * time_s
    if now_mps <= 0:
        reason = "Braking on as measured, the vehicle before would have stopped by then."
        return replace(known, paper_distance_gap_m=paper_m, reason=reason)
    distance_m = (leaving_mps + now_mps) / 2 * time_s
    u_m = hypot(_u_motion_m(leader, headway_s, since_front_s), now_mps * u_rear_s)
    if follower.speed_mps is not None:
        u_m = hypot(u_m, now_mps * _u_crossing_s(follower, follower.speed_mps, rate))
    u_m = hypot(u_m, U_LATER_ACCELERATION_MPS2 * time_s**2 / 2)
    return replace(known, distance_gap_m=distance_m, paper_distance_gap_m=paper_m, u_distance_gap_m=u_m)


def _u_crossing_s(motion: Motion, speed_mps: float, line_rate_hz: float) -> float:
    """Of the moment at which one end of a vehicle crosses camera 1: an end is known to so many metres at any
    speed, as the length's budget says of both together.
    """
    u_both_m = hypot(*(one.u_length_m for one in motion.budget if one.source in _BOUNDARIES))
    return hypot(u_both_m / sqrt(2) / speed_mps, U_LINE_LINES / line_rate_hz)


def _u_motion_m(leader: Motion, headway_s: float, since_front_s: float) -> float:
    """What the leader's speed and acceleration, correlated as fitted, bring to v D + a (t2^2 - t1^2) / 2."""
    of_speed = (headway_s - since_front_s) * (leader.u_speed_mps or 0.0)
    of_acceleration = (headway_s**2 - since_front_s**2) / 2 * (leader.u_acceleration_mps2 or 0.0)
    together = 2 * (leader.correlation or 0.0) * of_speed * of_acceleration
    return sqrt(max(of_speed**2 + of_acceleration**2 + together, 0.0))
