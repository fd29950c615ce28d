"""ChArUco boards: numbered corners to a few hundredths of a pixel, in part or whole, old pattern or new."""

import dataclasses

import cv2
import numpy as np
import pytest

from sightline.cli import main
from sightline.errors import BadInput
from sightline.geometry.board import Board
from sightline.geometry.calibration import calibrate
from sightline.geometry.camera import Camera
from sightline.geometry.charuco import Charuco, charuco_of
from sightline.geometry.corners import Corners, find_board
from sightline.geometry.pose import pose_from_corners
from sightline.geometry.road_pose import Reference
from sightline.geometry.tracking import track
from tests.geometry.scenes import camera_of
from tests.geometry.simulate import Lens, Scene, picture

TOP_M = 1.6
BOARD = Board(6, 5, 0.1, Charuco("4X4_50", 0.075))
CELL_PX = 120


def print_of(board: Board, legacy: bool = False):
    """The board's print as a function of the place on it, in squares from the first inner corner."""
    assert board.charuco is not None
    words = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
    size = (board.columns + 1, board.rows + 1)
    made = cv2.aruco.CharucoBoard(size, 1.0, board.charuco.marker_m / board.square_m, words)
    made.setLegacyPattern(legacy)
    ink = made.generateImage((size[0] * CELL_PX, size[1] * CELL_PX), marginSize=0).astype(float)

    def paint(across, down, columns, rows):
        row = np.clip(np.floor((down + 1) * CELL_PX).astype(int), 0, ink.shape[0] - 1)
        column = np.clip(np.floor((across + 1) * CELL_PX).astype(int), 0, ink.shape[1] - 1)
        on_it = (across > -1) & (across < columns) & (down > -1) & (down < rows)
        near = (across > -1.7) & (across < columns + 0.7) & (down > -1.7) & (down < rows + 0.7)
        return np.where(on_it, 40 + 165 / 255 * ink[row, column], np.where(near, 205.0, 118.0))

    return paint


def scene(distance: float = 1.8, roll: float = 3.0, x: float = 0.0) -> Scene:
    return Scene(
        Lens(), (0.3 - distance * np.tan(0.3) + x, -distance, 1.4), float(np.degrees(0.3)), 4.0, roll
    )


def seen(at: Scene, board: Board = BOARD, legacy: bool = False) -> tuple[np.ndarray, np.ndarray]:
    """Picture, and the true corners (rows, columns, 2) as printed."""
    truth = at.look(at.board(board.columns, board.rows, board.square_m, TOP_M).reshape(-1, 3))
    paint = print_of(board, legacy)
    grey = picture(at, board.columns, board.rows, board.square_m, TOP_M, samples=4, paint=paint)
    return grey, truth.reshape(board.rows, board.columns, 2)


@pytest.mark.parametrize(("roll", "legacy"), [(3.0, False), (-50.0, True), (178.0, False)])
def test_corners_are_where_they_are(roll: float, legacy: bool) -> None:
    """No half pixel off, as some versions of OpenCV are; upside down they are numbered as seen."""
    grey, truth = seen(scene(roll=roll), legacy=legacy)
    found = find_board(grey, BOARD)
    assert found.found and found.ids is None, found.reason
    error = found.points_px - (truth[::-1, ::-1] if roll > 90 else truth)
    assert np.sqrt(np.square(error).mean()) < 0.04
    assert np.abs(error.mean(axis=(0, 1))).max() < 0.02


def test_a_part_of_the_board_has_its_numbers() -> None:
    grey, truth = seen(scene(x=1.05))
    found = find_board(grey, BOARD)
    assert found.found and found.ids is not None and 6 <= len(found.ids) < BOARD.corners
    error = found.points_px - truth.reshape(-1, 2)[found.which]
    assert np.sqrt(np.square(error).mean()) < 0.05
    with pytest.raises(BadInput, match="show the whole board"):
        pose_from_corners(camera_of(Lens()), [found], BOARD, Reference("top", TOP_M))


