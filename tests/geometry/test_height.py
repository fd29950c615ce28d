"""Heights: exact, with the right uncertainty, and refused with a reason where there are none."""

import dataclasses

import numpy as np
import pytest

from sightline.coverage import COVERAGE_95
from sightline.geometry.arrays import exp_rotation
from sightline.geometry.gradient import gradient
from sightline.geometry.height import height_both, measure_height, measure_heights
from sightline.geometry.ray_intersection import REASONS, intersect_rays
from sightline.geometry.road_pose import BoardOnRoad, RoadPose
from tests.geometry.scenes import LENSES, camera_of, pose_of
from tests.geometry.simulate import Lens, Scene

BOARD = BoardOnRoad(6, 4, 0.1, "top", 0.9, 0.003, 0.005, 3.0)


def scenes(count: int, seed: int):
    """Random cameras and vehicles whose two points lie in the picture."""
    rng = np.random.default_rng(seed)
    while count:
        lens = LENSES[rng.integers(len(LENSES))]
        eye = (rng.uniform(-1, 1), -rng.uniform(1.5, 6), rng.uniform(0.9, 2.5))
        scene = Scene(lens, eye, rng.uniform(-35, 35), rng.uniform(-2, 20), rng.uniform(-60, 60))
        across = rng.uniform(-0.5, 1.0)
        inset = rng.uniform(0, 1.2)
        height = rng.uniform(0.3, 2.2)
        ahead = (across - eye[1]) * np.tan(np.radians(scene.yaw))
        x = eye[0] + ahead + rng.uniform(-1.5, 1.5, 2)
        contact, target = (x[0], across, 0.0), (x[1], across + inset, height)
        clicks = scene.look([contact, target])
        if pose_of(scene).camera.inside(clicks).all():
            count -= 1
            yield scene, np.array(contact), clicks, inset, height


def test_formula_error_below_a_nanometre_on_distorted_scenes() -> None:
    for scene, contact, clicks, inset, height in scenes(150, 3):
        found = measure_height(pose_of(scene), clicks[0], clicks[1], inset_m=inset)
        assert found.status == "ok", found.reason
        assert found.height_m == pytest.approx(height, abs=1e-9)
        assert (found.x_m, found.y_m) == pytest.approx(tuple(contact[:2]), abs=1e-8)
        assert found.distance_m == pytest.approx(np.linalg.norm(contact - scene.eye), abs=1e-8)


def test_ignored_inset_costs_the_closed_form_bias() -> None:
    """bias = (Hc - h) inset / (D + inset), metrology 2.2; it holds for any attitude and any lens."""
    for scene, contact, clicks, inset, height in scenes(200, 4):
        corrected, uncorrected = height_both(pose_of(scene), clicks[0], clicks[1], 1.0, inset, 0.1)
        d = contact[1] - scene.eye[1]
        bias = (scene.eye[2] - height) * inset / (d + inset)
        assert corrected.height_m == pytest.approx(height, abs=1e-9)
        if uncorrected.height_m is not None:
            assert uncorrected.height_m - height == pytest.approx(bias, abs=1e-9)
            entry = next(e.u_m for e in corrected.budget if e.source == "inset")
            assert entry == pytest.approx(abs(height - scene.eye[2]) / (d + inset) * 0.1, abs=1e-9)


def test_table_of_the_bias() -> None:
    """Three cells of the table in metrology 2.2, to the millimetre that it prints."""
    for height, inset, distance, wanted_mm in (
        (1.10, 0.40, 3.0, 47),
        (1.26, 0.85, 2.0, 72),
        (1.90, 1.20, 1.5, -178),
    ):
        scene = Scene(Lens(f=200.0), (0.0, 0.0, 1.5), 0.0, 0.0)
        clicks = scene.look([(0, distance, 0), (0, distance + inset, height)])
        found = measure_height(pose_of(scene), clicks[0], clicks[1])
        assert found.height_m is not None, found.reason
        assert round(1000 * (found.height_m - height)) == wanted_mm


def one() -> tuple[RoadPose, np.ndarray, float]:
    lens = Lens()
    scene = Scene(lens, (0.3, -3.0, 1.5), 12.0, 6.0, 4.0)
    clicks = scene.look([(1.0, 0.1, 0.0), (0.6, 0.55, 1.16)])
    rng = np.random.default_rng(5)
    a = rng.normal(size=(15, 15)) * np.array([*[0.4] * 4, *[1e-3] * 5, *[1e-3] * 6])[:, None]
    return pose_of(scene, covariance=a @ a.T, board=BOARD), clicks, 0.45


