"""Sub-pixel corners against rendered truth, side by side with OpenCV's cornerSubPix."""

import numpy as np
import pytest

from sightline.geometry.board import Board
from sightline.geometry.corners import find_board, refine_subpixel
from sightline.geometry.height import measure_height
from sightline.geometry.mean_picture import MeanPicture
from sightline.geometry.pose import pose_from_corners
from sightline.geometry.road_pose import Reference
from sightline.geometry.saddle import refine_saddles
from sightline.geometry.tracking import track
from tests.geometry.scenes import camera_of
from tests.geometry.simulate import Lens, Scene, picture


def shot(seed: int, yaw: float = 30.0, distance: float = 3.0, **more):
    eye = (0.25 - distance * np.tan(np.radians(yaw)) + 0.013 * seed, -distance, 1.4 + 0.007 * seed)
    scene = Scene(Lens(), eye, yaw, 4 + 0.3 * seed, 2.0 + seed)
    truth = scene.look(scene.board(6, 4, 0.1, 1.5).reshape(-1, 3)).reshape(4, 6, 2)
    return scene, picture(scene, 6, 4, 0.1, 1.5, seed=seed, samples=6, **more), truth


@pytest.mark.parametrize(("blur", "noise", "limit"), [(0.8, 3.0, 0.02), (0.5, 3.0, 0.02), (1.2, 8.0, 0.05)])
def test_corner_error(blur: float, noise: float, limit: float) -> None:
    saddle, opencv = [], []
    for seed in range(2):
        _, grey, truth = shot(seed, blur=blur, noise=noise)
        start = refine_subpixel(grey, truth + np.random.default_rng(seed).normal(0, 0.2, truth.shape))
        fitted = refine_saddles(grey, start)
        assert fitted.ok.all()
        saddle.append(fitted.points_px.reshape(truth.shape) - truth)
        opencv.append(start - truth)
    rms, rms_opencv = (float(np.sqrt(np.mean(np.square(e)))) for e in (saddle, opencv))
    assert rms <= limit
    assert rms <= 0.6 * rms_opencv


def test_a_fit_that_cannot_settle_keeps_its_start() -> None:
    flat = np.full((120, 160), 90.0) + np.random.default_rng(1).normal(0, 2, (120, 160))
    x, y = np.meshgrid(np.arange(40, 100, 15.0), np.arange(40, 90, 15.0))
    grid = np.stack([x, y], axis=2)
    fitted = refine_saddles(flat, grid)
    assert np.abs(fitted.points_px - grid.reshape(-1, 2)).max() <= 1.0
    assert not fitted.ok.all()
    border = refine_saddles(flat, grid - 39.0)
    assert not border.ok[0]
    assert border.points_px[0] == pytest.approx(grid[0, 0] - 39.0)


def test_height_from_a_still_clip_within_a_millimetre() -> None:
    """A clip of a still board at 3 m, noise in every frame: perfect clicks give heights within 1 mm."""
    scene, grey, _ = shot(0, yaw=20.0)
    rng = np.random.default_rng(2)
    board, reference = Board(6, 4, 0.1), Reference("top", 1.5)
    mean, frames, last = MeanPicture(), [], None
    for _ in range(25):
        noisy = np.clip(grey + rng.normal(0, 3, grey.shape), 0, 255).astype(np.uint8)
        last = find_board(noisy, board) if last is None else track(noisy, last)
        assert last.found
        frames.append(last)
        mean.add(noisy, last)
    pose = pose_from_corners(camera_of(Lens()), frames, board, reference, mean.result())
    assert pose.frames_used == 25
    errors = []
    for across in (-1.0, 0.0, 1.0, 2.0):
        for height in (0.65, 1.16, 1.5):
            x = scene.eye[0] + (across + 3.0) * np.tan(np.radians(20))
            clicks = scene.look([(x, across, 0.0), (x + 0.1, across, height)])
            found = measure_height(pose, clicks[0], clicks[1], sigma_px=0.0)
            if found.height_m is not None:
                errors.append(found.height_m - height)
    assert len(errors) >= 6
    assert np.sqrt(np.mean(np.square(errors))) <= 0.001
