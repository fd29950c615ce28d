"""Parsed poses: what was used last stays."""

from sightline.geometry.documents import pose_to_dict
from sightline.measurements.height_of_clicks import PoseCache
from tests.geometry.scenes import pose_of
from tests.geometry.simulate import Lens, Scene


def test_the_pose_used_last_stays() -> None:
    document = pose_to_dict(pose_of(Scene(Lens(), (0.3, -3.0, 1.5), 12.0, 6.0, 4.0)))
    poses = PoseCache(2)
    first = poses.put(1, document)
    poses.put(2, document)
    assert poses.get(1) is first
    poses.put(3, document)
    assert poses.get(1) is first and poses.get(2) is None and poses.get(3) is not None
