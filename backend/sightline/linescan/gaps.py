"""Time gap, distance gap and headway of successive vehicles of one direction and lane at camera 1.

Definitions. Time gap: from the rear of the vehicle before to this front, both at camera 1 (equation (5)).
Headway: from the front before, of that direction and lane, to this front, also where both overlap, as a
count of traffic takes it (`traffic.headways_s`). Distance gap: between the same two points as the time gap at
the moment this front reaches camera 1, so the leader is carried on by its own motion from where its rear left
camera 1. Its u holds what was measured. A leader that changes its acceleration by A after camera 1 changes
the gap by A t^2 / 2, t being the time gap; nobody sees that, and no number here holds it: with 0.3 m/s^2 4 cm
at 0.5 s, 0.6 m at 2 s.
The paper's D, the time gap times the mean of the two speeds, is kept beside it by name: it is exact at
mid-time only for equal or constant speeds, and far off where neighbours differ strongly.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import hypot

from sightline.enums import ScanDirection
from sightline.linescan.boundaries import U_LINE_LINES
from sightline.linescan.budget import u_at_one_camera, u_end_of
from sightline.linescan.parts import Crossings, Gap, Motion, Rig, front_seen, rear_seen
from sightline.linescan.rig import u_travelled_m
from sightline.linescan.traffic import Stream
from sightline.messages.said import Said

NONE_BEFORE = Said("scan-gap-none-before")
LANE_UNKNOWN = Said("scan-gap-lane-unknown")
BEFORE_UNKNOWN = Said("scan-gap-before-unknown")
OVERLAP = Said("scan-gap-overlap")
REAR_UNSEEN = Said("scan-gap-rear-unseen")
OTHER_RATE = Said("scan-gap-other-rate")
LEADER_STOPPED = Said("scan-gap-leader-stopped")


#: A vehicle with the rig that it was measured with.
Measured = tuple[Crossings, Motion, Rig]


class Leaders:
    """Vehicle after vehicle in the order of their fronts at camera 1: the gap to the one before it of its
    direction and lane, of those beside each other the one whose rear left camera 1 last.

    Where a rig has lanes and a vehicle's is not known, neither its gap is, nor the next one of either lane.
    """

    def __init__(self, rig: Rig) -> None:
        self._rig = rig
        self._last: dict[Stream, tuple[int, Crossings, Motion, Rig]] = {}
        self._fronts: dict[Stream, tuple[int, Crossings, Motion, Rig]] = {}
        self._unknown: dict[ScanDirection, int] = {}
        self._count = 0

    def next(
        self, crossings: Crossings, motion: Motion, rig: Rig | None = None, *, beside: bool = False
    ) -> Gap:
        """The gap before this vehicle, which is the one before from now on unless that one leaves later.

        `rig`: that it was measured with, where the vehicles do not all have one. `beside`: this one passes
        one that stands and is told later, which is then the leader of a list.
        """
        this = crossings, motion, rig or self._rig
        leader, headway_s = self.leader(*this), self._headway_s(*this)
        if beside and (leader == NONE_BEFORE or not isinstance(leader, Said)):
            return Gap(None, None, None, reason=OVERLAP)
        if isinstance(leader, Said):
            return Gap(None, None, headway_s, reason=leader)
        return replace(_gap(leader[1:], this), headway_s=headway_s)

    def _headway_s(self, *this: *Measured) -> float | None:
        """From the last front of its direction and lane to this one, which is the last from now on; None
        where one of unknown lane may have come since.
        """
        way, lane = this[0].direction, this[1].lane
        before = self._fronts.get((way, lane))
        if before is None or this[0].front_line_1 >= before[1].front_line_1:
            self._fronts[way, lane] = self._count, *this
        if before is None or self._unknown.get(way, 0) >= before[0]:
            return None
        return _headway_s(before[1:], this)

    def leader(
        self, crossings: Crossings, motion: Motion, rig: Rig | None = None
    ) -> tuple[int, *Measured] | Said:
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
            self._last[way, motion.lane] = self._count, crossings, motion, rig or self._rig
        if self._unknown.get(way, 0) > (before[0] if before else 0):
            return BEFORE_UNKNOWN
        return NONE_BEFORE if before is None else before


def gaps(vehicles: Sequence[tuple[Crossings, Motion] | Measured], rig: Rig) -> list[Gap]:
    """One gap a vehicle, in the order given (by front at camera 1), to the one before it of its direction and
    lane; the first of each has nothing before it. Lines of two that were measured at different line rates
    have no time between them.
    """
    leaders = Leaders(rig)
    return [leaders.next(*one) for one in vehicles]


def _headway_s(before: Measured, this: Measured) -> float | None:
    """From front to front; None where one was not seen, is told late, or has another line rate."""
    lines = this[0].front_line_1 - before[0].front_line_1
    seen = all(front_seen(motion.reason, at.front_line_1) for at, motion, _ in (before, this))
    rates_hz = {rig.line_rate_hz for _, _, rig in (before, this)}
    return lines / rates_hz.pop() if seen and len(rates_hz) == 1 and lines >= 0 else None


def _gap(before: Measured, this: Measured) -> Gap:
    """All but the headway."""
    (ahead, leader, rig_ahead), (behind, follower, rig) = before, this
    rate = rig.line_rate_hz
    if rig_ahead.line_rate_hz != rate:
        return Gap(None, None, None, reason=OTHER_RATE)
    time_s = (behind.front_line_1 - ahead.rear_line_1) / rate
    since_front_s = (behind.front_line_1 - ahead.front_line_1) / rate
    if time_s <= 0 or since_front_s <= 0:
        return Gap(None, None, None, reason=OVERLAP)
    if not rear_seen(leader.reason):
        return Gap(None, None, None, reason=REAR_UNSEEN)
    known = Gap(time_s, None, None)
    if leader.speed_mps is None or leader.acceleration_mps2 is None:
        return replace(known, reason=Said("scan-gap-leader-unmeasured"))
    passing_s = (ahead.rear_line_1 - ahead.front_line_1) / rate
    leaving_mps = leader.speed_mps + leader.acceleration_mps2 * passing_s
    if leaving_mps <= 0:
        return replace(known, reason=LEADER_STOPPED)
    u_rear_s = _u_crossing_s("rear", leader, leaving_mps, rate)
    paper_m = u_time_s = None
    u_front_s = 0.0
    if follower.speed_mps:
        paper_m = time_s * (leader.speed_mps + follower.speed_mps) / 2
        u_front_s = _u_crossing_s("front", follower, follower.speed_mps, rate)
        u_time_s = hypot(u_rear_s, u_front_s, time_s * rig.u_line_rate_ratio)
    known = replace(known, u_time_gap_s=u_time_s)
    now_mps = leaving_mps + leader.acceleration_mps2 * time_s
    if now_mps <= 0:
        return replace(known, paper_distance_gap_m=paper_m, reason=LEADER_STOPPED)
    distance_m = (leaving_mps + now_mps) / 2 * time_s
    u_motion_m = u_travelled_m(leader, passing_s, since_front_s, rig.u_line_rate_ratio)
    u_m = hypot(u_motion_m, now_mps * u_rear_s, now_mps * u_front_s)
    return replace(known, distance_gap_m=distance_m, paper_distance_gap_m=paper_m, u_distance_gap_m=u_m)


def _u_crossing_s(end: str, motion: Motion, speed_mps: float, line_rate_hz: float) -> float:
    """Of the moment at which one `end` of a vehicle crosses camera 1: it is known to so many metres at any
    speed, as the length's budget says; one that a person placed besides to what lies between two lines.
    """
    lines = 0.0 if motion.u_boundaries_m else U_LINE_LINES
    end_m = u_end_of(motion.budget, end)
    # the paper's length is camera 1's alone, the other the mean of both cameras'
    if motion.method == "direct":
        end_m = u_at_one_camera(end_m, lines * (motion.speed_mps or 0.0) / line_rate_hz)
    return hypot(end_m / speed_mps, lines / line_rate_hz)
