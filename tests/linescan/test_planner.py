"""Expected uncertainties against the default chain on simulated strips; pixels and exposure by hand."""

from math import hypot, sqrt

import numpy as np
import pytest
from scipy.stats import chi2

from sightline.coverage import COVERAGE_95
from sightline.demo.scan import RIG as DEMO_RIG
from sightline.errors import BadInput
from sightline.linescan.exposure import LineCamera, plan_exposure
from sightline.linescan.gaps import gaps
from sightline.linescan.methods import MEASURE
from sightline.linescan.parts import Rig
from sightline.linescan.planner import COARSE_LINE_M, LinePlan, plan_lines
from tests.linescan.scenes import found
from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import ScanSite, traffic, truths

pytestmark = pytest.mark.once
SPEED_MPS, BASELINE_M, U_BASELINE_M, RATE_HZ = 25.0, 0.6, 0.004, 3000.0
# seed, line rate, slowest and fastest, baseline
SITES = (
    (31, 2441.4, (25.0, 36.0), 0.593),
    (32, 2441.4, (12.0, 18.0), 0.593),
    (33, 4882.8, (25.0, 36.0), 0.3),
    (34, 1220.7, (12.0, 18.0), 1.2),
    (35, 9765.6, (15.0, 36.0), 0.593),
    (36, 2441.4, (28.0, 36.0), 0.593),
)


def missed(
    seed: int, rate_hz: float, speeds_mps: tuple[float, float], baseline_m: float, n: int
) -> np.ndarray:
    """Errors of speed, length and the distance gap before each of n simulated vehicles over the standard
    uncertainties planned, and what is planned of the gap over what is stated: (n, 4), NaN of the first gap.
    """
    site = ScanSite(rows=256, line_rate_hz=rate_hz, misalignment_px=0.4, seed=seed, baseline_m=baseline_m)
    cars = traffic(seed, n, speeds_mps=speeds_mps, gaps_s=(0.4, 0.6))
    rig = Rig(baseline_m, rate_hz)
    passages = found(strips(site, cars), rig)[0]
    assert len(passages) == n
    motions = [MEASURE["direct"](passage, rig) for passage in passages]
    before = gaps([(one.crossings, motion) for one, motion in zip(passages, motions, strict=True)], rig)
    out = []
    for motion, car, gap, true in zip(motions, cars, before, truths(site, cars), strict=True):
        assert true.vehicle is car and motion.speed_mps is not None and motion.length_m is not None
        told_s = {} if gap.time_gap_s is None else {"time_gap_s": gap.time_gap_s}
        plan = plan_lines(car.speed_mps, baseline_m, 0.01, rate_hz, length_m=car.length_m, **told_s)
        speed, length, _, distance_gap = plan.values
        out.append(
            [
                (motion.speed_mps - car.speed_mps) / speed.u,
                (motion.length_m - car.length_m) / length.u,
                ((gap.distance_gap_m or np.nan) - (true.distance_gap_m or np.nan)) / distance_gap.u,
                distance_gap.u / (gap.u_distance_gap_m or np.nan),
            ]
        )
    return np.array(out)


@pytest.mark.parametrize("vehicles", [3, pytest.param(5, marks=pytest.mark.proof)])
def test_the_demonstrations_own_rig_is_planned_as_it_measures(vehicles: int) -> None:
    """Fast vehicles, within what chance allows so few (chi-square, 0.1 % on either side). To whole lines the
    plan would be off by the tenfold. A single gap's own u scatters as what few clusters of errors tell.
    """
    each = missed(*SITES[0], n=vehicles)
    speed, length = np.sum(np.square(each[:, :2]), axis=0)
    least, most = chi2.ppf((0.001, 0.999), vehicles)
    assert least < speed < most and least < length < most
    least, most = chi2.ppf((0.001, 0.999), vehicles - 1)
    assert least < np.sum(np.square(each[1:, 2])) < most
    assert 0.4 < np.median(each[1:, 3]) < 2.5


