"""The set-up sheet of a plan: one page, in each language, with the plan's own numbers."""

import re
from math import radians

import pytest

from sightline import messages
from sightline.cameras.planning.sheet import _Sheet
from sightline.geometry.plan import plan_site
from sightline.geometry.site import Site, plain_camera
from tests.export.report.pdf_text import words
from tests.support.app import Client, error_of

ASKED = "camera_height_m=1.5&distance_m=3&width_px=1920&height_px=1080&field_of_view_deg=65"


@pytest.fixture
def survey(operator: Client) -> int:
    made: int = operator.made("/surveys", {"name": "Hill road"})["id"]
    return made


def text_of(pdf: bytes) -> str:
    return " ".join(words(pdf).split())


@pytest.mark.parametrize("language", messages.languages())
def test_the_sheet_is_one_page_with_the_plan_in_it(operator: Client, survey: int, language: str) -> None:
    answer = operator.get(f"/surveys/{survey}/plan.pdf?{ASKED}&language={language}")
    assert answer.headers["Content-Type"] == "application/pdf"
    assert len(re.findall(rb"/Type\s*/Page\b", answer.content)) == 1
    text = text_of(answer.content)
    assert "Hill road" in text and messages.say("sheet-check-row", {}, language).split(",")[0] in text
    plan = operator.seen(f"/surveys/{survey}/plan?{ASKED}")
    for one in plan["targets"]:
        assert (
            messages.say("sheet-millimetres", {"millimetres": 1000 * one["U95_height_m"]}, language) in text
        )
    for passing in plan["passing"]:
        assert f"1/{passing['shutter']} s" in text


@pytest.mark.parametrize("direction_deg", [0, 25])
def test_text_and_plan_set_the_board_along_the_traffic(
    operator: Client, survey: int, direction_deg: int
) -> None:
    """The board gives the road its direction: the camera is turned, not the board."""
    site = Site(camera_height_m=1.5, distance_m=3.0, direction_rad=radians(direction_deg))
    camera = plain_camera(1920, 1080, radians(65))
    ((end, other),) = _Sheet(plan_site(camera, site), camera, 65.0, "en").above()["board"]
    assert end[0] == other[0] and end[1] != other[1]  # as far across the road, along it
    text = text_of(operator.get(f"/surveys/{survey}/plan.pdf?{ASKED}&direction_deg={direction_deg}").content)
    assert "its rows along the traffic" in text and "turned by" not in text


def test_a_target_that_cannot_be_measured_has_no_number(operator: Client, survey: int) -> None:
    near = ASKED.replace("distance_m=3", "distance_m=0.6")
    plan = operator.seen(f"/surveys/{survey}/plan?{near}")
    assert any(one["U95_height_m"] is None for one in plan["targets"])
    assert "not measurable" in text_of(operator.get(f"/surveys/{survey}/plan.pdf?{near}").content)


def test_what_cannot_be_planned_is_refused_in_a_sentence(operator: Client, survey: int) -> None:
    odd = operator.get(f"/surveys/{survey}/plan.pdf?{ASKED}&language=xx")
    assert odd.status_code == 422 and "“xx”. Choose one of en" in error_of(odd)
    high = operator.get(f"/surveys/{survey}/plan.pdf?{ASKED.replace('=1.5', '=150')}")
    assert high.status_code == 422 and "camera height" in error_of(high)
