"""Detection: found where it is, refused with a reason where it is not (how soon: tests/bench)."""

from typing import Any

import cv2
import numpy as np
import pytest

from sightline.errors import BadInput
from sightline.geometry import corners
from sightline.geometry.board import Board
from sightline.geometry.corners import find_board
from sightline.geometry.tracking import track
from tests.geometry.scenes import shared
from tests.geometry.simulate import Lens, Scene, picture
from tests.support.waiting import NEVER_S

BOARD = Board(6, 4, 0.1)


def scene(x: float = -0.7, y: float = -3.0, z: float = 1.4, yaw: float = 18.0) -> Scene:
    return Scene(Lens(), (x, y, z), yaw, 4.0)


def clutter(seed: int, height: int = 480, width: int = 640) -> np.ndarray:
    """Rectangles, lines and noise, without a board."""
    rng = np.random.default_rng(seed)
    image = np.full((height, width), 120, np.uint8)
    for _ in range(120):
        a, b = rng.integers(0, [width, height], (2, 2)).tolist()
        cv2.rectangle(image, a, b, int(rng.integers(0, 255)), -1 if rng.random() < 0.6 else 2)
    noise = rng.normal(0, 4, image.shape)
    return np.clip(image + noise, 0, 255).astype(np.uint8)


@pytest.mark.parametrize("seed", [0, *(pytest.param(n, marks=pytest.mark.proof) for n in (1, 2, 3))])
def test_clutter_holds_no_board(seed: int) -> None:
    found = find_board(clutter(seed), BOARD, time_limit_s=2.0)
    assert not found.found and found.reason
    assert found.points_px.shape == (0, 0, 2)


def test_the_classic_detector_sees_a_large_picture_reduced(monkeypatch: pytest.MonkeyPatch) -> None:
    """It would take 16 s for this one, and cannot be stopped."""
    sizes, classic = list[int](), corners._classic

    def noted(gray: np.ndarray, *more: Any) -> Any:
        sizes.append(gray.size)
        return classic(gray, *more)

    monkeypatch.setattr(corners, "_classic", noted)
    assert not find_board(clutter(1, 1080, 1920), BOARD).found
    assert sizes and max(sizes) <= 500_000


def test_no_search_begins_that_could_outlast_the_time_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    """By a clock of its own: each takes 0.9 s, so after the second only a quick one fits into 2 s."""
    clock = [0.0]

    def search(*_: Any) -> None:
        clock[0] += 0.9

    for name in ("_classic", "_sector"):
        monkeypatch.setattr(corners, name, search)
    monkeypatch.setattr(corners, "perf_counter", lambda: clock[0])
    found = find_board(clutter(0), BOARD, time_limit_s=2.0)
    assert clock[0] == pytest.approx(2.7)
    assert found.reason and "before the time limit" in str(found.reason)


def test_a_board_in_a_large_picture_is_found_reduced_and_measured_in_full() -> None:
    large = Scene(Lens(1088.0, 959.5, 539.5, width=1920, height=1080), (-0.7, -3.0, 1.4), 18.0, 4.0)
    found = find_board(picture(large, 6, 4, 0.1, 1.5, samples=4), BOARD)
    truth = large.look(large.board(6, 4, 0.1, 1.5).reshape(-1, 3)).reshape(4, 6, 2)
    assert found.found and found.detector == "classic, reduced"
    assert np.sqrt(np.square(found.points_px - truth).mean()) < 0.06


def test_a_soft_board_in_five_megapixels_is_fitted_as_soft_as_it_is() -> None:
    lens = Lens(1934.0, 1279.5, 959.5, width=2560, height=1920)
    large = Scene(lens, (-0.7, -3.0, 1.4), 18.0, 4.0, 3.0)
    drawn = picture(large, 6, 4, 0.1, 1.5, samples=3, blur=0.0, noise=0.0)
    soft = cv2.GaussianBlur(drawn, (0, 0), 8.0).astype(float)
    noisy = np.clip(soft + np.random.default_rng(1).normal(0, 3, soft.shape), 0, 255).astype(np.uint8)
    found = find_board(noisy, BOARD, NEVER_S)
    truth = large.look(large.board(6, 4, 0.1, 1.5).reshape(-1, 3)).reshape(4, 6, 2)
    assert found.found
    assert np.sqrt(np.square(found.points_px - truth).mean()) < 0.06


