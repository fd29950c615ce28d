"""Finding vehicles in strips of the demonstration's generator: none missed, invented or merged."""

from dataclasses import replace

import numpy as np
import pytest

from sightline.commands.scanned import row_of
from sightline.errors import BadInput
from sightline.linescan import finding
from sightline.linescan.background import (
    Grid,
    enough_lines,
    first_road,
    road_from,
    same_but_for_light,
    same_but_moved,
)
from sightline.linescan.direct import measure_direct
from sightline.linescan.finding import NO_ROAD, STOPPED, Finder
from sightline.linescan.gaps import REAR_UNSEEN, gaps
from sightline.linescan.methods import MEASURE
from sightline.linescan.parts import CUT, STOOD, TOO_LONG, Rig
from sightline.linescan.passing import measure_passages
from tests.linescan.scenes import (
    RIG,
    SITE,
    SLOW_RIG,
    cars,
    found,
    plain,
    plain_found,
    plain_truth,
    side_by_side,
    standing,
    stopping,
    touching,
    two_standing,
)
from tests.simulation.scan_strips import strips

pytestmark = pytest.mark.once


def _boundaries_m(passages, truth):
    """(n, 4) errors of the boundaries, metres along the road."""
    rows = []
    for passage, true in zip(passages, truth, strict=True):
        c, per_line = passage.crossings, true.vehicle.speed_mps / RIG.line_rate_hz
        rows.append(
            [
                (c.front_line_1 - true.front_line_1) * per_line,
                (c.rear_line_1 - true.rear_line_1) * per_line,
                (c.front_line_2 - true.front_line_2) * per_line,
                (c.rear_line_2 - true.rear_line_2) * per_line,
            ]
        )
    return np.array(rows)


def test_all_are_found_with_boundaries_to_millimetres_despite_the_shadow():
    passages, finder = plain_found()
    errors = _boundaries_m(passages, plain_truth())
    # the shadow begins 270 mm before the front
    assert np.abs(errors).max() < 0.010
    assert finder.found == 3 and finder.alone == 0
    assert all(passage.reason is None for passage in passages)


def test_the_shadow_zone_is_the_rigs():
    """Where a camera sees more road, the usual zone takes the shadow for a bumper; the rig's own does not."""
    truth, low = plain_truth(), tuple(strip[:, 48:] for strip in plain())
    usual = _boundaries_m(found(low)[0], truth)
    assert np.abs(usual).max(1).min() > 0.2  # the shadow begins 270 mm before the front
    own, finder = found(low, replace(RIG, shadow_share=0.3))
    assert finder.found == 3 and np.abs(_boundaries_m(own, truth)).max() < 0.05
    none = _boundaries_m(found(plain(), replace(RIG, shadow_share=0.0))[0], truth)
    assert np.abs(none).max(1).min() > 0.2


def test_time_gaps_are_right_within_half_a_millisecond():
    passages, _ = plain_found()
    for before, this, true in zip(passages, passages[1:], plain_truth()[1:], strict=False):
        gap_s = (this.crossings.front_line_1 - before.crossings.rear_line_1) / RIG.line_rate_hz
        assert gap_s == pytest.approx(true.time_gap_s, abs=0.5e-3)


@pytest.mark.parametrize("piece", [97, 40_000])
def test_pieces_of_any_size_give_the_same_vehicles(piece):
    first, _ = plain_found()
    other, _ = found(plain(), piece=piece)
    for a, b in zip(first, other, strict=True):
        assert a.crossings == b.crossings
        assert a.start_1 == b.start_1 and np.array_equal(a.second, b.second)


def test_pictures_are_cut_with_their_margin_at_the_right_lines():
    first, second = plain()
    for passage in plain_found()[0]:
        assert np.array_equal(passage.first, first[passage.start_1 : passage.start_1 + len(passage.first)])
        assert np.array_equal(passage.second, second[passage.start_2 : passage.start_2 + len(passage.second)])
        assert passage.start_1 < passage.crossings.front_line_1 - 40
        assert passage.start_2 + len(passage.second) > passage.crossings.rear_line_2 + 40


