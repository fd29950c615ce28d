"""Statistics of scanned vehicles: what counts, and errors without what is common to all."""

import pytest

from sightline.scans.statistics.service import VehicleMotion, statistics_of_seen

pytestmark = pytest.mark.once


def seen(number: int, state: str = "accepted", **values: float) -> VehicleMotion:
    """A measured vehicle of 4 m, by default."""
    return VehicleMotion(
        vehicle_id=number,
        scan_id=1,
        number=number,
        state=state,
        measured=state != "not_measurable",
        lighting="daytime",
        values={"speed_mps": 10.0 + number, "length_m": 4.04, "u_length_m": 0.041, **values},
        known={"length_m": 4.0, "u_length_m": 0.005},
        rig_baseline_m=0.6,
        rig_u_baseline_m=0.006,
    )


def test_rejected_vehicles_never_count_and_unreviewed_ones_where_asked_for() -> None:
    found = [seen(1), seen(2, "to_review"), seen(3, "rejected"), seen(4, "not_measurable")]
    told = statistics_of_seen(found, accepted_only=True)
    assert told.counted == {
        "vehicles": 4,
        "used": 1,
        "without_time": 0,
        "to_review": 1,
        "accepted": 1,
        "rejected": 1,
        "not_measurable": 1,
    }
    assert [row.number for row in told.table] == [1]
    assert [row.number for row in statistics_of_seen(found, accepted_only=False).table] == [1, 2]
    speed, _, gap = told.spreads[:3]
    assert (speed.n, speed.mean, speed.sd) == (1, 11.0, None) and gap.n == 0 and gap.ecdf is None


def test_a_baseline_is_judged_without_its_own_uncertainty() -> None:
    told = statistics_of_seen([seen(n) for n in range(1, 8)], accepted_only=True)
    assert told.length_errors["overall"].figures["bias_m"] == pytest.approx(0.04)
    ratio = told.length_ratio
    # 1 % of 4.04 m is the baseline's and common; 7 mm, 1 mm and the makers' 5 mm are each vehicle's own
    alone = ((0.041**2 - 0.0404**2 + 1e-6 + (1.01 * 0.005) ** 2) ** 0.5) / 4.0
    assert ratio.value == pytest.approx(1.01) and ratio.u == pytest.approx(alone / 7**0.5, rel=1e-6)
    assert ratio.warning is not None and "1.00 % longer" in str(ratio.warning)
