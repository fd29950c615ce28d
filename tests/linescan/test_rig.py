"""What the traffic says of the rig, and wheelbases from two clicks."""

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from sightline.errors import BadInput
from sightline.linescan.finding import STOPPED
from sightline.linescan.gaps import gaps
from sightline.linescan.parts import Crossings, Lane, Motion, Rig
from sightline.linescan.rig import RigEstimate, baseline_ratio, gain, misalignment, require_rig, wheelbase

RIG = Rig(0.593, 4882.8)


def motion(**more: float) -> Motion:
    return Motion("direct", Crossings(1000, 2000, 1200, 2200), "ok", None, **more)  # type: ignore[arg-type]


def test_the_rigs_constants_are_medians_that_one_bad_vehicle_does_not_move() -> None:
    rng = np.random.default_rng(4)
    motions = [
        motion(misalignment_px=0.6 + rng.normal(0, 0.03), u_misalignment_px=0.03, gain=1.04)
        for _ in range(30)
    ]
    motions[3] = motion(misalignment_px=5.0, u_misalignment_px=0.03, gain=1.3)
    found = misalignment(motions)
    assert found.value == pytest.approx(0.6, abs=0.02) and found.warning is None and found.n == 30
    assert found.u is not None and 0.003 < found.u < 0.015
    assert gain(motions).value == 1.04
    assert "5 are needed" in str(misalignment(motions[:4]).reason)
    scattered = [motion(misalignment_px=one, u_misalignment_px=0.03) for one in np.linspace(-1, 1, 20)]
    assert "camera moved" in str(misalignment(scattered).warning)


def test_the_medians_uncertainty_holds() -> None:
    rng = np.random.default_rng(5)
    inside = 0
    for _ in range(1000):
        found = misalignment([motion(misalignment_px=rng.normal(0.2, 0.05)) for _ in range(15)])
        inside += abs(found.value - 0.2) < 1.96 * found.u
    assert 0.92 < inside / 1000 < 0.985


def test_known_lengths_check_the_baseline() -> None:
    rng = np.random.default_rng(6)
    truth = rng.uniform(2.4, 3.0, 12)
    right = baseline_ratio("wheelbase", truth + rng.normal(0, 0.01, 12), [0.01] * 12, truth, [0.002] * 12)
    said = "of known vehicles are off by 0.06 % on average, within the U95 of this mean (0.22 %)"
    assert right.warning is None and f"12 wheelbases {said}" in str(right.agrees)
    assert right.value == pytest.approx(1, abs=0.004)
    long = baseline_ratio("length", 1.01 * truth + rng.normal(0, 0.01, 12), [0.01] * 12, truth, [0.002] * 12)
    assert "longer" in str(long.warning) and long.value == pytest.approx(1.01, abs=0.004)
    assert "too few" in str(baseline_ratio("wheelbase", [2.6], [0.01], [2.6], [0.01]).reason)


def test_a_baseline_that_is_said_to_agree_is_off_by_its_u95_at_most() -> None:
    """u = 1 % each, of nine 0.333 %: U95 is 0.653 %, twice u 0.667 %."""

    def found(off: float) -> RigEstimate:
        return baseline_ratio("wheelbase", [2.5 * (1 + off)] * 9, [0.025] * 9, [2.5] * 9, [0.0] * 9)

    assert found(0.0065).warning is None and found(0.0065).agrees is not None
    assert found(0.0066).agrees is None and "longer" in str(found(0.0066).warning)


def test_a_wheelbase_is_what_the_motion_covers_between_the_hubs() -> None:
    moving = motion(
        speed_mps=17.0, u_speed_mps=0.01, acceleration_mps2=-1.2, u_acceleration_mps2=0.1, correlation=-0.9
    )
    seconds = np.array([0.05, 0.21])
    lines = 1000 + seconds * RIG.line_rate_hz
    expected = np.diff(17.0 * seconds - 0.6 * seconds**2)[0]
    found = wheelbase(moving, RIG, lines[1], lines[0])
    assert found.wheelbase_m == pytest.approx(expected, abs=1e-12)
    rng = np.random.default_rng(7)
    spread = np.array([[1e-4, -0.9e-3], [-0.9e-3, 1e-2]])
    drawn = rng.multivariate_normal([17.0, -1.2], spread, 4000)
    clicks = np.sort(seconds + rng.normal(0, 2 / RIG.line_rate_hz, (4000, 2)))
    way = drawn[:, :1] * clicks + drawn[:, 1:] / 2 * clicks**2
    assert found.u_wheelbase_m == pytest.approx(np.std(way[:, 1] - way[:, 0]), rel=0.05)


