"""Where a contact click snaps to: the drawn tyre's contact within reach, and nowhere else."""

import cv2
import numpy as np
import pytest

from sightline.geometry.snap import ACROSS_PX, DOWN_PX, UP_PX, Snap, snap, within_reach
from tests.bench.surveys import pose_of, site
from tests.simulation import truth
from tests.simulation.render import render_frame

SCENE = site(611)  # no other test or bench is tuned on it
POSE = pose_of(SCENE)


@pytest.fixture(scope="module")
def wheel() -> tuple[np.ndarray, np.ndarray]:
    """(luminance, contact) of a vehicle seen whole."""
    one = next(one for one in truth(SCENE) if one.vehicle.lane == "near" and one.first_whole_frame)
    seen = next(each for each in one.frames if each.frame == one.best_frame)
    gray = cv2.cvtColor(render_frame(SCENE, seen.frame), cv2.COLOR_BGR2GRAY)
    return gray, np.array(seen.pixels["contact_rear"])


@pytest.mark.parametrize("off", [(0.0, 0.0), (2.5, 1.5), (-3.0, -9.0), (1.0, -17.0), (-2.0, -26.0)])
def test_a_click_on_or_above_the_contact_goes_to_it(
    wheel: tuple[np.ndarray, np.ndarray], off: tuple[float, float]
) -> None:
    gray, contact = wheel
    found = snap(gray, POSE, contact + off)
    assert isinstance(found, Snap), found
    assert np.hypot(*(np.array(found.contact_px) - contact)) < 1.0 and found.expected_px < 0.9


@pytest.mark.parametrize("off", [(ACROSS_PX + 3, 0.0), (0.0, UP_PX + 4), (0.0, -DOWN_PX - 4)])
def test_a_click_out_of_reach_stays(wheel: tuple[np.ndarray, np.ndarray], off: tuple[float, float]) -> None:
    gray, contact = wheel
    assert isinstance(snap(gray, POSE, contact + off), str)
    assert within_reach(contact, contact) and not within_reach(contact + off, contact)


def test_a_click_where_no_tyre_is_stays() -> None:
    empty = np.full((SCENE.camera.height_px, SCENE.camera.width_px), 120, np.uint8)
    assert snap(empty, POSE, (300.0, 400.0)) == "snap-no-tyre"
    assert snap(empty, POSE, (300.0, 2.0)) == "snap-no-tyre"  # the sky
