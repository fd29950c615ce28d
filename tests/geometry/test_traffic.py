"""What a second frame gains, and what traffic says of a pose and of insets."""

import dataclasses

import numpy as np
import pytest

from sightline.adjustment.shared_errors import moved_pose
from sightline.geometry.documents import pose_from_dict
from sightline.geometry.gain import second_frame_gain
from sightline.geometry.height import measure_height, shared_covariance
from sightline.geometry.inset_trend import (
    Sightings,
    combine_sightings,
    inset_from_known_heights,
    inset_from_solved,
    inset_from_trend,
    sightings,
)
from sightline.geometry.insets import bias_m
from sightline.geometry.multiframe import measure_frames
from sightline.geometry.spread import mean_and_spread, outliers
from sightline.geometry.traffic import heading_of_pair, headings_of_pairs, turn_pose_to_heading
from sightline.messages.said import Said
from tests.adjustment.survey import BoardBudget, prior_covariance, told_pose, truth_at
from tests.geometry.scenes import headings, pose_of
from tests.geometry.simulate import Lens, Scene

SCENE = Scene(Lens(), (0.0, -3.0, 1.5), 0.0, 4.0)


def unshared(camera_height_m, distance_m, measured_m, u_m) -> Sightings:
    """Sightings that share nothing, from numbers or columns (N,)."""
    columns = [np.atleast_1d(v).astype(float) for v in (camera_height_m, distance_m, measured_m, u_m)]
    n = len(columns[2])
    return Sightings(*np.broadcast_arrays(*columns), np.zeros((n, n)))


def test_gain_foretells_the_uncertainty_and_the_second_clicks() -> None:
    pose = pose_of(SCENE)
    first = SCENE.look([(-1.0, 0.0, 0.0), (-1.3, 0.45, 1.16)])
    second = SCENE.look([(0.8, 0.0, 0.0), (0.5, 0.45, 1.16)])
    gain = second_frame_gain(pose, first[0], first[1], 1.8, 1.0, 0.45, 0.10)
    assert gain is not None
    assert gain.contact_px == pytest.approx(second[0], abs=1e-6)
    assert gain.target_px == pytest.approx(second[1], abs=1e-6)
    found = measure_frames(pose, [first[0], second[0]], [first[1], second[1]])
    assert gain.u_double_m == pytest.approx(found.height.u_height_m, rel=1e-6)
    assert gain.u_double_m < 0.6 * gain.u_single_m
    nearer = second_frame_gain(pose, first[0], first[1], 0.4, 1.0, 0.45, 0.1)
    assert nearer is not None and gain.u_double_m < nearer.u_double_m
    assert second_frame_gain(pose, first[0], first[1], 0.01, 1.0, 0.45, 0.1) is None
    assert second_frame_gain(pose, first[0], first[1], 30.0) is None
    assert second_frame_gain(pose, (3, 3), (2, 2), 1.0) is None


def wheels(turn, rng, n, noise_px=0.5, sway=0.0):
    """Clicks (n, 2) twice on the tyre contacts of n vehicles that travel at an angle to the road's X."""
    scene = dataclasses.replace(SCENE, pitch=10.0)
    ends = []
    for _ in range(n):
        x, y = rng.uniform(-1.5, -1.0), rng.uniform(0, 1.5)
        angle = turn + rng.normal(0, sway)
        ends.append(((x, y, 0.0), (x + 2.6 * np.cos(angle), y + 2.6 * np.sin(angle), 0.0)))
    look = [scene.look([end[i] for end in ends]) + rng.normal(0, noise_px, (n, 2)) for i in (0, 1)]
    return pose_of(scene), *look


def test_headings_find_a_turned_board() -> None:
    turn = 0.02
    pose, a, b = wheels(turn, np.random.default_rng(1), 12)
    found = headings(pose, a, b, 0.5)
    assert not isinstance(found, Said)
    assert found.mean_rad == pytest.approx(turn, abs=4 * found.u_mean_rad)
    assert found.proposed and 0 < found.u_mean_rad < 0.01
    corrected = headings(turn_pose_to_heading(pose, found.mean_rad), a, b, 0.5)
    assert not isinstance(corrected, Said)
    assert abs(corrected.mean_rad) < 1e-6 and not corrected.proposed
    scene = dataclasses.replace(SCENE, pitch=10.0)
    clicks = scene.look([(-1.2, 0.5, 0.0), (-0.9, 0.5, 1.2)])
    before, after = (
        measure_height(p, clicks[0], clicks[1]).height_m for p in (pose, turn_pose_to_heading(pose, turn))
    )
    assert before is not None and after is not None and abs(after - before) < 0.004
    assert isinstance(headings(pose, a[:2], b[:2], 1.0), Said)
    assert isinstance(headings(pose, a, a, 1.0), Said)