def moved(pose: RoadPose, index: int, step: float) -> RoadPose:
    """The pose with one of its parameters (docs/formats.md) moved."""
    camera = pose.camera
    v = np.array([camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px, *camera.distortion])
    r, t = np.zeros(3), np.zeros(3)
    n = len(v)
    if index < n:
        v[index] += step
    elif index < n + 3:
        r[index - n] = step
    else:
        t[index - n - 3] = step
    lens = dataclasses.replace(camera, fx_px=v[0], fy_px=v[1], cx_px=v[2], cy_px=v[3], distortion=v[4:])
    turn = exp_rotation(r)
    return RoadPose(lens, turn @ pose.rotation, turn @ pose.translation_m + t)


def test_gradient_equals_differences() -> None:
    pose, clicks, inset = one()
    seen = intersect_rays(pose, clicks[:1], clicks[1:], inset)
    g = gradient(pose, seen)

    def height(
        pose: RoadPose = pose, c: np.ndarray = clicks[0], t: np.ndarray = clicks[1], d: float = inset
    ) -> float:
        return float(intersect_rays(pose, c.reshape(1, 2), t.reshape(1, 2), d).height_m[0])

    e = 1e-6
    for axis in range(2):
        d = np.eye(2)[axis] * e
        assert g.contact[axis, 0] == pytest.approx(
            (height(c=clicks[0] + d) - height(c=clicks[0] - d)) / (2 * e), rel=1e-6
        )
        assert g.target[axis, 0] == pytest.approx(
            (height(t=clicks[1] + d) - height(t=clicks[1] - d)) / (2 * e), rel=1e-6
        )
    assert g.inset[0] == pytest.approx((height(d=inset + e) - height(d=inset - e)) / (2 * e), rel=1e-6)
    for i, name in enumerate(pose.parameters):
        step = 1e-4 if name.endswith("_px") else 1e-6
        numeric = (height(moved(pose, i, step)) - height(moved(pose, i, -step))) / (2 * step)
        assert g.parameters[i, 0] == pytest.approx(numeric, rel=2e-6, abs=1e-9), name


def test_lean_and_board_height_equal_the_closed_forms() -> None:
    """Level camera, metrology 2.1: dh/dlean = (h/Hc)(Db - D) + h (Hc - h)/D; dh/dheight = h/Hc."""
    scene = Scene(Lens(k=(0.0,) * 5), (0.0, -2.4, 1.5), 0.0, 0.0)
    h, distance, board = 0.9, 3.5, 2.4
    clicks = scene.look([(0, distance - 2.4, 0), (0.2, distance - 2.4, h)])
    found = measure_height(pose_of(scene, board=BOARD), clicks[0], clicks[1])
    entries = {e.source: e.u_m for e in found.budget}
    slope = (h / 1.5) * (board - distance) + h * (1.5 - h) / distance
    assert entries["board lean"] == pytest.approx(abs(slope) * BOARD.u_lean_rad, rel=1e-9)
    assert entries["board height"] == pytest.approx(h / 1.5 * BOARD.u_reference_height_m, rel=1e-9)


def test_budget_adds_up() -> None:
    pose, clicks, inset = one()
    found = measure_height(pose, clicks[0], clicks[1], 1.3, inset, 0.1)
    assert found.u_height_m is not None and found.U95_height_m is not None
    assert found.u_height_m == pytest.approx(np.sqrt(sum(e.u_m**2 for e in found.budget)), rel=1e-12)
    assert found.U95_height_m == pytest.approx(COVERAGE_95 * found.u_height_m)
    assert len({e.source for e in found.budget}) == 7
    no_covariance = dataclasses.replace(pose, covariance=None)
    bare = measure_height(no_covariance, clicks[0], clicks[1], 1.3, inset, 0.1)
    assert any("unknown" in str(flag) for flag in bare.flags)
    assert bare.u_height_m is not None and bare.u_height_m < found.u_height_m


@pytest.mark.parametrize("count", [150, pytest.param(300, marks=pytest.mark.proof)])
def test_interval_covers_95_percent(count: int) -> None:
    """Clicks, lens and pose drawn jointly from the stated covariance; the height re-solved each time."""
    pose, clicks, inset = one()
    scale = 0.15
    covariance = pose.covariance * scale**2
    pose = dataclasses.replace(pose, covariance=covariance, board=None)
    rng = np.random.default_rng(6)
    draws = rng.multivariate_normal(np.zeros(15), covariance, count)
    hits = 0
    errors = []
    for draw in draws:
        moved_pose = pose
        for i in range(15):
            moved_pose = moved(moved_pose, i, draw[i]) if i < 9 else moved_pose
        turn = exp_rotation(draw[9:12])
        moved_pose = RoadPose(
            moved_pose.camera, turn @ pose.rotation, turn @ pose.translation_m + draw[12:], covariance
        )
        noisy = clicks + rng.normal(size=(2, 2))
        target_inset = inset + rng.normal() * 0.05
        found = measure_height(moved_pose, noisy[0], noisy[1], 1.0, target_inset, 0.05)
        assert found.height_m is not None and found.U95_height_m is not None
        errors.append((found.height_m - 1.16) / (found.U95_height_m / COVERAGE_95))
        hits += abs(found.height_m - 1.16) <= found.U95_height_m
    assert 0.92 <= hits / len(draws) <= 0.98
    assert np.std(errors) == pytest.approx(1.0, abs=0.1)


