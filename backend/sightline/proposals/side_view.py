"""A frame's arrays, and where a road point is seen."""

import numpy as np
from numpy.typing import NDArray

from sightline.arrays import Floats
from sightline.geometry.camera import project
from sightline.geometry.road_pose import RoadPose

Bgr = NDArray[np.uint8]
Plane = NDArray[np.float32]


def pixel_of(pose: RoadPose, x_m: float, y_m: float, z_m: float) -> tuple[float, float]:
    """Where a road point is seen, pixels."""
    found: Floats = project(pose.camera, pose.to_camera(np.array([[x_m, y_m, z_m]])))[0]
    return float(found[0]), float(found[1])
