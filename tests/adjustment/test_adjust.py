"""The adjustment against a survey that shares no code with it; tests/bench/bench_adjustment.py has the
coverage.
"""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sightline.adjustment.adjust import _heading, adjust
from sightline.adjustment.local_tests import Cleaned
from sightline.adjustment.observed import REAR, Known, ObservedPass, shared_insets
from sightline.adjustment.shared_errors import covariance_at, moved_pose, shared_errors
from sightline.adjustment.traffic_model import HEADING, arrange_passes, linearise
from sightline.errors import BadInput
from sightline.geometry.height import systematic_covariance
from sightline.geometry.road_pose import RoadPose
from tests.adjustment.cases import EYE_M, case, draw, eye
from tests.adjustment.survey import BoardBudget, Fleet

SMALL = Fleet(vehicles=6, frames=4, u_roof=0.01)


def test_what_all_heights_share_shrinks_and_the_rest_is_as_large_as_said() -> None:
    cases = [case(Fleet(vehicles=50), seed) for seed in range(8)]
    u = np.array([one.after.u_height_m for one in cases])
    errors = np.array([one.after.height_m for one in cases]) - EYE_M
    assert all(one.before.u_height_m > 0.015 for one in cases)
    assert u.max() < 0.003
    assert 1.0 < np.square(errors / u).sum() < 26.1  # chi-square of 8, 0.1 % on either side
    # vehicles keep to the road: what their mean direction is off by is the pose's, however many they are
    turned = [one.adjustment.heading_rad / one.adjustment.u_heading_rad for one in cases]
    assert 1.0 < np.square(turned).sum() < 26.1
    for one in cases:
        told = one.adjustment
        assert told.used == 50 and not told.left_out
        assert told.degrees_of_freedom == 50 * (8 * 3 * 2 + 1 - 14)  # y, heading, W, ahead, inset, H, places
        assert told.chi2_limit is not None and told.chi2 < told.chi2_limit


def test_a_board_that_leans_more_than_stated_is_found_and_corrected() -> None:
    sure = BoardBudget(lean=0.001, noise_px=0.01, lens=(0.05, 0.05, 0.05, 0.05, 1e-4, 1e-4, 1e-5, 1e-5, 1e-4))
    one = case(Fleet(), 3, sure, lean=0.010)
    assert one.before.height_m is not None and one.after.height_m is not None
    assert abs(one.before.height_m - EYE_M) > 0.015
    assert abs(one.after.height_m - EYE_M) < 0.006  # two uncertainties
    assert "board_lean_rad" in [note.values.get("part") for note in one.adjustment.notes]
    lean = next(moved for moved in one.adjustment.moved if moved.name == "board_lean_rad")
    assert abs(lean.value) == pytest.approx(0.010, abs=3 * lean.u_after)
    assert lean.u_after < 0.002


def test_vehicles_of_another_model_are_named() -> None:
    one = case(Fleet(vehicles=40, wrong_share=0.1), 3)
    assert len(one.wrong) == 5
    assert {left.name for left in one.adjustment.left_out} == set(one.wrong)
    assert all("check the model." in str(left.reason) for left in one.adjustment.left_out)


def test_nothing_known_improves_nothing() -> None:
    pose, traffic, _ = draw(Fleet(vehicles=5, u_wheelbase=None), 0)
    found = adjust(pose, traffic)
    assert found.used == 0 and len(found.left_out) == 5
    assert np.array_equal(found.pose.rotation, pose.rotation)
    assert eye(found.pose).u_height_m == pytest.approx(eye(pose).u_height_m, rel=1e-9)
    assert all(abs(one.value) < 1e-12 and one.u_after == pytest.approx(one.u_before) for one in found.moved)


def test_the_common_error_does_not_vanish_with_the_number_of_vehicles() -> None:
    fleet = Fleet(vehicles=100, u_wheelbase=0.005, sigma_px=0.05, frames=4)
    pose, traffic, _ = draw(fleet, 1, BoardBudget(height=0.02, square=0.002))
    u = [eye(adjust(pose, traffic, common).pose).u_height_m for common in (0.0, 0.01)]
    assert u[0] is not None and u[1] is not None
    assert u[0] < 0.0012
    assert u[1] > 0.002


