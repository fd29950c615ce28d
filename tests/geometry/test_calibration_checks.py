"""Cross-validation, the board's shape and what is missing, against scenes that are simulated elsewhere."""

import json
from dataclasses import replace

import numpy as np
import pytest
from click.testing import CliRunner

from sightline.commands.calibrate import calibrate as calibrate_command
from sightline.errors import BadInput
from sightline.geometry.arrays import freeze_array
from sightline.geometry.board import Board
from sightline.geometry.calibration import calibrate
from sightline.geometry.calibration_checks import calibrate_and_check
from sightline.geometry.corners import Corners
from sightline.geometry.crossvalidation import cross_validate, cross_validation_warnings
from sightline.geometry.documents import camera_from_dict
from tests.geometry.scenes import shared
from tests.geometry.simulate import Lens, Scene
from tests.geometry.test_calibration import BOARD, SIZE, view, views


def three_leaved(given, size_px: float):
    """The same views through a lens with a term that neither model has: it grows with the square of the
    radius and turns three times round the axis.
    """
    out = []
    for name, corners, size in given:
        x, y = np.moveaxis((corners.points_px - [319.5, 239.5]) / 400.0, -1, 0)
        length, angle = size_px * (x * x + y * y), 3.0 * np.arctan2(y, x)
        moved = corners.points_px + np.stack([length * np.cos(angle), length * np.sin(angle)], axis=-1)
        out.append((name, replace(corners, points_px=freeze_array(moved)), size))
    return out


def bowed(lens: Lens, count: int, seed: int, sag_m: float, lying: bool = False):
    """Views of a board whose middle lies `sag_m` behind its ends, some of it on its side."""
    rng, given = np.random.default_rng(seed), []
    while len(given) < count:
        eye = (rng.uniform(-0.1, 0.4), -rng.uniform(0.3, 0.6), rng.uniform(0.9, 1.2))
        scene = Scene(lens, eye, rng.uniform(-40, 40), rng.uniform(-32, 32), rng.uniform(-10, 10))
        on_side = lying and len(given) % 3 == 0
        columns, rows = (6, 9) if on_side else (9, 6)
        grid = scene.board(columns, rows, BOARD.square_m, 1.1)
        along = np.linspace(-1, 1, 9)
        grid[..., 1] += sag_m * (1 - (along[:, None] if on_side else along[None, :]) ** 2)
        points = scene.look(grid.reshape(-1, 3))
        in_front = (np.array([0.15, 0.0, 1.0]) - scene.eye) @ scene.axes()[2] > 0.25
        if in_front and (points > 4).all() and (points < [635, 475]).all():
            seen = freeze_array(points.reshape(rows, columns, 2) + rng.normal(0, 0.05, (rows, columns, 2)))
            as_seen = Board(columns, rows, BOARD.square_m)
            given.append((f"{len(given)}.png", Corners(True, seen, as_seen, None, 2.0, "simulated"), SIZE))
    return given


@pytest.mark.parametrize("sets", [2, pytest.param(4, marks=pytest.mark.proof)])
def test_halves_of_a_right_model_differ_as_their_covariances_say(sets: int) -> None:
    found = [cross_validate(views(Lens(), 24, 210 + n), BOARD) for n in range(sets)]
    ratios = [
        d.difference_m / d.expected_m for one in found for d in one.height_differences if d.distance_m != 3.0
    ]
    assert 0.6 < np.sqrt(np.mean(np.square(ratios))) < 1.5
    assert all(one.views == (12, 12) for one in found)
    held_out = [one.all_held_out_rms_px for one in found]
    assert np.mean(held_out) == pytest.approx(0.15 * np.sqrt(2), rel=0.1)
    assert all(one.fit_rms_px < one.all_held_out_rms_px for one in found)
    assert sum(bool(cross_validation_warnings(one)) for one in found) == 0
    at_board = [d.difference_m for one in found for d in one.height_differences if d.distance_m == 3.0]
    assert max(map(abs, at_board)) < 0.002  # errors of the lens pivot at the board's distance


def test_a_term_that_the_model_lacks_is_found_by_halves_that_disagree() -> None:
    given = views(Lens(), 24, 0)
    assert cross_validation_warnings(cross_validate(given, BOARD)) == ()
    checked = calibrate_and_check(three_leaved(given, 4.0), BOARD)
    worst = max(checked.cross_validation.height_differences, key=lambda d: abs(d.difference_m))
    assert abs(worst.difference_m) > 2.5 * worst.expected_m
    warning = next(w for w in checked.result.warnings if w.code == "calibration-halves-differ-beyond")
    told = warning.values["distance_m"], warning.values["difference_m"]
    differ = checked.cross_validation.height_differences
    assert told in [(d.distance_m, round(abs(d.difference_m), 4)) for d in differ]
    assert "other model" in str(warning) and "bent" in str(warning)


def test_too_few_views_for_two_halves_give_the_reason() -> None:
    checked = calibrate_and_check(views(Lens(), 5, 12), BOARD)
    told = checked.documents()["cross_validation"]
    assert "at least 6" in str(told["reason"]) and told["held_out_rms_px"] is None
    assert told["height_differences"] == [] and checked.cross_validation == told["reason"]
    assert checked.documents()["board_shape"] is None
    assert "at least 12" in str(cross_validate(views(Lens(), 11, 12), BOARD, bent_board=True))


