"""Road poses: exact on exact corners, honest on noisy ones, refused with a reason."""

import dataclasses

import cv2
import numpy as np
import pytest

from sightline.coverage import COVERAGE_95
from sightline.errors import BadInput
from sightline.geometry.arrays import freeze_array
from sightline.geometry.board import Board, canonical_order
from sightline.geometry.corners import Corners, not_found
from sightline.geometry.height import measure_height
from sightline.geometry.pose import expected_u, pose_from_corners
from sightline.geometry.road_pose import Reference
from sightline.messages.said import Said
from tests.geometry.scenes import LENSES, camera_of, pose_of
from tests.geometry.simulate import Lens, Scene

BOARD = Board(6, 4, 0.1)
REFERENCE = Reference("top", 1.5)


def corners(
    scene: Scene, noise: np.ndarray | float = 0.0, board: Board = BOARD, top_m: float = 1.5
) -> Corners:
    points = scene.look(scene.board(board.columns, board.rows, board.square_m, top_m).reshape(-1, 3))
    grid = points.reshape(board.rows, board.columns, 2) + noise
    return Corners(True, freeze_array(grid), board, None, 2.0, "simulated")


def facing(yaw: float = 20.0, distance: float = 3.0, roll: float = 0.0, lens: Lens | None = None) -> Scene:
    return Scene(lens or Lens(), (0.25 - distance * np.tan(np.radians(yaw)), -distance, 1.4), yaw, 4.0, roll)


@pytest.mark.parametrize("lens", LENSES)
@pytest.mark.parametrize(("yaw", "roll"), [(0.0, 0.0), (25.0, -60.0), (-30.0, 45.0), (5.0, 60.0)])
def test_exact_corners_give_exact_heights(lens: Lens, yaw: float, roll: float) -> None:
    """Dupuis' chain end to end: 3e-12 m is the figure to meet, 1e-9 m the limit."""
    scene = facing(yaw, 3.0, roll, lens)
    pose = pose_from_corners(camera_of(lens), [corners(scene)], BOARD, REFERENCE)
    assert np.abs(pose.rotation - scene.axes()).max() < 1e-9
    assert pose.centre_m == pytest.approx(scene.eye, abs=1e-9)
    clicks = scene.look([(0.4, 0.3, 0.0), (0.2, 0.75, 1.16)])
    found = measure_height(pose, clicks[0], clicks[1], inset_m=0.45)
    if pose.camera.inside(clicks).all():
        assert found.height_m == pytest.approx(1.16, abs=1e-9)


def test_square_on_board_is_no_degree_off() -> None:
    """OpenCV's IPPE with z towards the camera is off by 2.6 degrees for a board seen exactly square-on."""
    scene = Scene(Lens(k=(0.0,) * 5), (0.25, -3.0, 1.35), 0.0, 0.0)
    pose = pose_from_corners(camera_of(scene.lens), [corners(scene)], BOARD, REFERENCE)
    assert np.abs(pose.rotation - scene.axes()).max() < 1e-9


def test_bottom_reference_and_transposed_board() -> None:
    scene = facing()
    pose = pose_from_corners(camera_of(Lens()), [corners(scene)], BOARD, Reference("bottom", 1.2))
    assert pose.centre_m == pytest.approx(scene.eye, abs=1e-9)
    assert pose.board is not None
    assert (pose.board.columns, pose.board.rows, pose.board.reference) == (6, 4, "bottom")
    assert pose.board.distance_m == pytest.approx(
        np.linalg.norm(np.array(scene.eye) - [0.25, 0, 1.35]), abs=1e-9
    )


def test_numbers_agree_with_opencv_on_noisy_corners() -> None:
    scene = facing()
    noisy = corners(scene, np.random.default_rng(1).normal(0, 0.2, (4, 6, 2)))
    pose = pose_from_corners(camera_of(Lens()), [noisy], BOARD, REFERENCE)
    camera = camera_of(Lens())
    flat = np.array([[j * 0.1, i * 0.1, 0.0] for i in range(4) for j in range(6)])
    _, turn, shift = cv2.solvePnP(
        flat, noisy.points_px.reshape(-1, 2), np.array(camera.matrix), np.array(camera.distortion)
    )
    turn, shift = cv2.solvePnPRefineLM(
        flat,
        noisy.points_px.reshape(-1, 2),
        np.array(camera.matrix),
        np.array(camera.distortion),
        turn,
        shift,
    )
    board_rotation = cv2.Rodrigues(turn)[0]
    centre = -board_rotation.T @ shift.ravel()
    wanted = [centre[0], centre[2], 1.5 - centre[1]]
    assert pose.centre_m == pytest.approx(wanted, abs=2e-4)