def test_sixteen_bits_give_the_same_boundaries():
    pair = tuple(np.asarray(strip.astype(np.uint16) * 200) for strip in plain())
    for a, b in zip(found(pair)[0], plain_found()[0], strict=True):
        assert a.crossings.front_line_1 == pytest.approx(b.crossings.front_line_1, abs=0.3)
        assert a.crossings.rear_line_2 == pytest.approx(b.crossings.rear_line_2, abs=0.3)


def test_vehicles_nearly_touching_are_kept_apart():
    pair, truth = touching()
    passages, _ = found(pair)
    assert len(passages) == 2
    assert np.abs(_boundaries_m(passages, truth)).max() < 0.010


@pytest.mark.parametrize("against", [False, True])
def test_two_side_by_side_are_not_measured(against):
    passages, _ = found(side_by_side(against))
    motions = [MEASURE["direct"](passage, RIG) for passage in passages]
    assert [motion.status for motion in motions] == ["not_measurable"]
    assert motions[0].speed_mps is None and motions[0].length_m is None
    assert "side by side" in str(motions[0].reason)


@pytest.mark.parametrize("wait_s", [0.3, 1.5])
def test_a_vehicle_that_stops_in_view_is_not_measured(wait_s):
    passages, _ = found(stopping(wait_s))
    motions = [measure_direct(passage, RIG) for passage in passages]
    assert [motion.status for motion in motions] == ["not_measurable"]
    assert "stopped" in str(motions[0].reason)
    if wait_s > 1:
        assert motions[0].reason == STOPPED


@pytest.mark.parametrize("at_m", [0.3, 1.6])
def test_a_vehicle_that_stands_is_in_view_until_it_has_gone(at_m):
    """With its front between the cameras (0.3 m), or before both; what passes it is found too."""
    pair, (rear_s, next_s) = standing(at_m)
    passages, _ = found(pair, SLOW_RIG)
    stood, beside, after = measure_passages(passages, SLOW_RIG, "direct")
    assert stood.motion.reason == STOPPED and stood.rear_s == pytest.approx(rear_s, abs=0.012)
    assert after.front_s == pytest.approx(next_s, abs=0.01)
    assert beside.front_s == pytest.approx(7.0, abs=0.05)
    assert beside.motion.speed_mps == pytest.approx(14.0, abs=0.1)
    assert after.gap.time_gap_s == pytest.approx(1.8, abs=0.012)


def test_one_that_stops_before_one_that_stands_is_told_apart():
    """It was taken for the road before which the first stood, and was in no list."""
    pair, (behind_s, before_s) = two_standing(8.0)
    passages, _ = found(pair, SLOW_RIG)
    before, behind, after = measure_passages(passages, SLOW_RIG, "direct")
    assert (before.motion.reason, behind.motion.reason, after.motion.reason) == (STOPPED, STOPPED, None)
    assert before.front_s == pytest.approx(7.0, abs=0.4) and before.rear_s == pytest.approx(
        before_s, abs=0.05
    )
    assert behind.front_s == pytest.approx(1.2, abs=0.4) and behind.rear_s == pytest.approx(
        behind_s, abs=0.05
    )
    assert after.gap.time_gap_s == pytest.approx(1.8, abs=0.025)


@pytest.mark.parametrize("wait_s", [20.0, 30.0])
def test_one_stands_before_another_until_that_has_left(wait_s):
    """Nobody saw the one behind leave: both are in view until the road is seen again. What was seen of its
    leaving, and then where it had stuck out behind the other, by the noise, was up to 36 vehicles more.
    """
    pair, (_, before_s) = two_standing(wait_s)
    passages, finder = found(pair, SLOW_RIG)
    behind, before, after = measure_passages(passages, SLOW_RIG, "direct")
    assert (before.motion.reason, behind.motion.reason, after.motion.reason) == (STOPPED, STOPPED, None)
    assert behind.rear_s == pytest.approx(before_s, abs=0.05) and before.rear_s == pytest.approx(
        before_s, abs=0.1
    )
    assert finder.alone == 0


