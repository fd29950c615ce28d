"""The direct chain on strips whose motion is known; the large runs are in tests/bench/bench_linescan.py."""

from dataclasses import replace
from functools import lru_cache

import cv2
import numpy as np
import pytest

from sightline.linescan import direct
from sightline.linescan.direct import NO_ORDER, NO_TEXTURE, _prepared, baseline_of, measure_direct
from sightline.linescan.masks import Sheet, sample_sheet, shift_sheet
from sightline.linescan.paper import measure_paper
from sightline.linescan.parts import CUT, Crossings, Passage, Rig
from sightline.linescan.registration import register
from sightline.linescan.spread import covariance
from sightline.linescan.warp import Course, solved_by_boundaries
from sightline.messages.said import Said
from tests.linescan.scenes import RIG, SITE, cars, found, plain_found, plain_truth
from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import ScanSite, ScanVehicle, truths

pytestmark = pytest.mark.once
SOURCES = ("baseline", "clock", "misalignment", "fit", "front", "rear")


@lru_cache(maxsize=1)
def passages() -> tuple[Passage, ...]:
    return tuple(plain_found()[0])


def test_few_lines_from_camera_to_camera_are_named_as_that() -> None:
    """The pictures fit three lines apart, the boundaries say four: no two vehicles, too few lines."""
    rng = np.random.default_rng(1405)
    texture = cv2.GaussianBlur(rng.normal(0, 200, (60, 96)).astype(np.float32), (0, 0), sigmaX=3, sigmaY=2)
    pictures = []
    for shift in (0, 3):
        picture = np.full((120, 96), 100, np.float32)
        picture[20 + shift : 80 + shift] += texture + 30
        pictures.append(np.clip(picture + rng.normal(0, 1, picture.shape), 0, 255).astype(np.uint8))
    road = np.full(96, 100, np.float32)
    passage = Passage(Crossings(19.5, 79.5, 23.5, 83.5), pictures[0], pictures[1], 0, 0, road, road, 1.0)
    motion = measure_direct(passage, Rig(2.57, 29.83))
    assert str(motion.reason).startswith("Only about 4 lines were recorded")


@pytest.mark.parametrize("number", [0, 1, 2])
def test_speed_acceleration_length_and_misalignment_are_the_true_ones(number):
    motion = measure_direct(passages()[number], RIG)
    car = plain_truth()[number].vehicle
    assert motion.status == "ok" and motion.method == "direct"
    assert motion.speed_mps == pytest.approx(car.speed_mps, rel=0.0012)
    assert motion.acceleration_mps2 == pytest.approx(car.acceleration_mps2, abs=0.25)
    assert motion.length_m == pytest.approx(car.length_m, abs=0.012)
    assert motion.misalignment_px == pytest.approx(SITE.misalignment_px, abs=0.05)
    assert motion.gain == pytest.approx(SITE.gain_2, rel=0.02)
    assert abs(motion.speed_mps - car.speed_mps) < 3 * motion.u_speed_mps
    assert motion.u_speed_mps < 0.0012 * car.speed_mps


def test_noise_of_8_grey_values_and_256_rows():
    site = ScanSite(rows=256, read_noise_dn=8.0, misalignment_px=-0.5, seed=9)
    car = cars()[1]
    found_passages, _ = found(strips(site, (replace(car, front_s=0.6),)))
    motion = measure_direct(found_passages[0], RIG)
    assert len(found_passages) == 1
    assert motion.speed_mps == pytest.approx(car.speed_mps, rel=0.0024)
    assert motion.misalignment_px == pytest.approx(-0.5, abs=0.1)


def test_only_a_motion_that_its_last_round_moved_beyond_its_uncertainty_is_said_not_to_have_converged(
    monkeypatch,
):
    site = ScanSite(rows=256, read_noise_dn=8.0, seed=9)
    fast = [replace(car, front_s=0.6, speed_mps=40.0) for car in cars()[:3]]
    fast = [found(strips(site, (car,)))[0][0] for car in fast]
    said = Said("scan-motion-not-converged")
    assert [said in measure_direct(one, RIG).warnings for one in fast] == [False] * 3
    with monkeypatch.context() as strict:
        strict.setattr(direct, "SETTLED", 0.0)  # what the rounds stop at is settled in any case
        assert said not in measure_direct(passages()[0], RIG).warnings
    rounds = {"most_rounds": 1}
    monkeypatch.setattr(direct, "register", lambda *args, **_: register(*args[:9], **rounds))
    assert said in measure_direct(fast[0], RIG).warnings
    # a covariance that says nothing says of no step that it is small
    monkeypatch.setattr(direct, "covariance", lambda slopes, *rest: 0 * covariance(slopes, *rest))
    assert said in measure_direct(fast[0], RIG).warnings