def test_an_inset_that_all_roofs_assume_is_wrong_for_all_of_them() -> None:
    """Half its variance is that of its mean (DECISIONS.md, 31), which more roofs do not average out."""
    sure = BoardBudget(lean=0.001, height=0.006, noise_px=0.01, lens=(*[0.05] * 4, *[1e-4] * 4, 1e-3))
    vans = Fleet(40, frames=1, sigma_px=0.3, roof=2.5, u_common=0.001, u_wheelbase=None, u_roof=0.005)
    cases = [case(vans, seed, sure) for seed in range(10)]
    u = np.array([one.after.u_height_m for one in cases])
    errors = np.array([one.after.height_m for one in cases]) - EYE_M
    assert np.square(errors / u).sum() < 29.6  # chi-square of 10, 0.1 %
    (common,) = (one for one in cases[0].adjustment.moved if one.name == "roof_inset_common_m")
    assert common.of_m == 0.3 and common.u_before == pytest.approx(0.5**0.5 * 0.1)


def test_only_roofs_that_assume_the_same_inset_share_its_error() -> None:
    pose, traffic, _ = draw(replace(SMALL, vehicles=5), 2)
    insets = (0.3, 0.2, 0.3, 0.2, 0.25)  # the last one is some vehicle's own
    odd = [replace(one, roof_inset=Known(inset_m, 0.1)) for one, inset_m in zip(traffic, insets, strict=True)]
    found = [one.of_m for one in adjust(pose, odd).moved if one.name == "roof_inset_common_m"]
    assert found == [0.2, 0.3]
    table = arrange_passes(pose, odd)
    assert table.common[:, 2].tolist() == [3, 2, 3, 2, -1]
    assert table.u_m[:, 2] == pytest.approx([0.5**0.5 * 0.1] * 4 + [0.1])


def test_everything_is_in_the_covariance_of_the_adjusted_pose() -> None:
    one = case(SMALL, 4)
    pose = one.adjustment.pose
    assert pose.covariance is not None and pose.camera.covariance is not None
    assert np.allclose(systematic_covariance(pose), pose.covariance)
    assert np.allclose(pose.camera.covariance, pose.covariance[:9, :9])
    assert pose.board is not None and pose.board.u_lean_rad == pose.board.u_reference_height_m == 0.0


def test_points_that_scatter_more_than_stated_are_believed_less() -> None:
    honest = case(replace(Fleet(), sigma_px=1.0), 6)
    careless = case(replace(Fleet(), real_sigma_px=1.0), 6)
    assert any(
        note.code == "adjustment-points-scatter" and note.values["factor"] in (1.9, 2.0)
        for note in careless.adjustment.notes
    )
    assert not honest.adjustment.notes
    assert careless.after.u_height_m == pytest.approx(honest.after.u_height_m, rel=0.1)


def test_single_points_that_are_far_off_are_dropped_and_named() -> None:
    pose, traffic, _ = draw(SMALL, 5)
    clean = adjust(pose, traffic)
    pixels = np.array(traffic[2].points_px)
    pixels[5] += (25.0, -18.0)
    found = adjust(pose, [*traffic[:2], replace(traffic[2], points_px=pixels), *traffic[3:]])
    assert [(one.name, one.frame, one.point) for one in found.dropped_points] == [("2", 1, "front_tyre")]
    assert np.allclose(found.pose.translation_m, clean.pose.translation_m, atol=0.001)


def test_a_pose_that_states_nothing_is_refused_and_one_without_covariance_is_not() -> None:
    pose, traffic, _ = draw(SMALL, 0)
    without = replace(pose, covariance=None, camera=replace(pose.camera, covariance=None))
    assert adjust(without, traffic).used > 0
    with pytest.raises(BadInput):
        adjust(replace(without, board=None), traffic)


def test_a_pass_that_cannot_be_used_says_why() -> None:
    pose, traffic, _ = draw(SMALL, 1)
    first = traffic[0]
    roof = first.point == 2
    roof_alone = replace(
        first,
        frame=first.frame[roof],
        point=first.point[roof],
        points_px=first.points_px[roof],
        sigma_px=first.sigma_px[roof],
    )
    outside = np.array(first.points_px)
    outside[0, 0] = -40.0
    sky = np.array(first.points_px)
    sky[first.point == REAR, 1] = 2.0
    odd = [
        replace(roof_alone, name="a"),
        replace(first, name="b", points_px=outside),
        replace(first, name="c", points_px=sky),
        replace(first, name="d", wheelbase=Known(-1.0, 0.01)),
        replace(first, name="e", sigma_px=np.full(len(first.frame), 1e-300)),
        replace(first, name="f", frame=np.zeros(len(first.frame), dtype=np.int64)),
    ]
    found = adjust(pose, [*traffic, *odd])
    assert found.used == 6
    assert [one.name for one in found.left_out] == list("abcdef")
    assert len({one.reason for one in found.left_out}) == 6


