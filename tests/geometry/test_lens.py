"""Lens models: equal to textbook formulas, inverted exactly, refused where there is no inverse."""

import dataclasses

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.geometry.camera import Camera, normalised_to_pixels, project, project_with_jacobians, undistort
from tests.geometry.scenes import LENSES, camera_of
from tests.geometry.simulate import Lens, bend


def grid(camera: Camera, step: float = 7.0) -> np.ndarray:
    x, y = np.meshgrid(np.arange(0, camera.width_px, step), np.arange(0, camera.height_px, step))
    return np.stack([x.ravel(), y.ravel()], axis=1)


@pytest.mark.parametrize("lens", LENSES)
def test_round_trip_within_a_billionth_of_a_pixel(lens: Lens) -> None:
    camera = camera_of(lens)
    pixels = grid(camera)
    seen = undistort(camera, pixels)
    assert seen.ok.mean() > 0.99
    back = normalised_to_pixels(camera, seen.points)
    assert np.abs(back - pixels)[seen.ok].max() <= 1e-9


@pytest.mark.parametrize("lens", LENSES)
def test_projection_equals_the_textbook_formulas(lens: Lens) -> None:
    rng = np.random.default_rng(1)
    points = rng.normal(size=(200, 3)) * [0.5, 0.4, 0.2] + [0, 0, 2]
    a, b = bend(lens, points[:, 0] / points[:, 2], points[:, 1] / points[:, 2])
    wanted = np.stack([lens.f * a + lens.cx, lens.f * b + lens.cy], axis=1)
    assert np.abs(project(camera_of(lens), points) - wanted).max() < 1e-9


@given(
    st.tuples(
        st.floats(-0.45, 0.3), st.floats(-0.2, 0.3), st.floats(-2e-3, 2e-3), st.floats(-2e-3, 2e-3),
        st.floats(-0.1, 0.1),
    ),
    st.floats(250, 1500),
)  # fmt: skip
def test_any_brown_lens_round_trips_or_refuses(k: tuple[float, ...], f: float) -> None:
    camera = camera_of(Lens(f=f, k=k))
    pixels = grid(camera, 23.0)
    seen = undistort(camera, pixels)
    back = normalised_to_pixels(camera, seen.points[seen.ok])
    if seen.ok.any():
        assert np.abs(back - pixels[seen.ok]).max() <= 1e-9
    radius = np.hypot(seen.points[:, 0], seen.points[:, 1])
    assert (radius[seen.ok] <= camera.limit.radius).all()


@given(st.floats(0.02, 1.2), st.floats(0, 6.28))
def test_directions_inside_the_valid_radius_come_back(radius: float, angle: float) -> None:
    for lens in LENSES:
        camera = camera_of(lens)
        r = radius * min(camera.limit.radius, 1.1) * 0.8
        direction = np.array([[r * np.cos(angle), r * np.sin(angle)]])
        pixel = normalised_to_pixels(camera, direction)
        if camera.inside(pixel)[0]:
            seen = undistort(camera, pixel)
            assert seen.ok[0]
            assert np.abs(seen.points - direction).max() < 1e-11


def test_a_lens_that_folds_refuses_the_corners() -> None:
    """k = -.42, .22, -.06: the corners of the picture have no solution at all."""
    camera = camera_of(Lens(f=400.0, k=(-0.42, 0.22, 0.0, 0.0, -0.06)))
    assert not undistort(camera, [[0, 0], [639, 0], [0, 479], [639, 479]]).ok.any()
    assert undistort(camera, [[320, 240], [100, 240]]).ok.all()
    r = camera.limit.radius
    just_in, just_out = bend_radius(camera, r * 0.999), bend_radius(camera, r * 1.001)
    assert just_out < bend_radius(camera, r) + 1e-9
    assert just_in < bend_radius(camera, r) + 1e-9


def bend_radius(camera: Camera, r: float) -> float:
    lens = Lens(k=tuple(camera.distortion), kind=camera.model)
    return float(np.hypot(*bend(lens, np.array([r]), np.array([0.0])))[0])


def test_points_behind_the_camera_and_beyond_the_fold_are_not_projected() -> None:
    camera = camera_of(Lens(k=(-0.42, 0.22, 0.0, 0.0, -0.06)))
    pixels = project(camera, [[0, 0, -1], [0, 0, 0], [5.0, 0, 1.0], [0.1, 0, 1]])
    assert np.isnan(pixels[:3]).all()
    assert np.isfinite(pixels[3]).all()


def test_nan_is_refused() -> None:
    assert not undistort(camera_of(Lens()), [[np.nan, 3.0], [np.inf, 2.0]]).ok.any()


@pytest.mark.parametrize("lens", LENSES)
def test_jacobians_equal_differences(lens: Lens) -> None:
    camera = camera_of(lens)
    points = np.random.default_rng(2).normal(size=(30, 3)) * [0.5, 0.4, 0.2] + [0, 0, 2]
    _, by_point, by_lens = project_with_jacobians(camera, points)
    e = 1e-6
    for axis in range(3):
        d = np.eye(3)[axis] * e
        numeric = (project(camera, points + d) - project(camera, points - d)) / (2 * e)
        assert np.allclose(by_point[:, :, axis], numeric, atol=1e-5)
    values = np.array([camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px, *camera.distortion])
    for i in range(len(values)):
        step = np.eye(len(values))[i] * 1e-5
        plus, minus = (moved(camera, values + s * step) for s in (1, -1))
        numeric = (project(plus, points) - project(minus, points)) / 2e-5
        assert np.allclose(by_lens[:, :, i], numeric, atol=1e-4), camera.parameters[i]


def moved(camera: Camera, v: np.ndarray) -> Camera:
    return dataclasses.replace(camera, fx_px=v[0], fy_px=v[1], cx_px=v[2], cy_px=v[3], distortion=v[4:])