@pytest.mark.proof
def test_the_expected_uncertainty_is_what_simulated_vehicles_leave() -> None:
    """Lines 2 to 15 mm apart, baselines of 0.3 to 1.2 m: neither too small nor idle."""
    each = np.concatenate([missed(*site, n=8) for site in SITES])
    speed, length = np.abs(each).T[:2]
    assert np.mean(speed <= COVERAGE_95) >= 0.9 and 0.6 < np.sqrt(np.mean(speed**2)) < 1.1
    # few lengths err by a contrast that is missing at one end; of those a vehicle's own u tells
    assert np.mean(length <= COVERAGE_95) >= 0.85 and 0.4 < np.median(length) / 0.6745 < 1.2


def planned(**changes: float) -> LinePlan:
    rig = {
        "speed_mps": 120 / 3.6,
        "line_rate_hz": DEMO_RIG.line_rate_hz,
        "u_baseline_m": DEMO_RIG.u_baseline_m,
    }
    return plan_lines(**{"baseline_m": DEMO_RIG.baseline_m, "error": 0.01, **rig, **changes})


def test_the_demonstrations_rig_is_fit_for_120_km_h() -> None:
    plan = planned()
    # 0.0001 m and 0.015 of 13.65 mm, over 0.593 m; with the baseline's 0.3 mm: 0.15 km/h where it said 2.21
    share = hypot(0.0001, 0.015 * 120 / 3.6 / 2441.4, 0.0003) / 0.593
    assert plan.u_speed_mps == pytest.approx(120 / 3.6 * share)
    assert 3.6 * plan.U95_speed_mps == pytest.approx(0.149, abs=0.001)
    assert plan.fine_hz == pytest.approx(120 / 3.6 / 0.010)
    assert str(plan.words[0]) == (
        "The vehicle moves 13.7 mm from line to line, which can be measured; 3330 Hz brings it to 10 mm."
    )
    assert not any("more than" in str(one) for one in plan.words)
    assert plan_lines(120 / 3.6, 0.593, 0.01).line_rate_hz == plan.fine_hz


def test_what_stops_a_rig_is_said() -> None:
    """A baseline of 10 cm misses 0.1 %, the advised one reaches it. Lines too far apart, and too few."""
    short = planned(baseline_m=0.1, error=0.001)
    times = short.U95_speed_mps / short.speed_mps / 0.001
    # 1.96 times 0.377 mm over 0.1 m; fewer than 8 lines would be said first
    assert f"{times:.1f}" == "7.4" and str(short.words[0]).startswith("Only 7.3 lines")
    assert "use a baseline 7.4 times as long, measured as accurately" in str(short.words[2])
    longer = planned(baseline_m=0.1 * times, error=0.001)
    assert longer.U95_speed_mps / longer.speed_mps == pytest.approx(0.001)
    coarse = planned(line_rate_hz=120 / 3.6 / COARSE_LINE_M * 0.99, baseline_m=0.15)
    assert str(coarse.words[0]).startswith("Only 7.4 lines lie between the cameras")
    assert str(coarse.words[1]).endswith("beyond 20 mm most vehicles are refused. Use 3330 Hz or more.")
    assert any("The baseline is the limit" in str(one) for one in planned(u_baseline_m=0.002).words)
    assert any(
        "Registering the strips is the limit" in str(one) for one in planned(u_baseline_m=0.0001).words
    )


def test_speed_is_planned_once() -> None:
    plan = plan_lines(SPEED_MPS, BASELINE_M, 0.01, RATE_HZ, U_BASELINE_M)
    speed = plan.values[0]
    assert (speed.u_strips, speed.u_baseline, speed.u) == (
        pytest.approx(plan.u_strips_mps),
        pytest.approx(plan.u_baseline_mps),
        pytest.approx(plan.u_speed_mps),
    )
    for one in plan.values:
        assert one.u == pytest.approx(sqrt(one.u_strips**2 + one.u_baseline**2 + one.u_edges**2))
    for wrong in ({"length_m": 0.0}, {"length_m": 101.0}, {"time_gap_s": -1.0}):
        with pytest.raises(BadInput, match="up to 100 m long"):
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