def test_what_leaves_behind_one_that_stands_is_no_vehicle_though_the_road_seems_lit_anew():
    """The larger one leaves from behind the smaller one; what is then seen is like the road before."""
    pair, (_, before_s) = two_standing(20.0, (0, 1))
    passages, finder = found(pair, SLOW_RIG)
    told = list(measure_passages(passages, SLOW_RIG, "direct"))
    assert [one.front_s for one in told] == pytest.approx([1.48, 7.36, before_s + 1.8], abs=0.01)
    assert finder.alone == 0


def test_what_leaves_is_no_vehicle_in_pieces():
    """Parts of it that look as it did while it stood were two more vehicles, at 10.68 and 11.18 s."""
    passages, finder = found(standing(1.6, far=True)[0], SLOW_RIG)
    fronts_s = [one.crossings.front_line_1 / SLOW_RIG.line_rate_hz for one in passages]
    assert fronts_s == pytest.approx([1.48, 7.0, 13.5], abs=0.05) and finder.alone == 0


def test_vehicles_come_in_the_order_of_their_fronts_at_camera_1_also_beside_one_that_stands_before_camera_2():
    (first, second), _ = standing(0.3)
    passages, _ = found((second, first), SLOW_RIG)
    beside, stood, after = measure_passages(passages, SLOW_RIG, "direct")
    assert [one.motion.reason for one in (beside, stood, after)] == [None, STOPPED, None]
    assert beside.front_s == pytest.approx(7.0 + RIG.baseline_m / 14.0, abs=0.05)
    assert stood.rear_s == pytest.approx(12.04, abs=0.012)  # of the other camera, when it has left both
    assert after.gap.time_gap_s == pytest.approx(after.front_s - stood.rear_s)


def test_a_rear_that_nobody_saw_is_not_told(monkeypatch):
    """What stands for too long, and until the recording ends, may be no vehicle: how long it stood is not
    known, nor the next one's gap.
    """
    monkeypatch.setattr(finding, "STANDS_S", 4.0)
    passages, _ = found(tuple(strip[:9000] for strip in standing(1.6)[0]), SLOW_RIG)
    stood, beside = measure_passages(passages, SLOW_RIG, "direct")
    assert stood.motion.reason == STOOD and stood.rear_s is None
    assert (row_of(stood)["rear_line_1"], row_of(stood)["rear_line_2"]) == (None, None)
    assert (beside.gap.time_gap_s, beside.gap.distance_gap_m, beside.gap.reason) == (None, None, REAR_UNSEEN)
    assert beside.gap.headway_s == pytest.approx(beside.front_s - stood.front_s, abs=0.01)


@pytest.mark.parametrize(
    ("stands_s", "at_m", "wait_s", "swapped"),
    [
        (4.0, 1.6, 7.0, False),  # given up before the other passes beside it
        (7.0, 1.6, 7.0, False),  # and after
        (4.0, 1.6, 7.0, True),
        # before one camera alone: its driving off was a vehicle of its own, or none
        (4.0, 0.3, 7.0, False),
        (4.0, 0.3, 7.0, True),
        (4.0, 0.3, 10.5, False),
    ],
)
def test_what_was_given_up_has_left_when_it_did(monkeypatch, stands_s, at_m, wait_s, swapped):
    """For others that pass beside it nobody waits any longer. The next one's gap ran from the one that had
    passed, 6.2 s, as it is listed and as it is told while they pass.
    """
    monkeypatch.setattr(finding, "STANDS_S", stands_s)
    pair, (rear_s, next_s) = standing(at_m, wait_s=wait_s)
    passages, _ = found(pair[::-1] if swapped else pair, SLOW_RIG)
    beside, stood, after = measure_passages(passages, SLOW_RIG, "direct")
    late_s = after.front_s - next_s  # at the other camera
    at = stood.motion.crossings
    lines = (at.front_line_2, at.front_line_1) if swapped else (at.front_line_1, at.front_line_2)
    fronts_s = [1.96, 3.03 + wait_s] if at_m < 1 else [1.56, 1.775]
    assert np.array(lines) / SLOW_RIG.line_rate_hz == pytest.approx(fronts_s, abs=0.02)
    assert stood.motion.reason == STOPPED and -0.01 < late_s < 0.06
    assert stood.rear_s == pytest.approx(rear_s + (0.16 if swapped else 0.0), abs=0.015)
    assert beside.motion.speed_mps == pytest.approx(14.0, abs=0.1)
    assert after.gap.time_gap_s == pytest.approx(1.69 if swapped else 1.8, abs=0.015)
    if at_m > 1:
        # before one that is told later: nobody before that is in front of it
        assert "overlap" in str(beside.gap.reason)
    listed = sorted((beside, stood, after), key=lambda one: one.front_s)
    gap = gaps([(one.motion.crossings, one.motion) for one in listed], SLOW_RIG)[2]
    assert gap.time_gap_s == pytest.approx(after.gap.time_gap_s)


