"""Known heights of eyes and lamps, and check targets: on the page, in the package, found when forged."""

from pathlib import Path
from typing import Any

import pytest

from sightline.export.verify.package import verify_package
from sightline.infra.csv_package.files import FolderFiles
from sightline.infra.services import Services
from tests.export.report.pdf_text import words
from tests.support.app import Client, error_of
from tests.support.ground import Ground, add_vehicle, lay_ground, measure, pixel
from tests.support.packages import edit, reseal, rows, written

pytestmark = pytest.mark.dialect
LAMP = {"known_taillight_m": 0.72, "u_known_taillight_m": 0.002, "known_taillight_source": "tape, 3 May"}


@pytest.fixture
def ground(services: Services, survey_id: int, recording_id: int) -> Ground:
    return lay_ground(services, survey_id, recording_id)


def lamp_at(height_m: float, **more: Any) -> dict[str, Any]:
    """Clicks on a taillight at a height above the contact, 3 m from the camera."""
    point = {"contact": pixel(0.0, 0.0, 0.0), "target_point": pixel(0.0, 0.0, height_m)}
    return {"target": "taillight", "inset_m": 0.0, "u_inset_m": 0.0, **point, **more}


@pytest.fixture
def compared(operator: Client, reviewer: Client, ground: Ground) -> Ground:
    """Two cars whose lamps are known, one whose lamp is not, and a check target with lamp and roof."""
    cars: list[tuple[dict[str, Any], float]] = [
        ({"lighting": "daytime", **LAMP}, 0.73),
        ({"lighting": "low_light", **LAMP, "u_known_taillight_m": None}, 0.70),
        ({"lighting": "daytime"}, 0.60),
        ({"lighting": "daytime", **LAMP, "check_target": True, "manufacturer_height_m": 1.3}, 0.90),
    ]
    for fields, height_m in cars:
        car = add_vehicle(operator, ground.recording_id, category="saloon", **fields)
        made = [measure(operator, car["id"], **lamp_at(height_m))]
        if car["check_target"]:
            made.append(measure(operator, car["id"]))
        for one in made:
            reviewer.made(f"/measurements/{one['id']}/reviews", {"revision": 1, "verdict": "accepted"})
    return ground


def of(found: list[dict[str, Any]], target: str, *, check: bool) -> dict[str, Any]:
    """The row of a target, of the traffic or of check targets."""
    return next(one for one in found if one["target"] == target and one["check_target"] == check)


def bias_mm(one: dict[str, Any], group: str = "all") -> float:
    value = next(row for row in one["groups"] if row["group"] == group)["figures"]["bias_m"]["value"]
    return 1000.0 * float(value)


def test_errors_are_told_by_target_and_check_targets_count_nowhere_else(
    viewer: Client, compared: Ground
) -> None:
    page = viewer.seen(f"/statistics?survey={compared.survey_id}")
    known = page["known_errors"]
    assert [(one["target"], one["check_target"]) for one in known] == [
        ("taillight", False),
        ("roof", True),
        ("taillight", True),
    ]
    traffic, check = of(known, "taillight", check=False), of(known, "taillight", check=True)
    assert bias_mm(traffic) == pytest.approx((10.0 - 20.0) / 2, abs=0.01)
    assert bias_mm(traffic, "daytime") == pytest.approx(10.0, abs=0.01)
    assert bias_mm(traffic, "saloon") == bias_mm(traffic)
    assert bias_mm(check) == pytest.approx(180.0, abs=0.01)
    assert traffic["inside"]["n"] == 1  # of the other nobody said how sure it is
    raw = viewer.seen(f"/statistics?survey={compared.survey_id}&correction=none")["known_errors"]
    assert "n" not in of(raw, "taillight", check=False)["inside"]  # U95 is of the corrected height
    # the heights of the traffic: no row of the check target
    lamps = next(one for one in page["targets"] if one["target"] == "taillight")
    assert lamps["corrected"]["n"] == 3 and page["counted"]["vehicles"] == 3
    assert page["counted"]["with_reference"] == 0
    assert next(one for one in page["targets"] if one["target"] == "roof")["raw"]["n"] == 0
    sample = viewer.seen(f"/surveys/{compared.survey_id}/sample")["response"]
    of_all = next(
        one
        for one in sample
        if one["lighting"] == "all" and one["class_set"] == "all" and one["target"] is None
    )
    assert of_all["in_sample"] == 3


@pytest.mark.once
def test_a_package_carries_them_and_a_forged_one_is_found(
    services: Services, compared: Ground, tmp_path: Path
) -> None:
    place = written(services, compared.survey_id, tmp_path / "package")
    lamp = next(row for row in rows(place, "vehicles.csv") if row["check_target"] == "true")
    assert (lamp["known_taillight_m"], lamp["known_taillight_source"]) == ("0.720000", "tape, 3 May")
    told = {
        (row["target"], row["check_target"]): float(row["value"])
        for row in rows(place, "statistics/errors_by_target.csv")
        if (row["heights"], row["group"], row["figure"]) == ("inset", "all", "bias_m")
    }
    assert told["taillight", "true"] == pytest.approx(0.18, abs=1e-5)
    left_out = rows(place, "exclusions.csv")
    assert {row["state"] for row in left_out} == {"check_target"} and len(left_out) == 2
    report = " ".join(words((place / "report.pdf").read_bytes()).split())
    glance, rest = report.split("Not covered", 1)
    assert "Taillight, lower edge, check targets" in glance and "Taillight, lower edge, check targets" in rest
    found = verify_package(FolderFiles(place))
    assert found.ok, found.problem
    lies: tuple[dict[str, str], ...] = ({"known_taillight_m": "0.900000"}, {"check_target": "false"})
    for n, lie in enumerate(lies):
        forged = written(services, compared.survey_id, tmp_path / f"forged-{n}")
        edit(forged, "vehicles.csv", lambda row: row["check_target"] == "true", **lie)
        reseal(forged, page=True)
        assert not verify_package(FolderFiles(forged)).ok


@pytest.mark.once
def test_a_known_height_that_cannot_be_is_refused(operator: Client, ground: Ground) -> None:
    car = add_vehicle(operator, ground.recording_id)["id"]
    for wrong in ({"known_driver_eye_m": 1160.0}, {"u_known_other_m": -0.1}):
        answer = operator.put(f"/vehicles/{car}", {**wrong, "version": 1})
        assert answer.status_code == 422 and error_of(answer)
    feet = operator.put(f"/vehicles/{car}", {"known_driver_eye_m": 3.8, "version": 1})
    assert error_of(feet) == "A driver’s eye height of 3.8 m is out of range; give 0.3 to 3.5 m."
    seen = operator.put(f"/vehicles/{car}", {"known_driver_eye_m": 1.16, "version": 1}).json()
    assert (seen["known_driver_eye_m"], seen["check_target"]) == (1.16, False)
