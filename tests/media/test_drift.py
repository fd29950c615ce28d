"""The background found again: known shifts and turns of drawn frames, and a camera that stands still."""

from functools import lru_cache

import cv2
import numpy as np
import pytest

from sightline.geometry.drift import Motion
from sightline.geometry.drift_spans import Look, course, floor_px
from sightline.media.video.drift import background, mean_of, register
from sightline.messages.said import Said
from tests.simulation.render import render_frame
from tests.simulation.scene import day_scene, low_light_scene

SIZE = (640, 480)
SHAKES = [
    (0.12, -0.16, 0.0),
    (-1.8, 2.4, 0.0),
    (0.0, 0.0, 0.05),
    *(pytest.param(x, 0.0, 0.0, marks=pytest.mark.proof) for x in (0.2, 1.0)),
]


@lru_cache(maxsize=32)
def frame(light: str, n: int) -> np.ndarray:
    scene = day_scene() if light == "day" else low_light_scene()
    return np.asarray(cv2.cvtColor(render_frame(scene, n), cv2.COLOR_BGR2GRAY), np.uint8)


@lru_cache(maxsize=2)
def of_pose(light: str):  # type: ignore[no-untyped-def]
    """Frames with the board in them; later ones show vehicles instead."""
    return background(mean_of([frame(light, n) for n in (0, 30, 60, 90)]))


def shaken(picture: np.ndarray, x: float, y: float, turn_deg: float, noise: float, seed: int) -> np.ndarray:
    """Shifted in the frequency domain (no interpolation), turned at four times the size."""
    image = picture.astype(np.float64)
    if turn_deg:
        large = cv2.resize(image, None, fx=4, fy=4, interpolation=cv2.INTER_CUBIC)
        middle = ((large.shape[1] - 1) / 2, (large.shape[0] - 1) / 2)
        matrix = cv2.getRotationMatrix2D(middle, -turn_deg, 1.0)
        large = cv2.warpAffine(
            large, matrix, large.shape[::-1], flags=cv2.INTER_CUBIC, borderMode=cv2.BORDER_REFLECT
        )
        image = cv2.resize(large, SIZE, interpolation=cv2.INTER_AREA)
    padded = np.pad(image, 32, mode="reflect")
    fy, fx = np.fft.fftfreq(padded.shape[0])[:, None], np.fft.fftfreq(padded.shape[1])[None]
    moved = np.fft.ifft2(np.fft.fft2(padded) * np.exp(-2j * np.pi * (fx * x + fy * y))).real[32:-32, 32:-32]
    moved = moved + np.random.default_rng(seed).normal(0.0, noise, moved.shape)
    return np.clip(np.round(moved), 0, 255).astype(np.uint8)


@pytest.mark.parametrize(("x", "y", "turn_deg"), SHAKES)
def test_a_known_shake_by_day_is_recovered(x: float, y: float, turn_deg: float) -> None:
    found = register(of_pose("day"), shaken(frame("day", 420), x, y, turn_deg, 2.2, 5))
    assert isinstance(found, Motion), found
    assert np.hypot(found.x_px - x, found.y_px - y) < 0.05
    # a twentieth of a pixel at the picture's corner, 400 px from its centre
    assert abs(found.turn_rad - np.deg2rad(turn_deg)) * 400 < 0.05
    assert found.moved_px > floor_px(found.u_px)


def test_in_low_light_the_floor_is_larger_and_a_pixel_is_still_seen() -> None:
    day = register(of_pose("day"), frame("day", 420))
    low = register(of_pose("low_light"), shaken(frame("low_light", 420), 0.6, -0.8, 0.0, 3.0, 1))
    assert isinstance(day, Motion) and isinstance(low, Motion)
    assert low.u_px > 2 * day.u_px
    assert np.hypot(low.x_px - 0.6, low.y_px + 0.8) < 4 * low.u_px < 0.4


@pytest.mark.parametrize("seeds", [3, pytest.param(10, marks=pytest.mark.proof)])
@pytest.mark.parametrize("light", ["day", "low_light"])
def test_a_still_camera_is_never_said_to_have_moved(light: str, seeds: int) -> None:
    for seed in range(seeds):
        shown = frame(light, (150, 420, 560)[seed % 3])
        found = register(of_pose(light), shaken(shown, 0.0, 0.0, 0.0, 2.0 if light == "day" else 4.0, seed))
        assert isinstance(found, Motion), found
        assert found.moved_px < floor_px(found.u_px), (seed, found)


def test_what_shows_no_background_gives_a_reason_and_no_motion() -> None:
    rng = np.random.default_rng(3)
    dark = rng.normal(4.0, 2.0, SIZE[::-1]).clip(0, 255).astype(np.uint8)
    other = cv2.flip(frame("day", 150), 1)
    for picture in (dark, other, np.zeros(SIZE[::-1], np.uint8)):
        found = register(of_pose("day"), picture)
        assert isinstance(found, Said) and found.code == "drift-few-points"
    assert isinstance(register(background(np.zeros(SIZE[::-1], np.uint8)), frame("day", 150)), Said)


def test_bumps_are_found_to_the_frame_in_pictures() -> None:
    """Frame 157 of a clip of 200 jumps by half a pixel; from 180 on the camera is back."""
    seen: list[int] = []

    def look(n: int) -> Motion | str:
        seen.append(n)
        off = (0.3, -0.4) if 157 <= n < 180 else (0.0, 0.0)
        return register(of_pose("day"), shaken(frame("day", 150 + n % 2), *off, 0.0, 2.0, n))

    found = course([Look(n, look(n)) for n in range(0, 200, 12)], 199, SIZE, look)
    assert [(bump.after, bump.frame) for bump in found.bumps] == [(156, 157), (179, 180)]
    assert [(one.first_frame, one.last_frame, one.moved) for one in found.spans] == [
        (0, 156, False),
        (157, 179, True),
        (180, 199, False),
    ]
    assert found.spans[1].motion.moved_px == pytest.approx(0.5, abs=0.05)
    assert found.floor_px == pytest.approx(0.05, abs=0.02)
    assert len(seen) < 40
