"""Equations (2) to (5) of the paper, printed and corrected, against motions integrated step by step."""

from dataclasses import dataclass, replace

import pytest

from sightline.enums import ScanMethod
from sightline.errors import BadInput
from sightline.linescan.equations import solve_crossings
from sightline.linescan.finding import STOPPED
from sightline.linescan.gaps import LEADER_STOPPED, OTHER_RATE, OVERLAP, REAR_UNSEEN, Leaders, gaps
from sightline.linescan.parts import CUT, STOOD, Crossings, Entry, Motion, Rig
from sightline.linescan.planner import line_rate_for, speed_error
from sightline.linescan.traffic import headways_s

BASELINE_M, RATE_HZ = 0.593, 4882.8


@dataclass(frozen=True)
class PaperMotion:
    """Speed (m/s), length (m), acceleration (m/s^2) of equations (3) and (4)."""

    speed_mps: float
    length_m: float
    acceleration_mps2: float


def solve_as_printed(crossings: Crossings, baseline_m: float, line_rate_hz: float) -> PaperMotion:
    """Equations (3) and (4) as printed. (4) lacks f^2, so what it gives is no acceleration (its unit is m).

    Of the paper's line numbers as in `parts`; the program uses `solve_crossings`.
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


def _equation_3(crossings: Crossings, baseline_m: float, line_rate_hz: float) -> tuple[float, float]:
    speed = baseline_m * line_rate_hz / _transit(crossings.front_line_1, crossings.front_line_2)
    return speed, speed * (crossings.rear_line_1 - crossings.front_line_1) / line_rate_hz


def _transit(first: float, second: float) -> float:
    if second <= first:
        raise ValueError("A point must cross camera 1 before camera 2: are the cameras swapped?")
    return second - first


def crossing_line(speed: float, acceleration: float, distance: float) -> float:
    """When a point `distance` behind the front reaches camera 1, by bisection; lines."""
    low, high = 0.0, 100.0
    for _ in range(200):
        middle = (low + high) / 2
        reached = speed * middle + acceleration * middle * middle / 2
        # beyond standstill a braking vehicle is taken as gone
        moving = speed + acceleration * middle > 0
        low, high = (middle, high) if reached < distance and moving else (low, middle)
    return low * RATE_HZ


def crossings(speed: float, acceleration: float, length: float, start: float = 0.0) -> Crossings:
    places = (0.0, length, BASELINE_M, length + BASELINE_M)
    return Crossings(*(start + crossing_line(speed, acceleration, place) for place in places))


@pytest.mark.parametrize(
    ("speed", "acceleration", "length"), [(10, 1.5, 4.39), (10, -4, 4.39), (17.6, 0, 3.84), (36, -1.4, 8)]
)
def test_corrected_acceleration_and_the_exact_motion_are_exact(
    speed: float, acceleration: float, length: float
) -> None:
    seen = crossings(speed, acceleration, length)
    assert solve_corrected(seen, BASELINE_M, RATE_HZ).acceleration_mps2 == pytest.approx(
        acceleration, abs=1e-8
    )
    found = solve_crossings(seen, BASELINE_M, RATE_HZ)
    assert found.speed_mps == pytest.approx(speed, rel=1e-9)
    assert found.acceleration_mps2 == pytest.approx(acceleration, abs=1e-8)
    assert found.length_m == pytest.approx(length, abs=1e-9)


def test_what_is_printed_is_no_acceleration_and_its_time_base_is_off() -> None:
    seen = crossings(17.5, -1.4, 4.39)
    as_printed = solve_as_printed(seen, BASELINE_M, RATE_HZ)
    assert as_printed.acceleration_mps2 == pytest.approx(-5.9e-8, rel=0.01)
    assert as_printed.acceleration_mps2 * RATE_HZ**2 == pytest.approx(-1.4, rel=0.005)
    braking = crossings(10, -4, 4.39)
    with_f2 = solve_as_printed(braking, BASELINE_M, RATE_HZ).acceleration_mps2 * RATE_HZ**2
    assert with_f2 == pytest.approx(-4.06, abs=0.005)
    # Equation (3): the speed midway between the cameras, and a length that neglects the acceleration.
    assert solve_corrected(braking, BASELINE_M, RATE_HZ).speed_mps == pytest.approx(10 * 0.988, rel=0.001)
    assert solve_corrected(braking, BASELINE_M, RATE_HZ).length_m - 4.39 > 0.4


def test_crossings_in_no_order_are_no_motion() -> None:
    with pytest.raises(ValueError, match="swapped"):
        solve_corrected(Crossings(100, 900, 50, 850), BASELINE_M, RATE_HZ)
    with pytest.raises(ValueError, match="front"):
        solve_crossings(Crossings(100, 90, 150, 140), BASELINE_M, RATE_HZ)


def test_the_line_rate_planner_gives_the_papers_own_figures() -> None:
    plan = line_rate_for(0.01, 120 / 3.6, 1.0)
    assert plan.printed_right_side_hz == pytest.approx(6600, rel=1e-3)
    assert plan.corrected_hz == pytest.approx(6667, rel=1e-3)
    expected = speed_error(70 / 3.6, BASELINE_M, RATE_HZ)
    assert expected.printed_right_side == pytest.approx(0.013, abs=0.0005)
    assert expected.corrected == pytest.approx(2 * 70 / 3.6 / (BASELINE_M * RATE_HZ))
    with pytest.raises(BadInput, match="share"):
        line_rate_for(1.0, 30.0, 1.0)


def motion(seen: Crossings, speed: float, acceleration: float, length: float) -> Motion:
    return Motion("direct", seen, "ok", None, speed, 0.01, acceleration, 0.1, length, 0.01, correlation=-0.9)


@pytest.mark.parametrize(
    ("method", "source", "found_m", "u_s"),
    [
        # an end at one camera has 1 / 1.58 of both cameras' variance of both ends
        ("direct", "boundaries", 0.004, 0.004 * 1.58**-0.5 / 20.0),
        # two lines' ends of a person's, of which the budget's metres hold one line
        ("direct", "boundaries", 0.0, ((0.004**2 - (0.06 / RATE_HZ * 20.0) ** 2) / 1.58 / 400) ** 0.5),
        ("paper", "front and rear", 0.0, 0.004 * 0.5**0.5 / 20.0),
        # of no source that is known the whole
        ("paper", "outline", 0.0, 0.004 / 20.0),
    ],
)
def test_budgets_of_before_that_tell_both_ends_together_give_gaps_no_less(
    method: ScanMethod, source: str, found_m: float, u_s: float
) -> None:
    """0, or what lies between two lines, was told of every vehicle of an earlier version."""
    ahead = crossings(20.0, 0.0, 4.2)
    behind = crossings(20.0, 0.0, 4.2, start=ahead.rear_line_1 + 6000)
    pair = [
        replace(
            motion(seen, 20.0, 0.0, 4.2),
            method=method,
            budget=(Entry(source, 0.0, 0.0, 0.004),),
            u_boundaries_m=found_m,
        )
        for seen in (ahead, behind)
    ]
    gap = gaps([(one.crossings, one) for one in pair], Rig(BASELINE_M, RATE_HZ))[1]
    lines_s = 0.0 if found_m else 0.06 / RATE_HZ
    assert gap.u_time_gap_s == pytest.approx((2 * (u_s**2 + lines_s**2)) ** 0.5, rel=1e-9)


def test_who_stands_or_goes_back_as_it_leaves_has_left_no_distance() -> None:
    """Which a person or another program may have stored: nothing breaks."""
    ahead, behind = crossings(20.0, 0.0, 4.2), crossings(20.0, 0.0, 4.2, start=9000.0)
    standing = motion(ahead, 0.0, 0.0, 4.2), motion(behind, 0.0, 0.0, 4.2)
    going = motion(behind, 20.0, 0.0, 4.2)
    for leader, follower in ((standing[0], going), (motion(ahead, -1.0, 0.0, 4.2), going), standing):
        gap = gaps([(ahead, leader), (behind, follower)], Rig(BASELINE_M, RATE_HZ))[1]
        assert gap.reason == LEADER_STOPPED and gap.u_distance_gap_m is None
    gap = gaps([(ahead, motion(ahead, 20.0, 0.0, 4.2)), (behind, standing[1])], Rig(BASELINE_M, RATE_HZ))[1]
    assert gap.distance_gap_m is not None and gap.u_time_gap_s is None


def test_gaps_carry_the_leader_on_by_its_own_motion() -> None:
    rig = Rig(BASELINE_M, RATE_HZ)
    ahead, behind = crossings(12.0, 0.8, 4.2), crossings(28.0, 0.0, 5.0, start=9000.0)
    first, gap = gaps([(ahead, motion(ahead, 12.0, 0.8, 4.2)), (behind, motion(behind, 28.0, 0.0, 5.0))], rig)
    assert first.time_gap_s is None and first.reason
    then = 9000.0 / RATE_HZ
    assert gap.headway_s == pytest.approx(then)
    assert gap.time_gap_s == pytest.approx((9000.0 - ahead.rear_line_1) / RATE_HZ)
    assert gap.distance_gap_m == pytest.approx(12.0 * then + 0.4 * then**2 - 4.2, abs=1e-9)
    assert gap.paper_distance_gap_m == pytest.approx(20.0 * gap.time_gap_s)
    assert abs(gap.paper_distance_gap_m - gap.distance_gap_m) > 0.2 * gap.distance_gap_m
    assert 0 < gap.u_distance_gap_m < 0.5


def test_an_end_is_known_to_so_many_metres_so_a_slow_vehicles_gap_is_less_sure() -> None:
    rig = Rig(BASELINE_M, RATE_HZ)
    u_s = []
    for speed in (2.5, 25.0):
        ahead = crossings(speed, 0.0, 4.2)
        behind = crossings(speed, 0.0, 4.2, start=ahead.rear_line_1 + 6000)
        ends = (
            Entry("front", 0.0, 0.0, 0.0028),
            Entry("rear", 0.0, 0.0, 0.0016),
            Entry("fit", 0.01, 0.02, 5.0),
        )
        pair = [(seen, replace(motion(seen, speed, 0.0, 4.2), budget=ends)) for seen in (ahead, behind)]
        u_s.append(gaps(pair, rig)[1].u_time_gap_s)
        later = gaps(pair, replace(rig, u_line_rate_ratio=0.01))[1]
        assert later.u_time_gap_s == pytest.approx(0.01 * later.time_gap_s, rel=0.01)
    # 2.8 mm of the follower's front and 1.6 mm of the leader's rear are as the mean of two cameras whose
    # errors correlate by 0.58; what interpolating between two lines left in them comes off by half, and on
    # again for the one line of each end
    for found, speed in zip(u_s, (2.5, 25.0), strict=True):
        lines_s = 0.06 / RATE_HZ
        both = [(end_m**2 - (lines_s * speed) ** 2 / 2) * 2 / 1.58 for end_m in (0.0028, 0.0016)]
        assert found == pytest.approx((sum(both) / speed**2 + 2 * lines_s**2) ** 0.5, rel=0.01)


def test_after_two_beside_each_other_a_gap_runs_from_the_rear_that_left_last() -> None:
    """A lorry of 18 m is passed by a car; the next one comes 1 s after the lorry's rear."""
    rig = Rig(BASELINE_M, RATE_HZ)
    lorry, car = crossings(12.0, 0.0, 18.0, start=50.0), crossings(20.0, 0.0, 4.0, start=650.0)
    behind = crossings(12.0, 0.0, 4.0, start=lorry.rear_line_1 + RATE_HZ)
    vehicles = [
        (lorry, motion(lorry, 12.0, 0.0, 18.0)),
        (car, motion(car, 20.0, 0.0, 4.0)),
        (behind, motion(behind, 12.0, 0.0, 4.0)),
    ]
    _, beside, gap = gaps(vehicles, rig)
    assert beside.time_gap_s is None and "overlap" in str(beside.reason)
    assert gap.time_gap_s == pytest.approx(1.0) and gap.distance_gap_m == pytest.approx(12.0)
    # front to front, as a count of traffic takes it: from the car beside the lorry
    fronts_s = [one.front_line_1 / RATE_HZ for one, _ in vehicles]
    assert headways_s(fronts_s, [True] * 3) == [
        None,
        *(pytest.approx(one.headway_s) for one in (beside, gap)),
    ]
    assert gap.headway_s == pytest.approx(2.5 - 600 / RATE_HZ)
    unseen = gaps([(lorry, Motion("direct", lorry, "not_measurable", STOOD)), *vehicles[1:]], rig)[2]
    assert (unseen.time_gap_s, unseen.reason, unseen.headway_s) == (None, REAR_UNSEEN, gap.headway_s)


