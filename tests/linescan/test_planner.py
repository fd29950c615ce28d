"""Expected uncertainties against crossings that are really rounded to lines; pixels and exposure by hand."""

from math import sqrt

import numpy as np
import pytest

from sightline.errors import BadInput
from sightline.linescan.budget import U_EDGE_M
from sightline.linescan.exposure import LineCamera, plan_exposure
from sightline.linescan.planner import plan_lines

pytestmark = pytest.mark.once
SPEED_MPS, BASELINE_M, U_BASELINE_M, LENGTH_M, GAP_S, RATE_HZ = 25.0, 0.6, 0.004, 4.2, 0.9, 3000.0


def simulated(n: int) -> dict[str, np.ndarray]:
    """Errors of n pairs of vehicles at about this speed, by formulas of their own: crossings to whole lines.

    Speeds and gaps differ a little, so that no two crossings are rounded alike.
    """
    rng = np.random.default_rng(14)
    start, true = rng.uniform(0.0, 1.0, n), SPEED_MPS * rng.uniform(0.98, 1.02, n)
    gap_s = GAP_S * rng.uniform(0.99, 1.01, n)
    front, rear, following = rng.normal(0.0, U_EDGE_M, (3, n))

    def line_s(metres: np.ndarray) -> np.ndarray:
        return np.rint((start + metres / true) * RATE_HZ) / RATE_HZ

    front_1, front_2 = line_s(front), line_s(BASELINE_M + front)
    rear_1, next_1 = line_s(LENGTH_M + rear), line_s(LENGTH_M + gap_s * true + following)
    speed = (BASELINE_M + rng.normal(0.0, U_BASELINE_M, n)) / (front_2 - front_1)
    return {
        "speed": speed - true,
        "length": speed * (rear_1 - front_1) - LENGTH_M,
        "time_gap": next_1 - rear_1 - gap_s,
        "distance_gap": speed * (next_1 - rear_1) - gap_s * true,
    }


@pytest.mark.parametrize("quantity", ["speed", "length", "time_gap", "distance_gap"])
def test_the_expected_uncertainty_is_what_whole_lines_and_the_baseline_leave(quantity: str) -> None:
    plan = plan_lines(SPEED_MPS, BASELINE_M, 0.01, RATE_HZ, U_BASELINE_M, length_m=LENGTH_M, time_gap_s=GAP_S)
    found = {one.quantity: one for one in plan.values}[quantity]
    error = simulated(40_000)[quantity]
    assert float(np.std(error)) == pytest.approx(found.u, rel=0.02)
    assert np.mean(np.abs(error) <= found.U95) == pytest.approx(0.95, abs=0.015)
    assert found.u == pytest.approx(sqrt(found.u_lines**2 + found.u_baseline**2 + found.u_edges**2))


def test_speed_is_planned_as_before() -> None:
    plan = plan_lines(SPEED_MPS, BASELINE_M, 0.01, RATE_HZ, U_BASELINE_M)
    speed = plan.values[0]
    assert (speed.u_lines, speed.u_baseline, speed.u) == (
        pytest.approx(plan.u_lines_mps),
        pytest.approx(plan.u_baseline_mps),
        pytest.approx(plan.u_speed_mps),
    )
    for wrong in ({"length_m": 0.0}, {"length_m": 101.0}, {"time_gap_s": -1.0}):
        with pytest.raises(ValueError, match="up to 100 m long"):
            plan_lines(SPEED_MPS, BASELINE_M, 0.01, RATE_HZ, **wrong)


def test_pixels_and_exposure_by_hand() -> None:
    # 10 um behind 20 mm at 4 m cover 2 mm; 100 us at 25 m/s are 2.5 mm; lines are 5 mm apart
    camera = LineCamera(10.0, 40.0, 20.0, 4.0, exposure_us=100.0)
    found = plan_exposure(camera, 25.0, 5000.0, 0.6)
    assert (found.pixel_width_m, found.pixel_height_m) == (pytest.approx(0.002), pytest.approx(0.008))
    assert (found.blur_m, found.smear_m) == (pytest.approx(0.0025), pytest.approx(0.0045))
    assert found.shape == pytest.approx(1.6) and found.row_error == pytest.approx(0.008 / 0.6)
    assert found.light == pytest.approx(400 / 25 * 0.1) and found.hints == ()
    whole = plan_exposure(LineCamera(5.0, 5.0, 20.0, 4.0), 25.0, 50_000.0, 0.6)
    assert whole.exposure_us == pytest.approx(20.0) and whole.light == pytest.approx(0.02)
    assert whole.hints == ("dark",)
    coarse = plan_exposure(LineCamera(50.0, 200.0, 20.0, 4.0), 25.0, 5000.0, 0.6)
    assert coarse.hints == ("tall",)
    assert plan_exposure(LineCamera(60.0, 20.0, 20.0, 4.0), 25.0, 5000.0, 0.6).hints == ("wide",)


@pytest.mark.parametrize(
    ("camera", "said"),
    [
        (LineCamera(10.0, 10.0, 20.0, 4.0, exposure_us=201.0), "201 µs is longer than one line, 200 µs"),
        (LineCamera(0.0, 10.0, 20.0, 4.0), "pixel_width_um of 0 is out of range"),
        (LineCamera(10.0, 10.0, 20.0, 4.0, exposure_us=-1.0), "exposure_us of -1 is out of range"),
        (LineCamera(10.0, 10.0, -3.0, 4.0), "focal_mm of -3 is out of range"),
    ],
)
def test_a_camera_that_cannot_be_is_refused(camera: LineCamera, said: str) -> None:
    with pytest.raises(BadInput, match=said):
        plan_exposure(camera, 25.0, 5000.0, 0.6)
