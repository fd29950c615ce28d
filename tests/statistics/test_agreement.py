"""Trend, limits of agreement, the reference's part and the corrections, against SciPy and by simulation."""

import numpy as np
import pytest
from scipy import stats

from sightline.messages.said import Said
from sightline.statistics.agreement import bland_altman, reference_part, trend
from sightline.statistics.corrections import CORRECTIONS, Known, correct_heights
from sightline.statistics.errors import error_group
from sightline.statistics.shared_errors import SharedErrors
from sightline.statistics.summary import Roofs, errors_of
from sightline.statistics.total_uncertainty import HeightSample

U_TRUTH = 0.03 / np.sqrt(3)


def test_trend_is_scipys_and_its_band_holds() -> None:
    rng = np.random.default_rng(1)
    height = rng.normal(1.5, 0.12, 80)
    held = []
    for _ in range(400):
        error = 0.01 - 0.05 * (height - 1.5) + rng.normal(0, 0.02, 80)
        found = trend(height, error)
        assert not isinstance(found, Said)
        true = 0.01 - 0.05 * (found.at[10] - 1.5)
        held.append(found.low[10] <= true <= found.high[10])
        held.append(found.slope_ci95.low <= -0.05 <= found.slope_ci95.high)
    assert np.mean(held) == pytest.approx(0.95, abs=0.025)
    assert not isinstance(found, Said)
    line = stats.linregress(height, error)
    assert (found.slope, found.intercept) == pytest.approx((line.slope, line.intercept))
    assert found.correlation == pytest.approx(line.rvalue)
    assert "at least 4" in str(trend([1.0], [0.0])) and "same" in str(trend([1.0] * 9, np.arange(9.0)))


def test_errors_of_one_size_either_way_are_not_said_to_be_the_same() -> None:
    reference = np.linspace(1.4, 1.6, 20)
    measured = reference + 0.01 * (-1.0) ** np.arange(20)
    roofs = Roofs(measured, measured, reference, np.full(20, U_TRUTH), np.array(["daytime"] * 20))
    found = errors_of(roofs, "inset", "none")
    assert not isinstance(found.trend, Said) and not isinstance(found.bland_altman, Said)
    assert str(found.absolute_trend) == "All errors are of the same size, so there is no trend."


def test_limits_of_agreement() -> None:
    error = np.random.default_rng(3).normal(0.01, 0.02, 200)
    found = bland_altman(error)
    assert not isinstance(found, Said)
    assert found.bias_m == pytest.approx(error.mean())
    assert found.upper_m - found.bias_m == pytest.approx(1.959964 * error.std(ddof=1), rel=1e-6)
    rng = np.random.default_rng(4)
    held = []
    for _ in range(500):
        one = bland_altman(rng.normal(0.0, 0.02, 120))
        assert not isinstance(one, Said)
        held.append(one.upper_ci95.low <= 1.959964 * 0.02 <= one.upper_ci95.high)
    assert np.mean(held) == pytest.approx(0.95, abs=0.03)
    assert "at least 4" in str(bland_altman([0.1]))


@pytest.mark.parametrize("surveys", [40, pytest.param(400, marks=pytest.mark.proof)])
def test_limits_of_agreement_are_no_surer_than_the_bias_that_they_lie_about(surveys: int) -> None:
    """Errors that share a pose's, u 10 mm: both limits move with it; coverage over simulated surveys."""
    rng = np.random.default_rng(8)
    shared = (SharedErrors(np.zeros(80, dtype=np.int64), np.full(80, 0.01)),)
    lower, upper = -1.959964 * 0.015, 1.959964 * 0.015
    held = []
    for _ in range(surveys):
        error = rng.normal(0.0, 0.015, 80) + rng.normal(0.0, 0.01)
        reference = rng.normal(1.5, 0.1, 80)
        group = error_group(error, reference, HeightSample(reference, np.full(80, 0.01), shared))
        found, bias = bland_altman(error, *group.total_ends()), group.ci95["bias_m"]
        assert not isinstance(found, Said) and bias is not None
        widths = [one.high - one.low for one in (found.lower_ci95, found.upper_ci95)]
        assert min(widths) > bias.high - bias.low
        held.append(found.lower_ci95.low <= lower <= found.lower_ci95.high)
        held.append(found.upper_ci95.low <= upper <= found.upper_ci95.high)
    assert 0.90 <= np.mean(held) <= 0.99


