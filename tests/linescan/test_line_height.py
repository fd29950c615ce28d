"""A line camera's pose from a rod and heights from two rows, against a camera turned by angles."""

from math import atan2, tan

import numpy as np
import pytest

from sightline.linescan.line_height import contact_distance, ladder, line_height
from sightline.linescan.line_pose import LinePoseError, solve_line_pose

FOCAL_PX, PRINCIPAL_ROW, PITCH_RAD, CAMERA_M = 900.0, 505.0, -0.07, 1.1
ROD = [(distance, height) for distance in (2.0, 5.0) for height in (0.0, 0.5, 1.0, 1.5)]


def row_of(distance_m: float, height_m: float) -> float:
    return PRINCIPAL_ROW - FOCAL_PX * tan(atan2(height_m - CAMERA_M, distance_m) - PITCH_RAD)


def marks(rng: np.random.Generator | None = None, sigma_px: float = 0.3) -> tuple[list[float], ...]:
    rows = [row_of(*one) + (0.0 if rng is None else rng.normal(0, sigma_px)) for one in ROD]
    return [one[0] for one in ROD], [one[1] for one in ROD], rows


def test_exact_marks_give_the_pose_and_exact_heights() -> None:
    pose = solve_line_pose(*marks(), sigma_px=0.3)
    assert pose.camera_height_m == pytest.approx(CAMERA_M, abs=1e-9)
    assert pose.focal_px == pytest.approx(FOCAL_PX, rel=1e-8)
    assert np.arctan(pose.parameters[2]) == pytest.approx(PITCH_RAD, abs=1e-9)
    assert pose.rows_of(3.3, 0.8)[()] == pytest.approx(row_of(3.3, 0.8), abs=1e-7)
    found = line_height(pose, row_of(3.0, 0.0), row_of(3.45, 1.45), inset_m=0.45)
    assert found.distance_m == pytest.approx(3.0, abs=1e-8)
    assert found.height_m == pytest.approx(1.45, abs=1e-8)
    assert [one.source for one in found.budget][:2] == ["click, target", "click, contact"]


def test_uncertainties_hold_what_they_promise() -> None:
    rng = np.random.default_rng(3)
    errors, claimed, distances = [], [], []
    for _ in range(500):
        pose = solve_line_pose(*marks(rng), sigma_px=0.3)
        inset = rng.normal(0.45, 0.1)
        contact, target = row_of(3.2, 0.0) + rng.normal(), row_of(3.2 + inset, 1.2) + rng.normal()
        found = line_height(pose, contact, target, inset_m=0.45, u_inset_m=0.1)
        assert found.height_m is not None and found.distance_m is not None
        errors.append(found.height_m - 1.2)
        claimed.append(found.u_height_m)
        distances.append((found.distance_m - 3.2) / found.u_distance_m)
    assert np.std(errors) == pytest.approx(np.mean(claimed), rel=0.08)
    assert np.std(distances) == pytest.approx(1.0, rel=0.08)


def test_the_rods_own_uncertainty_is_carried() -> None:
    """Stands nearer or farther than was taped, rods that lean: the scatter is what is claimed."""
    rng = np.random.default_rng(4)
    heights, errors, claimed = [], [], []
    given = {"sigma_px": 0.3, "u_distance_m": 0.02, "u_lean_rad": 0.01}
    for _ in range(300):
        off = dict(zip((2.0, 5.0), rng.normal(0, 0.02, 2), strict=True))
        lean = dict(zip((2.0, 5.0), rng.normal(0, 0.01, 2), strict=True))
        rows = [row_of(d + off[d] + h * lean[d], h) + rng.normal(0, 0.3) for d, h in ROD]
        pose = solve_line_pose([one[0] for one in ROD], [one[1] for one in ROD], rows, **given)
        found = line_height(pose, row_of(3.2, 0.0), row_of(3.2, 1.5), sigma_px=1e-6)
        assert found.height_m is not None and found.u_height_m is not None
        heights.append(pose.camera_height_m)
        errors.append(found.height_m - 1.5)
        claimed.append((np.sqrt(pose.covariance[3, 3]), found.u_height_m))
    assert np.std(heights) == pytest.approx(np.mean(claimed, axis=0)[0], rel=0.12)
    assert np.std(errors) == pytest.approx(np.mean(claimed, axis=0)[1], rel=0.12)


def test_the_ladder_stands_at_the_contacts_distance() -> None:
    pose = solve_line_pose(*marks(), sigma_px=0.3)
    assert contact_distance(pose, row_of(3.0, 0.0)) == pytest.approx(3.0, abs=1e-8)
    assert contact_distance(pose, row_of(3.0, CAMERA_M + 0.1)) is None
    rungs = ladder(pose, 3.0, 1000)
    assert [height for height, _ in rungs] == [0.0, 0.5, 1.0, 1.5, 2.0, 2.5]
    assert all(row == pytest.approx(row_of(3.0, height), abs=1e-6) for height, row in rungs)


def test_sigma_from_residuals() -> None:
    pose = solve_line_pose(*marks(np.random.default_rng(5)))
    known = solve_line_pose(*marks(np.random.default_rng(5)), sigma_px=0.3)
    ratio = np.sqrt(pose.covariance[3, 3] / known.covariance[3, 3])
    assert 0.3 < ratio < 2.0 and pose.rms_px == known.rms_px


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda d, h, r: ([3.0] * 8, h, r), "one distance"),
        (lambda d, h, r: (d[:3], h[:3], r[:3]), "too few"),
        (lambda d, h, r: (d, h, [1000 - one for one in r]), "rod is up"),
        (lambda d, h, r: (d, h, [*r[:-1], float("nan")]), "numbers"),
        (lambda d, h, r: (d, h[:-1], r), "Each mark"),
        (lambda d, h, r: ([-one for one in d], h, r), "above 0"),
        (
            lambda d, h, r: (d, [CAMERA_M] * 8, [row_of(1.0, CAMERA_M)] * 8),
            "hold the rod upright|camera height",
        ),
    ],
)
def test_marks_that_fix_no_pose_are_refused_in_words(change: object, words: str) -> None:
    with pytest.raises(LinePoseError, match=words):
        solve_line_pose(*change(*marks()), sigma_px=0.3)  # type: ignore[operator]


def test_rows_that_no_road_point_has_give_a_reason() -> None:
    pose = solve_line_pose(*marks(), sigma_px=0.3)
    assert "horizon" in str(line_height(pose, row_of(3.0, 1.2), row_of(3.0, 1.5)).reason)
    assert "not above" in str(line_height(pose, row_of(3.0, 0.0), row_of(2.0, 0.0)).reason)
    assert "number" in str(line_height(pose, float("nan"), 10.0).reason)
    outside = line_height(pose, row_of(3.0, 0.0), row_of(3.0, 3.0))
    assert outside.status == "ok" and outside.flags[0].code == "line-height-extrapolated"
