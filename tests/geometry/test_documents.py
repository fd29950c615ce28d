"""camera.json and pose.json: round trips, and refusals that name the key."""

import dataclasses
import json

import numpy as np
import pytest

from sightline.errors import BadInput
from sightline.geometry.camera import View
from sightline.geometry.documents import camera_from_dict, camera_to_dict, pose_from_dict, pose_to_dict
from sightline.geometry.road_pose import BoardOnRoad, RoadPose
from sightline.messages.said import Said
from tests.geometry.scenes import camera_of, pose_of
from tests.geometry.simulate import Lens, Scene


def a_pose() -> RoadPose:
    rng = np.random.default_rng(1)
    a = rng.normal(size=(15, 15))
    camera = dataclasses.replace(
        camera_of(Lens(), (a @ a.T)[:9, :9]),
        rms_px=0.2,
        views=(View("a.png", 0.2, True), View("b", None, False, Said("board-not-found"))),
    )
    board = BoardOnRoad(6, 4, 0.1, "bottom", 0.6, 0.002, 0.004, 3.1)
    base = pose_of(Scene(yaw=10.0))
    return RoadPose(camera, base.rotation, base.translation_m, a @ a.T, board, 7, 0.05)


def test_round_trip_keeps_every_digit() -> None:
    pose = a_pose()
    back = pose_from_dict(json.loads(json.dumps(pose_to_dict(pose))))
    assert pose_to_dict(back) == pose_to_dict(pose)
    assert back.camera.views == pose.camera.views and back.board == pose.board


def test_the_contracts_keys_are_there() -> None:
    document = pose_to_dict(a_pose())
    assert set(document) == {
        "format", "camera", "cam_from_road", "parameters", "covariance", "board", "frames_used", "rms_px",
    }  # fmt: skip
    assert document["parameters"] == [
        "fx_px", "fy_px", "cx_px", "cy_px", "k1", "k2", "p1", "p2", "k3", "rx", "ry", "rz", "tx", "ty", "tz",
    ]  # fmt: skip
    assert set(document["camera"]) == {
        "format", "name", "width_px", "height_px", "model", "fx_px", "fy_px", "cx_px", "cy_px", "distortion",
        "rms_px", "parameters", "covariance", "views",
    }  # fmt: skip


def test_covariance_in_another_order_is_put_in_ours() -> None:
    document = camera_to_dict(a_pose().camera)
    matrix = np.array(document["covariance"])
    order = list(reversed(range(9)))
    document["parameters"] = [document["parameters"][i] for i in order]
    document["covariance"] = matrix[np.ix_(order, order)].tolist()
    assert np.allclose(camera_from_dict(document).covariance, matrix)


def test_null_covariance_and_board_are_accepted() -> None:
    document = pose_to_dict(a_pose())
    document["covariance"] = document["camera"]["covariance"] = document["board"] = None
    pose = pose_from_dict(document)
    assert pose.covariance is None and pose.board is None and pose.camera.covariance is None


@pytest.mark.parametrize(
    ("path", "value", "key"),
    [
        (("format",), "sightline-pose-9", "format"),
        (("camera",), None, "camera"),
        (("camera", "fx_px"), "wide", "fx_px"),
        (("camera", "fx_px"), -1.0, "fx_px"),
        (("camera", "fx_px"), float("nan"), "fx_px"),
        (("camera", "width_px"), 0, "width_px"),
        (("camera", "width_px"), True, "width_px"),
        (("camera", "model"), "omni", "model"),
        (("camera", "distortion"), [1, 2], "distortion"),
        (("camera", "distortion"), "none", "distortion"),
        (("camera", "covariance"), [[1, 2], [3, 4]], "covariance"),
        (("camera", "covariance"), (-np.eye(9)).tolist(), "covariance"),
        (("camera", "parameters"), ["fx_px", "q"], "parameters"),
        (("camera", "parameters"), ["fx_px", "fx_px"], "parameters"),
        (("parameters",), [[], {}], "parameters"),
        (("camera", "views"), 3, "views"),
        (("cam_from_road", "rotation"), np.diag([1, 1, -1]).tolist(), "rotation"),
        (("cam_from_road", "rotation"), [[1, 0], [0, 1]], "rotation"),
        (("cam_from_road", "translation_m"), [1, 2], "translation_m"),
        (("board", "square_m"), 0, "square_m"),
        (("board", "reference"), "left", "reference"),
        (("board", "u_lean_rad"), -0.1, "u_lean_rad"),
        (("frames_used"), -1, "frames_used"),
    ],
)
def test_refusals_name_the_key(path, value, key) -> None:
    document = pose_to_dict(a_pose())
    path = (path,) if isinstance(path, str) else path
    inner = document
    for step in path[:-1]:
        inner = inner[step]
    inner[path[-1]] = value
    with pytest.raises(BadInput, match=key) as caught:
        pose_from_dict(document, "my_pose.json")
    assert "my_pose.json" in caught.value.message and "\n" not in caught.value.message


@pytest.mark.parametrize("document", [None, [], 3, "x", {}])
def test_other_json_is_refused(document) -> None:
    with pytest.raises(BadInput):
        camera_from_dict(document)
    with pytest.raises(BadInput):
        pose_from_dict(document)


@pytest.mark.parametrize("huge", [1e13, 1e300, 10**400, float("inf")])
@pytest.mark.parametrize(
    "place", [("camera", "fx_px"), ("camera", "width_px"), ("board", "distance_m"), ("frames_used",)]
)
def test_a_number_beyond_all_measure_is_refused_by_its_key(place: tuple[str, ...], huge: float) -> None:
    document = json.loads(json.dumps(pose_to_dict(a_pose())))
    inside = document
    for key in place[:-1]:
        inside = inside[key]
    inside[place[-1]] = huge
    with pytest.raises(BadInput, match=place[-1]):
        pose_from_dict(document)


@pytest.mark.parametrize("huge", [1e300, 10**400])
def test_a_list_with_such_a_number_is_refused(huge: float) -> None:
    document = json.loads(json.dumps(pose_to_dict(a_pose())))
    document["cam_from_road"]["translation_m"][1] = huge
    with pytest.raises(BadInput, match="translation_m"):
        pose_from_dict(document)
