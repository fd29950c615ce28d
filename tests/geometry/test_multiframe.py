"""Two frames and more: the inset is solved for, with honest uncertainties."""

import dataclasses

import numpy as np
import pytest

from sightline.coverage import COVERAGE_95
from sightline.geometry import multiframe
from sightline.geometry.height import measure_height
from sightline.geometry.multiframe import measure_frames
from sightline.geometry.road_pose import BoardOnRoad, RoadPose
from tests.geometry.scenes import LENSES, pose_of
from tests.geometry.simulate import Lens, Scene

SQUARE_ON = Scene(Lens(), (0.0, -3.0, 1.5), 0.0, 0.0)


def clicks(scene: Scene, travels, heading=0.0, start=(-1.0, 0.0), ahead=-0.3, inset=0.45, height=1.16):
    t = np.array([np.cos(heading), np.sin(heading)])
    n = np.array([-t[1], t[0]])
    ground = [np.array(start) + d * t for d in travels]
    contacts = [(*g, 0.0) for g in ground]
    targets = [(*(g + ahead * t + inset * n), height) for g in ground]
    return scene.look(contacts), scene.look(targets)


@pytest.mark.parametrize("lens", LENSES)
@pytest.mark.parametrize(
    ("travels", "heading"), [((0, 2.0), 0.0), ((0, 0.8, 1.7), 0.03), ((0, -1.2, -2.0), -0.02)]
)
def test_exact_clicks_give_exact_heights_and_insets(lens, travels, heading) -> None:
    scene = Scene(lens, (0.1, -3.0, 1.5), 8.0, 5.0, 3.0)
    contacts, targets = clicks(scene, travels, heading, start=(-1.0 if travels[1] > 0 else 1.0, 0.2))
    found = measure_frames(pose_of(scene), contacts, targets, u_heading_rad=None)
    assert found.height.status == "ok", found.height.reason
    assert found.height.height_m == pytest.approx(1.16, abs=1e-9)
    assert found.solved_inset_m == pytest.approx(0.45, abs=1e-8)
    assert found.heading_rad == pytest.approx(heading, abs=1e-8)
    assert found.travel_m == pytest.approx(abs(travels[-1]), abs=1e-8)
    assert found.frames == len(travels)


@pytest.mark.parametrize("count", [250, pytest.param(500, marks=pytest.mark.proof)])
def test_scatter_is_as_stated_and_meets_the_goal(count: int) -> None:
    """D 3 m, 2 m of travel, 1 px: at most 6.5 mm and 35 mm, bias at most 0.5 mm (metrology 4)."""
    contacts, targets = clicks(SQUARE_ON, (0.0, 2.0))
    pose = pose_of(SQUARE_ON)
    rng = np.random.default_rng(1)
    rows = []
    for _ in range(count):
        found = measure_frames(pose, contacts + rng.normal(size=(2, 2)), targets + rng.normal(size=(2, 2)))
        assert found.height.height_m is not None
        rows.append(
            (found.height.height_m, found.height.u_height_m, found.solved_inset_m, found.u_solved_inset_m)
        )
    h, u, inset, u_inset = np.array(rows, dtype=float).T
    assert h.std() <= 0.0065 and inset.std() <= 0.035
    assert abs(h.mean() - 1.16) <= 0.0005 + 2 * h.std() / np.sqrt(count)
    assert h.std() == pytest.approx(u.mean(), rel=0.09)
    assert inset.std() == pytest.approx(u_inset.mean(), rel=0.09)
    assert 0.92 < (np.abs(h - 1.16) < COVERAGE_95 * u).mean() < 0.98


def test_more_frames_and_more_travel_say_more() -> None:
    pose = pose_of(SQUARE_ON)
    u = []
    for travels in ((0, 0.8), (0, 1.5), (0, 2.0), (0, 0.83, 1.67, 2.5)):
        height = measure_frames(pose, *clicks(SQUARE_ON, travels)).height
        assert height.u_height_m is not None
        u.append(height.u_height_m)
    assert u == sorted(u, reverse=True)
    assert u[-1] < 0.0048


def test_budget_holds_lens_pose_lean_and_board_height() -> None:
    board = BoardOnRoad(6, 4, 0.1, "top", 0.9, 0.003, 0.005, 3.0)
    rng = np.random.default_rng(2)
    a = rng.normal(size=(15, 15)) * np.array([*[0.3] * 4, *[1e-3] * 5, *[1e-3] * 6])[:, None]
    pose = dataclasses.replace(pose_of(SQUARE_ON), covariance=a @ a.T, board=board)
    found = measure_frames(pose, *clicks(SQUARE_ON, (0, 2.0)))
    entries = {e.source: e.u_m for e in found.height.budget}
    assert set(entries) == {"clicks", "heading", "lens and pose", "board lean", "board roll", "board height"}
    assert found.height.u_height_m == pytest.approx(np.sqrt(sum(v**2 for v in entries.values())))
    # a road plane 3 mm off scales every height by 3 mm / Hc
    assert entries["board height"] == pytest.approx(1.16 / 1.5 * 0.003, rel=0.05)


