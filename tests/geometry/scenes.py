"""Bridges between the independent simulation and the code under test, and where the real data are."""

import os
from pathlib import Path

import numpy as np
import pytest

from sightline.geometry.camera import Camera
from sightline.geometry.road_pose import RoadPose
from sightline.geometry.traffic import Headings, headings_of_pairs, summary_of_headings
from sightline.messages.said import Said
from tests.geometry.simulate import Lens, Scene

LENSES = (
    Lens(),
    Lens(k=(0.0, 0.0, 0.0, 0.0, 0.0)),
    Lens(k=(-0.1, 0.02, 1e-3, -8e-4, 0.01, 0.15, 0.03, 0.005)),
    Lens(f=300.0, k=(0.073, -0.020, 0.016, -0.0014), kind="fisheye"),
)


def camera_of(lens: Lens, covariance: np.ndarray | None = None) -> Camera:
    k = np.array(lens.k)
    return Camera(
        "simulated", lens.width, lens.height, lens.kind, lens.f, lens.f, lens.cx, lens.cy, k,
        covariance=covariance,
    )  # fmt: skip


def pose_of(scene: Scene, **more: object) -> RoadPose:
    rotation, translation = scene.pose_arrays()
    return RoadPose(camera_of(scene.lens), rotation, translation, **more)  # type: ignore[arg-type]


def headings(pose: RoadPose, first_px: np.ndarray, second_px: np.ndarray, sigma_px: float) -> Headings | str:
    """The traffic's direction from both tyre contacts (N, 2) of N vehicles, as the checks put it together."""
    pairs = headings_of_pairs(pose, first_px, second_px, sigma_px)
    return summary_of_headings(pose, [pair for pair in pairs if not isinstance(pair, Said)])


def shared(*parts: str) -> Path:
    """A folder or file of the real data; the test is skipped where it is absent."""
    root = Path(__file__).resolve().parents[2]
    data = Path(os.environ.get("SIGHTLINE_SHARED_DATA", root.parent / "shared" / "data"))
    path = data.joinpath(*parts)
    if not path.exists():
        pytest.skip("the folder of real data is not here; set SIGHTLINE_SHARED_DATA to its place")
    return path
