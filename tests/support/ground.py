"""A recording with a known road pose: a camera 1.5 m above the road, 3 m in front of it, looking across."""

from dataclasses import dataclass, replace
from typing import Any
from uuid import uuid4

import numpy as np

from sightline.cameras.calibrations.store import add_calibration
from sightline.cameras.store import create_camera
from sightline.geometry.camera import Camera, project
from sightline.geometry.documents import camera_to_dict, pose_to_dict
from sightline.geometry.road_pose import BoardOnRoad, RoadPose
from sightline.infra.services import Services
from sightline.messages.said import Said
from sightline.poses import store
from sightline.reviews.plan_store import choose_review_plan
from sightline.vehicles.proposing.plan_store import choose_free_plan
from tests.support.app import FRAME_HEIGHT, FRAME_WIDTH, Client

FOCAL_PX = 150.0
CENTRE_M = (0.0, -3.0, 1.5)


def flat_camera(width: int = FRAME_WIDTH, height: int = FRAME_HEIGHT, focal_px: float = FOCAL_PX) -> Camera:
    """A lens without distortion whose principal point is the middle of the picture."""
    middle = ((width - 1) / 2, (height - 1) / 2)
    return Camera("flat", width, height, "brown", focal_px, focal_px, *middle, np.zeros(5))


def pose_above_road() -> RoadPose:
    """Looks along +Y from CENTRE_M, level, with a board of known place."""
    rotation = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    board = BoardOnRoad(9, 6, 0.1, "top", 1.1, 0.003, 0.005, 3.0)
    return RoadPose(flat_camera(), rotation, -rotation @ np.array(CENTRE_M), None, board, 10, 0.1)


def pixel(x_m: float, y_m: float, z_m: float) -> list[float]:
    """Where a road point appears."""
    pose = pose_above_road()
    point = project(pose.camera, pose.to_camera(np.array([[x_m, y_m, z_m]])))[0]
    return [float(point[0]), float(point[1])]


@dataclass(frozen=True)
class Ground:
    """Ids of what was laid down."""

    survey_id: int
    recording_id: int
    camera_id: int
    calibration_id: int
    pose_id: int


def store_calibration(services: Services, survey_id: int, camera: Camera) -> tuple[int, int]:
    """(camera id, calibration id) of a stored calibration."""
    with services.writing() as session:
        body = create_camera(session, survey_id, name="Test camera", actor=None)
        made = add_calibration(
            session,
            body.id,
            source="import",
            document=camera_to_dict(camera),
            trusted=True,
            warnings=[],
            coverage=[],
            views=[],
            summary=Said("said", sentence="for tests"),
            actor=None,
        )
    return body.id, made.id


def add_pose(
    services: Services,
    recording_id: int,
    calibration_id: int,
    camera: Camera,
    *,
    attach: bool = True,
    **place: Any,
) -> int:
    """Store the pose above the road (or in another `place`), by default in force for the recording."""
    document = pose_to_dict(replace(pose_above_road(), camera=camera, **place))
    with services.writing() as session:
        made = store.add_pose(
            session,
            recording_id,
            calibration_id=calibration_id,
            first_frame=0,
            last_frame=3,
            rms_px=0.1,
            distance_m=3.0,
            summary=[],
            document=document,
            warnings=[],
            expected=[],
            overlay={"grid": [], "iso_heights": [], "axes": None, "corners_px": []},
            attach=attach,
            actor=None,
        )
    return made.id


def lay_ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    """Store camera, calibration and pose, in force for the recording; nothing is clicked blind or free."""
    with services.writing() as session:
        choose_review_plan(session, survey_id, blind_one_in=0, version=0, actor=None)
        choose_free_plan(session, survey_id, free_one_in=0, version=0, actor=None)
    camera_id, calibration_id = store_calibration(services, survey_id, flat_camera())
    pose_id = add_pose(services, recording_id, calibration_id, flat_camera())
    return Ground(survey_id, recording_id, camera_id, calibration_id, pose_id)


def add_vehicle(client: Client, recording_id: int, **fields: Any) -> dict[str, Any]:
    """A vehicle record."""
    body = {"first_frame": 0, "last_frame": 8, **fields}
    made: dict[str, Any] = client.made(f"/recordings/{recording_id}/vehicles", body)
    return made


def clicks(height_m: float = 1.2, **more: Any) -> dict[str, Any]:
    """A click pair on a spot `height_m` above the wheel's contact, in the side plane."""
    body = {
        "target": "roof",
        "frame": 2,
        "contact": pixel(0.2, 0.0, 0.0),
        "target_point": pixel(0.6, 0.0, height_m),
        "inset_m": 0.0,
        "u_inset_m": 0.0,
    }
    return {**body, **more}


def measure(client: Client, vehicle_id: int, **more: Any) -> dict[str, Any]:
    """A stored measurement."""
    body = {"client_key": str(uuid4()), **clicks(**more)}
    made: dict[str, Any] = client.made(f"/vehicles/{vehicle_id}/measurements", body)
    return made