@pytest.mark.parametrize("swapped", [False, True])
def test_one_that_only_one_camera_saw_leave_has_no_rear(monkeypatch, swapped):
    """Camera 2 sees another road from 7.4 s on. It is of its own direction all the same."""
    monkeypatch.setattr(finding, "STANDS_S", 4.0)
    (first, second), (rear_s, _) = standing(1.6, wait_s=12.0)
    turned = np.concatenate([second[:9000], second[9000:, ::-1]])
    passages, _ = found((turned, first) if swapped else (first, turned), SLOW_RIG)
    _, stood = measure_passages(passages, SLOW_RIG, "direct")
    at = stood.motion.crossings
    assert (stood.motion.reason, stood.rear_s) == (STOOD, None)
    assert at.direction == ("camera_2_first" if swapped else "camera_1_first")
    assert at.rear_line_1 / SLOW_RIG.line_rate_hz == pytest.approx(rear_s, abs=0.02)


def test_what_stands_when_the_recording_ends_stood_until_then():
    strips_ = tuple(strip[:9000] for strip in standing(1.6)[0])
    passages, _ = found(strips_, SLOW_RIG)
    assert [(one.reason, one.crossings.rear_line_1) for one in passages[:1]] == [(STOPPED, 8999.5)]


def test_swapped_strips_are_recognised_from_the_traffic():
    first, second = plain()
    passages, finder = found((second, first))
    assert [passage.reason for passage in passages] == [None] * 3
    assert {passage.crossings.direction for passage in passages} == {"camera_2_first"}
    assert finder.reversed == finder.found == 3


def test_vehicles_cut_by_the_ends_of_the_recording_say_so():
    start = int(plain_truth()[0].front_line_1 + 300)
    stop = int(plain_truth()[2].front_line_1 + 400)
    passages, _ = found(tuple(strip[start:stop] for strip in plain()))
    assert [passage.reason for passage in passages] == [CUT, None, CUT]
    assert passages[0].crossings.front_line_1 == 0.0  # it is of this recording


def test_an_empty_road_under_drifting_light_holds_no_vehicle():
    site = replace(SITE, drift=0.2, drift_period_s=6.0)
    passages, finder = found(strips(site, (), 4.0))
    assert passages == [] and finder.found == 0


def test_a_jump_of_the_light_becomes_the_new_background():
    pair = [strip.astype(float) for strip in plain()]
    at = int(plain_truth()[1].rear_line_2 + 120)
    for strip in pair:
        strip[at:] *= 1.25
    pair = tuple(np.clip(strip, 0, 255).astype(np.uint8) for strip in pair)
    passages, finder = found(pair)
    lines = [passage.crossings.front_line_1 for passage in passages if passage.reason is None]
    assert min(abs(line - plain_truth()[2].front_line_1) for line in lines) < 8
    assert all(watcher.jumps == 1 for watcher in finder.watchers)


def test_memory_stays_bounded_while_the_road_is_empty():
    finder = Finder(64, Rig(0.593, 4882.8))
    road = np.full((5000, 64), 90, np.uint8) + np.arange(64, dtype=np.uint8)
    for _ in range(12):
        finder.push(road, road)
    assert all(sum(len(block) for _, block in reel.blocks) < 2500 for reel in finder._buffers)


