"""The error of a height by a camera that moved, at its own clicks, against an independent camera."""

from dataclasses import replace

import numpy as np
import pytest

from sightline.geometry.drift import Motion, fit_motion
from sightline.geometry.followed_tracks import Following, Tracks
from sightline.measurements.followed_text import text_of
from sightline.measurements.height_of_clicks import answer
from sightline.measurements.moved import drift_flags, errors_of_motion
from sightline.measurements.records import ClickedFrame, Clicks
from sightline.recordings.drift import MovedSpan
from tests.geometry.passing import CONTACT, TARGET, Drawn, frames_of, look
from tests.geometry.scenes import pose_of
from tests.geometry.simulate import Lens, Scene

NARROW = Lens(f=1000.0, k=(-0.05, 0.0, 0.0, 0.0, 0.0))
STOOD = Scene(NARROW, (0.0, -3.0, 1.5), 0.0, 5.0, 0.3)
TURNS = ({"pitch": 0.03}, {"roll": 0.06}, {"pitch": -0.02, "yaw": 0.05, "roll": 0.04})
HEIGHT_M = 1.2


def turned(scene: Scene, turn: dict[str, float]) -> Scene:
    return replace(scene, **{name: getattr(scene, name) + by for name, by in turn.items()})


def told(scene: Scene, now: Scene, first: int = 0, last: int = 9) -> MovedSpan:
    """What a far background tells of the camera's motion."""
    size = (scene.lens.width, scene.lens.height)
    drawn = np.random.default_rng(4).uniform((-0.3, -0.22, 0.9), (0.3, 0.22, 1.1), (1500, 3))
    far = 90.0 * drawn @ scene.axes() + scene.eye
    found = fit_motion(scene.look(far), now.look(far), size)
    assert isinstance(found, Motion)
    motion = (found.x_px, found.y_px, found.turn_rad, found.scale)
    return MovedSpan(first, last, found.moved_px, None, None, *motion)


def clicked(scene: Scene, away_m: float, x_m: float = 0.0) -> Clicks:
    y = scene.eye[1] + away_m
    (contact, target) = scene.look([(x_m, y, 0.0), (x_m + 0.3, y, HEIGHT_M)]).tolist()
    return Clicks(
        target="roof",
        contact=tuple(contact),
        target_point=tuple(target),
        sigma_px=0.5,
        inset_m=0.0,
        u_inset_m=0.0,
    )


@pytest.mark.parametrize("lens", [NARROW, Lens()])
@pytest.mark.parametrize("away_m", [6.0, 12.0, 20.0])
@pytest.mark.parametrize("turn", TURNS)
def test_the_error_told_is_that_of_the_simulated_camera_at_each_distance(
    lens: Lens, away_m: float, turn: dict[str, float]
) -> None:
    scene = replace(STOOD, lens=lens)
    now, pose = turned(scene, turn), pose_of(scene)
    span = told(scene, now)
    clicks = clicked(now, away_m, 0.05 * away_m)
    measured_m = answer(pose, clicks).height_m
    assert measured_m is not None
    error_m = errors_of_motion(pose, [clicks], [span])[0]
    assert error_m == pytest.approx(measured_m - HEIGHT_M, rel=0.03)
    assert abs(error_m or 0.0) > 0.0005
    flag = drift_flags(pose, [clicks], [span])[0]
    assert flag is not None and flag.values["error_m"] == pytest.approx(abs(measured_m - HEIGHT_M), abs=0.001)


def test_it_is_not_as_the_distance_where_the_camera_is_above_the_target() -> None:
    """Own derivation: a pitch by dp gives dp h (D / C - (C - h) / D), D across, C the camera's height."""
    for away_m, pitch in ((6.0, 36.0), (12.0, 20.0)):
        scene = Scene(replace(NARROW, f=2000.0), (0.0, -3.0, 5.0), 0.0, pitch)
        now = turned(scene, TURNS[0])
        expected_m = np.deg2rad(0.03) * HEIGHT_M * (away_m / 5.0 - (5.0 - HEIGHT_M) / away_m)
        error_m = errors_of_motion(pose_of(scene), [clicked(now, away_m)], [told(scene, now)])[0]
        assert error_m == pytest.approx(expected_m, rel=0.03)


@pytest.mark.parametrize("solved", ["frames", "pass"])
def test_a_height_of_several_frames_has_each_frames_own_motion_undone(solved: str) -> None:
    """The camera moved between the frames: only what was clicked and followed after that goes back."""
    scene = replace(STOOD, eye=(0.0, -6.4, 1.5))
    now, pose, car = turned(scene, TURNS[0]), pose_of(scene), Drawn(x=0.2, speed=6.0, inset=0.4)
    frame, point, t = frames_of(scene, car, (CONTACT, TARGET))
    both = [n for n in np.unique(frame) if (frame == n).sum() == 2]
    kept = np.isin(frame, both)
    frame, point, t = frame[kept] - both[0], point[kept], t[kept]
    stood, moved = look(scene, car, point, t), look(now, car, point, t)
    last = len(both) - 1
    span = told(scene, now, last // 2, last)
    seen = np.where((frame >= last // 2)[:, None], moved, stood)

    def clicks(pixels: np.ndarray) -> Clicks:
        one = clicked(scene, 6.4)
        tracks = Tracks(frame, t, point, pixels, np.full(len(frame), 0.2))
        first, *more = (
            ClickedFrame(frame=n, contact=tuple(c), target_point=tuple(p))
            for n in (0, last)
            for c, p in [pixels[frame == n].tolist()]
        )
        return replace(
            one,
            frame=0,
            inset_m=None,
            contact=first.contact,
            target_point=first.target_point,
            more_frames=tuple(more) if solved == "frames" else (),
            followed=text_of(tracks, Following(begun_on=0)) if solved == "pass" else None,
        )

    true_m, measured_m = answer(pose, clicks(stood)).height_m, answer(pose, clicks(seen)).height_m
    error_m = errors_of_motion(pose, [clicks(seen)], [span])[0]
    assert true_m is not None and measured_m is not None
    assert error_m == pytest.approx(measured_m - true_m, rel=0.03)
    assert abs(error_m or 0.0) > 0.0005


def test_errors_told_together_are_those_of_each_alone() -> None:
    """Of heights of two clicks, of several frames, without an inset, and where there is no height."""
    now, pose = turned(STOOD, TURNS[0]), pose_of(STOOD)
    span = told(STOOD, now)
    near, far = clicked(now, 6.0), clicked(now, 15.0)
    further = ClickedFrame(frame=7, contact=far.contact, target_point=far.target_point)
    solved = replace(near, inset_m=None, u_inset_m=None, more_frames=(further,))
    in_the_sky = replace(near, contact=(960.0, 2.0), target_point=(960.0, 1.0))
    every = [near, solved, replace(near, inset_m=None, u_inset_m=None), in_the_sky, far]
    alone = [error for one in every for error in errors_of_motion(pose, [one], [span])]
    together = errors_of_motion(pose, every, [span])
    assert [error is None for error in together] == [error is None for error in alone]
    assert [error is None for error in together] == [False, False, True, True, False]
    for of_all, of_one in zip(together, alone, strict=True):
        assert (of_all or 0.0) == pytest.approx(of_one or 0.0, rel=1e-9)