def test_mean_heading_covers_the_truth_and_its_own_uncertainty_is_right() -> None:
    rng = np.random.default_rng(5)
    off, u = [], []
    for _ in range(60):
        pose, a, b = wheels(0.01, rng, 8, noise_px=1.0, sway=0.004)
        found = headings(pose, a, b, 1.0)
        assert not isinstance(found, Said)
        off.append(found.mean_rad - 0.01)
        u.append(found.u_mean_rad)
    assert np.std(off) == pytest.approx(np.mean(u), rel=0.3)
    assert abs(np.mean(off)) < 3 * np.std(off) / np.sqrt(len(off))
    one = [heading_of_pair(pose, p, q, 1.0) for p, q in zip(a, b, strict=True)]
    assert all(not isinstance(h, Said) and 0.001 < h.u_heading_rad < 0.02 for h in one)


def test_a_board_that_is_off_does_not_pass_for_a_turned_road() -> None:
    """A roll of 5 mrad at 4 m turns all directions by 0.8 degrees, those of many vehicles too."""
    truth, budget = truth_at(distance=4.0, height=1.4), BoardBudget(lens=(0.1,) * 4 + (1e-4,) * 5)
    covariance, px, z, proposed = prior_covariance(truth, budget), 0.5, [], 0
    for seed in range(40):
        rng = np.random.default_rng(seed)
        pose = pose_from_dict(told_pose(truth, budget, covariance, rng))
        rear = np.column_stack([rng.uniform(-1.3, -0.9, 15), rng.uniform(-0.5, 1.0, 15), np.zeros(15)])
        turn = rng.normal(0, 0.003, 15)
        front = rear + 2.5 * np.column_stack([np.cos(turn), np.sin(turn), np.zeros(15)])
        clicked = [truth.see(of) + rng.normal(0, px, (15, 2)) for of in (rear, front)]
        found = headings(pose, *clicked, px)
        assert not isinstance(found, Said)
        z.append(found.mean_rad / found.u_mean_rad)
        proposed += found.proposed
    assert 0.6 < np.sqrt(np.mean(np.square(z))) < 1.38  # chi-square of 40, 0.1 % on either side
    assert proposed <= 7  # of 2 expected; 8 and more have a chance of 0.001


def test_a_direction_follows_lens_and_pose_as_it_is_told_to() -> None:
    pose, a, b = wheels(0.02, np.random.default_rng(4), 3)
    found = headings_of_pairs(pose, a, b)
    for k, step in ((1, 1e-3), (4, 1e-6), (9, 1e-6), (10, 1e-6), (11, 1e-6), (13, 1e-6)):
        increments = np.zeros(15)
        increments[k] = step
        moved = [headings_of_pairs(moved_pose(pose, s * increments), a, b) for s in (1, -1)]
        for one, up, down in zip(found, *moved, strict=True):
            slope = (up.heading_rad - down.heading_rad) / (2 * step)
            assert one.parts.by_lens_pose[k] == pytest.approx(slope, rel=1e-4, abs=1e-7)


def test_a_pair_that_is_none_says_why() -> None:
    pose, a, b = wheels(0.0, np.random.default_rng(2), 6)
    b[3] = b[3] + [0.0, -14.0]  # a tyre in the next lane
    found = headings(pose, a, b, 0.5)
    assert not isinstance(found, Said) and found.used.tolist() == [True, True, True, False, True, True]
    near = heading_of_pair(pose, a[0], a[0] + 3.0)
    sky = heading_of_pair(pose, a[0], (320.0, 3.0))
    assert isinstance(near, Said) and near.code == "heading-base-short"
    assert isinstance(sky, Said) and str(sky).startswith("The second tyre contact: ")


