"""Proposals on drawn frames: contacts, roof, lamps and eye where they are drawn, else a refusal in words."""

from collections.abc import Sequence
from types import SimpleNamespace
from typing import Any, cast

import cv2
import numpy as np
import pytest

from sightline.detection.background import Background
from sightline.geometry.camera import Camera
from sightline.geometry.height import measure_height
from sightline.geometry.road_pose import RoadPose
from sightline.media.networks import proposal_networks
from sightline.proposals import canvas
from sightline.proposals.canvas import UNSEEN, lay_on_canvas
from sightline.proposals.frames import box_on, frame_seen, frames_to_look_at
from sightline.proposals.keypoints import FINE_POINTS, fine_canvas, moved_to_plane, plane_point
from sightline.proposals.motion import Motion
from sightline.proposals.propose import (
    POINTS,
    REST_PX,
    TRUST,
    FrameSeen,
    Proposals,
    Proposed,
    _Best,
    propose_points,
)
from sightline.proposals.road import FEWEST, road_behind
from sightline.proposals.targets import BY_HAND, Place
from tests.bench.surveys import boxes_of, pose_of
from tests.simulation import PassTruth, day_scene, render_frame, truth
from tests.simulation.scene import Scene

SCENE = day_scene()
NETWORKS = proposal_networks()


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


def seen_of(true: PassTruth, road: Background, count: int) -> list[FrameSeen]:
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


@pytest.fixture(scope="module", params=[7, pytest.param(9, marks=pytest.mark.proof)])
def proposed(road: Background, request: pytest.FixtureRequest) -> tuple[PassTruth, Proposals]:
    """From so many frames."""
    true = truth(SCENE)[0]
    direction = "right" if true.vehicle.direction > 0 else "left"
    seen = seen_of(true, road, request.param)
    found = propose_points(NETWORKS, seen, pose_of(SCENE), direction, true.best_frame)
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


def test_headlights_are_left_to_people(proposed: tuple[PassTruth, Proposals]) -> None:
    assert proposed[1].points["headlight"] == "proposals-headlight-by-hand"


@pytest.mark.parametrize("name", [name for name in FINE_POINTS if name not in BY_HAND])
def test_heights_are_right_within_what_is_predicted(proposed: tuple[PassTruth, Proposals], name: str) -> None:
    true, found = proposed
    contact = found.points["contact_rear"]
    assert isinstance(contact, Proposed)
    point, spot = found.points[name], true.spot(name)
    assert isinstance(point, Proposed) and point.expected_m is not None, point
    height = measure_height(pose_of(SCENE), contact.point_px, point.point_px, 1.0, spot.inset_m)
    assert height.height_m == pytest.approx(spot.height_m, abs=3.5 * point.expected_m)
    assert point.expected_m < 0.03


def test_a_place_is_the_same_ray_on_another_plane() -> None:
    pose = pose_of(SCENE)
    near = plane_point(pose, (250.0, 200.0), 0.2)
    assert moved_to_plane(pose, near, 0.2, 1.4) == pytest.approx(plane_point(pose, (250.0, 200.0), 1.4))


def test_what_is_laid_out_lies_under_its_own_place() -> None:
    pose, picture = pose_of(SCENE), np.zeros((480, 640, 3), np.uint8)
    picture[200:, 250:] = 200
    x, z = plane_point(pose, (249.5, 199.5), 0.2)
    view = lay_on_canvas(
        fine_canvas("taillight", x, z, 0.2, 1), picture, np.zeros((480, 640), np.float32), pose
    )
    assert view.shape == (4, 48, 48) and (view[3] == 0).all()
    bright = view[0] > 0.5 * (view[0].min() + view[0].max())
    assert bright[:22, 26:].all() and not bright[26:].any() and not bright[:, :22].any()
    beside = fine_canvas("taillight", x + 40, z, 0.2, 1)
    assert (lay_on_canvas(beside, picture, np.zeros((480, 640), np.float32), pose)[3] == UNSEEN).all()


C_M, TURN = np.array([0.0, -4.0, 1.5]), np.deg2rad(35.0)
LENS = Camera("turned", 1920, 1080, "brown", 1400.0, 1400.0, 959.5, 539.5, np.zeros(5))


def turned() -> RoadPose:
    """A level camera that looks by TURN to the right of straight across the road."""
    cos, sin = np.cos(TURN), np.sin(TURN)
    rotation = np.array([[cos, -sin, 0.0], [0.0, 0.0, -1.0], [sin, cos, 0.0]])
    return RoadPose(LENS, rotation, -rotation @ C_M)


def seen_at(x_m: float, y_m: float, z_m: float) -> np.ndarray:
    """The same camera written out."""
    away = np.sin(TURN) * x_m + np.cos(TURN) * (y_m - C_M[1])
    along = np.cos(TURN) * x_m - np.sin(TURN) * (y_m - C_M[1])
    return 1400.0 * np.array([along, C_M[2] - z_m]) / away + (959.5, 539.5)


