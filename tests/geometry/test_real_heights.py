"""Heights of real vehicles in a real frame (KITTI), whose true values its authors state."""

import json

import numpy as np
import pytest

from sightline.geometry.camera import Camera
from sightline.geometry.height import measure_height
from sightline.geometry.road_pose import RoadPose
from tests.geometry.scenes import shared


def pose_from_plane(frame: dict, plane: dict, axis: list[float]) -> RoadPose:
    """A road pose out of a plane n.X + offset = 0 and the vehicle's axis, both in the camera frame."""
    k = np.array(frame["K"])
    camera = Camera(
        "kitti", frame["width"], frame["height"], "brown", k[0, 0], k[1, 1], k[0, 2], k[1, 2], np.zeros(5)
    )
    up = np.array(plane["normal_up_cam"])
    up /= np.linalg.norm(up)
    along = np.array(axis) - up * (np.array(axis) @ up)
    along /= np.linalg.norm(along)
    away = np.cross(up, along)
    if away[0] * -1 < 0:  # the vehicles stand on the left: away from the camera is to the left
        along, away = -along, -away
    rotation = np.stack([along, away, up], axis=1)
    return RoadPose(camera, rotation, -up * plane["offset_m"])


def test_expected_heights_of_the_truth_file() -> None:
    truth = json.loads(shared("heights", "kitti_000217_truth.json").read_text())
    count = 0
    for frame in truth["frames"]:
        for vehicle in frame["vehicles"]:
            for key, plane in (
                ("expected_height_exact_plane_m", vehicle["exact_plane_for_this_vehicle"]),
                ("expected_height_scene_plane_m", frame["scene_ground_plane"]),
            ):
                pose = pose_from_plane(frame, plane, vehicle["vehicle_axis_cam"])
                for pair in vehicle["pairs"]:
                    found = measure_height(pose, pair["ground_px"], pair["top_px"])
                    if pair["angle_between_ray_and_side_plane_deg"] < 1.5 and found.status != "ok":
                        continue
                    assert found.height_m == pytest.approx(pair[key], abs=0.002), (
                        vehicle["id"],
                        found.reason,
                    )
                    count += 1
    assert count >= 28