def test_lens_and_pose_part_equals_resolving() -> None:
    """Move the pose, solve again: the height moves as the budget's derivative says."""
    step = 1e-4
    a = np.zeros((15, 15))
    a[9, 9] = step**2  # rx alone
    pose = pose_of(SQUARE_ON)
    contacts, targets = clicks(SQUARE_ON, (0, 2.0), heading=0.01)
    contacts, targets = contacts + 0.3, targets - np.array([0.2, -0.1])
    stated = {
        e.source: e.u_m
        for e in measure_frames(dataclasses.replace(pose, covariance=a), contacts, targets).height.budget
    }
    c, s = np.cos(step), np.sin(step)
    turn = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
    moved = RoadPose(pose.camera, turn @ pose.rotation, turn @ pose.translation_m)
    before, after = (measure_frames(p, contacts, targets).height.height_m for p in (pose, moved))
    assert before is not None and after is not None
    assert stated["lens and pose"] == pytest.approx(abs(after - before), rel=0.02)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda c, t: (c[:1], t[:1]), "at least two frames"),
        (lambda c, t: (c, t[:1]), "at least two frames"),
        (lambda c, t: (np.array([c[0], c[0] + 1]), np.array([t[0], t[0] + 1])), "further apart"),
        (lambda c, t: (c * [1, np.nan], t), "Frame 1 of 2"),
        (lambda c, t: (np.array([c[0], [c[1][0], 5.0]]), t), "horizon"),
        (lambda c, t: (t, c), "below the road"),
    ],
)
def test_reasons(change, words) -> None:
    contacts, targets = clicks(SQUARE_ON, (0.0, 2.0))
    found = measure_frames(pose_of(SQUARE_ON), *change(contacts, targets))
    assert found.height.status == "not_measurable"
    assert words in str(found.height.reason)
    assert found.solved_inset_m is None and found.height.height_m is None


@pytest.mark.parametrize(
    ("inset", "measured"),
    [(-0.4, True), (0.3, True), (2.5, True), (2.8, False), (3.44, False), (-0.7, False)],
)
def test_an_inset_that_no_vehicle_has_gives_no_height(inset: float, measured: bool) -> None:
    """A second frame with the roof clicked where it is not: 3.44 m once made a roof 0.25 m too high."""
    contacts, targets = clicks(SQUARE_ON, (0.0, 1.0), inset=inset, height=1.3)
    found = measure_frames(pose_of(SQUARE_ON), contacts, targets)
    if measured:
        assert found.height.height_m == pytest.approx(1.3, abs=1e-6)
        assert found.solved_inset_m == pytest.approx(inset, abs=1e-6)
    else:
        assert (found.height.status, found.height.height_m) == ("not_measurable", None)
        assert f"inset of {inset:.2f} m is not plausible" in str(found.height.reason)


def test_clicks_that_do_not_belong_together_are_flagged() -> None:
    contacts, targets = clicks(SQUARE_ON, (0.0, 2.0))
    found = measure_frames(pose_of(SQUARE_ON), contacts, targets + np.array([[0, 0], [0, 25.0]]))
    assert found.height.status == "not_measurable" or any("do not fit" in str(f) for f in found.height.flags)


@pytest.mark.parametrize("lens_known", [True, False])
def test_what_the_pose_does_not_say_is_told_as_for_one_frame(lens_known) -> None:
    contacts, targets = clicks(SQUARE_ON, (0.0, 2.0))
    bare = pose_of(SQUARE_ON)
    bow = ((0.0,) * 6,) * 2
    board = BoardOnRoad(6, 4, 0.1, "top", 0.9, 0.003, 0.005, 3.0, 1e-4, 5e-4, bow)
    camera = dataclasses.replace(bare.camera, covariance=np.eye(9) * 1e-9) if lens_known else bare.camera
    full = dataclasses.replace(bare, camera=camera, covariance=np.eye(15) * 1e-9, board=board)
    for pose, lacking in ((bare, 2), (full, 0 if lens_known else 1)):
        told = [
            {f for f in found.flags if "not included" in str(f) or "of the lens is unknown" in str(f)}
            for found in (
                measure_frames(pose, contacts, targets).height,
                measure_height(pose, contacts[0], targets[0]),
            )
        ]
        assert told[0] == told[1]
        assert len(told[0]) == lacking


def test_clicks_that_do_not_settle_have_a_reason_instead_of_a_height() -> None:
    contacts, targets = [[127.0, 425.0], [335.0, 300.0]], [[97.0, 174.0], [320.0, 354.0]]
    found = measure_frames(pose_of(SQUARE_ON), contacts, targets)
    assert (found.height.status, found.height.height_m) == ("not_measurable", None)
    assert "do not fit one moving vehicle" in str(found.height.reason)


@pytest.mark.parametrize("sigma_px", [1.0, 0.0])
def test_rounds_that_run_out_give_no_height(monkeypatch: pytest.MonkeyPatch, sigma_px: float) -> None:
    contacts, targets = clicks(SQUARE_ON, (0.0, 2.0))
    targets = targets + np.array([[3.0, -2.0], [-4.0, 1.0]])
    assert measure_frames(pose_of(SQUARE_ON), contacts, targets, sigma_px).height.status == "ok"
    monkeypatch.setattr(multiframe, "_ROUNDS", 1)
    found = measure_frames(pose_of(SQUARE_ON), contacts, targets, sigma_px)
    assert "do not fit one moving vehicle" in str(found.height.reason) and found.solved_inset_m is None
