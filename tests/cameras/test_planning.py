"""The plan of a site: with a plain camera before anything is there, and with a survey's calibration."""

import pytest

from sightline.infra.services import Services
from tests.support.app import Client, error_of
from tests.support.ground import flat_camera, store_calibration

pytestmark = pytest.mark.once

PLAIN = "width_px=640&height_px=480&field_of_view_deg=67"
PLACE = "camera_height_m=1.5&distance_m=3"


def test_a_plan_before_anything_is_there(viewer: Client, survey_id: int) -> None:
    plan = viewer.seen(f"/surveys/{survey_id}/plan?{PLAIN}&{PLACE}")
    assert plan["site"]["board_distance_m"] == 3.0 and not plan["camera"]["lens_known"]
    targets = {t["target"]: t for t in plan["targets"]}
    assert set(targets) == {"roof", "driver_eye", "driver_eye_far", "taillight", "headlight"}
    eye = targets["driver_eye"]
    assert eye["bias_if_ignored_m"] == pytest.approx(0.35 * 0.45 / 3.45)
    squares = sum(part["u_m"] ** 2 for part in eye["budget"])
    assert squares**0.5 == pytest.approx(eye["u_height_m"])
    assert eye["two_frames"]["u_height_m"] < eye["u_height_m"]
    assert len(plan["U95_over_distance"]) == 5 and len(plan["bias_over_camera_height"]) == 2
    assert any("second frame" in sentence["message"] for sentence in plan["advice"])


def test_a_plan_with_the_surveys_calibration_and_insets(
    operator: Client, services: Services, survey_id: int
) -> None:
    _, calibration_id = store_calibration(services, survey_id, flat_camera())
    path = f"/surveys/{survey_id}/plan?calibration_id={calibration_id}&{PLACE}"
    before = operator.seen(path)["targets"][1]
    insets = {"driver_eye_near": {"inset_m": 0.6, "u_inset_m": 0.3, "note": ""}}
    operator.put(f"/surveys/{survey_id}", {"name": "Wide", "version": 1, "insets": insets})
    after = operator.seen(path)
    assert after["camera"]["width_px"] == flat_camera().width_px
    assert after["targets"][1]["inset_m"] == 0.6
    assert after["targets"][1]["u_height_m"] > before["u_height_m"]


def test_what_cannot_be_planned_is_said_in_words(
    operator: Client, services: Services, survey_id: int
) -> None:
    other = int(operator.made("/surveys", {"name": "Another"})["id"])
    _, foreign = store_calibration(services, other, flat_camera())
    for query, word in (
        (f"{PLAIN}&camera_height_m=-1&distance_m=3", "camera height"),
        (f"{PLAIN}&camera_height_m=nan&distance_m=3", "camera_height_m"),
        (f"{PLAIN}&{PLACE}&board_distance_m=0", "distance to the board"),
        (f"{PLAIN}&{PLACE}&direction_deg=80", "direction"),
        (f"width_px=640&height_px=480&field_of_view_deg=190&{PLACE}", "field of view"),
        (f"width_px=640&{PLACE}", "Choose a calibration"),
        (f"calibration_id={foreign}&{PLACE}", "another survey"),
    ):
        refused = operator.get(f"/surveys/{survey_id}/plan?{query}")
        assert refused.status_code in (400, 422), query
        assert word in error_of(refused)
    assert operator.get(f"/surveys/{survey_id}/plan?calibration_id=999&{PLACE}").status_code == 404
    assert operator.get(f"/surveys/999/plan?{PLAIN}&{PLACE}").status_code == 404


def test_a_line_rate_is_planned_in_both_forms(viewer: Client) -> None:
    rig = f"speed_mps={120 / 3.6}&baseline_m=1"
    plan = viewer.seen(f"/line-rate-plan?{rig}&error=0.01")
    assert plan["printed"]["line_rate_hz"] == pytest.approx(6600)
    assert plan["corrected"]["line_rate_hz"] == pytest.approx(20000 / 3)
    # not given, the line rate is that of 10 mm a line, which registering needs
    assert plan["line_rate_hz"] == plan["fine_hz"] == pytest.approx(10_000 / 3)
    assert plan["lines"] == pytest.approx(100)
    at_its = viewer.seen(f"/line-rate-plan?{rig}&error=0.01&line_rate_hz={20000 / 3}")
    assert at_its["corrected"]["error_mps"] == pytest.approx(0.01 * 120 / 3.6)
    assert at_its["printed"]["error"] == pytest.approx(2 / 202)
    # 2000 Hz: 16.7 mm of road a line; 0.1 mm and 0.015 of that, over a baseline of 1 m
    coarse = viewer.seen(f"/line-rate-plan?{rig}&error=0.01&line_rate_hz=2000&u_baseline_m=0.01")
    assert coarse["u_strips_mps"] == pytest.approx(120 / 3.6 * (0.0001**2 + (0.015 / 60) ** 2) ** 0.5)
    assert coarse["u_speed_mps"] ** 2 == pytest.approx(coarse["u_strips_mps"] ** 2 + (1.2 / 3.6) ** 2)
    assert any("more than the 1 % allowed" in one["message"] for one in coarse["advice"])
    assert any("baseline is the limit" in one["message"] for one in coarse["advice"])
    told = {one["quantity"]: one for one in coarse["values"]}
    assert set(told) == {"speed", "length", "time_gap", "distance_gap"}
    assert told["length"]["value"] == 4.5 and told["distance_gap"]["value"] == pytest.approx(50.0)
    assert told["speed"]["U95"] == pytest.approx(coarse["U95_speed_mps"]) and coarse["exposure"] is None
    pixels = "pixel_width_um=10&pixel_height_um=10&focal_mm=20&distance_m=3"
    seen = viewer.seen(f"/line-rate-plan?{rig}&error=0.01&line_rate_hz=2000&{pixels}")["exposure"]
    assert seen["exposure_us"] == pytest.approx(500) and seen["pixel_width_m"] == pytest.approx(0.0015)
    for query, word in (
        (f"{rig}&error=0.01&length_m=0", "up to 100 m long"),
        (f"{rig}&error=0.01&line_rate_hz=2000&{pixels}&exposure_us=501", "longer than one line"),
        (f"{rig}&error=0.01&{pixels.replace('=20', '=nan')}", "focal_mm"),
        (f"{rig}&error=1.5", "share between 0 and 1"),
        (f"{rig}&error=0.01&line_rate_hz=0", "give 10 to 1000000 Hz"),
        (f"{rig}&error=0.01&u_baseline_m=2", "less than the baseline"),
        ("speed_mps=nan&baseline_m=1&error=0.01", "speed_mps"),
    ):
        refused = viewer.get(f"/line-rate-plan?{query}")
        assert refused.status_code in (400, 422) and word in error_of(refused), query
