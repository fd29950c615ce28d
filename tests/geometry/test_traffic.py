"""What a second frame gains, and what traffic says of a pose and of insets."""

import dataclasses

import numpy as np
import pytest

from backend.geometry.gain import best_second_frame, second_frame_gain
from backend.geometry.height import measure_height
from backend.geometry.multiframe import measure_frames
from backend.geometry.traffic import headings, inset_from_known_heights, turned
from tests.geometry.scenes import pose_of
from tests.geometry.simulate import Lens, Scene

SCENE = Scene(Lens(), (0.0, -3.0, 1.5), 0.0, 4.0)


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
    best = best_second_frame(pose, first[0], first[1], [0.01, 0.4, 1.8, 30.0], 1.0, 0.45, 0.1)
    assert best is not None and best[0] == 2
    assert second_frame_gain(pose, first[0], first[1], 30.0) is None
    assert second_frame_gain(pose, (3, 3), (2, 2), 1.0) is None


def test_headings_find_a_turned_board() -> None:
    turn = 0.02
    rng = np.random.default_rng(1)
    fronts, rears = [], []
    for _ in range(12):
        x, y = rng.uniform(-1.5, -1.0), rng.uniform(0, 1.5)
        fronts.append((x, y, 0.0))
        rears.append((x + 2.6 * np.cos(turn), y + 2.6 * np.sin(turn), 0.0))
    pose = pose_of(dataclasses.replace(SCENE, pitch=10.0))
    scene = dataclasses.replace(SCENE, pitch=10.0)
    a = scene.look(fronts) + rng.normal(0, 0.5, (12, 2))
    b = scene.look(rears) + rng.normal(0, 0.5, (12, 2))
    found = headings(pose, a, b)
    assert not isinstance(found, str)
    assert found.mean_rad == pytest.approx(turn, abs=4 * found.u_mean_rad)
    assert found.proposed and 0 < found.u_mean_rad < 0.01
    corrected = headings(turned(pose, found.mean_rad), a, b)
    assert not isinstance(corrected, str)
    assert abs(corrected.mean_rad) < 1e-6 and not corrected.proposed
    clicks = scene.look([fronts[0], (fronts[0][0] + 0.3, fronts[0][1], 1.2)])
    before, after = (measure_height(p, clicks[0], clicks[1]).height_m for p in (pose, turned(pose, turn)))
    assert before is not None and after is not None and abs(after - before) < 0.004
    assert isinstance(headings(pose, a[:2], b[:2]), str)
    assert isinstance(headings(pose, a, a), str)


def test_inset_from_roofs_of_known_height() -> None:
    rng = np.random.default_rng(2)
    n, inset, camera = 300, 0.4, 1.2
    known = rng.uniform(1.4, 2.0, n)
    distance = rng.uniform(2.0, 5.0, n)
    measured = camera + (known - camera) * distance / (distance + inset) + rng.normal(0, 0.007, n)
    found = inset_from_known_heights(camera, distance, measured, known)
    assert not isinstance(found, str)
    assert found.inset_m == pytest.approx(inset, abs=4 * found.u_inset_m + 0.01)
    assert found.u_inset_m < 0.02 and found.vehicles == n
    assert isinstance(inset_from_known_heights(1.2, [3.0], [1.5], [1.6]), str)
    assert isinstance(inset_from_known_heights(1.2, [3.0] * 5, [1.2] * 5, [1.2] * 5), str)
