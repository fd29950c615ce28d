"""Calibration: its uncertainty against simulation, its verdicts, and the real sets."""

import json

import cv2
import numpy as np
import pytest

from sightline.errors import BadInput
from sightline.geometry.arrays import freeze_array
from sightline.geometry.board import Board
from sightline.geometry.calibration import calibrate
from sightline.geometry.corners import Corners, find_board, not_found
from sightline.messages.said import Said
from tests.geometry.scenes import shared
from tests.geometry.simulate import Lens, Scene

BOARD = Board(9, 6, 0.03)
SIZE = (640, 480)
OF_OTHER_SIZES = {f"calibration{n}.jpg" for n in (1, 4, 5, 7, 15)}


def view(
    lens: Lens, rng: np.random.Generator, noise: float, tilt: float = 35.0, board: Board = BOARD
) -> Corners:
    """A board somewhere in the picture, tilted at random, as the independent simulation sees it."""
    while True:
        scene = Scene(
            lens,
            (rng.uniform(-0.1, 0.4), -rng.uniform(0.3, 0.7), rng.uniform(0.9, 1.2)),
            rng.uniform(-tilt, tilt),
            rng.uniform(-tilt, tilt) * 0.8,
            rng.uniform(-10, 10),
        )
        points = scene.look(scene.board(board.columns, board.rows, board.square_m, 1.1).reshape(-1, 3))
        depth = (np.array([0.15, 0.0, 1.0]) - scene.eye) @ scene.axes()[2]
        if depth > 0.25 and (points > 4).all() and (points < [635, 475]).all():
            grid = points.reshape(board.rows, board.columns, 2)
            return Corners(
                True, freeze_array(grid + rng.normal(0, noise, grid.shape)), board, None, 2.0, "simulated"
            )


def views(lens: Lens, count: int, seed: int, noise: float = 0.15, tilt: float = 35.0):
    rng = np.random.default_rng(seed)
    return [(f"{i}.png", view(lens, rng, noise, tilt), SIZE) for i in range(count)]


@pytest.mark.parametrize("sets", [4, pytest.param(6, marks=pytest.mark.proof)])
@pytest.mark.parametrize("lens", [Lens(), Lens(f=300.0, k=(0.05, -0.01, 0.004, -0.001), kind="fisheye")])
def test_stated_uncertainty_is_that_of_repeated_calibrations(lens: Lens, sets: int) -> None:
    runs = [calibrate(views(lens, 12, seed), BOARD, lens.kind).camera for seed in range(sets)]
    truth = np.array([lens.f, lens.f, lens.cx, lens.cy])
    found = np.array([[c.fx_px, c.fy_px, c.cx_px, c.cy_px] for c in runs])
    stated = np.array([np.sqrt(np.diag(c.covariance)[:4]) for c in runs])
    z = (found - truth) / stated
    assert 0.65 < np.sqrt(np.mean(z**2)) < 1.45
    assert np.mean([c.rms_px for c in runs]) == pytest.approx(0.15 * np.sqrt(2), rel=0.05)
    assert all(c.parameters[:4] == ("fx_px", "fy_px", "cx_px", "cy_px") for c in runs)


def test_covariance_agrees_with_opencv_standard_deviations() -> None:
    given = views(Lens(), 15, 3)
    camera = calibrate(given, BOARD).camera
    objects = [np.array([[j * 0.03, i * 0.03, 0] for i in range(6) for j in range(9)], np.float32)] * 15
    seen = [c.points_px.reshape(-1, 1, 2).astype(np.float32) for _, c, _ in given]
    stop = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 300, 1e-12)
    out = cv2.calibrateCameraExtended(objects, seen, SIZE, None, None, criteria=stop)
    assert camera.fx_px == pytest.approx(out[1][0, 0], abs=0.01)
    assert camera.covariance is not None
    ratio = out[5].ravel()[:9] / np.sqrt(np.diag(camera.covariance))
    assert ratio == pytest.approx(
        np.full(9, ratio[0]), rel=1e-3
    )  # OpenCV counts the residuals' freedom otherwise


def test_a_set_on_which_opencv_stops_too_early() -> None:
    """After its 30 rounds OpenCV says f = 822 px with a residual of 0.8 px; the truth is 483.5 px."""
    camera = calibrate(views(Lens(), 15, 102), BOARD).camera
    assert camera.fx_px == pytest.approx(483.5, abs=5)
    assert camera.rms_px == pytest.approx(0.15 * np.sqrt(2), rel=0.1)