def test_a_turned_pose_carries_the_uncertainty_of_the_turn() -> None:
    scene = dataclasses.replace(SCENE, pitch=10.0)
    covariance = np.diag(np.full(15, 1e-8))
    plain = pose_of(scene, covariance=covariance)
    pose = turn_pose_to_heading(plain, 0.02, 0.004)
    assert pose.covariance is not None
    # the increments of 1 rad about Z through the origin leave the origin where it is and turn X to Y
    extra = np.array(pose.covariance - covariance)[-6:, -6:] / 0.004**2
    turn = extra[:, 0] / np.sqrt(extra[0, 0]) if extra[0, 0] > 0 else extra[:, 1] / np.sqrt(extra[1, 1])
    step = 1e-6

    def moved(point):
        at_cam = pose.to_camera(np.array([point]))[0]
        return at_cam + step * (np.cross(turn[:3], at_cam) + turn[3:])

    assert moved((0.0, 0.0, 0.0)) == pytest.approx(pose.translation_m, abs=1e-12)
    assert moved((0.0, 0.0, 1.0)) == pytest.approx(pose.to_camera(np.array([[0, 0, 1.0]]))[0], abs=1e-12)
    along = (moved((1.0, 0.0, 0.0)) - pose.to_camera(np.array([[1.0, 0, 0]]))[0]) / step
    assert abs(along @ pose.rotation[:, 1]) == pytest.approx(1.0, abs=1e-9)
    # a target ahead of the contact feels it: (h - Hc) / D * ahead * u
    clicks = scene.look([(-1.0, 0.0, 0.0), (0.2, 0.0, 1.1)])
    u = [measure_height(p, *clicks, 0.0).u_height_m for p in (turn_pose_to_heading(plain, 0.02, 0.0), pose)]
    more = np.sqrt(u[1] ** 2 - u[0] ** 2)
    assert more == pytest.approx(abs(1.1 - 1.5) / 3.0 * 1.2 * 0.004, rel=0.1)


def roofs(rng, n, inset=0.4, camera=1.2, u_m=0.007, truth=0.0):
    """Uncorrected heights of roofs by their definition, and their known heights off by +-truth (uniform)."""
    true, distance = rng.uniform(1.4, 2.0, n), rng.uniform(2.0, 5.0, n)
    measured = camera + (true - camera) * distance / (distance + inset) + rng.normal(0, u_m, n)
    return unshared(camera, distance, measured, u_m), true + rng.uniform(-truth, truth, n)


def test_inset_from_roofs_of_known_height() -> None:
    rng = np.random.default_rng(2)
    rows, known = roofs(rng, 300)
    found = inset_from_known_heights(rows, known, 0.0)
    assert not isinstance(found, Said)
    assert found.inset_m == pytest.approx(0.4, abs=4 * found.u_inset_m)
    assert found.u_inset_m < 0.02 and found.vehicles == 300 and found.caution is None
    few = inset_from_known_heights(unshared(1.2, [3.0], [1.5], 0.01), [1.6], 0.01)
    assert isinstance(few, Said)
    level = inset_from_known_heights(unshared(1.2, [3.0] * 5, [1.2] * 5, 0.01), [1.2] * 5, 0.01)
    assert isinstance(level, Said) and "at about camera height" in str(level)
    # known heights to +-3 cm, as in the paper's validation: no bias, and 95 % intervals that cover
    inside, found_m = [], []
    for _ in range(200):
        rows, known = roofs(rng, 24, truth=0.03)
        one = inset_from_known_heights(rows, known, 0.03 / np.sqrt(3))
        assert not isinstance(one, Said)
        inside.append(abs(one.inset_m - 0.4) < 1.96 * one.u_inset_m)
        found_m.append(one.inset_m)
    assert 0.92 < np.mean(inside) < 0.99
    assert abs(np.mean(found_m) - 0.4) < 0.01


def test_one_wrong_catalogue_entry_is_left_out_and_named() -> None:
    rows, known = roofs(np.random.default_rng(4), 9)
    known[5] += 0.25
    found = inset_from_known_heights(rows, known, 0.01)
    assert not isinstance(found, Said) and found.left_out == (5,) and found.vehicles == 8
    assert found.inset_m == pytest.approx(0.4, abs=3 * found.u_inset_m)


