"""The set-up sheet of a plan: one page, in each language, with the plan's own numbers."""

import re

import pytest

from sightline import messages
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