def test_lines_of_two_that_were_measured_at_different_rates_have_no_time_between_them() -> None:
    """A rate that was corrected leaves the gap between those that were measured before it as it was."""
    rig = Rig(BASELINE_M, RATE_HZ)
    then = replace(rig, line_rate_hz=2 * RATE_HZ)
    seen = [crossings(12.0, 0.0, 4.0, start=at) for at in (0.0, 90_000.0, 180_000.0)]
    one, two, three = ((at, motion(at, 12.0, 0.0, 4.0)) for at in seen)
    _, before, after = gaps([(*one, then), (*two, then), (*three, rig)], rig)
    (_, alone) = gaps([one, two], then)
    assert before == alone and alone.time_gap_s is not None
    assert (after.time_gap_s, after.headway_s, after.reason) == (None, None, OTHER_RATE)


def test_beside_one_that_is_told_later_there_is_no_gap_as_in_the_list() -> None:
    """Who stands is the leader of a list, in which it comes by its front: those beside it overlap with it."""
    rig = Rig(BASELINE_M, RATE_HZ)
    seen = [crossings(12.0, 0.0, 4.0, start=at) for at in (0.0, 90_000.0, 99_000.0)]
    passed = [(one, motion(one, 12.0, 0.0, 4.0)) for one in seen]
    stood = replace(crossings(12.0, 0.0, 4.0, start=20_000.0), rear_line_1=200_000.0, rear_line_2=200_000.0)
    listed = gaps([passed[0], (stood, Motion("direct", stood, "not_measurable", STOPPED)), *passed[1:]], rig)
    leaders = Leaders(rig)
    told = [leaders.next(*one, beside=at > 0) for at, one in enumerate(passed)]
    assert [(one.time_gap_s, one.reason) for one in told[1:]] == [(None, OVERLAP)] * 2
    assert [one.reason for one in listed[2:]] == [OVERLAP] * 2


