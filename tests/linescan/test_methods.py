"""No result of either method is a motion that no road vehicle has."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sightline.linescan.methods import MEASURE, believed, unlikely
from sightline.linescan.parts import Crossings, Motion, Passage, Rig
from tests.linescan.scenes import RIG, found, plain

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
    return found(plain())[0][0]


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"speed_mps": -52.5, "u_speed_mps": 391.0, "length_m": -66.0}, "speed, -52.5 m/s"),
        ({"speed_mps": 120.0}, "speed, 120.0 m/s"),
        ({"length_m": 66.0}, "length, 66.0 m,"),
        ({"acceleration_mps2": -14.0}, "acceleration, -14.0"),
        ({"speed_mps": 2.0, "acceleration_mps2": -10.5}, "stopped in view"),
        ({"u_speed_mps": 4.0}, "speed is unsure by 39 %"),
        ({"u_length_m": 2.0}, "length is unsure by 96 %"),
    ],
)
def test_a_motion_that_cannot_be_has_its_reason(
    changed: dict[str, float], said: str, passage: Passage
) -> None:
    motion = replace(GOOD, **changed)  # type: ignore[arg-type]
    refused = believed(lambda _passage, _rig: motion)(passage, Rig(0.593, 4882.8))
    assert refused.status == "not_measurable" and refused.reason is not None and said in refused.reason
    assert refused.speed_mps is None and refused.length_m is None and refused.u_speed_mps is None
    assert refused.crossings == SEEN and refused.method == "paper"


def test_a_motion_that_may_be_is_left_as_it_is() -> None:
    assert unlikely(GOOD, RIG) is None
    assert unlikely(Motion("direct", SEEN, "not_measurable", "It rained."), RIG) is None


numbers = st.floats(-200, 200, allow_nan=False)


@given(numbers, numbers, numbers, st.floats(0, 500, allow_nan=False))
def test_what_is_believed_is_within_all_limits(v: float, a: float, length: float, u: float) -> None:
    motion = replace(GOOD, speed_mps=v, acceleration_mps2=a, length_m=length, u_speed_mps=u)
    if unlikely(motion, RIG) is None:
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
