"""Overlays: bent as the lens bends, cut at the picture's border and at the valid radius."""

import numpy as np
import pytest

from sightline.geometry.road import axes_at_contact, iso_heights, ladder_at_contact, road_grid, road_point
from sightline.messages.said import Said
from tests.geometry.scenes import LENSES, pose_of
from tests.geometry.simulate import Lens, Scene

CONTACT = (0.6, 0.2, 0.0)


def scene_of(lens: Lens) -> Scene:
    return Scene(lens, (0.3, -3.0, 1.5), 10.0, 8.0, 2.0)


def distance_to(line: np.ndarray, points: np.ndarray) -> float:
    """Largest distance of points from a polyline."""
    start, chord = line[:-1], np.diff(line, axis=0)
    share = ((points[:, None] - start) * chord).sum(axis=2) / np.square(chord).sum(axis=1)
    nearest = start + np.clip(share, 0, 1)[..., None] * chord
    return float(np.linalg.norm(points[:, None] - nearest, axis=2).min(axis=1).max())


@pytest.mark.parametrize("lens", LENSES)
def test_axes_follow_the_lens(lens: Lens) -> None:
    scene = scene_of(lens)
    pose = pose_of(scene)
    click = scene.look([CONTACT])[0]
    overlay = axes_at_contact(pose, click)
    assert not isinstance(overlay, Said)
    assert overlay.contact_m == pytest.approx(CONTACT, abs=1e-9)
    assert overlay.origin_px == pytest.approx(click)
    steps = (0.1, 0, 0), (0, 0, 0.1), (0, 0.1, 0)
    for line, step in zip((overlay.longitudinal, overlay.vertical, overlay.transversal), steps, strict=True):
        points = scene.look([np.array(CONTACT) + k * np.array(step) for k in range(0, 12)])
        shown = points[pose.camera.inside(points)]
        assert distance_to(line, shown) < 0.1
        assert pose.camera.inside(line).all()


def test_rungs_lie_at_their_heights() -> None:
    scene = scene_of(Lens())
    click = scene.look([CONTACT])[0]
    rungs = ladder_at_contact(pose_of(scene), click, inset_m=0.45)
    assert not isinstance(rungs, Said)
    for rung in rungs:
        middle = scene.look([(CONTACT[0], CONTACT[1] + 0.45, rung.height_m)])
        assert distance_to(rung.polyline_px, middle) < 0.1
        assert rung.label == (round(rung.height_m * 10) % 5 == 0)
    heights = [r.height_m for r in rungs]
    assert heights == sorted(heights) and heights[0] == 0.1


def test_no_line_folds_back_into_the_picture() -> None:
    """A polynomial lens maps far points back inside; such lines must end at the valid radius."""
    lens = Lens(f=300.0, k=(-0.42, 0.22, 0.0, 0.0, -0.06))
    pose = pose_of(Scene(lens, (0.0, -2.0, 1.5), 0.0, 10.0))
    for line in road_grid(pose, half_length_m=40.0):
        turns = np.diff(np.unwrap(np.arctan2(*np.diff(line, axis=0).T)))
        assert pose.camera.inside(line).all()
        assert np.abs(turns).max(initial=0.0) < 1.0


def test_grid_and_iso_heights() -> None:
    scene = scene_of(Lens())
    pose = pose_of(scene)
    assert len(road_grid(pose)) > 10
    levels = iso_heights(pose, 3.0)
    assert [h for h, _ in levels] == [0.5, 1.0, 1.5, 2.0]
    for height, line in levels:
        points = scene.look([(x, 0.0, height) for x in np.linspace(-1, 2, 10)])
        assert distance_to(line, points[pose.camera.inside(points)]) < 0.1


@pytest.mark.parametrize(
    ("click", "words"), [((320, 20), "horizon"), ((-5, 300), "outside"), ((np.nan, 3), "finite")]
)
def test_reasons(click, words) -> None:
    pose = pose_of(scene_of(Lens()))
    for answer in (road_point(pose, click), axes_at_contact(pose, click), ladder_at_contact(pose, click)):
        assert isinstance(answer, Said) and words in str(answer)
