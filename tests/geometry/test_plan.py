"""The plan of a site against Monte Carlo: board, corners, lens, insets and clicks drawn, heights measured."""

import dataclasses

import numpy as np
import pytest

from sightline.errors import BadInput
from sightline.geometry.board import road_points
from sightline.geometry.height import measure_heights
from sightline.geometry.insets import USUAL_INSETS
from sightline.geometry.multiframe import measure_frames
from sightline.geometry.plan import Plan, plan_site
from sightline.geometry.planar import refine
from sightline.geometry.road_pose import BoardOnRoad, RoadPose
from sightline.geometry.site import (
    BOARD_TOP_M,
    CORNER_SIGMA_PX,
    PLANNING_BOARD,
    Site,
    plain_camera,
    site_pose,
)
from tests.geometry.scenes import camera_of
from tests.geometry.simulate import Lens, Scene

# f (for both axes), cx, cy, then the distortion
LENS_SD = np.array([1.5, 1.5, 1.5, 2e-3, 3e-3, 2e-4, 2e-4, 2e-3])
_BOTH_AXES = np.array([[1, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
SPREAD = np.block([[_BOTH_AXES, np.zeros((4, 5))], [np.zeros((5, 3)), np.eye(5)]]) * LENS_SD
CAMERA = camera_of(Lens(), SPREAD @ SPREAD.T)
SITE = Site(1.5, 3.0)
PLACES = [
    SITE,
    Site(1.15, 4.0, board_distance_m=3.0, direction_rad=float(np.deg2rad(20))),
]


def planned(site: Site = SITE) -> Plan:
    return plan_site(CAMERA, site)


def of(plan: Plan, name: str):
    return next(t for t in plan.targets if t.target == name)


def scene_of(site: Site, tilt_rad: float) -> Scene:
    """The site again, in the simulation's own words; the board stands at Y = 0 from X = 0 on."""
    along = np.tan(site.direction_rad)
    eye = (0.25 - site.board_m * along, -site.board_m, site.camera_height_m)
    return Scene(Lens(), eye, np.rad2deg(site.direction_rad), np.rad2deg(tilt_rad))


def worn_board(scene: Scene, known: BoardOnRoad, rng: np.random.Generator) -> np.ndarray:
    """Corners of a board as it really stands: off in height, size, lean and roll, and bent."""
    grid = scene.board(6, 4, 0.1 + rng.normal(0, known.u_square_m), 0.0)
    across, down = np.meshgrid(np.linspace(-1, 1, 6), np.linspace(-1, 1, 4))
    bow = rng.normal(0, known.u_bow_m, 2)
    grid[..., 1] += bow[0] * (1 - across**2) + bow[1] * (1 - down**2)
    lean, roll = rng.normal(0, known.u_lean_rad, 2)
    about_x = np.array([[1, 0, 0], [0, np.cos(lean), -np.sin(lean)], [0, np.sin(lean), np.cos(lean)]])
    about_y = np.array([[np.cos(roll), 0, np.sin(roll)], [0, 1, 0], [-np.sin(roll), 0, np.cos(roll)]])
    top = 0.9 + rng.normal(0, known.u_reference_height_m)
    return grid.reshape(-1, 3) @ (about_x @ about_y).T + [0.0, 0.0, top]


def drawn(scene: Scene, start: RoadPose, rng: np.random.Generator) -> tuple[Scene, RoadPose]:
    """A scene with a lens that is off by its covariance, and the pose that somebody who does not know that
    finds from one noisy look at an imperfect board.
    """
    error = rng.normal(0, LENS_SD)
    lens = scene.lens
    k = tuple(np.array(lens.k) + error[3:])
    real = dataclasses.replace(scene, lens=Lens(lens.f + error[0], lens.cx + error[1], lens.cy + error[2], k))
    seen = real.look(worn_board(scene, start.board, rng)) + rng.normal(0, CORNER_SIGMA_PX, (24, 2))
    points = road_points(PLANNING_BOARD, "top", BOARD_TOP_M)
    found = refine(CAMERA, start.rotation, start.translation_m, points, seen)
    return real, RoadPose(CAMERA, found.rotation, found.translation)


def points_on_vehicle(scene: Scene, site: Site, along: float, inset: float, height: float) -> np.ndarray:
    x = scene.eye[0] + site.distance_m * np.tan(site.direction_rad) + along
    y = scene.eye[1] + site.distance_m
    return scene.look(np.array([(x, y, 0.0), (x, y + inset, height)]))


@pytest.mark.parametrize("draws", [200, pytest.param(400, marks=pytest.mark.proof)])
@pytest.mark.parametrize("site", PLACES, ids=["square", "oblique"])
def test_planned_uncertainty_is_the_scatter_of_measured_heights(site: Site, draws: int) -> None:
    plan = planned(site)
    scene, start = scene_of(site, plan.tilt_rad), site_pose(CAMERA, site)
    rng = np.random.default_rng(7)
    names = [t.target for t in plan.targets]
    heights = np.empty((draws, len(names)))
    for row in heights:
        real, pose = drawn(scene, start, rng)
        clicks = np.array(
            [
                points_on_vehicle(real, site, 0.0, rng.normal(t.inset_m, t.u_inset_m), t.height_m)
                for t in plan.targets
            ]
        )
        clicks += rng.normal(0, site.sigma_px, clicks.shape)
        insets = np.array([t.inset_m for t in plan.targets])
        row[:] = measure_heights(
            pose, clicks[:, 0], clicks[:, 1], 1.0, insets, with_uncertainty=False
        ).height_m
    for name, found in zip(names, heights.T, strict=True):
        target = of(plan, name)
        assert found.std() == pytest.approx(target.result.u_height_m, rel=0.1), name
        assert abs(found.mean() - target.height_m) < 4 * found.std() / np.sqrt(len(heights)) + 5e-4, name


@pytest.mark.parametrize("draws", [150, pytest.param(300, marks=pytest.mark.proof)])
def test_planned_two_frames_are_the_scatter_of_measured_ones(draws: int) -> None:
    plan = planned()
    eye = of(plan, "driver_eye")
    scene, start = scene_of(SITE, plan.tilt_rad), site_pose(CAMERA, SITE)
    rng = np.random.default_rng(11)
    rows = []
    for _ in range(draws):
        real, pose = drawn(scene, start, rng)
        heading = rng.normal(0, np.deg2rad(1.0))
        inset = rng.normal(eye.inset_m, eye.u_inset_m)
        pairs = []
        for along in (-1.0, 1.0):
            x, y = 0.25 + along * np.cos(heading), along * np.sin(heading)
            across = (-np.sin(heading) * inset, np.cos(heading) * inset)
            pairs.append(real.look(np.array([(x, y, 0.0), (x + across[0], y + across[1], eye.height_m)])))
        clicks = np.array(pairs) + rng.normal(size=(2, 2, 2))
        found = measure_frames(pose, clicks[:, 0], clicks[:, 1])
        rows.append((found.height.height_m, found.solved_inset_m - inset))
    height, inset_error = np.array(rows, dtype=float).T
    assert height.std() == pytest.approx(eye.two_frames.u_height_m, rel=0.1)
    assert inset_error.std() == pytest.approx(eye.two_frames.u_inset_m, rel=0.1)
    assert eye.two_frames.u_height_m < eye.result.u_height_m


def test_bias_of_an_ignored_inset_is_what_a_measurement_without_it_shows() -> None:
    plan = planned()
    scene = scene_of(SITE, plan.tilt_rad)
    pose = RoadPose(camera_of(Lens()), *scene.pose_arrays())
    for target in plan.targets:
        clicks = points_on_vehicle(scene, SITE, 0.0, target.inset_m, target.height_m)
        read = measure_heights(pose, clicks[:1], clicks[1:]).height_m[0]
        assert read - target.height_m == pytest.approx(target.bias_if_ignored_m, abs=1e-9), target.target


def test_curves_hold_the_plan_itself() -> None:
    plan = planned(dataclasses.replace(SITE, camera_height_m=1.2))
    for curve in plan.U95_over_distance:
        at = curve.at_m.index(3.0)
        assert curve.value_m[at] == pytest.approx(of(plan, curve.target).result.U95_height_m, rel=1e-6)
    for curve in plan.bias_over_height:
        at = int(np.argmin(np.abs(np.array(curve.at_m) - 1.2)))
        assert curve.value_m[at] == pytest.approx(of(plan, curve.target).bias_if_ignored_m)
    assert [c.target for c in plan.U95_over_distance] == [t.target for t in plan.targets]


def test_a_camera_at_the_eyes_height_does_not_mind_the_inset() -> None:
    low, high = (of(planned(Site(h, 3.0)), "driver_eye") for h in (1.15, 1.8))
    assert abs(low.bias_if_ignored_m) < 1e-9 < 0.05 < high.bias_if_ignored_m
    assert low.result.u_height_m < 0.7 * high.result.u_height_m


def test_the_surveys_own_insets_are_planned_with() -> None:
    wide = plan_site(CAMERA, SITE, {"driver_eye": (0.6, 0.3)})
    assert (of(wide, "driver_eye").inset_m, of(wide, "driver_eye").u_inset_m) == (0.6, 0.3)
    assert of(wide, "driver_eye").result.u_height_m > of(planned(), "driver_eye").result.u_height_m
    assert of(wide, "roof").inset_m == USUAL_INSETS["roof"][0]


def test_a_board_out_of_the_picture_gives_a_reason_and_no_number() -> None:
    plan = plan_site(camera_of(Lens()), Site(1.5, 5.0, board_distance_m=0.8))
    assert all(t.result.U95_height_m is None and "board" in str(t.result.reason) for t in plan.targets)
    assert all(v is None for curve in plan.U95_over_distance for v in curve.value_m)
    assert "would not show a board" in str(plan.advice[0])


def test_travel_beyond_the_picture_gives_a_reason() -> None:
    eye = of(planned(dataclasses.replace(SITE, travel_m=9.0)), "driver_eye")
    assert eye.result.status == "ok" and eye.two_frames.u_height_m is None
    assert "4.7 m of the wheel path" in str(eye.two_frames.reason)


def test_a_plain_camera_sees_its_field_of_view() -> None:
    camera = plain_camera(640, 480, np.deg2rad(67.0))
    assert np.rad2deg(2 * np.arctan(320 / camera.fx_px)) == pytest.approx(67.0)
    look = plan_site(camera, SITE).outlook
    assert np.rad2deg(look.right_rad - look.left_rad) == pytest.approx(67.0, abs=2.5)
    assert look.bottom_rad < 0 < look.top_rad


@pytest.mark.parametrize(
    ("site", "word"),
    [
        (Site(-1.0, 3.0), "camera height"),
        (Site(1.5, float("nan")), "wheel path"),
        (Site(1.5, 3.0, 0.0), "board"),
        (Site(1.5, 3.0, sigma_px=0.0), "click uncertainty"),
        (Site(1.5, 3.0, direction_rad=1.3), "direction"),
        (Site(1.5, 3.0, travel_m=0.0), "travel"),
    ],
)
def test_numbers_that_no_site_has_are_refused_in_words(site: Site, word: str) -> None:
    with pytest.raises(BadInput, match=word):
        plan_site(camera_of(Lens()), site)


@pytest.mark.parametrize(("size", "degrees"), [((0, 480), 67.0), ((640, 480), 179.0), ((640, 480), np.nan)])
def test_cameras_that_cannot_be_are_refused(size: tuple[int, int], degrees: float) -> None:
    with pytest.raises(BadInput, match="is out of range"):
        plain_camera(*size, np.deg2rad(degrees))


@pytest.mark.parametrize("site", PLACES)
def test_blur_and_frames_are_those_of_a_vehicle_that_drives_by(site) -> None:
    """Against the simulation's own camera: a point at eye height, a millisecond on."""
    plan = planned(site)
    scene = scene_of(site, plan.tilt_rad)
    across = site.distance_m - site.board_m
    middle = scene.eye[0] + site.distance_m * np.tan(site.direction_rad)
    eye = of(plan, "driver_eye").height_m
    for one in plan.passing:
        step = one.speed_mps * 0.5e-3
        there = scene.look([[middle - step, across, eye], [middle + step, across, eye]])
        assert one.blur_px == pytest.approx(np.hypot(*(there[1] - there[0])), rel=2e-3)
        assert one.longest_exposure_s == pytest.approx(2e-3 / one.blur_px)
        assert 0.0 <= one.shutter * one.longest_exposure_s - 1.0 < 0.1
        assert one.frames == tuple(int(plan.track_shown_m / one.speed_mps * rate) for rate in (30.0, 60.0))
    assert [one.frames[0] for one in plan.passing] == sorted(
        (o.frames[0] for o in plan.passing), reverse=True
    )