def test_strips_that_differ_are_refused_in_words():
    finder = Finder(64, RIG)
    with pytest.raises(BadInput, match="both cameras"):
        finder.push(np.zeros((100, 64), np.uint8), np.zeros((90, 64), np.uint8))
    with pytest.raises(BadInput, match="64 rows expected"):
        finder.push(np.zeros((100, 32), np.uint8), np.zeros((100, 32), np.uint8))
    with pytest.raises(BadInput, match="at least 8"):
        Finder(4, RIG)


def test_the_first_road_is_found_although_a_vehicle_passes():
    first, _ = plain()
    true = plain_truth()[0]
    part = first[int(true.front_line_1) - 300 : int(true.rear_line_1) + 900]
    grid = Grid(128, 4, 2)
    empty = first[200:700].mean(0)
    assert np.abs(first_road(part, grid).line - empty).mean() < 1.5


def test_a_slow_camera_shows_the_empty_road_in_a_few_lines():
    """Columns of a video at 30 frames a second: 20 lines are empty, then a vehicle covers the road."""
    rng = np.random.default_rng(5)
    empty = rng.uniform(60, 160, 128)
    lines = np.repeat(empty[None], 80, 0)
    lines[20:] = rng.uniform(20, 220, (60, 128))
    seen = np.clip(lines + rng.normal(0, 2, lines.shape), 0, 255).astype(np.uint8)
    assert enough_lines(2441.4) == 100
    found = first_road(seen, Grid(128, 1, 2), enough_lines(30.0))
    assert np.abs(found.line - empty).mean() < 2.0 and found.common_dn < 1.0


def test_light_is_told_from_a_vehicle():
    first, _ = plain()
    grid = Grid(128, 4, 2)
    road = road_from(first[200:500], grid)
    brighter = np.asarray(road.pooled * 1.3 + 4, np.float32)
    middle = int(np.mean([plain_truth()[0].front_line_1, plain_truth()[0].rear_line_1]))
    vehicle = grid.pooled(first[middle : middle + 40]).mean(0)
    assert same_but_for_light(brighter, road, grid)
    assert not same_but_for_light(vehicle, road, grid)
    assert len(cars()) == 3


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16])
def test_something_restless_that_stays_in_view_does_not_fill_the_memory(dtype, monkeypatch):
    monkeypatch.setattr(finding, "KEPT_BYTES", 1 << 20)
    finder, rng = Finder(64, RIG), np.random.default_rng(2)
    scale = np.iinfo(dtype).max // 255
    road, wave = np.full(64, 100.0), np.sin(np.arange(1000) / 9.0)[:, None]
    out, most = [], 0
    for number in range(60):
        lines = road + rng.normal(0, 2, (1000, 64)) + (number > 8) * (60 + 40 * wave)
        pushed = (scale * lines).astype(dtype)
        out += finder.push(pushed, pushed.copy())
        most = max(most, sum(block.nbytes for lines in finder._buffers for _, block in lines.blocks))
    assert [passage.reason for passage in out[:1]] == [TOO_LONG]
    # a quarter over, and the block that has just come, of each strip
    assert 1 << 20 < most < 2 * (1.25 * (1 << 20) + 2 * pushed.nbytes)