@pytest.mark.parametrize("clock", [0.0, 0.01])
def test_the_clock_moves_no_wheelbase_and_no_gap(clock: float) -> None:
    """1 % of line rate: speed and both times err together, so the way between two lines does not."""
    v, a, rig = 20.0, 1.5, replace(RIG, u_line_rate_ratio=clock)
    fitted = np.array([[1e-4, -0.9e-3], [-0.9e-3, 1e-2]])
    spread = fitted + clock**2 * np.outer([v, 2 * a], [v, 2 * a])
    u_v, u_a = np.sqrt(np.diag(spread))
    moving = motion(
        speed_mps=v,
        u_speed_mps=u_v,
        acceleration_mps2=a,
        u_acceleration_mps2=u_a,
        correlation=spread[0, 1] / (u_v * u_a),
        length_m=4.2,
    )
    found = wheelbase(moving, rig, 1300.0, 1900.0, u_line=0.0)
    begin_s, end_s = 300.0 / rig.line_rate_hz, 900.0 / rig.line_rate_hz
    gradient = np.array([end_s - begin_s, (end_s**2 - begin_s**2) / 2])
    assert found.u_wheelbase_m == pytest.approx((gradient @ fitted @ gradient) ** 0.5, rel=1e-6)
    unmeasured = Motion("direct", Crossings(6000, 7000, 6200, 7200), "not_measurable", STOPPED)
    gap = gaps([(moving.crossings, moving), (unmeasured.crossings, unmeasured)], rig)[1]
    begin_s, end_s = 1000.0 / rig.line_rate_hz, 5000.0 / rig.line_rate_hz
    gradient = np.array([end_s - begin_s, (end_s**2 - begin_s**2) / 2])
    # its rear's place, to 0.06 lines at 20 m/s, is 0.3 mm
    assert gap.u_distance_gap_m == pytest.approx((gradient @ fitted @ gradient) ** 0.5, rel=1e-3)


def test_clicks_that_give_no_wheelbase_have_a_reason() -> None:
    none = Motion("direct", Crossings(0, 1, 2, 3), "not_measurable", STOPPED)
    assert wheelbase(none, RIG, 1, 2).reason == STOPPED
    moving = motion(speed_mps=10.0, acceleration_mps2=-4.0)
    assert "different wheels" in str(wheelbase(moving, RIG, 1500, 1500).reason)
    assert "at rest" in str(wheelbase(moving, RIG, 1500, 1000 + 4882.8 * 3).reason)


@pytest.mark.parametrize(
    ("field", "value", "says"),
    [
        ("baseline_m", 0.0, "A baseline of 0 m is out of range; give 0.01 to 100 m."),
        ("baseline_m", float("nan"), "A baseline of nan m"),
        ("line_rate_hz", 2e6, "A line rate of 2000000 Hz is out of range; give 10 to 1000000 Hz."),
        ("u_baseline_m", 0.7, "give 0 to 0.593 m."),
        ("u_line_rate_ratio", -1e-3, "give 0 to 0.1 of the line rate."),
        ("divergence_rad", 0.3, "A divergence of 0.3 rad"),
        ("shadow_share", 0.61, "A shadow zone of 0.61 of the rows"),
        ("distance_m", 0.0, "A distance to the vehicles of 0 m"),
        ("misalignment_px", 2e3, "A misalignment of 2000 px"),
        ("baseline_correlation", -1.1, "A correlation of baseline and divergence of -1.1"),
        ("u_distance_m", -0.1, "An uncertainty of the distance to the vehicles of -0.1 m"),
        ("divergence_rad", 1e-3, "A divergence needs the distance"),
        ("u_divergence_rad", 1e-4, "A divergence needs the distance"),
    ],
)
def test_values_that_no_rig_has_are_refused(field: str, value: float, says: str) -> None:
    rig = Rig(baseline_m=0.593, line_rate_hz=4882.8, u_baseline_m=0.0003)
    require_rig(rig)
    with pytest.raises(BadInput, match=re.escape(says)):
        require_rig(replace(rig, **{field: value}))


@pytest.mark.parametrize(
    ("away", "says"),
    [
        ({"distance_m": 12.0}, "planes cross in front of the vehicles, which are 12 m away; correct"),
        ({"lanes": (Lane("near", 5.0), Lane("far", 12.0))}, "planes cross in front of the vehicles, which"),
        ({"lanes": (Lane("far", 11.8), Lane("near", 5.0))}, "planes are 0.003 m apart at 11.8 m"),
    ],
)
def test_planes_that_meet_before_the_vehicles_are_refused(away: dict[str, Any], says: str) -> None:
    """0.593 m and 50 mrad towards each other: beyond 11.86 m, speeds would be negative."""
    rig = Rig(0.593, 4882.8, divergence_rad=-0.05)
    require_rig(replace(rig, distance_m=5.0))
    with pytest.raises(BadInput, match=re.escape(says)):
        require_rig(replace(rig, **away))
