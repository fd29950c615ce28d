"""Proposals on drawn frames: contacts, roof and rear lamp where they are drawn, else a refusal in words."""

from collections.abc import Sequence
from dataclasses import replace

import cv2
import numpy as np
import pytest

from sightline.detection.background import Background
from sightline.geometry.height import measure_height
from sightline.messages import say
from sightline.proposals.frames import box_on, frame_seen, frames_to_look_at
from sightline.proposals.propose import BY_HAND, POINTS, FrameSeen, Proposals, Proposed, propose_points
from sightline.proposals.road import FEWEST, road_behind
from sightline.simulation import PassTruth, day_scene, render_frame, truth
from sightline.simulation.scene import Scene
from tests.bench.surveys import boxes_of, pose_of

SCENE = day_scene()


def road_of(scene: Scene, frames: Sequence[int]) -> Background:
    road = road_behind([gray_of(scene, n) for n in frames])
    assert not isinstance(road, str)
    return road


def gray_of(scene: Scene, n: int) -> np.ndarray:
    return cv2.cvtColor(render_frame(scene, n), cv2.COLOR_BGR2GRAY)


@pytest.fixture(scope="module")
def road() -> Background:
    """The empty road, between the board and the first vehicle."""
    return road_of(SCENE, range(131, 131 + FEWEST))


def seen_of(true: PassTruth, road: Background, count: int = 5) -> list[FrameSeen]:
    """Some frames on which the vehicle is whole."""
    assert true.first_whole_frame is not None and true.last_whole_frame is not None
    boxes = boxes_of(SCENE.camera, true.vehicle)
    picked = np.linspace(true.first_whole_frame, true.last_whole_frame, count).round().astype(int)
    return [
        frame_seen(
            int(n), render_frame(SCENE, int(n)), gray_of(SCENE, int(n)), road, [(int(n), *boxes[int(n)])]
        )
        for n in picked
    ]


@pytest.fixture(scope="module")
def proposed(road: Background) -> tuple[PassTruth, Proposals]:
    true = truth(SCENE)[0]
    direction = "right" if true.vehicle.direction > 0 else "left"
    found = propose_points(seen_of(true, road), pose_of(SCENE), direction, true.best_frame)
    assert isinstance(found, Proposals), found
    return true, found


def test_what_is_proposed_lies_where_it_is_drawn(proposed: tuple[PassTruth, Proposals]) -> None:
    true, found = proposed
    frame = next(one for one in true.frames if one.frame == found.frame)
    assert set(found.points) == set(POINTS) and found.frames >= 3
    assert found.wheelbase_m == pytest.approx(true.vehicle.model.wheelbase_m, abs=0.02)
    for name in ("contact_rear", "contact_front"):
        point = found.points[name]
        assert isinstance(point, Proposed), point
        assert np.hypot(*np.subtract(point.point_px, frame.pixels[name])) < 1.5
        assert point.expected_m is None and 0 < point.expected_px < 2


def test_heights_of_roof_and_rear_lamp_are_right_within_what_is_predicted(
    proposed: tuple[PassTruth, Proposals],
) -> None:
    true, found = proposed
    contact = found.points["contact_rear"]
    assert isinstance(contact, Proposed)
    for name in ("roof", "taillight"):
        point, spot = found.points[name], true.spot(name)
        assert isinstance(point, Proposed) and point.expected_m is not None, point
        height = measure_height(pose_of(SCENE), contact.point_px, point.point_px, 1.0, spot.inset_m)
        assert height.height_m == pytest.approx(spot.height_m, abs=3 * point.expected_m)
        assert point.expected_m < 0.02


def test_headlight_and_eye_are_refused_in_words(proposed: tuple[PassTruth, Proposals]) -> None:
    _, found = proposed
    for name, reason in BY_HAND.items():
        assert found.points[name] == reason and "click it yourself" in say(reason, {})


def test_a_vehicle_that_goes_the_other_way_than_said_is_no_vehicle(road: Background) -> None:
    true = truth(SCENE)[0]
    wrong = "left" if true.vehicle.direction > 0 else "right"
    found = propose_points(seen_of(true, road, 3), pose_of(SCENE), wrong, true.best_frame)
    assert found == "proposals-not-one-vehicle"


def test_an_empty_road_has_no_proposals(road: Background) -> None:
    frames = [
        frame_seen(n, render_frame(SCENE, n), gray_of(SCENE, n), road, [(n, 200.0, 150.0, 400.0, 350.0)])
        for n in (131, 133, 135)
    ]
    found = propose_points(frames, pose_of(SCENE), "right", 133)
    assert found == "proposals-wheels-on-few-frames"


def test_a_camera_that_looks_down_on_the_roof_proposes_none(road: Background) -> None:
    true = truth(SCENE)[0]
    high = replace(SCENE.camera, centre_m=(-0.62, -3.06, 2.3), pitch_rad=0.2)
    scene = replace(SCENE, camera=high)
    boxes = boxes_of(high, true.vehicle)
    behind = road_of(scene, range(131, 131 + FEWEST))
    picked = [n for n, box in boxes.items() if box[0] > 5 and box[2] < 634][::4][:5]
    seen = [
        frame_seen(n, render_frame(scene, n), gray_of(scene, n), behind, [(n, *boxes[n])]) for n in picked
    ]
    direction = "right" if true.vehicle.direction > 0 else "left"
    found = propose_points(seen, pose_of(scene), direction, picked[2])
    roof = found.points["roof"] if isinstance(found, Proposals) else found
    assert isinstance(roof, str), roof


def test_frames_are_those_on_which_it_is_whole() -> None:
    boxes = [
        (10, 0.0, 100.0, 150.0, 200.0),
        (30, 300.0, 100.0, 500.0, 200.0),
        (50, 550.0, 100.0, 639.0, 200.0),
    ]
    frames = frames_to_look_at(boxes, 30, 640)
    assert 30 in frames and len(frames) in (7, 8) and frames == tuple(sorted(frames))
    assert all(box_on(boxes, n)[0] > 2 and box_on(boxes, n)[2] < 637 for n in frames)
    assert box_on(boxes, 20) == (150.0, 100.0, 325.0, 200.0)
    never_whole = [(10, 0.0, 100.0, 640.0, 200.0), (20, 0.0, 100.0, 640.0, 200.0)]
    assert 15 in frames_to_look_at(never_whole, 15, 640)


def test_too_few_pictures_of_the_road_are_refused() -> None:
    few = [np.zeros((4, 4), np.uint8)] * (FEWEST - 1)
    assert road_behind(few) == "proposals-no-empty-road"