def test_odd_views_are_left_out_by_name() -> None:
    given = views(Lens(), 10, 4)
    blurred = Corners(True, given[0][1].points_px, BOARD, None, 40.0, "simulated")
    odd = [
        ("wide.png", given[0][1], (641, 481)),
        ("none.png", not_found(BOARD, Said("board-not-found")), SIZE),
        ("soft.png", blurred, SIZE),
    ]
    result = calibrate(given + odd, BOARD)
    reasons = {v.file: v.reason for v in result.camera.views if not v.used}
    assert set(reasons) == {"wide.png", "none.png", "soft.png"}
    assert "641x481" in str(reasons["wide.png"]) and "blurred" in str(reasons["soft.png"])
    assert [v.file for v in result.camera.views] == [name for name, _, _ in given + odd]
    assert all(v.rms_px is None for v in result.camera.views if not v.used)
    assert result.coverage.shape == (12, 16) and result.coverage.sum() == 10 * 54
    assert result.residuals_px["0.png"].shape == (6, 9, 2)


@pytest.mark.parametrize("named", ["copy of {}", "{}"])
def test_a_picture_given_twice_counts_once(named: str) -> None:
    """Twice as many views that say the same would make the lens look better known by the root of two."""
    given = views(Lens(), 8, seed=3)
    copies = [(named.format(name), corners, size) for name, corners, size in given]
    once, twice = calibrate(given, BOARD), calibrate([*given, *copies], BOARD)
    assert (twice.camera.covariance == once.camera.covariance).all()
    reasons = [one.reason for one in twice.camera.views if not one.used]
    assert reasons == [Said("calibration-image-twice", file=f"{i}.png") for i in range(8)]
    assert [one.used for one in twice.camera.views] == [True] * 8 + [False] * 8


def test_fewer_than_three_views_are_bad_input() -> None:
    with pytest.raises(BadInput, match="at least 3"):
        calibrate(views(Lens(), 2, 5), BOARD)
    with pytest.raises(BadInput, match="at least 3"):
        calibrate([("a.png", not_found(BOARD, Said("board-not-found")), SIZE)] * 5, BOARD)
    with pytest.raises(BadInput):
        calibrate([], BOARD)


def test_good_set_is_trusted_and_poor_ones_say_why() -> None:
    good = calibrate(views(Lens(), 30, 6, tilt=45.0), BOARD)
    assert good.trusted, good.warnings
    few = calibrate(views(Lens(), 4, 7), BOARD)
    assert not few.trusted and any("Only 4 views" in str(w) for w in few.warnings)
    parallel = calibrate(views(Lens(), 12, 8, tilt=3.0), BOARD)
    assert not parallel.trusted and any("same orientation" in str(w) for w in parallel.warnings)


def test_wrong_lens_model_is_named() -> None:
    fisheye = Lens(f=210.0, k=(0.1, -0.05, 0.02, -0.01), kind="fisheye")
    rng = np.random.default_rng(9)
    near = [(f"{i}.png", view(fisheye, rng, 0.05, 45.0, Board(9, 6, 0.06)), SIZE) for i in range(15)]
    result = calibrate(near, Board(9, 6, 0.06), "brown")
    right = calibrate(near, Board(9, 6, 0.06), "fisheye")
    assert right.camera.rms_px is not None and right.camera.rms_px < 0.1
    assert any("fisheye model fits better" in str(w) for w in result.warnings)
    assert not result.trusted


def test_a_spoiled_view_is_named() -> None:
    given = views(Lens(), 14, 10, 0.1)
    rng = np.random.default_rng(11)
    bad = given[3][1].points_px + rng.normal(0, 1.5, (6, 9, 2))
    given[3] = ("bad.png", Corners(True, freeze_array(bad), BOARD, None, 2.0, "simulated"), SIZE)
    assert any(str(w).startswith("bad.png fits much worse") for w in calibrate(given, BOARD).warnings)


@pytest.mark.parametrize(
    ("folder", "size", "square", "left_out"),
    [
        ("opencv_left", (9, 6), 0.025, set()),
        pytest.param("gopro_wide", (8, 6), 1.0, {"GOPR0055.jpg"}, marks=pytest.mark.proof),
        pytest.param("mixed_sizes", (9, 6), 1.0, OF_OTHER_SIZES, marks=pytest.mark.proof),
    ],
)
def test_real_sets_reach_the_reference(folder, size, square, left_out) -> None:
    reference = json.loads(shared("calibration", "reference.json").read_text())
    wanted = next(s for s in reference["sets"] if s["set"] == folder)
    board = Board(*size, square)
    given = []
    for path in sorted(shared("calibration", folder).glob("*.jpg")):
        grey = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE)
        given.append((path.name, find_board(grey, board), (grey.shape[1], grey.shape[0])))
    for model, key in (("brown", "pinhole5"), ("fisheye", "fisheye")):
        if key not in wanted:
            continue
        camera = calibrate(given, board, model).camera
        assert {v.file for v in camera.views if not v.used} == left_out
        assert camera.rms_px is not None and camera.rms_px <= wanted[key]["rms_px"] + 0.001
        got = (camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px)
        for value, name in zip(got, ("fx", "fy", "cx", "cy"), strict=True):
            assert value == pytest.approx(wanted[key][name], abs=0.003 * wanted[key]["fx"]), name