def test_what_all_heights_share_is_in_the_uncertainty() -> None:
    """A camera height off by 1 cm moves every roof alike: more vehicles must not make it go away."""
    rows, known = roofs(np.random.default_rng(6), 100)
    plain = inset_from_known_heights(rows, known, 0.0)
    shared = dataclasses.replace(rows, shared_m2=np.full((100, 100), 0.01**2))
    found = inset_from_known_heights(shared, known, 0.0)
    off = dataclasses.replace(rows, measured_m=rows.measured_m + 0.01)
    moved = inset_from_known_heights(off, known, 0.0)
    assert not isinstance(plain, Said) and not isinstance(found, Said) and not isinstance(moved, Said)
    effect = abs(moved.inset_m - plain.inset_m)
    assert effect > 0.03
    assert np.sqrt(found.u_inset_m**2 - plain.u_inset_m**2) == pytest.approx(effect, rel=0.15)


def test_sightings_are_the_uncorrected_heights() -> None:
    poses = [pose_of(SCENE), pose_of(dataclasses.replace(SCENE, eye=(0.0, -3.4, 1.3)))]
    parts, heights = [], []
    for scene, pose in zip((SCENE, dataclasses.replace(SCENE, eye=(0.0, -3.4, 1.3))), poses, strict=True):
        clicks = scene.look([(-0.5, 0.2, 0.0), (-0.2, 0.65, 1.16), (0.0, 0.0, 0.0), (0.1, 0.45, 1.6)])
        part, fine = sightings(pose, clicks[::2], clicks[1::2], 1.0)
        assert fine.all()
        parts.append(part)
        heights += [(scene.eye[2], 0.2 - scene.eye[1], 1.16), (scene.eye[2], -scene.eye[1], 1.6)]
    rows = combine_sightings(parts)
    for i, (camera, distance, height) in enumerate(heights):
        assert rows.camera_height_m[i] == pytest.approx(camera, abs=1e-9)
        assert rows.distance_m[i] == pytest.approx(distance, abs=1e-9)
        bias = float(bias_m(camera, height, 0.45, distance))
        assert rows.measured_m[i] == pytest.approx(height + bias, abs=1e-9)
    assert rows.shared_m2.shape == (4, 4)
    # metrology's own table: an eye at 1.10 m, camera at 1.5 m
    assert np.rint(1000 * bias_m(1.5, 1.10, 0.40, [1.5, 2, 3, 5])).tolist() == [84, 67, 47, 30]
    bad, fine = sightings(poses[0], [(320.0, 3.0)], [(320.0, 2.0)], 1.0)
    assert len(bad) == 0 and not fine.any()


def eyes(rng, n, inset=0.45, camera=1.5):
    """Uncorrected eye heights of vehicles spread over two lanes."""
    height, distance = rng.normal(1.16, 0.075, n), rng.uniform(1.5, 5.0, n)
    read = camera + (height - camera) * distance / (distance + inset) + rng.normal(0, 0.008, n)
    return unshared(camera, distance, read, 0.008)


def test_trend_with_distance_finds_the_inset_as_well_as_it_can() -> None:
    rng = np.random.default_rng(7)
    found = [inset_from_trend(eyes(rng, 400)) for _ in range(200)]
    assert all(not isinstance(one, Said) and one.caution is None for one in found)
    insets = np.array([one.inset_m for one in found if not isinstance(one, Said)])
    u = np.array([one.u_inset_m for one in found if not isinstance(one, Said)])
    assert np.mean(insets) == pytest.approx(0.45, abs=0.04)
    assert 0.09 < np.std(insets) < 0.16  # metrology: +-0.13 m
    assert 0.92 <= np.mean(np.abs(insets - 0.45) < 1.96 * u) <= 0.98


def test_trend_says_when_it_says_nothing() -> None:
    rng = np.random.default_rng(8)
    assert isinstance(inset_from_trend(eyes(rng, 9)), Said)
    few = inset_from_trend(eyes(rng, 30))
    assert isinstance(few, Said) or (few.caution is not None and "few hundred" in str(few.caution))
    level = inset_from_trend(eyes(rng, 200, camera=1.2))
    level_says = level if isinstance(level, Said) else level.caution
    assert "at about camera height" in str(level_says)
    rows = eyes(rng, 200)
    alike = dataclasses.replace(rows, distance_m=np.full(200, 3.0) + rng.uniform(-0.1, 0.1, 200))
    same = inset_from_trend(alike)
    assert isinstance(same, Said) or (same.caution is not None and "same distance" in str(same.caution))


