"""No result of either method is a motion that no road vehicle has."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.coverage import expanded
from sightline.enums import ScanMethod
from sightline.linescan.either_way import WOULD_STOP
from sightline.linescan.methods import MEASURE, refuse_unlikely, unlikely_motion_reason
from sightline.linescan.parts import Crossings, Motion, Passage, Rig
from tests.linescan.scenes import RIG, SITE, found, plain_found
from tests.simulation.scan_strips import strips
from tests.simulation.scan_traffic import traffic, truths

SEEN = Crossings(1000.0, 2000.0, 1200.0, 2200.0)
GOOD = Motion(
    method="paper",
    crossings=SEEN,
    status="ok",
    speed_mps=20.0,
    u_speed_mps=0.05,
    acceleration_mps2=0.5,
    u_acceleration_mps2=0.1,
    length_m=4.1,
    u_length_m=0.02,
)


@pytest.fixture(scope="module")
def passage() -> Passage:
    return plain_found()[0][0]


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"speed_mps": -52.5, "u_speed_mps": 391.0, "length_m": -66.0}, "speed of -52.5 m/s"),
        ({"speed_mps": 120.0}, "speed of 120.0 m/s"),
        ({"length_m": 66.0}, "length of 66.0 m "),
        ({"acceleration_mps2": -14.0}, "acceleration of -14.0"),
        ({"speed_mps": 2.0, "acceleration_mps2": -10.5}, "stopped in view"),
        ({"u_speed_mps": 4.0}, "U95 of the speed is 39 %"),
        ({"u_length_m": 2.0}, "U95 of the length is 96 %"),
        ({"u_speed_mps": 0.0}, "Too little of the vehicle was matched"),
        ({"u_speed_mps": float("nan")}, "Too little of the vehicle was matched"),
        ({"speed_mps": float("nan")}, "computed speed is not a number"),
    ],
)
def test_a_motion_that_cannot_be_has_its_reason(
    changed: dict[str, float], said: str, passage: Passage
) -> None:
    motion = replace(GOOD, **changed)  # type: ignore[arg-type]
    refused = refuse_unlikely(lambda _passage, _rig: motion)(passage, Rig(0.593, 4882.8))
    assert refused.status == "not_measurable" and refused.reason is not None and said in str(refused.reason)
    assert refused.speed_mps is None and refused.length_m is None and refused.u_speed_mps is None
    assert refused.crossings == SEEN and refused.method == "paper"


def test_a_motion_that_may_be_is_left_as_it_is() -> None:
    assert unlikely_motion_reason(GOOD, RIG) is None
    assert unlikely_motion_reason(Motion("direct", SEEN, "not_measurable", WOULD_STOP), RIG) is None


numbers = st.floats(-200, 200, allow_nan=False)


@given(numbers, numbers, numbers, st.floats(0, 500, allow_nan=False))
def test_what_is_believed_is_within_all_limits(v: float, a: float, length: float, u: float) -> None:
    motion = replace(GOOD, speed_mps=v, acceleration_mps2=a, length_m=length, u_speed_mps=u)
    if unlikely_motion_reason(motion, RIG) is None:
        seconds = (SEEN.rear_line_1 - SEEN.front_line_1) / RIG.line_rate_hz
        assert 1 <= v <= 85 and 1 <= length <= 32 and abs(a) <= 11.5 and v + a * seconds > 0
        assert 1.96 * u <= 0.25 * v


def test_boundaries_at_wrong_places_give_no_number(passage: Passage) -> None:
    """Boundaries that a person put most of a vehicle's length off on camera 2."""
    c = passage.crossings
    for moved in (600.0, -600.0):
        wrong = Crossings(c.front_line_1, c.rear_line_1, c.front_line_2 + moved, c.rear_line_2 - moved)
        for method in ("direct", "paper"):
            motion = MEASURE[method](replace(passage, crossings=wrong), RIG)
            assert motion.status == "not_measurable" and motion.reason, (method, moved, motion.speed_mps)


@pytest.mark.once
@pytest.mark.parametrize("method", ["direct", "paper"])
@pytest.mark.parametrize("seed", [1, *(pytest.param(n, marks=pytest.mark.proof) for n in (0, *range(2, 12)))])
def test_no_nonsense_has_the_status_ok(method: ScanMethod, seed: int) -> None:
    """Whatever noise, line rate, speed and boundaries are: either a motion within physics that agrees with
    the truth within its own U95 times three, or a refusal in words. Boundaries move as by a careless hand.
    """
    rng = np.random.default_rng((seed, 4711))
    site = replace(
        SITE,
        rows=96,
        seed=seed,
        read_noise_dn=float(rng.choice([2.0, 8.0, 16.0])),
        line_rate_hz=float(rng.choice([4882.8, 1200.0, 300.0, 60.0])),
    )
    rig = Rig(site.baseline_m, site.line_rate_hz)
    vehicles = traffic(seed, 2, speeds_mps=(4.0, 40.0))
    speeds = [true.vehicle.speed_mps for true in truths(site, vehicles)]
    for passage in found(strips(site, vehicles), rig)[0]:
        for by in (0.0, float(rng.uniform(-0.8, 0.8))):
            c = passage.crossings
            span = by * (c.rear_line_1 - c.front_line_1)
            moved = replace(passage, crossings=replace(c, front_line_2=c.front_line_2 + span))
            motion = MEASURE[method](moved, rig)
            if motion.status != "ok":
                assert motion.reason and motion.speed_mps is None and motion.u_length_m is None
                continue
            assert unlikely_motion_reason(motion, rig) is None
            v, u = motion.speed_mps, motion.u_speed_mps
            assert v is not None and u is not None and 1 <= v <= 85 and 0 < u <= 0.13 * v
            assert 1 <= (motion.length_m or 0) <= 32 and (motion.u_length_m or 0) > 0
            assert min(abs(v - true) for true in speeds) < 3 * expanded(u)