def test_a_survey_states_the_total_intervals_of_its_limits_of_agreement() -> None:
    rng = np.random.default_rng(9)
    reference = rng.normal(1.5, 0.1, 60)
    measured, lighting = reference + rng.normal(0.0, 0.015, 60), np.array(["daytime"] * 60)
    one_pose = (SharedErrors(np.zeros(60, dtype=np.int64), np.full(60, 0.02)),)
    widths = []
    for shared in ((), one_pose):
        parts = HeightSample(measured, np.full(60, 0.01), shared)
        roofs = Roofs(measured, measured, reference, np.full(60, 0.01), lighting, parts)
        found = errors_of(roofs, "inset", "none").bland_altman
        assert not isinstance(found, Said)
        widths.append(found.upper_ci95.high - found.upper_ci95.low)
    assert widths[0] < 0.02 and widths[1] > 2 * 1.96 * 0.02


def test_what_an_uncertain_reference_explains() -> None:
    """A perfect camera against +-3 cm: everything; the negative correlation it makes is foretold."""
    rng = np.random.default_rng(7)
    true = rng.normal(1.5, 0.115, 40_000)
    reference = true + rng.uniform(-0.03, 0.03, len(true))
    for camera_sd in (0.0067, 0.019):
        error = true + rng.normal(0, camera_sd, len(true)) - reference
        found = reference_part(error, reference, U_TRUTH)
        assert not isinstance(found, Said) and found.camera_sd_m is not None
        assert found.camera_sd_m == pytest.approx(camera_sd, rel=0.06)
        assert found.share_of_variance == pytest.approx(U_TRUTH**2 / (U_TRUTH**2 + camera_sd**2), rel=0.03)
        assert found.correlation_alone == pytest.approx(float(np.corrcoef(error, reference)[0, 1]), abs=0.015)
    nothing = reference_part(0.5 * (true - reference), reference, U_TRUTH)
    assert not isinstance(nothing, Said) and nothing.camera_sd_m is None and "all of" in str(nothing.words)
    rounded = reference_part(error, reference, U_TRUTH, rounded=True)
    assert not isinstance(rounded, Said) and rounded.camera_sd_m is not None
    assert rounded.rounding_share * np.var(error, ddof=1) == pytest.approx(2 * 0.01**2 / 12)


def simulated(n: int = 4000) -> tuple[np.ndarray, np.ndarray, np.ndarray, Known]:
    """(true eye heights, corrected by inset, the paper's, known roofs), camera 1.5 m high, inset .45."""
    rng = np.random.default_rng(11)
    camera_m, distance_m = 1.5, rng.uniform(1.5, 5.0, n)
    eye = rng.normal(1.2, 0.08, n)
    noise = rng.normal(0, 0.006, n)
    paper = eye + (camera_m - eye) * 0.45 / (distance_m + 0.45) + noise
    roof = rng.normal(1.52, 0.1, 400)
    seen = roof + (camera_m - roof) * 0.3 / (3.0 + 0.3) + rng.normal(0, 0.006, 400)
    return eye, eye + noise, paper, Known(seen, seen - roof)


def test_corrections_as_the_paper_may_be_read() -> None:
    eye, by_inset, paper, known = simulated()
    apart = {}
    for kind in CORRECTIONS:
        found = correct_heights(kind, by_inset, paper, known, camera_sd_m=0.006)
        assert not isinstance(found, Said) and found.words
        apart[kind] = 1000 * (np.percentile(found.height_m, 50) - np.percentile(eye, 50))
    # raw is tens of millimetres too high, a shift by roofs does not mend it, the inset does
    assert apart["none"] > 25 and apart["shift"] > 25 and abs(apart["inset"]) < 2
    shifted = correct_heights("shift", by_inset, paper, known)
    assert not isinstance(shifted, Said)
    assert np.allclose(shifted.height_m, paper - known.error_m.mean())
    regressed = correct_heights("regression", by_inset, paper, known)
    assert not isinstance(regressed, Said) and regressed.warning and "extrapolates" in str(regressed.warning)
    narrower = correct_heights("deconvolution", by_inset, paper, known, camera_sd_m=0.03)
    assert not isinstance(narrower, Said)
    assert np.var(narrower.height_m, ddof=1) == pytest.approx(np.var(paper, ddof=1) - 0.03**2)


def test_corrections_that_cannot_be_made_say_why() -> None:
    _, by_inset, paper, known = simulated(50)
    few = Known(known.measured_m[:2], known.error_m[:2])
    assert "at least 4" in str(correct_heights("shift", by_inset, paper, few))
    assert "is unknown" in str(correct_heights("deconvolution", by_inset, paper, known, None))
    assert "cannot be removed" in str(correct_heights("deconvolution", by_inset, paper, known, 0.5))
    level = Known(np.full(9, 1.5), np.linspace(0.0, 0.08, 9))
    assert "one height" in str(correct_heights("regression", by_inset, paper, level))
