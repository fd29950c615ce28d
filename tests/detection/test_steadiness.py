"""A camera that stands, one that is held by hand, and one that is carried away."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import cv2
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sightline.detection.steadiness import (
    Steadiness,
    corners_by_cell,
    map_back,
    shared_motion,
    warp_onto_first,
)
from sightline.media.video.passes import PassSearch, find_passes
from sightline.media.video.writer import write_mp4
from tests.media.street import HEIGHT, WIDTH, car, street, texture

CARS = [car(15), car(55, right=False, near=False, grey=40)]
ROOM = 40


def scenery(width: int = WIDTH + 2 * ROOM, height: int = HEIGHT + 2 * ROOM) -> np.ndarray:
    """A picture with detail of all sizes, larger than the view by ROOM on each side."""
    return texture(width, height, 3)


def view(picture: np.ndarray, dx: float, dy: float) -> np.ndarray:
    """What a camera sees that looks dx to the right and dy down, pixels."""
    matrix = np.array([[1.0, 0.0, ROOM + dx], [0.0, 1.0, ROOM + dy]])
    seen = cv2.warpAffine(picture, matrix, (WIDTH, HEIGHT), flags=cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP)
    return np.clip(seen, 0, 255).astype(np.uint8)


@given(dx=st.floats(-30, 30), dy=st.floats(-30, 30))
@settings(max_examples=15, deadline=None)
def test_a_shift_is_found_and_undone(dx: float, dy: float) -> None:
    picture = scenery()
    first, moved = view(picture, 0, 0), view(picture, dx, dy)
    found = shared_motion(first, moved, corners_by_cell(first))
    assert found is not None
    wanted = np.array([dx, dy]) / WIDTH if np.hypot(dx, dy) >= 0.35 else np.zeros(2)
    assert found.transform[:, 2] == pytest.approx(wanted, abs=0.3 / WIDTH)
    middle = slice(ROOM, -ROOM), slice(ROOM, -ROOM)
    apart = cv2.absdiff(warp_onto_first(moved, found.transform), first)[middle]
    assert apart.mean() < 4
    x, y = map_back(found.transform, 0.5 + found.transform[0, 2], 0.3 + found.transform[1, 2])
    assert (x, y) == pytest.approx((0.5, 0.3), abs=0.01)


def test_a_lorry_that_fills_the_picture_does_not_move_the_camera() -> None:
    steadiness, picture = Steadiness(30.0), view(scenery(), 0, 0)
    lorry = view(np.ascontiguousarray(scenery()[::-1]), 0, 0)
    for n in range(60):
        frame = picture.copy()
        right = min(WIDTH, 10 * n)
        frame[20:230, :right] = np.roll(lorry, 10 * n, axis=1)[20:230, :right]
        steadiness.place(frame)
    assert steadiness.wander().still


def searched(path: Path, shake_px: float) -> PassSearch:
    """The street, seen by a camera that shakes by up to so much and shows all of it but ROOM / 2 at each
    border.
    """
    half = ROOM // 2

    def frames() -> Iterator[np.ndarray]:
        for n, gray in enumerate(street(100, CARS, detailed=True)):
            dx, dy = shake_px * np.sin(0.21 * n), 0.7 * shake_px * np.sin(0.13 * n + 1)
            matrix = np.array([[1.0, 0.0, half + dx], [0.0, 1.0, half + dy]])
            size, flags = (WIDTH - ROOM, HEIGHT - ROOM), cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
            yield np.repeat(cv2.warpAffine(gray, matrix, size, flags=flags)[..., None], 3, 2)

    write_mp4(path, frames(), 30, crf=18)
    return find_passes(path)


def test_a_hand_held_camera_is_followed_and_said(tmp_path: Path) -> None:
    search = searched(tmp_path / "held.mp4", shake_px=12.0)
    assert [one.direction for one in search.passes] == ["right", "left"]
    for one, mover in zip(search.passes, CARS, strict=True):
        there = [n for n in range(1000) if mover.in_view(n)]
        assert abs(one.first_frame - there[0]) <= 4 and abs(one.last_frame - there[-1]) <= 5
    assert len(search.notes) == 1 and "The camera moves by up to" in str(search.notes[0])


def test_a_camera_that_stands_has_no_note(tmp_path: Path) -> None:
    search = searched(tmp_path / "stands.mp4", shake_px=0.0)
    assert len(search.passes) == 2 and search.notes == ()


def test_a_camera_that_is_carried_away_gives_no_passes(tmp_path: Path) -> None:
    wide = scenery(WIDTH + 2 * ROOM + 500)
    path = tmp_path / "carried.mp4"
    frames = (view(np.ascontiguousarray(wide[:, 5 * n :]), 0, 0) for n in range(90))
    write_mp4(path, (np.repeat(gray[..., None], 3, 2) for gray in frames), 30, crf=18)
    search = find_passes(path)
    assert search.passes == ()
    assert "mark the passes by hand" in str(search.notes[0])
