"""Points followed through drawn passes: where they are, how sure that is, what is dropped and why."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from sightline.geometry.follow_pass import LOST, UNLIKE, PassFrame, follow_pass
from sightline.geometry.followed_tracks import CONTACT, SECOND, TARGET
from sightline.geometry.whole_pass import measure_pass
from sightline.messages.said import Said
from tests.bench.bench_whole_pass_pictures import begun_on
from tests.bench.surveys import pose_of
from tests.simulation import day_scene, render_frame, truth

SCENE = day_scene()
POSE = pose_of(SCENE)
NAMES = {CONTACT: "contact_rear", SECOND: "contact_front", TARGET: "driver_eye"}


@pytest.fixture(scope="module")
def drawn():
    """The sixth vehicle: truth, the frame that is confirmed, and every frame of its pass in gray."""
    true = truth(SCENE)[5]
    first = begun_on(SCENE, true, "driver_eye")
    assert first is not None and {"contact_rear", "contact_front"} <= set(first.pixels)
    span = range(true.frames[0].frame, true.frames[-1].frame + 1)
    grays = [cv2.cvtColor(render_frame(SCENE, n), cv2.COLOR_BGR2GRAY) for n in span]
    frames = [PassFrame(n, n / SCENE.fps, gray) for n, gray in zip(span, grays, strict=True)]
    return true, first, frames


def points_of(first):
    return {point: first.pixels[name] for point, name in NAMES.items()}


@pytest.fixture(scope="module")
def found(drawn):
    _, first, frames = drawn
    got = follow_pass(POSE, frames, first.frame, points_of(first), "driver_eye", 0.5, 0.0)
    assert not isinstance(got, Said), got
    return got


def off_px(true, tracks):
    seen = {one.frame: one.pixels for one in true.frames}
    return np.array(
        [
            at - np.array(seen[int(n)][NAMES[int(point)]])
            for n, point, at in zip(tracks.frame, tracks.point, tracks.points_px, strict=True)
            if NAMES[int(point)] in seen.get(int(n), {})
        ]
    )


def test_points_are_followed_to_where_they_are(drawn, found) -> None:
    true, _, _ = drawn
    for point, least in ((CONTACT, 12), (SECOND, 12), (TARGET, 12)):
        assert (found.tracks.point == point).sum() >= least
    off = off_px(true, found.tracks)
    assert np.median(np.abs(off)) < 0.15 and np.percentile(np.abs(off), 90) < 0.7


def test_times_that_a_file_rounded_are_said_to_be_uncertain(drawn) -> None:
    _, first, frames = drawn
    near = [one for one in frames if abs(one.frame - first.frame) < 6]
    rounded = [replace(one, time_s=round(one.time_s * SCENE.fps / 29.97, 3), tick_s=1e-3) for one in near]
    got = follow_pass(POSE, rounded, first.frame, points_of(first), "driver_eye", 0.5, 0.0)
    assert not isinstance(got, Said), got
    assert got.following.u_time_s == pytest.approx(1e-3 / np.sqrt(12.0))


def test_the_height_of_the_whole_pass_is_true(drawn, found) -> None:
    true, _, _ = drawn
    fit = measure_pass(POSE, found.tracks, found.following)
    spot = true.spot("driver_eye")
    assert fit.height.height_m is not None and fit.inset_m is not None and fit.wheelbase_m is not None
    assert fit.height.height_m == pytest.approx(spot.height_m, abs=0.004)
    assert fit.inset_m.value == pytest.approx(spot.inset_m, abs=0.05)
    assert fit.wheelbase_m.value == pytest.approx(true.vehicle.model.wheelbase_m, abs=0.01)
    assert abs(abs(fit.speed_mps.value) - true.vehicle.speed_mps) < 0.05


def test_the_point_stays_where_it_was_confirmed(drawn, found) -> None:
    _, first, _ = drawn
    at = found.tracks.points_px[(found.tracks.frame == first.frame) & (found.tracks.point == TARGET)]
    assert at[0] == pytest.approx(first.pixels["driver_eye"], abs=1e-6)
    assert found.following.begun_on == first.frame


def test_a_frame_where_something_stands_before_the_point_is_dropped_with_its_reason(drawn) -> None:
    _, first, frames = drawn
    n = first.frame + 2
    covered = [
        replace(one, gray=cv2.rectangle(one.gray.copy(), (0, 0), (639, 300), 90, -1))
        if one.frame == n
        else one
        for one in frames
    ]
    got = follow_pass(POSE, covered, first.frame, points_of(first), "driver_eye", 0.5)
    assert not isinstance(got, Said)
    reasons = {one.reason for one in got.lost if (one.frame, one.point) == (n, "target")}
    assert reasons & {UNLIKE, LOST}, reasons
    assert not ((got.tracks.frame == n) & (got.tracks.point == TARGET)).any()
    assert ((got.tracks.frame == n + 1) & (got.tracks.point == TARGET)).any()


def test_what_left_the_picture_says_so_and_every_frame_is_accounted_for(drawn, found) -> None:
    _, _, frames = drawn
    assert any("left the frame" in str(one.reason) for one in found.lost)
    told = {(one.frame, one.point) for one in found.lost}
    kept = {
        (int(n), ("contact", "second_contact", "target")[int(point)])
        for n, point in zip(found.tracks.frame, found.tracks.point, strict=True)
    }
    assert not told & kept
    assert told | kept == {(f.frame, p) for f in frames for p in ("contact", "second_contact", "target")}


def test_more_noise_gives_a_larger_uncertainty(drawn, found) -> None:
    _, first, frames = drawn
    rng = np.random.default_rng(3)
    noisy = [
        replace(one, gray=np.clip(one.gray + rng.normal(0, 12, one.gray.shape), 0, 255).astype(np.uint8))
        for one in frames
    ]
    got = follow_pass(POSE, noisy, first.frame, points_of(first), "driver_eye", 0.5)
    assert not isinstance(got, Said)
    for point in (CONTACT, SECOND):
        before = np.median(found.tracks.sigma_px[found.tracks.point == point])
        assert np.median(got.tracks.sigma_px[got.tracks.point == point]) > 1.5 * before


def test_what_cannot_be_followed_says_why(drawn) -> None:
    _, first, frames = drawn
    points = points_of(first)
    other = follow_pass(POSE, frames, 10**6, points, "driver_eye", 0.5)
    assert other == Said("follow-frame-not-of-pass")
    alone = follow_pass(POSE, frames, first.frame, {CONTACT: points[CONTACT]}, "driver_eye", 0.5)
    assert alone == Said("follow-points-needed")
    roof = follow_pass(POSE, frames, first.frame, points, "roof", 0.3)
    assert roof == Said("follow-outline")
    still = [PassFrame(one.frame, one.time_s, frames[0].gray * 0 + 90) for one in frames]
    lost = follow_pass(POSE, still, first.frame, points, "driver_eye", 0.5)
    assert lost == Said("follow-not-from-here")
