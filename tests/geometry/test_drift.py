"""What a moved picture does to a height, and the course of a recording, against a simulation."""

from dataclasses import replace

import numpy as np
import pytest

from sightline.geometry.drift import Motion, displacement_px, fit_motion, height_change
from sightline.geometry.drift_spans import Look, course
from sightline.geometry.height import measure_height
from sightline.messages.said import Said
from tests.geometry.scenes import pose_of
from tests.geometry.simulate import Lens, Scene

SIZE = (640, 480)


def motion(x: float = 0.0, y: float = 0.0, turn: float = 0.0, u: float = 0.01) -> Motion:
    return Motion(x, y, turn, 1.0, displacement_px(np.array([x, y, 0.0, turn]), SIZE), u, 100)


def test_the_fit_ignores_a_third_of_foreign_points_and_knows_its_uncertainty() -> None:
    ratios, errors = [], []
    for seed in range(60):
        rng = np.random.default_rng(seed)
        before = rng.uniform((0, 0), SIZE, (150, 2))
        true = motion(*rng.uniform(-3, 3, 2), rng.normal(0, 2e-3))
        after = true.move(before, SIZE) + rng.normal(0, 0.1, before.shape)
        after[:50] += rng.uniform((-6, -12), (18, 12), (50, 2))
        found = fit_motion(before, after, SIZE)
        assert isinstance(found, Motion)
        off = np.array(
            [found.x_px - true.x_px, found.y_px - true.y_px, found.scale - 1, found.turn_rad - true.turn_rad]
        )
        errors.append(displacement_px(off, SIZE))
        ratios.append(errors[-1] / found.u_px)
    assert max(errors) < 0.07
    # root mean square of the error over its stated uncertainty: 1 if that is right
    assert 0.6 < float(np.sqrt(np.mean(np.square(ratios)))) < 1.5


def test_too_few_points_or_one_corner_of_the_picture_tell_nothing() -> None:
    rng = np.random.default_rng(1)
    corner = rng.uniform((0, 0), (90, 90), (60, 2))
    assert "one part" in str(fit_motion(corner, corner + 1.0, SIZE))
    assert "Only 5" in str(fit_motion(corner[:5], corner[:5], SIZE))


@pytest.mark.parametrize("lens", [Lens(), Lens(k=(0.0, 0.0, 0.0, 0.0, 0.0))])
@pytest.mark.parametrize("turn", [{"pitch": 0.1}, {"roll": 0.1}, {"yaw": 0.05, "pitch": -0.05}])
def test_the_change_of_height_is_that_of_a_simulated_camera_that_turned(
    lens: Lens, turn: dict[str, float]
) -> None:
    scene = Scene(lens=lens)
    now = replace(scene, **{name: getattr(scene, name) + by for name, by in turn.items()})
    far = np.random.default_rng(4).uniform((-30, 40, -10), (30, 60, 20), (300, 3))
    before = scene.look(far)
    seen = (before > 0).all(axis=1) & (before < SIZE).all(axis=1)
    moved = fit_motion(before[seen], now.look(far[seen]), SIZE)
    assert isinstance(moved, Motion)
    pose = pose_of(scene)
    found = height_change(pose, moved)
    assert found.distance_m == 3.0 and found.change_m is not None
    worst = 0.0
    for x in np.linspace(-1.7, 1.7, 41):
        contact, target = now.look([(x, 0.0, 0.0), (x, 0.0, 1.2)])
        height = measure_height(pose, contact, target).height_m
        if height is not None and abs(height - 1.2) > abs(worst):
            worst = height - 1.2
    assert found.change_m == pytest.approx(worst, rel=0.3)
    assert abs(worst) > 0.0005


def course_of(moves: dict[int, Motion | str], last: int, every: int):  # type: ignore[no-untyped-def]
    return course(
        [Look(n, moves[n]) for n in range(0, last + 1, every)], last, SIZE, lambda n: moves.get(n, "none")
    )


def test_one_frame_that_jumps_is_no_bump_and_a_slow_creep_is_told() -> None:
    rng = np.random.default_rng(7)
    still = {n: motion(*rng.normal(0, 0.008, 2)) for n in range(301)}
    jumped = {**still, 100: motion(3.0, 0.0)}
    found = course_of(jumped, 300, 10)
    assert found.bumps == () and [span.moved for span in found.spans] == [False]

    crept = {n: motion(0.3 * n / 300, rng.normal(0, 0.008)) for n in range(301)}
    slow = course_of(crept, 300, 10)
    assert slow.bumps == ()
    assert [span.moved for span in slow.spans] == [False, True]
    assert 40 <= slow.spans[1].first_frame <= 80 and slow.spans[1].motion.moved_px > 0.25


def test_covered_frames_beside_a_bump_count_as_moved() -> None:
    moves: dict[int, Motion | str] = {n: motion(2.0 if n >= 50 else 0.0) for n in range(101)}
    moves |= {n: "covered" for n in range(46, 55)}
    found = course_of(moves, 100, 20)
    assert [(bump.after, bump.frame) for bump in found.bumps] == [(45, 55)]
    assert [(span.first_frame, span.last_frame, span.moved) for span in found.spans] == [
        (0, 45, False),
        (46, 100, True),
    ]


def test_without_motions_there_is_the_commonest_reason() -> None:
    dark = dict.fromkeys(range(101), Said("drift-few-points", count=3))
    found = course_of({**dark, 0: Said("drift-other-size")}, 100, 10)
    assert found.reason == dark[1] and found.spans == () and found.floor_px is None
