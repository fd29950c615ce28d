"""The demonstration's tyre contacts: clicked half a pixel beside the truth, they follow the road."""

import numpy as np

from sightline.demo.wheels import CLICK_NOISE_PX, both_in_sight
from sightline.geometry.camera import Camera
from sightline.geometry.road_pose import RoadPose
from tests.geometry.scenes import headings
from tests.simulation.scene import Scene, day_scene, low_light_scene
from tests.simulation.truth import pass_truth


def true_pose(scene: Scene) -> RoadPose:
    camera = scene.camera
    lens = Camera(
        "truth", camera.width_px, camera.height_px, "brown", camera.fx_px, camera.fy_px, camera.cx_px,
        camera.cy_px, np.array(camera.distortion),
    )  # fmt: skip
    return RoadPose(lens, camera.rotation(), camera.translation_m())


def test_traffic_of_both_videos_goes_along_the_road() -> None:
    rng = np.random.default_rng(1)
    for scene in (day_scene(), low_light_scene()):
        found = [both_in_sight(pass_truth(scene, one)) for one in scene.vehicles[:6]]
        pairs = [one for one in found if one is not None]
        assert len(pairs) >= 5
        clicks = np.array([[rear, front] for _, rear, front in pairs])
        exact = headings(true_pose(scene), clicks[:, 0], clicks[:, 1], CLICK_NOISE_PX)
        assert not isinstance(exact, str) and np.abs(exact.heading_rad[exact.used]).max() < 1e-6
        noisy = clicks + rng.normal(0.0, CLICK_NOISE_PX, clicks.shape)
        seen = headings(true_pose(scene), noisy[:, 0], noisy[:, 1], CLICK_NOISE_PX)
        assert not isinstance(seen, str)
        assert abs(seen.mean_rad) < 2.0 * seen.u_mean_rad and not seen.proposed