def test_a_corner_that_the_detector_puts_beside_itself_is_brought_home(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    drawn = picture(scene(), 6, 4, 0.1, 1.5)
    truth = scene().look(scene().board(6, 4, 0.1, 1.5).reshape(-1, 3))
    astray = truth.copy()
    astray[23] += 0.25 * (truth[23] - truth[22])
    monkeypatch.setattr(corners, "_classic", lambda gray, board, flags: astray)
    found = find_board(drawn, BOARD)
    assert found.found
    assert np.abs(found.points_px.reshape(-1, 2) - truth).max() < 0.3


@pytest.mark.parametrize("x", [-2.0, *(pytest.param(x, marks=pytest.mark.proof) for x in (2.5, -2.15))])
def test_a_board_cut_by_the_border_is_refused(x: float) -> None:
    cut = scene(x=x, yaw=0.0)
    corners = cut.look(cut.board(6, 4, 0.1, 1.5).reshape(-1, 3))
    assert corners[:, 0].min() < 0 or corners[:, 0].max() > 639
    image = picture(cut, 6, 4, 0.1, 1.5, samples=3)
    found = find_board(image, BOARD)
    assert not found.found
    assert found.reason and ("cut" in str(found.reason) or "whole board" in str(found.reason))


def test_another_board_size_is_refused() -> None:
    image = picture(scene(), 6, 4, 0.1, 1.5, samples=3)
    found = find_board(image, Board(8, 5, 0.1))
    assert not found.found and found.reason and "8x5" in str(found.reason)


def test_small_far_board_is_found_by_a_fallback() -> None:
    far = Scene(Lens(k=(0.0,) * 5), (0.2, -6.5, 1.4), 0.0, 1.0, 3.0)
    image = picture(far, 6, 4, 0.1, 1.6, samples=5, blur=0.7, noise=2)
    found = find_board(image, BOARD, NEVER_S)
    assert found.found, found.reason
    truth = far.look(far.board(6, 4, 0.1, 1.6).reshape(-1, 3)).reshape(4, 6, 2)
    assert np.sqrt(np.square(found.points_px - truth).mean()) < 0.15


def test_impossible_board_raises() -> None:
    with pytest.raises(BadInput):
        find_board(clutter(0), Board(0, 4, 0.1))


def test_sharpness_grows_with_blur() -> None:
    sharp, soft = (find_board(picture(scene(), 6, 4, 0.1, 1.5, samples=3, blur=b), BOARD) for b in (0.6, 2.0))
    assert sharp.found and soft.found
    assert 0 < sharp.sharpness < soft.sharpness


def test_following_a_board() -> None:
    first = find_board(picture(scene(), 6, 4, 0.1, 1.5, samples=4), BOARD)
    moved = scene(x=-0.69)
    next_picture = picture(moved, 6, 4, 0.1, 1.5, samples=4, seed=1)
    followed = track(next_picture, first)
    truth = moved.look(moved.board(6, 4, 0.1, 1.5).reshape(-1, 3)).reshape(4, 6, 2)
    assert followed.found, followed.reason
    assert np.sqrt(np.square(followed.points_px - truth).mean()) < 0.1
    assert not track(clutter(2), first).found


@pytest.mark.parametrize("every", [10, *(pytest.param(n, marks=pytest.mark.proof) for n in (5, 1))])
@pytest.mark.parametrize(
    ("folder", "size", "refused"),
    [
        ("gopro_wide", (8, 6), {"GOPR0055.jpg"}),
        ("mixed_sizes", (9, 6), {"calibration1.jpg", "calibration4.jpg", "calibration5.jpg"}),
    ],
)
def test_real_sets_are_found_as_the_reference_says(
    folder: str, size: tuple[int, int], refused: set[str], every: int
) -> None:
    """The GoPro picture that cuts the board off, and those of the mixed set, are refused; of the others every
    tenth is looked at, or every one.
    """
    paths = sorted(shared("calibration", folder).glob("*.jpg"))
    missed = set()
    for path in (path for n, path in enumerate(paths) if n % every == 0 or path.name in refused):
        found = find_board(cv2.imread(str(path), cv2.IMREAD_GRAYSCALE), Board(*size, 0.03), NEVER_S)
        if not found.found:
            assert found.reason
            missed.add(path.name)
    assert missed == refused