def test_two_frame_insets_give_mean_and_spread_between_vehicles() -> None:
    rng = np.random.default_rng(9)
    u = rng.uniform(0.02, 0.08, 200)
    found = inset_from_solved(rng.normal(0.35, np.hypot(u, 0.10)), u)
    assert not isinstance(found, Said)
    assert found.inset_m == pytest.approx(0.35, abs=4 * found.u_inset_m)
    assert found.spread_m == pytest.approx(0.10, rel=0.2)
    few = inset_from_solved([0.3, 0.35, 0.31, 0.33, 0.29, 1.6], [0.02] * 6)
    assert not isinstance(few, Said) and few.left_out == (5,) and few.spread_m is None
    assert isinstance(inset_from_solved([0.3], [0.02]), Said)


def test_what_all_insets_of_a_pose_share_stays_in_their_mean() -> None:
    """Lens, pose, board and the board's direction are off once for all vehicles of a survey."""
    truth = truth_at(distance=4.0, height=1.4, board=3.5)
    budget = BoardBudget(noise_px=0.1, lens=(*[1.6] * 2, *[2.0] * 2, *[4e-3] * 2, *[4e-4] * 2, 4e-3))
    covariance, px, z = prior_covariance(truth, budget), 0.25, []
    for seed in range(5):
        rng = np.random.default_rng(seed)
        pose = pose_from_dict(told_pose(truth, budget, covariance, rng))
        board = np.deg2rad(1.0) * rng.normal()
        found = []
        for _ in range(12):
            inset, y, turn = rng.normal(0.45, 0.03), rng.uniform(-0.3, 1.5), board + rng.normal(0, 0.003)
            along = np.array([np.cos(turn), np.sin(turn), 0.0])
            across = np.array([-along[1], along[0], 0.0])
            contacts = np.array([-0.95, y, 0.0]) + np.outer([0.0, 1.7], along)
            targets = contacts - 0.3 * along + inset * across + [0.0, 0.0, rng.normal(1.16, 0.05)]
            clicked = [truth.see(of) + rng.normal(0, px, (2, 2)) for of in (contacts, targets)]
            found.append(measure_frames(pose, *clicked, px))
        insets_m, parts = [one.solved_inset_m for one in found], [one.inset_parts for one in found]
        mean = inset_from_solved(insets_m, [one.u_own for one in parts], shared_covariance(pose, parts))
        assert not isinstance(mean, Said)
        z.append((mean.inset_m - 0.45) / mean.u_inset_m)
    assert np.square(z).sum() < 20.5  # chi-square of 5, 0.1 %


def test_mean_and_spread_by_hand() -> None:
    even = mean_and_spread([1.0, 1.0, 1.0], [0.1, 0.2, 0.2])
    assert (even.mean, even.between) == (pytest.approx(1.0), 0.0)
    assert even.u_mean == pytest.approx((100 + 25 + 25) ** -0.5)
    apart = mean_and_spread([0.0, 2.0, 4.0], [1e-6] * 3)
    assert apart.between == pytest.approx(2.0) and apart.u_mean == pytest.approx(2 / np.sqrt(3))
    assert mean_and_spread([3.0], [0.5]).u_mean == pytest.approx(0.5)
    shared = mean_and_spread(
        [1.0, 1.0], [0.1, 0.2], [[0.09, 0.06], [0.06, 0.04]]
    )  # as 0.3 and 0.2 of one error
    assert shared.u_own == pytest.approx((1 / 0.01 + 1 / 0.04) ** -0.5)
    assert shared.u_mean == pytest.approx(np.hypot(shared.u_own, 0.8 * 0.3 + 0.2 * 0.2))
    assert outliers([1.0, 1.1, 0.9, 9.0]).sum() == 0 and outliers([1.0, 1.1, 0.9, 1.0, 9.0]).tolist()[-1]
    assert not outliers([1.0, 1.1, 0.9, 1.0, 9.0], [0.1, 0.1, 0.1, 0.1, 3.0]).any()