def test_speed_and_acceleration_are_correlated_by_the_fit_and_by_the_baseline():
    alone = measure_direct(passages()[0], RIG)
    # a faster front and a stronger braking leave the middle, where the pictures tell most, as it is
    assert -1 < alone.correlation < -0.5
    loose = measure_direct(passages()[0], replace(RIG, u_baseline_m=0.2))
    assert loose.correlation == pytest.approx(np.sign(loose.acceleration_mps2), abs=0.05)


def test_the_budget_lists_its_sources_and_sums_to_the_uncertainty():
    rig = replace(RIG, u_baseline_m=0.002, u_line_rate_ratio=5e-5)
    motion = measure_direct(passages()[0], rig)
    assert tuple(entry.source for entry in motion.budget) == SOURCES
    for name, total in (
        ("u_speed_mps", motion.u_speed_mps),
        ("u_acceleration_mps2", motion.u_acceleration_mps2),
        ("u_length_m", motion.u_length_m),
    ):
        assert total == pytest.approx(np.sqrt(sum(getattr(e, name) ** 2 for e in motion.budget)))
    by_source = {entry.source: entry for entry in motion.budget}
    assert by_source["baseline"].u_speed_mps == pytest.approx(motion.speed_mps * 0.002 / 0.593)
    assert by_source["baseline"].u_length_m == pytest.approx(motion.length_m * 0.002 / 0.593)
    assert by_source["clock"].u_speed_mps == pytest.approx(motion.speed_mps * 5e-5)
    assert by_source["clock"].u_length_m == 0.0
    front, rear = by_source["front"], by_source["rear"]
    # the speed is that at the front's crossing of camera 1, of which the length has both cameras' mean
    by_front = abs(motion.acceleration_mps2) / motion.speed_mps * front.u_length_m * np.sqrt(2 / 1.58)
    assert front.u_speed_mps == pytest.approx(by_front) and front.u_length_m > 0
    assert rear.u_speed_mps == 0.0 and rear.u_length_m > 0


def test_what_takes_a_gain_and_an_offset_together_is_not_cut_by_a_cluster():
    """Halves of a cell in two clusters err alike, where u takes clusters for independent."""
    scene, _, _ = _prepared(passages()[0], RIG)
    cells = len(np.unique(scene.cell))
    assert len({len(np.unique(cluster)) for cluster in scene.clusters}) == len(scene.clusters) > 1
    for cluster in scene.clusters:
        assert len(np.unique(np.stack([scene.cell, cluster]), axis=1).T) == cells


def test_a_baseline_off_by_a_per_cent_is_an_error_of_a_per_cent():
    right = measure_direct(passages()[2], RIG)
    wrong = measure_direct(passages()[2], replace(RIG, baseline_m=0.593 * 1.01))
    assert wrong.speed_mps / right.speed_mps == pytest.approx(1.01, abs=1e-4)
    assert wrong.length_m / right.length_m == pytest.approx(1.01, abs=1e-4)


def test_planes_that_open_lengthen_the_baseline_with_the_distance():
    rig = Rig(0.593, 4882.8, u_baseline_m=0.001, divergence_rad=2e-4, u_divergence_rad=1e-4, distance_m=10.0)
    assert baseline_of(rig) == pytest.approx((0.595, np.hypot(0.001, 0.001)))


@pytest.mark.parametrize("measure", [measure_direct, measure_paper])
def test_a_calibrated_rig_gives_its_share_at_the_vehicles_distance(measure):
    """Baseline and divergence err against each other: at the lane less is left than either brings there."""
    rig = replace(
        RIG,
        baseline_m=0.581,
        u_baseline_m=0.002,
        divergence_rad=2e-3,
        u_divergence_rad=3e-4,
        distance_m=6.0,
        baseline_correlation=-0.9,
        u_distance_m=0.25,
    )
    motion = measure(passages()[0], rig)
    share = {one.source: one for one in motion.budget}["baseline"]
    left = 0.002**2 + (6 * 3e-4) ** 2 - 2 * 0.9 * 0.002 * 6 * 3e-4 + (2e-3 * 0.25) ** 2
    assert share.u_speed_mps == pytest.approx(motion.speed_mps * np.sqrt(left) / 0.593)
    assert share.u_length_m == pytest.approx(motion.length_m * np.sqrt(left) / 0.593)
    assert np.sqrt(left) < 0.0011 < np.hypot(0.002, 6 * 3e-4)


def test_a_known_misalignment_is_used():
    known = replace(RIG, misalignment_px=0.4, u_misalignment_px=0.001)
    free, held = measure_direct(passages()[0], RIG), measure_direct(passages()[0], known)
    assert abs(held.misalignment_px - 0.4) <= 0.003 and abs(free.misalignment_px - 0.4) <= 0.02
    assert held.u_misalignment_px <= free.u_misalignment_px