def of_one_long_thing(length_m, moved_px=0, line_rate_hz=RIG.line_rate_hz, speed_mps=20.0):
    """Strips (lines, rows) of a thing with a texture of its own before a road; the cameras give way by some
    rows as it passes.
    """
    rng = np.random.default_rng(3)
    rate, rows = line_rate_hz, 128
    lines = int(rate * (length_m / speed_mps + 3.0))
    knots = rng.uniform(60, 200, (int(length_m / 0.05) + 2, rows // 4))
    body = np.repeat(knots, 4, axis=1)
    out = []
    for reached_s in (1.0, 1.0 + RIG.baseline_m / speed_mps):
        road = np.interp(
            np.arange(rows + 8), np.arange(0, rows + 8, 3), rng.uniform(60, 160, (rows + 10) // 3)
        )
        place_m = speed_mps * (np.arange(lines) / rate - reached_s)
        there = (place_m >= 0) & (place_m < length_m)
        strip = np.repeat(road[None, :rows], lines, axis=0)
        strip[place_m >= length_m] = road[moved_px : rows + moved_px]
        at = place_m[there] / 0.05
        low, part = at.astype(int), (at % 1)[:, None]
        strip[there] = body[low] * (1 - part) + body[low + 1] * part
        strip[there, :10] = road[:10]
        out.append(np.clip(strip + rng.normal(0, 2, strip.shape), 0, 255).astype(np.uint8))
    return tuple(out)


def test_a_train_is_refused_for_its_length():
    passages, finder = found(of_one_long_thing(80.0))
    assert len(passages) == 1 and finder.alone == 0
    assert "length is 79 m" in str(passages[0].reason) and "the limit is 32 m" in str(passages[0].reason)


@pytest.mark.parametrize("length_m", [20.0, 40.0])
def test_the_rest_of_one_that_was_too_long_in_view_is_no_other(monkeypatch, length_m):
    """In view for 2 or 4 s, where lines of 1.2 s are kept: the rest was a second vehicle, and a third."""
    monkeypatch.setattr(finding, "KEPT_BYTES", 128 * round(1.2 * RIG.line_rate_hz))
    passages, finder = found(of_one_long_thing(length_m, speed_mps=10.0))
    assert [passage.reason for passage in passages] == [TOO_LONG] and finder.alone == 0


@pytest.mark.parametrize("length_m", [6.0, 80.0])
def test_a_camera_that_gave_way_is_said_and_what_passed_is_no_vehicle_that_stopped(length_m):
    """As in a video of a real train: its wind moved the camera by a pixel."""
    passages, finder = found(of_one_long_thing(length_m, moved_px=2))
    assert [watcher.moves for watcher in finder.watchers] == [1, 1]
    assert len(passages) == 1
    c = passages[0].crossings
    seen_m = 20.0 * (c.rear_line_1 - c.front_line_1) / RIG.line_rate_hz
    assert seen_m == pytest.approx(length_m, abs=0.15)
    assert ("length is" in str(passages[0].reason)) == (length_m > 32)


def test_the_way_is_not_guessed_from_a_line_or_two():
    """At 30 lines a second something at 20 m/s needs less than a line from camera to camera."""
    rig = Rig(RIG.baseline_m, 30.0)
    pair = of_one_long_thing(20.0, line_rate_hz=30.0)
    for strips_ in (pair, pair[::-1]):
        passages, finder = found(strips_, rig)
        assert len(passages) == 1 and finder.reversed == 0
        assert "too few for its speed or direction" in str(passages[0].reason)


def test_a_recording_that_never_shows_the_road_says_so():
    rng = np.random.default_rng(8)
    busy = np.repeat(rng.uniform(40, 200, (400, 32)), 4, axis=1)
    pair = tuple(np.clip(busy + rng.normal(0, 2, busy.shape), 0, 255).astype(np.uint8) for _ in range(2))
    passages, finder = found((pair[0], np.roll(pair[1], 5, axis=0)), Rig(RIG.baseline_m, 60.0))
    assert all(watcher.road.unrest > 0.1 for watcher in finder.watchers)
    assert all(passage.reason == NO_ROAD for passage in passages)


def test_a_road_some_rows_higher_is_told_from_a_vehicle():
    first, _ = plain()
    grid = Grid(128, 4, 2)
    road = road_from(first[200:500], grid)
    for by in (-2, 1, 2):
        assert same_but_moved(np.roll(road.line, by), road, grid)
    middle = int(np.mean([plain_truth()[0].front_line_1, plain_truth()[0].rear_line_1]))
    for at in range(middle - 300, middle + 300, 50):
        assert not same_but_moved(first[at : at + 40].mean(0, dtype=np.float32), road, grid)
