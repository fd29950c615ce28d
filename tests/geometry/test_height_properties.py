"""A height is the one that was drawn, and no unit, place or heading of the camera matters to it."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from sightline.geometry.height import measure_height
from tests.geometry.scenes import LENSES, pose_of
from tests.geometry.simulate import Scene


@given(
    lens=st.sampled_from(LENSES),
    eye_x=st.floats(-1, 1),
    eye_y=st.floats(-6, -1.5),
    camera_height=st.floats(0.9, 2.5),
    yaw=st.floats(-30, 30),
    pitch=st.floats(0, 15),
    along=st.floats(-1, 1),
    inset=st.floats(0, 1.2),
    height=st.floats(0.3, 2.2),
)
def test_a_drawn_height_is_measured(
    lens, eye_x, eye_y, camera_height, yaw, pitch, along, inset, height
) -> None:  # type: ignore[no-untyped-def]
    scene = Scene(lens, (eye_x, eye_y, camera_height), yaw, pitch, 0.0)
    x = eye_x - eye_y * np.tan(np.radians(yaw)) + along
    clicks = scene.look([(x, 0.0, 0.0), (x, inset, height)])
    pose = pose_of(scene)
    assume(pose.camera.inside(clicks).all())
    found = measure_height(pose, clicks[0], clicks[1], inset_m=inset)
    assume(found.status == "ok")
    assert found.height_m == pytest.approx(height, abs=1e-8)
    assert found.y_m == pytest.approx(0, abs=1e-8)
    assert found.u_height_m > 0
