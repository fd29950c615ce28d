"""The demonstration's own lens model against OpenCV's and against itself."""

import cv2
import numpy as np

from tests.simulation.camera import DemoCamera, slope_maps

CAMERA = DemoCamera()
MATRIX = np.array([[CAMERA.fx_px, 0, CAMERA.cx_px], [0, CAMERA.fy_px, CAMERA.cy_px], [0, 0, 1]])


def test_projection_equals_opencvs() -> None:
    rng = np.random.default_rng(1)
    points = rng.uniform((-1, -0.5, 0), (5, 4, 2.2), (200, 3))
    turn, _ = cv2.Rodrigues(CAMERA.rotation())
    there, _ = cv2.projectPoints(points, turn, CAMERA.translation_m(), MATRIX, np.array(CAMERA.distortion))
    inside = np.all((there[:, 0] > 0) & (there[:, 0] < (639, 479)), axis=1)
    assert inside.sum() > 60
    np.testing.assert_allclose(CAMERA.project(points)[inside], there[inside, 0], atol=1e-9)


def test_rotation_is_a_rotation_and_the_camera_looks_along_the_road() -> None:
    r = CAMERA.rotation()
    np.testing.assert_allclose(r @ r.T, np.eye(3), atol=1e-14)
    assert np.linalg.det(r) > 0
    assert r[1, 2] < -0.9 and r[2, 1] > 0.9  # image down is -Z, forward is +Y


def test_undistortion_inverts_distortion_over_the_whole_picture() -> None:
    u, v = np.meshgrid(np.linspace(0, 639, 40), np.linspace(0, 479, 30))
    pixels = np.stack([u, v], -1)
    flat = CAMERA.undistort(pixels)
    back = CAMERA.project_cam(np.concatenate([flat, np.ones((*flat.shape[:-1], 1))], -1))
    np.testing.assert_allclose(back, pixels, atol=1e-8)


def test_slope_maps_meet_projected_points_and_the_finer_map_agrees() -> None:
    point = np.array([1.3, 0.4, 0.9])
    x, y = CAMERA.project(point)
    for s in (1, 2, 3):
        a, b = slope_maps(CAMERA, s)
        at = (np.float32((x + 0.5) * s - 0.5), np.float32((y + 0.5) * s - 0.5))
        slope = [
            float(cv2.remap(m, np.array([[at[0]]]), np.array([[at[1]]]), cv2.INTER_LINEAR)[0, 0])
            for m in (a, b)
        ]
        away = point[1] - CAMERA.centre_m[1]
        assert abs(CAMERA.centre_m[0] + away * slope[0] - point[0]) < 1e-4
        assert abs(CAMERA.centre_m[2] + away * slope[1] - point[2]) < 1e-4
