"""The drawn camera: a pixel's ray comes back to the pixel, from any road point in view."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.simulation.camera import DemoCamera

CAMERA = DemoCamera()


@given(
    x=st.floats(20, CAMERA.width_px - 20), y=st.floats(20, CAMERA.height_px - 20), depth_m=st.floats(2, 12)
)
def test_a_ray_comes_back_to_its_pixel(x: float, y: float, depth_m: float) -> None:
    pixel = np.array([x, y])
    slope_x, slope_z = CAMERA.ray_slopes(pixel)
    cx, cy, cz = CAMERA.centre_m
    point = np.array([cx + depth_m * slope_x, cy + depth_m, cz + depth_m * slope_z])
    assert CAMERA.project(point) == pytest.approx(pixel, abs=1e-6)


@given(yaw=st.floats(-1, 1), pitch=st.floats(-0.3, 0.3), roll=st.floats(-0.3, 0.3))
def test_a_rotation_keeps_lengths_and_hands(yaw: float, pitch: float, roll: float) -> None:
    rotation = DemoCamera(yaw_rad=yaw, pitch_rad=pitch, roll_rad=roll).rotation()
    assert rotation @ rotation.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(rotation) == pytest.approx(1)
