"""Two lanes of one rig: each vehicle measured with its own lane's distance, gaps within a lane."""

from dataclasses import asdict, replace
from functools import lru_cache

import numpy as np
import pytest

from sightline.errors import BadInput
from sightline.linescan.gaps import BEFORE_UNKNOWN, LANE_UNKNOWN, NONE_BEFORE, gaps
from sightline.linescan.lanes import NO_LANE_THIS_WAY, lane_of
from sightline.linescan.methods import MEASURE
from sightline.linescan.parts import Lane, Motion, Passage, Rig
from sightline.linescan.passing import measure_passages
from sightline.linescan.rig import at_lane, baseline_of, require_rig, sound_rig_from
from sightline.linescan.traffic import headways_s
from tests.linescan.scenes import SITE, at, cars, found
from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import ScanTruth, traffic, truths

NEAR_M, FAR_M, OPENING_M = 5.0, 8.5, 0.021
Q = OPENING_M / (FAR_M - NEAR_M)
# the baseline at the near lane is the site's
RIG = Rig(
    SITE.baseline_m - Q * NEAR_M,
    SITE.line_rate_hz,
    u_baseline_m=1e-4,
    divergence_rad=Q,
    u_divergence_rad=2e-5,
    lanes=(
        Lane("near", NEAR_M, 0.1, tyres_from_px=106.0, tyres_to_px=128.0),
        Lane("far", FAR_M, 0.15, tyres_from_px=84.0, tyres_to_px=106.0, shadow_share=0.3),
    ),
)
WAYS = replace(
    RIG,
    lanes=(
        Lane("near", NEAR_M, 0.1, direction="camera_1_first"),
        Lane("far", FAR_M, 0.15, direction="camera_2_first", shadow_share=0.3),
    ),
)


@lru_cache(maxsize=2)
def seen(against: bool) -> tuple[list[Passage], tuple[ScanTruth, ...]]:
    """Near, far, far, near, all apart; the far lane the other way if `against`."""
    site = replace(SITE, opening_m=OPENING_M)
    bodies = (*cars(), *traffic(9, 1))
    vehicles, clear = [], 0.7
    for body, speed, far in zip(bodies, (18.0, 15.0, 21.0, 12.0), (False, True, True, False), strict=True):
        one = at(body, clear + 0.4, speed, far=far, against=far and against)
        vehicles.append(one)
        clear = one.clear_s(SITE.baseline_m)
    true = truths(site, tuple(vehicles))
    return found(strips(site, tuple(vehicles)), WAYS if against else RIG)[0], true


@pytest.mark.parametrize(("rig", "against"), [(RIG, False), (WAYS, True)])
def test_each_lane_has_its_own_baseline(rig: Rig, against: bool) -> None:
    """The far lane's speeds would be 3.5 % off with the near one's baseline; lengths as much."""
    passages, true = seen(against)
    assert len(passages) == len(true) == 4
    for passage, one in zip(passages, true, strict=True):
        motion = MEASURE["direct"](passage, rig)
        lane = "far" if one.vehicle.far else "near"
        assert (motion.lane, motion.lane_by, motion.status) == (lane, "machine", "ok")
        expected = one.vehicle.speed_mps
        assert motion.speed_mps is not None and motion.u_speed_mps is not None
        assert abs(motion.speed_mps - expected) < 4 * motion.u_speed_mps < 0.01 * expected
        assert motion.length_m == pytest.approx(one.vehicle.length_m, abs=0.02)
        entry = next(each for each in motion.budget if each.source == "baseline")
        baseline, u = baseline_of(at_lane(rig, lane))
        assert entry.u_length_m == pytest.approx(motion.length_m * u / baseline)


def test_with_one_distance_for_all_the_far_lane_is_wrong() -> None:
    passages, true = seen(False)
    alone = replace(RIG, distance_m=NEAR_M, u_distance_m=0.1, lanes=())
    motion = MEASURE["direct"](passages[1], alone)
    assert motion.speed_mps is not None
    assert motion.speed_mps / true[1].vehicle.speed_mps == pytest.approx(0.593 / 0.614, abs=1e-3)
    assert (motion.lane, motion.lane_by) == (None, None)


def test_rows_of_tyres_tell_the_lanes() -> None:
    passages, true = seen(False)
    for passage, one in zip(passages, true, strict=True):
        told = lane_of(passage, RIG)
        assert told.lane is not None and told.tyres_px is not None
        # the road is 1.2 m under the horizon, of which 0.62 at the far lane
        foot_m = 1.2 * (1 - 0.62) if one.vehicle.far else 0.0
        assert told.tyres_px == pytest.approx((SITE.top_m - foot_m) / SITE.field_m * SITE.rows, abs=4)