@pytest.mark.parametrize("x_m", [1.2, 2.8, 7.0])
def test_what_an_error_up_comes_to_in_pixels_follows_the_distance_along_the_cameras_way(x_m: float) -> None:
    one = SimpleNamespace(n=3, gray=np.zeros((1080, 1920), np.uint8))
    motion = Motion(x_m=x_m, step_m=0.5, n0=3, y_m=0.0, wheelbase_m=2.6, only=None, used=(3,))
    place = Place(along_m=0.0, drift=0.0, z_m=1.4, u_z_m=0.004, sure={3: 1.0})
    nothing: dict[Any, Any] = {}
    best = _Best(
        seen=[],
        looks=nothing,
        pose=turned(),
        motion=motion,
        found=nothing,
        places={"roof": place},
        ahead=1,
    )
    found = best.target("roof", cast(FrameSeen, one), Proposed(tuple(seen_at(x_m, 0.0, 0.0)), 1.0, None))
    assert isinstance(found, Proposed)
    drawn = [seen_at(x_m, 0.0, z) for z in np.random.default_rng(1).normal(1.4, 0.004, 4000)]
    spread = TRUST["roof"] * np.std(drawn, axis=0)[1]
    assert found.expected_px == pytest.approx(np.hypot(REST_PX, spread), rel=0.04)


@pytest.mark.parametrize("x_m", [0.5, 7.0])
def test_a_picture_is_smoothed_by_half_a_cell_as_it_is_seen(
    x_m: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    smoothed = list[tuple[float, float]]()

    def blur(values: np.ndarray, _size: object, sigma: float, sigmaY: float) -> np.ndarray:
        smoothed.append((sigma, sigmaY))
        return values

    monkeypatch.setattr(canvas.cv2, "GaussianBlur", blur)
    size, cell_m = (33, 33), (0.02, 0.02)
    at = canvas.Canvas(y_m=0.0, ahead=1, along_m=x_m - 0.32, z_m=0.8, cell_m=cell_m, size=size)
    picture = np.zeros((1080, 1920, 3), np.uint8)
    lay_on_canvas(at, picture, np.zeros((1080, 1920), np.float32), turned())
    middle = seen_at(x_m, 0.0, 1.12)
    half_a_cell = [
        0.5 * np.linalg.norm(seen_at(*to) - middle) for to in ((x_m + 0.02, 0, 1.12), (x_m, 0, 1.14))
    ]
    assert smoothed == [pytest.approx(half_a_cell, rel=0.02)] * 2


def test_a_vehicle_that_goes_the_other_way_than_said_is_no_vehicle(road: Background) -> None:
    true = truth(SCENE)[0]
    wrong = "left" if true.vehicle.direction > 0 else "right"
    found = propose_points(NETWORKS, seen_of(true, road, 3), pose_of(SCENE), wrong, true.best_frame)
    assert found == "proposals-not-one-vehicle"


def test_an_empty_road_has_no_proposals(road: Background) -> None:
    frames = [
        frame_seen(n, render_frame(SCENE, n), gray_of(SCENE, n), road, [(n, 200.0, 150.0, 400.0, 350.0)])
        for n in (131, 133, 135)
    ]
    found = propose_points(NETWORKS, frames, pose_of(SCENE), "right", 133)
    assert found == "proposals-wheels-on-few-frames"


def test_frames_are_those_on_which_it_is_whole() -> None:
    boxes = [
        (10, 0.0, 100.0, 150.0, 200.0),
        (30, 300.0, 100.0, 500.0, 200.0),
        (50, 550.0, 100.0, 639.0, 200.0),
    ]
    frames = frames_to_look_at(boxes, 30, 640)
    assert 30 in frames and len(frames) in (9, 10) and frames == tuple(sorted(frames))
    assert all(box_on(boxes, n)[0] > 2 and box_on(boxes, n)[2] < 637 for n in frames)
    assert box_on(boxes, 20) == (150.0, 100.0, 325.0, 200.0)
    never_whole = [(10, 0.0, 100.0, 640.0, 200.0), (20, 0.0, 100.0, 640.0, 200.0)]
    assert 15 in frames_to_look_at(never_whole, 15, 640)
    leaving = [(10, 0.0, 100.0, 600.0, 200.0), (20, 0.0, 100.0, 600.0, 200.0), (40, 0.0, 100.0, 2.0, 200.0)]
    assert max(frames_to_look_at(leaving, 12, 640)) == 28


def test_too_few_pictures_of_the_road_are_refused() -> None:
    few = [np.zeros((4, 4), np.uint8)] * (FEWEST - 1)
    assert road_behind(few) == "proposals-no-empty-road"