@pytest.mark.parametrize("lines", [-6.0, 6.0])
def test_boundaries_set_roughly_by_hand_hardly_move_the_speed(lines):
    passage = passages()[1]
    c = passage.crossings
    moved = replace(c, front_line_2=c.front_line_2 + lines, rear_line_1=c.rear_line_1 - lines)
    motion = measure_direct(replace(passage, crossings=moved), RIG)
    assert motion.speed_mps == pytest.approx(plain_truth()[1].vehicle.speed_mps, rel=0.0015)


def test_the_profile_follows_the_fit_and_its_error_is_what_the_profile_says():
    motion = measure_direct(passages()[2], RIG)
    profile = motion.profile
    assert len(profile.line_1) >= 20 and profile.used.sum() > 10
    assert (np.diff(profile.line_1) > 0).all()
    ratio = profile.speed_mps[profile.used] / profile.fitted_mps[profile.used] - 1
    assert motion.fit_error_percent == pytest.approx(100 * np.sqrt(np.mean(ratio**2)))
    assert motion.fit_error_percent < 0.3
    middle = Course(motion.speed_mps, motion.acceleration_mps2, 0.593)
    first_s = (profile.line_1 - motion.crossings.front_line_1) / RIG.line_rate_hz
    assert profile.fitted_mps == pytest.approx(0.593 / (middle.second_s(first_s) - first_s), rel=1e-4)


def test_what_cannot_be_measured_has_a_reason():
    passage = passages()[0]
    assert measure_direct(replace(passage, reason=CUT), RIG).reason == CUT
    c = passage.crossings
    turned = Crossings(c.rear_line_1, c.front_line_1, c.front_line_2, c.rear_line_2)
    assert measure_direct(replace(passage, crossings=turned), RIG).reason == NO_ORDER
    grey = np.full_like(passage.first, 200)
    blank = replace(passage, first=grey, second=np.full_like(passage.second, 200))
    motion = measure_direct(blank, RIG)
    assert motion.reason == NO_TEXTURE and motion.speed_mps is None and motion.budget == ()


def test_another_vehicle_in_the_second_picture_is_not_measured():
    one, other = passages()[0], passages()[1]
    lines = len(other.second)
    c = one.crossings
    stop = min(len(one.second), lines)
    mixed = replace(one, second=other.second[:stop])
    motion = measure_direct(replace(mixed, crossings=c), RIG)
    assert motion.status == "not_measurable" or motion.fit_error_percent > 1.0 or motion.warnings


@pytest.mark.parametrize("acceleration", [-4.0, 0.0, 1.5])
def test_crossings_follow_the_kinematics_exactly(acceleration):
    course = Course(10.0, acceleration, 0.593)
    first = np.array([0.0, 0.1, 0.4])
    second = course.second_s(first)
    assert course.travelled_m(second) - course.travelled_m(first) == pytest.approx([0.593] * 3, abs=1e-12)
    by_speed, by_acceleration = course.derivatives(first, second)
    h = 1e-6
    assert by_speed == pytest.approx(
        (Course(10 + h, acceleration, 0.593).second_s(first) - second) / h, rel=1e-4
    )
    assert by_acceleration == pytest.approx(
        (Course(10, acceleration + h, 0.593).second_s(first) - second) / h, rel=1e-4, abs=1e-12
    )


def test_boundaries_alone_give_speed_and_acceleration():
    car = replace(cars()[0], front_s=0.0, speed_mps=10.0, acceleration_mps2=-2.0)
    true = truths(ScanSite(), (car,))[0]
    lines = np.array([true.front_line_1, true.rear_line_1, true.front_line_2, true.rear_line_2])
    course = solved_by_boundaries(lines / 4882.8, 0.593)
    assert (course.speed_mps, course.acceleration_mps2) == pytest.approx((10.0, -2.0), abs=1e-6)
    assert isinstance(car, ScanVehicle)


def test_sampling_is_exact_for_quadratics():
    y, x = np.mgrid[-24:36, -24:33].astype(float)
    picture = (0.3 * y**2 - 0.2 * x * y + 0.1 * x**2 + 4).astype(np.float32)
    at, row = np.array([3.25, 7.9]), np.array([2.6, 5.6])
    sheet = shift_sheet(Sheet(picture, 0.0, 1, 1), -0.4)
    place, whole = at + 24, np.array([27.0, 30.0])
    expected = 0.3 * at**2 - 0.2 * row * at + 0.1 * row**2 + 4
    # in single precision, of values up to 600
    assert sample_sheet(sheet, place, whole) == pytest.approx(expected, abs=2e-4)