def test_road_pose_of_a_charuco_board() -> None:
    at = scene()
    grey, _ = seen(at)
    first = find_board(grey, BOARD)
    followed = track(picture(at, 6, 5, 0.1, TOP_M, samples=4, seed=1, paint=print_of(BOARD)), first)
    assert followed.found and followed.detector == "followed"
    pose = pose_from_corners(camera_of(Lens()), [first, followed], BOARD, Reference("top", TOP_M))
    assert pose.centre_m == pytest.approx(at.eye, abs=0.006)


def test_calibration_from_parts_of_a_board() -> None:
    """Corners by projection, each view cut at the picture's border: the lens comes out all the same."""
    rng = np.random.default_rng(3)
    views = []
    for index in range(14):
        at = Scene(
            Lens(), (rng.uniform(-0.3, 0.9), -rng.uniform(0.5, 0.9), TOP_M - rng.uniform(-0.2, 0.6)),
            rng.uniform(-25, 25), rng.uniform(-25, 25), rng.uniform(-20, 20),
        )  # fmt: skip
        points = at.look(at.board(6, 5, 0.1, TOP_M).reshape(-1, 3))
        inside = ((points > 3) & (points < [636, 476])).all(axis=1)
        if inside.sum() < 8:
            continue
        noisy = points[inside] + rng.normal(0, 0.05, (inside.sum(), 2))
        whole = inside.all()
        grid = noisy.reshape(5, 6, 2) if whole else noisy
        ids = None if whole else np.flatnonzero(inside)
        views.append((f"{index}.png", Corners(True, grid, BOARD, None, 0.0, "simulated", ids), (640, 480)))
    assert any(c.ids is not None for _, c, _ in views)
    camera: Camera = calibrate(views, BOARD).camera
    assert camera.fx_px == pytest.approx(Lens().f, abs=3.0)
    assert camera.rms_px is not None and camera.rms_px < 0.09


def test_clutter_and_boards_that_cannot_be() -> None:
    rng = np.random.default_rng(0)
    grey = np.full((480, 640), 120, np.uint8)
    for _ in range(150):
        a, b = rng.integers(0, [640, 480], (2, 2)).tolist()
        cv2.rectangle(grey, a, b, int(rng.integers(0, 255)), -1 if rng.random() < 0.6 else 2)
    found = find_board(grey, BOARD)
    assert not found.found and found.reason and "4X4_50" in str(found.reason)
    plain = picture(scene(), 6, 5, 0.1, TOP_M, samples=2)
    assert not find_board(plain, BOARD).found
    with pytest.raises(BadInput, match="dictionary"):
        charuco_of("5X4_50", 0.07)
    for marker, columns in ((0.1, 6), (float("nan"), 6), (0.07, 30)):
        with pytest.raises(BadInput):
            find_board(grey, dataclasses.replace(BOARD, columns=columns, charuco=Charuco("4X4_50", marker)))


def test_commands_take_charuco_boards(tmp_path, capsys) -> None:
    from json import dumps

    from sightline.geometry.documents import camera_to_dict

    camera, board = tmp_path / "camera.json", tmp_path / "board.png"
    camera.write_text(dumps(camera_to_dict(camera_of(Lens()))))
    cv2.imwrite(str(board), seen(scene())[0])
    how = ["--camera", camera, "--board", "6x5", "--square", 0.1, "--reference-height", TOP_M]
    out = ["-o", tmp_path / "pose.json"]
    run = lambda *more: main([str(a) for a in ("pose", board, *how, *more, *out)])  # noqa: E731
    assert run("--charuco", "DICT_4X4_50", "--marker", 0.075, "--u-bow", 0.001, "--u-square", 0.0002) == 0
    assert "camera 1.4" in capsys.readouterr().out
    assert run("--charuco", "4X4_50") == 2
    assert "--marker" in capsys.readouterr().err
    assert run("--charuco", "6X6_50", "--marker", 0.075) == 2