def test_a_gap_that_cannot_be_known_has_its_reason() -> None:
    rig = Rig(BASELINE_M, RATE_HZ)
    ahead, behind = crossings(9.0, 0.0, 4.2, start=50.0), crossings(9.0, 0.0, 4.2, start=60_000.0)
    none = Motion("direct", ahead, "not_measurable", STOPPED)
    after = motion(behind, 9.0, 0.0, 4.2)
    gap = gaps([(ahead, none), (behind, after)], rig)[1]
    assert gap.time_gap_s is not None and gap.distance_gap_m is None and "motion" in str(gap.reason)
    assert gap.u_time_gap_s is None
    # nobody saw its front: 12.3 s, from line 0, were a headway
    assert gap.headway_s is not None
    there = replace(ahead, front_line_1=0.0)
    for reason, time_gap_s in ((CUT, gap.time_gap_s), (STOPPED, gap.time_gap_s), (STOOD, None)):
        begun = gaps([(there, Motion("direct", there, "not_measurable", reason)), (behind, after)], rig)[1]
        assert (begun.headway_s, begun.time_gap_s) == (None, time_gap_s)
    braking = gaps([(ahead, motion(ahead, 9.0, -1.4, 4.2)), (behind, after)], rig)[1]
    assert braking.distance_gap_m is None and "stopped" in str(braking.reason)
    close = crossings(9.0, 0.0, 4.2, start=150.0)
    overlap = gaps([(ahead, motion(ahead, 9.0, 0.0, 4.2)), (close, after)], rig)[1]
    assert overlap.time_gap_s is None and "overlap" in str(overlap.reason)