def test_gaps_are_those_within_a_lane() -> None:
    passages, true = seen(False)
    vehicles = list(measure_passages(passages, RIG, "direct"))
    assert [one.motion.lane for one in vehicles] == ["near", "far", "far", "near"]
    assert [one.gap.reason for one in vehicles] == [NONE_BEFORE, NONE_BEFORE, None, None]
    rate = RIG.line_rate_hz
    expected = (true[3].front_line_1 - true[0].rear_line_1) / rate
    assert vehicles[3].gap.time_gap_s == pytest.approx(expected, abs=1e-3)


def test_an_unknown_lane_is_said_and_its_u_holds_for_all() -> None:
    passages, true = seen(False)
    lost = replace(RIG, lanes=tuple(replace(one, tyres_from_px=0.0, tyres_to_px=20.0) for one in RIG.lanes))
    vehicles = list(measure_passages(passages, lost, "direct"))
    for one, truth in zip(vehicles, true, strict=True):
        motion = one.motion
        assert motion.lane is None and "The lane is not known" in str(motion.warnings[-1])
        assert motion.speed_mps is not None and motion.u_speed_mps is not None
        assert abs(motion.speed_mps - truth.vehicle.speed_mps) < 1.96 * motion.u_speed_mps
    assert {one.gap.reason for one in vehicles} == {LANE_UNKNOWN}


def test_after_an_unknown_lane_no_lane_knows_its_leader() -> None:
    passages, _ = seen(False)
    motions: list[Motion] = [MEASURE["direct"](one, RIG) for one in passages]
    motions[1] = replace(motions[1], lane=None)
    told = gaps([(one.crossings, one) for one in motions], RIG)
    assert [one.reason for one in told] == [NONE_BEFORE, LANE_UNKNOWN, BEFORE_UNKNOWN, BEFORE_UNKNOWN]
    # nor has a count of traffic a headway there
    fronts_s = [one.crossings.front_line_1 / RIG.line_rate_hz for one in motions]
    for lane in {one.lane for one in motions}:
        own = [at for at, one in enumerate(motions) if one.lane == lane]
        headways = headways_s([fronts_s[at] for at in own], [True] * len(own), [fronts_s[1]])
        assert headways == [told[at].headway_s and pytest.approx(told[at].headway_s) for at in own]


def test_lanes_of_a_direction_that_is_not_theirs() -> None:
    passages, _ = seen(False)
    other = replace(WAYS, lanes=WAYS.lanes[1:])
    told = lane_of(passages[0], other)
    assert told.lane is None and told.why == NO_LANE_THIS_WAY


def test_a_rig_between_lanes_far_apart_is_one_that_may_be_read() -> None:
    """Packages told it of vehicles of unknown lane, and were refused as damaged."""
    told = Rig(0.5, 5000.0, 0.0005, lanes=(Lane("near", 10.0, 100.0), Lane("far", 1000.0)))
    between = replace(at_lane(told, None), lanes=())
    assert between.u_distance_m > 300 and sound_rig_from(asdict(between)) == between
    assert sound_rig_from(asdict(replace(between, u_distance_m=310.0))) is None
    with pytest.raises(BadInput, match="uncertainty of the distance"):
        require_rig(between)


def test_at_lane_covers_what_is_not_known() -> None:
    across = at_lane(RIG, None)
    assert across.distance_m == pytest.approx((NEAR_M + FAR_M) / 2)
    assert across.u_distance_m == pytest.approx(np.hypot((FAR_M - NEAR_M) / 12**0.5, 0.15))
    assert at_lane(WAYS, None, "camera_2_first").distance_m == FAR_M
    assert at_lane(replace(RIG, lanes=()), "near") == replace(RIG, lanes=())


@pytest.mark.parametrize(
    "lanes",
    [
        (Lane(" ", 5.0),),
        (Lane("a", 5.0), Lane("a", 8.0)),
        (Lane("a", -5.0),),
        (Lane("a", 5.0, -0.1),),
        (Lane("a", 5.0, tyres_from_px=10.0),),
        (Lane("a", 5.0, tyres_from_px=20.0, tyres_to_px=10.0),),
    ],
)
def test_lanes_that_cannot_be_are_refused(lanes: tuple[Lane, ...]) -> None:
    require_rig(RIG)
    with pytest.raises(BadInput):
        require_rig(replace(RIG, lanes=lanes))