@pytest.mark.parametrize("lying", [False, pytest.param(True, marks=pytest.mark.proof)])
def test_a_bent_board_is_found_and_its_shape_solved_for(lying: bool) -> None:
    given = bowed(Lens(), 14, 5, 0.002, lying)
    flat = calibrate_and_check(given, BOARD)
    warning = next(str(w) for w in flat.result.warnings if w.code == "calibration-board-bent-changes")
    assert "stiff" in warning and not flat.result.flatness.solved
    bent = calibrate_and_check(given, BOARD, bent_board=True)
    assert bent.result.flatness.shape.bow_m == pytest.approx(0.002, rel=0.1)
    noise_px = 0.05 * np.sqrt(2) * np.sqrt(1 - (14 * 6 + 9 + 8) / (14 * 108))  # less what was fitted
    assert bent.result.camera.rms_px == pytest.approx(noise_px, rel=0.05)
    assert flat.result.camera.rms_px > 1.5 * bent.result.camera.rms_px
    u = np.sqrt(bent.result.camera.covariance[0, 0])
    assert abs(bent.result.camera.fx_px - 483.5) < 3.5 * u
    assert abs(flat.result.camera.fx_px - 483.5) > abs(bent.result.camera.fx_px - 483.5)
    assert not any(w.code.startswith("calibration-board-bent") for w in bent.result.warnings)
    assert bent.documents()["board_shape"]["solved"] is True


def test_a_flat_board_is_not_called_bent() -> None:
    checked = calibrate_and_check(views(Lens(), 20, 6), BOARD)
    assert not any(w.code.startswith("calibration-board-bent") for w in checked.result.warnings)
    assert checked.result.flatness.shape.bow_m < 0.0005
    with pytest.raises(BadInput, match="at least 6"):
        calibrate(views(Lens(), 5, 7), BOARD, bent_board=True)


def test_what_is_missing_is_said_by_place_and_tilt() -> None:
    full = calibrate(views(Lens(), 24, 6, tilt=45.0), BOARD)
    assert not any(one.code.startswith("calibration-tilt") for one in full.reshoot)
    left = [v for v in views(Lens(), 36, 6) if v[1].points_px[..., 0].max() < 400]
    (where, *_) = calibrate(left, BOARD).reshoot
    assert where.code == "calibration-hold-in" and "right" in str(where) and "left" not in str(where)
    flat = calibrate(views(Lens(), 12, 8, tilt=3.0), BOARD)
    assert any("right, left, bottom and top edge in turn" in str(one) for one in flat.reshoot)


def test_a_turned_board_asks_for_the_other_edges() -> None:
    """From the right of the board, its right edge is the nearer one: the left one is asked for."""
    rng, given = np.random.default_rng(1), []
    while len(given) < 10:
        scene = Scene(
            Lens(), (rng.uniform(0.55, 0.75), -0.4, rng.uniform(0.9, 1.1)), -rng.uniform(42, 52), 5.0
        )
        points = scene.look(scene.board(9, 6, 0.03, 1.1).reshape(-1, 3))
        if (points > 4).all() and (points < [635, 475]).all():
            grid = freeze_array(points.reshape(6, 9, 2) + rng.normal(0, 0.05, (6, 9, 2)))
            given.append((f"{len(given)}.png", Corners(True, grid, BOARD, None, 2.0, "simulated"), SIZE))
    sentence = next(str(s) for s in calibrate(given, BOARD).reshoot if s.code.startswith("calibration-tilt"))
    assert "left" in sentence and "right" not in sentence


def test_warnings_for_sizes_missed_boards_repeats_and_small_squares() -> None:
    given = views(Lens(), 10, 4)
    odd = [("wide.png", given[0][1], (641, 481))]
    assert any("Images of several sizes: 1" in str(w) for w in calibrate(given + odd, BOARD).warnings)
    none = [(f"none{i}.png", replace(given[0][1], found=False), SIZE) for i in range(12)]
    assert any("in only 10 of 22" in str(w) for w in calibrate(given + none, BOARD).warnings)
    rng = np.random.default_rng(3)
    still = [
        (
            f"again{i}.png",
            replace(given[i % 5][1], points_px=given[i % 5][1].points_px + rng.normal(0, 0.1)),
            SIZE,
        )
        for i in range(15)
    ]
    repeated = calibrate(still, BOARD)
    assert not repeated.trusted and any("Only 5 of the 15 views differ" in str(w) for w in repeated.warnings)
    small = Board(9, 6, 0.008)
    tiny = [(f"{i}.png", view(Lens(), rng, 0.05, board=small), SIZE) for i in range(12)]
    assert any("squares are smaller than 10 px" in str(w) for w in calibrate(tiny, small).warnings)


def test_the_command_prints_the_checks_beside_camera_json(tmp_path) -> None:
    pictures = [str(p) for p in sorted(shared("calibration", "opencv_left").glob("*.jpg"))]
    output = tmp_path / "camera.json"
    arguments = [*pictures, "--board", "9x6", "--square", "0.025", "-o", str(output), "--json"]
    run = CliRunner().invoke(calibrate_command, arguments)
    assert run.exit_code == 0, run.output
    printed = json.loads(run.output)
    written = json.loads(output.read_text())
    assert set(printed) - set(written) == {
        "cross_validation", "board_shape", "reshoot", "warnings", "trusted", "coverage",
    }  # fmt: skip
    assert camera_from_dict(written).rms_px == pytest.approx(0.16, abs=0.01)
    checked = printed["cross_validation"]
    assert checked["views"] == [7, 6] and checked["reason"] is None
    assert printed["rms_px"] < checked["held_out_rms_px"] < 0.2
    assert [d["distance_m"] for d in checked["height_differences"]] == [2.0, 3.0, 5.0]