def test_many_equal_one_by_one() -> None:
    pose, _, _ = one()
    rng = np.random.default_rng(7)
    contacts = rng.uniform(-20, 660, (300, 2))
    targets = rng.uniform(-20, 660, (300, 2))
    sigma = rng.uniform(0.3, 2, 300)
    inset = rng.uniform(0, 1, 300)
    u_inset = rng.uniform(0, 0.3, 300)
    contacts[3] = np.nan
    many = measure_heights(pose, contacts, targets, sigma, inset, u_inset)
    for i in range(300):
        single = measure_height(pose, contacts[i], targets[i], sigma[i], inset[i], u_inset[i])
        assert single.reason == many.reason(i)
        if single.status == "ok":
            assert single.height_m == pytest.approx(many.height_m[i], rel=1e-12)
            assert single.u_height_m == pytest.approx(many.u_height_m[i], rel=1e-12)
            assert single.height_m > 0
        else:
            assert np.isnan(many.height_m[i])
            assert single.height_m is single.u_height_m is single.x_m is None
    assert many.ok.any() and not many.ok.all()


@pytest.mark.parametrize(
    ("contact", "target", "words"),
    [
        ((np.nan, 300), (300, 100), "not a finite"),
        ((700, 300), (300, 100), "contact point lies outside the frame"),
        ((300, 300), (300, -5), "target point lies outside the frame"),
        ((320, 100), (300, 90), "horizon"),
        ((320, 300), (320, 400), "swapped"),
        ((320, 300), (320, 300), "on or below the road"),
    ],
)
def test_reasons(contact, target, words) -> None:
    scene = Scene(Lens(), (0.0, -3.0, 1.5), 0.0, 5.0)
    found = measure_height(pose_of(scene), contact, target)
    assert found.status == "not_measurable"
    assert found.reason is not None and words in str(found.reason)
    assert found.height_m is None and found.U95_height_m is None and found.budget == ()


def test_swapped_clicks_of_real_vehicles_never_give_a_height() -> None:
    for scene, _, clicks, _, _ in scenes(150, 8):
        assert measure_height(pose_of(scene), clicks[1], clicks[0]).status == "not_measurable"


def test_side_plane_edge_on() -> None:
    scene = Scene(Lens(), (0.0, 0.0, 1.5), 90.0, 5.0)  # looks along the traffic
    clicks = scene.look([(6.0, 0.02, 0.0), (6.0, 0.02, 1.2)])
    found = measure_height(pose_of(scene), clicks[0], clicks[1])
    assert found.reason is not None and "edge-on" in str(found.reason)
    behind = scene.look([(6.0, -1.5, 0.0), (6.0, -1.5, 1.2)])
    assert "behind" in str(measure_height(pose_of(scene), behind[0], behind[1]).reason)


def test_outside_the_valid_radius() -> None:
    lens = Lens(f=400.0, k=(-0.42, 0.22, 0.0, 0.0, -0.06))
    scene = Scene(lens, (0.0, -3.0, 1.5), 0.0, 5.0)
    found = measure_height(pose_of(scene), (0, 479), (320, 200))
    assert found.reason is not None and "valid radius" in str(found.reason)


def test_camera_below_the_road() -> None:
    pose = pose_of(Scene(Lens(), (0.0, -3.0, -1.5), 0.0, 5.0))
    assert "below the road" in str(measure_height(pose, (320, 400), (320, 200)).reason)


@pytest.mark.parametrize(
    "values", [(-1.0, 0.0, 0.0), (np.nan, 0.0, 0.0), (1.0, np.inf, 0.0), (1.0, 0.0, -0.1)]
)
def test_bad_sigma_or_inset(values) -> None:
    pose, clicks, _ = one()
    found = measure_height(pose, clicks[0], clicks[1], *values)
    assert found.status == "not_measurable" and found.reason in REASONS
    many = measure_heights(pose, clicks[:1], clicks[1:], *values)
    assert not many.ok.any()


def test_square_camera_of_another_size_is_named() -> None:
    from sightline.errors import BadInput
    from sightline.geometry.camera import require_size

    with pytest.raises(BadInput, match="800x600"):
        require_size(camera_of(Lens()), 800, 600, "clip.mp4")
