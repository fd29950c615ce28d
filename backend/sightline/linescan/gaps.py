"""Time gap, distance gap and headway of successive vehicles of one direction and lane at camera 1.

Definitions. Time gap: from the rear of the vehicle before to this front, both at camera 1 (equation (5)).
Headway: from its front to this front. Distance gap: between the same two points at the moment this front
reaches camera 1, so the leader is carried on by its own motion from where its rear left camera 1. Its u holds
what was measured. A leader that changes its acceleration by A after camera 1 changes the gap by A t^2 / 2, t
being the time gap; nobody sees that, and no number here holds it: with 0.3 m/s^2 4 cm at 0.5 s, 0.6 m at 2 s.
The paper's D, the time gap times the mean of the two speeds, is kept beside it by name: it is exact at
mid-time only for equal or constant speeds, and far off where neighbours differ strongly.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import hypot, sqrt

from sightline.enums import ScanDirection
from sightline.linescan.boundaries import SAME_END, U_LINE_LINES
from sightline.linescan.parts import Crossings, Gap, Motion, Rig, front_seen, rear_seen
from sightline.linescan.rig import u_travelled_m
from sightline.messages.said import Said

NONE_BEFORE = Said("scan-gap-none-before")
LANE_UNKNOWN = Said("scan-gap-lane-unknown")
BEFORE_UNKNOWN = Said("scan-gap-before-unknown")
OVERLAP = Said("scan-gap-overlap")
REAR_UNSEEN = Said("scan-gap-rear-unseen")


class Leaders:
    """Vehicle after vehicle in the order of their fronts at camera 1: the gap to the one before it of its
    direction and lane, of those beside each other the one whose rear left camera 1 last.

    Where a rig has lanes and a vehicle's is not known, neither its gap is, nor the next one of either lane.
    """

    def __init__(self, rig: Rig) -> None:
        self._rig = rig
        self._last: dict[tuple[ScanDirection, str | None], tuple[int, Crossings, Motion]] = {}
        self._unknown: dict[ScanDirection, int] = {}
        self._count = 0

    def next(self, crossings: Crossings, motion: Motion, *, beside: bool = False) -> Gap:
        """The gap before this vehicle, which is the one before from now on unless that one leaves later.

        `beside`: this one passes one that stands and is told later, which is then the leader of a list.
        """
        leader = self.leader(crossings, motion)
        if beside and (leader == NONE_BEFORE or not isinstance(leader, Said)):
            leader = OVERLAP
        if isinstance(leader, Said):
            return Gap(None, None, None, reason=leader)
        return _gap(leader[1:], (crossings, motion), self._rig)

    def leader(self, crossings: Crossings, motion: Motion) -> tuple[int, Crossings, Motion] | Said:
        """The vehicle that this one's gap runs from, with its place from 1 among those told, or why none.

        One whose rear nobody saw was there at least until it was given up, and is taken to have left before
        the next front after that.
        """
        way, self._count = crossings.direction, self._count + 1
        if self._rig.lanes and motion.lane is None:
            self._unknown[way] = self._count
            return LANE_UNKNOWN
        before = self._last.get((way, motion.lane))
        if before is None or crossings.rear_line_1 >= before[1].rear_line_1:
            self._last[way, motion.lane] = self._count, crossings, motion
        if self._unknown.get(way, 0) > (before[0] if before else 0):
            return BEFORE_UNKNOWN
        return NONE_BEFORE if before is None else before


def gaps(vehicles: Sequence[tuple[Crossings, Motion]], rig: Rig) -> list[Gap]:
    """One gap a vehicle, in the order given (by front at camera 1), to the one before it of its direction and
    lane; the first of each has nothing before it.
    """
    leaders = Leaders(rig)
    return [leaders.next(*one) for one in vehicles]


def _gap(before: tuple[Crossings, Motion], this: tuple[Crossings, Motion], rig: Rig) -> Gap:
    (ahead, leader), (behind, follower) = before, this
    rate = rig.line_rate_hz
    time_s = (behind.front_line_1 - ahead.rear_line_1) / rate
    since_front_s = (behind.front_line_1 - ahead.front_line_1) / rate
    if time_s <= 0 or since_front_s <= 0:
        return Gap(None, None, None, reason=OVERLAP)
    headway_s = since_front_s if front_seen(leader.reason, ahead.front_line_1) else None
    if not rear_seen(leader.reason):
        return Gap(None, None, headway_s, reason=REAR_UNSEEN)
    known = Gap(time_s, None, headway_s)
    if leader.speed_mps is None or leader.acceleration_mps2 is None:
        return replace(known, reason=Said("scan-gap-leader-unmeasured"))
    passing_s = (ahead.rear_line_1 - ahead.front_line_1) / rate
    leaving_mps = leader.speed_mps + leader.acceleration_mps2 * passing_s
    u_rear_s = _u_crossing_s(leader, leaving_mps, rate)
    paper_m = u_time_s = None
    if follower.speed_mps is not None:
        paper_m = time_s * (leader.speed_mps + follower.speed_mps) / 2
        u_front_s = _u_crossing_s(follower, follower.speed_mps, rate)
        u_time_s = hypot(u_rear_s, u_front_s, time_s * rig.u_line_rate_ratio)
    known = replace(known, u_time_gap_s=u_time_s)
    now_mps = leaving_mps + leader.acceleration_mps2 * time_s
    if now_mps <= 0:
        return replace(known, paper_distance_gap_m=paper_m, reason=Said("scan-gap-leader-stopped"))
    distance_m = (leaving_mps + now_mps) / 2 * time_s
    u_motion_m = u_travelled_m(leader, passing_s, since_front_s, rig.u_line_rate_ratio)
    u_m = hypot(u_motion_m, now_mps * u_rear_s)
    if follower.speed_mps is not None:
        u_m = hypot(u_m, now_mps * _u_crossing_s(follower, follower.speed_mps, rate))
    return replace(known, distance_gap_m=distance_m, paper_distance_gap_m=paper_m, u_distance_gap_m=u_m)


def _u_crossing_s(motion: Motion, speed_mps: float, line_rate_hz: float) -> float:
    """Of the moment at which one end of a vehicle crosses camera 1: an end is known to so many metres at any
    speed, as the length's budget says of both together; between two lines it was interpolated.
    """
    of_length = {one.source: one.u_length_m for one in motion.budget}
    # the paper's length is camera 1's alone, the other the mean of both cameras', interpolated in both
    both_m = of_length.get("boundaries", 0.0)
    lines_m = U_LINE_LINES * (motion.speed_mps or 0.0) / line_rate_hz
    one_m = sqrt(max(both_m**2 - lines_m**2, 0.0) / (1 + SAME_END))
    one_m = hypot(one_m, of_length.get("front and rear", 0.0) / sqrt(2))
    return hypot(one_m / speed_mps, U_LINE_LINES / line_rate_hz)