@pytest.mark.parametrize("count", [80, pytest.param(150, marks=pytest.mark.proof)])
def test_uncertainty_is_that_of_repeated_boards(count: int) -> None:
    """Heights at 4 m from poses of noisy single frames scatter as the pose's covariance says."""
    scene = facing(25.0)
    rng = np.random.default_rng(2)
    clicks = scene.look([(0.9, 1.0, 0.0), (0.8, 1.0, 1.16)])
    heights, stated, hits = [], [], 0
    reference = dataclasses.replace(REFERENCE, u_height_m=0.0, u_lean_rad=0.0, u_square_m=0.0, u_bow_m=0.0)
    for _ in range(count):
        noisy = corners(scene, rng.normal(0, 0.15, (4, 6, 2)))
        pose = pose_from_corners(camera_of(Lens()), [noisy], BOARD, reference)
        found = measure_height(pose, clicks[0], clicks[1], sigma_px=0.0)
        assert found.height_m is not None and found.u_height_m is not None
        heights.append(found.height_m)
        stated.append(found.u_height_m)
        hits += abs(found.height_m - 1.16) < COVERAGE_95 * found.u_height_m
    assert np.std(heights) == pytest.approx(np.sqrt(np.mean(np.square(stated))), rel=0.12)
    assert abs(np.mean(heights) - 1.16) < 4 * np.std(heights) / np.sqrt(count)
    assert hits / count > 0.9


def test_lens_error_and_pose_answer_each_other() -> None:
    """With the pose solved again under a wrong focal length, heights move as the joint covariance says."""
    scene = facing(15.0)
    lens = np.zeros((9, 9))
    lens[0, 0] = lens[1, 1] = 4.0
    lens[0, 1] = lens[1, 0] = 3.9
    camera = camera_of(Lens(), lens)
    seen = corners(scene)
    reference = dataclasses.replace(REFERENCE, u_height_m=0.0, u_lean_rad=0.0, u_square_m=0.0, u_bow_m=0.0)
    pose = pose_from_corners(camera, [seen], BOARD, reference)
    clicks = scene.look([(0.9, 1.5, 0.0), (0.8, 1.5, 1.16)])
    stated = measure_height(pose, *clicks, sigma_px=0.0).u_height_m
    floor = pose_from_corners(camera_of(Lens()), [seen], BOARD, reference)
    floor_u = measure_height(floor, clicks[0], clicks[1], sigma_px=0.0).u_height_m
    assert stated is not None and floor_u is not None

    def height(dx: float, dy: float) -> float:
        wrong = dataclasses.replace(camera, fx_px=camera.fx_px + dx, fy_px=camera.fy_px + dy)
        found = measure_height(pose_from_corners(wrong, [seen], BOARD, reference), clicks[0], clicks[1])
        assert found.height_m is not None
        return found.height_m

    # one standard deviation to either side along each axis of the lens's covariance
    axes = np.linalg.cholesky(lens[:2, :2]).T
    halves = [(height(*axis) - height(*-axis)) / 2 for axis in axes]
    assert np.hypot(*halves) == pytest.approx(np.sqrt(stated**2 - floor_u**2), rel=0.05)


def test_frames_are_not_counted_as_independent() -> None:
    """150 frames with one static error know no more than one of them."""
    scene = facing()
    rng = np.random.default_rng(4)
    static = rng.normal(0, 0.1, (4, 6, 2))
    frames = [corners(scene, static + rng.normal(0, 0.01, (4, 6, 2))) for _ in range(150)]
    many = pose_from_corners(camera_of(Lens()), frames, BOARD, REFERENCE)
    single = pose_from_corners(camera_of(Lens()), frames[:1], BOARD, REFERENCE)
    assert many.frames_used == 150
    assert many.covariance is not None and single.covariance is not None
    ratio = np.sqrt(np.diag(many.covariance)[-6:] / np.diag(single.covariance)[-6:])
    assert (ratio > 0.8).all()