@given(seed=st.integers(0, 10**6), order=st.randoms(use_true_random=False))
@settings(max_examples=8, deadline=None)
def test_the_order_of_passes_and_rows_does_not_matter(seed, order) -> None:  # type: ignore[no-untyped-def]
    pose, traffic, _ = draw(SMALL, seed)
    shuffled = []
    for one in traffic:
        rows = list(range(len(one.frame)))
        order.shuffle(rows)
        shuffled.append(
            ObservedPass(
                one.name,
                one.frame[rows],
                one.point[rows],
                one.points_px[rows],
                one.sigma_px[rows],
                *one.lengths,
            )
        )
    order.shuffle(shuffled)
    first, second = adjust(pose, traffic), adjust(pose, shuffled)
    assert first.chi2 == pytest.approx(second.chi2, rel=1e-6)
    assert np.allclose(first.pose.translation_m, second.pose.translation_m, atol=1e-7)


@given(seed=st.integers(0, 10**6))
@settings(max_examples=10, deadline=None)
def test_derivatives_are_those_of_the_residuals(seed) -> None:  # type: ignore[no-untyped-def]
    pose, traffic, _ = draw(replace(SMALL, vehicles=2), seed)
    shared = shared_errors(pose, 0.005, 0.005, shared_insets(traffic))
    table = arrange_passes(pose, traffic)
    rng = np.random.default_rng(seed)
    z, unknown = rng.normal(0, 1, shared.size), table.start + rng.normal(0, 0.01, table.start.shape)
    weights = np.ones(len(table.owner)), np.ones((2, 3))
    at = linearise(shared, table, z, unknown, *weights)
    way, own_way = rng.normal(0, 1, z.shape), rng.normal(0, 1, unknown.shape)
    step = 1e-5
    ends = [
        linearise(shared, table, z + s * way, unknown + s * own_way, *weights).residual for s in (step, -step)
    ]
    wanted = -(at.shared @ way + np.einsum("prk,pk->pr", at.own, own_way))
    slope = (ends[0] - ends[1]) / (2 * step)
    assert np.abs(slope - wanted).max() < 1e-3 * np.abs(wanted).max()


def test_a_covariance_is_carried_to_the_moved_pose() -> None:
    pose, _, _ = draw(SMALL, 0)
    rng = np.random.default_rng(3)
    size = len(pose.parameters)
    increments = np.concatenate([np.zeros(size - 6), rng.normal(0, 0.05, 6)])
    carried = covariance_at(pose, increments, np.diag(np.r_[np.zeros(size - 6), np.full(6, 1e-12)]))
    from_new = moved_pose(pose, increments)
    draws = rng.normal(0, 1e-6, (4000, 6))
    seen = np.array(
        [_between(from_new, moved_pose(pose, increments + np.r_[np.zeros(size - 6), d])) for d in draws]
    )
    assert np.allclose(np.cov(seen.T), carried[-6:, -6:], atol=0.12e-12)


def _between(old: RoadPose, new: RoadPose) -> np.ndarray:
    """The increments that carry the old pose to the new one, to first order."""
    turn = new.rotation @ old.rotation.T
    r = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / 2
    return np.concatenate([r, new.translation_m - turn @ old.translation_m])


def test_the_mean_direction_is_as_unsure_as_the_passes_scatter() -> None:
    """Of 12 passes, each known to 0.05 degrees, that differ by 1.5: 0.09 degrees was told for 0.43."""
    rng, u = np.random.default_rng(5), np.deg2rad(0.05)
    off = []
    for _ in range(200):
        unknown, own = np.zeros((12, 8)), np.zeros((12, 8, 8))
        unknown[:, HEADING], own[:, HEADING, HEADING] = rng.normal(0, np.deg2rad(1.5), 12), u**2
        at = SimpleNamespace(own=np.zeros((12, 3, 8)), shared=np.zeros((12, 3, 2)))
        solution = SimpleNamespace(unknown=unknown, pass_covariance=own, at=at, covariance=np.eye(2))
        mean, u_mean = _heading(cast(Cleaned, SimpleNamespace(solution=solution)), np.ones(12, dtype=bool))
        off.append(mean / u_mean)
    assert np.sqrt(np.mean(np.square(off))) == pytest.approx(1.1, abs=0.15)