def test_reasons_in_words() -> None:
    camera = camera_of(Lens())
    scene = facing()
    moving = [corners(facing(20 + 0.3 * i)) for i in range(20)]
    with pytest.raises(BadInput, match="moves"):
        pose_from_corners(camera, moving, BOARD, REFERENCE)
    with pytest.raises(BadInput, match="none of the 2 frames"):
        pose_from_corners(camera, [not_found(BOARD, Said("board-not-found"))] * 2, BOARD, REFERENCE)
    with pytest.raises(BadInput, match="none of the 0 frames"):
        pose_from_corners(camera, [], BOARD, REFERENCE)
    with pytest.raises(BadInput, match="below the road"):
        pose_from_corners(camera, [corners(scene)], BOARD, Reference("bottom", -0.0, 0.003))
        pose_from_corners(
            camera, [corners(Scene(Lens(), (0.2, -3, 0.1), 0, 0))], BOARD, Reference("top", 0.1)
        )
    with pytest.raises(BadInput, match="do not fit"):
        spoiled = corners(scene, np.random.default_rng(5).normal(0, 6, (4, 6, 2)))
        pose_from_corners(camera, [spoiled], BOARD, REFERENCE)
    with pytest.raises(BadInput, match="is not plausible"):
        pose_from_corners(camera, [corners(scene)], BOARD, Reference("top", float(150)))


def test_edge_on_board_is_refused() -> None:
    eye = np.array([-3.0, -0.25, 1.4])
    scene = Scene(Lens(), tuple(eye), 86.0, 2.0)
    with pytest.raises(BadInput, match=r"edge-on|No pose|do not fit"):
        pose_from_corners(camera_of(Lens()), [corners(scene)], BOARD, REFERENCE)


@pytest.mark.parametrize("height", [1.2, 2.5, 4.0])
@pytest.mark.parametrize("yaw", [-20.0, 0.0, 20.0])
def test_a_board_that_lies_on_the_road_is_recognised(height: float, yaw: float) -> None:
    for distance in (2.0, 5.0):
        pitch = 0.7 * np.degrees(np.arctan2(height, distance))
        scene = Scene(Lens(), (0.25 - distance * np.sin(np.radians(yaw)), -distance, height), yaw, pitch, 1.0)
        lying = scene.look([(0.1 * j, -0.1 * i, 0.0) for i in range(4) for j in range(6)])
        with pytest.raises(BadInput, match="lie on the road"):
            pose_from_corners(camera_of(scene.lens), [seen_as(lying)], BOARD, Reference("top", 0.9))
        standing = scene.look(scene.board(6, 4, 0.1, 0.9).reshape(-1, 3))
        found = pose_from_corners(camera_of(scene.lens), [seen_as(standing)], BOARD, Reference("top", 0.9))
        assert found.centre_m[2] == pytest.approx(height, abs=1e-6)


def seen_as(points: np.ndarray) -> Corners:
    ordered, board = canonical_order(points.reshape(4, 6, 2), BOARD)
    return Corners(True, ordered, board, None, 1.0, "exact")


def test_a_few_moving_frames_are_left_out() -> None:
    scene = facing()
    rng = np.random.default_rng(6)
    still = [corners(scene, rng.normal(0, 0.05, (4, 6, 2))) for _ in range(30)]
    arriving = [corners(facing(20 + 2.0 * i)) for i in range(8, 0, -1)]
    pose = pose_from_corners(camera_of(Lens()), arriving + still, BOARD, REFERENCE)
    assert pose.frames_used == 30
    assert Said("pose-frames-moved") in pose.warnings


def test_expected_u() -> None:
    scene = Scene(Lens(f=380.0), (0.0, -3.0, 1.5), 0.0, 12.0)
    found = dict(expected_u(pose_of(scene), (0.4, 3.0, 5.0)))
    assert found[0.4] is None  # the road so near lies below the picture
    assert found[3.0] is not None and found[5.0] is not None
    level = 3.0 / 380 * np.sqrt(1 + (1 - 1.2 / 1.5) ** 2)
    assert found[3.0] == pytest.approx(level, rel=0.25)
    assert found[5.0] > found[3.0]
