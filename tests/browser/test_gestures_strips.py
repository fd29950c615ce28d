"""The pointer on the strips: a boundary is dragged, let go by Escape, and taken back."""

from typing import Any

import pytest
from playwright.sync_api import Locator, Page, expect


def undo_title(page: Page) -> str:
    return page.get_by_test_id("undo").get_by_role("button").get_attribute("title") or ""


def undo_button(page: Page) -> Locator:
    return page.get_by_test_id("undo").get_by_role("button")


@pytest.fixture
def bench(page: Page, survey_id: int) -> tuple[Locator, dict[str, Any]]:
    """The strips with the first vehicle chosen, and that vehicle as the server has it."""
    scan = page.request.get(f"/api/surveys/{survey_id}/scans").json()[0]
    vehicle = page.request.get(f"/api/scans/{scan['id']}/vehicles").json()[0]
    page.goto(f"/surveys/{survey_id}/scan?scan={scan['id']}")
    page.get_by_test_id(f"scan-vehicle-{vehicle['number']}").get_by_role("button").click()
    expect(page.get_by_test_id("scan-length")).to_contain_text(f"{vehicle['measurement']['length_m']:.3f}")
    strips = page.get_by_test_id("strips")
    strips.focus()
    page.keyboard.press("q")  # the vehicle fills the window
    return strips, vehicle


def front_at(strips: Locator) -> tuple[float, float]:
    """On the front in strip 1, while the vehicle is shown with a quarter of it before and behind."""
    box = strips.bounding_box()
    assert box
    return box["x"] + 0.25 / 1.5 * box["width"], box["y"] + 60


@pytest.mark.usefixtures("kept")
def test_a_boundary_of_the_strips_is_dragged_and_let_go_by_escape(
    page: Page, bench: tuple[Locator, dict[str, Any]]
) -> None:
    strips, vehicle = bench
    length = page.get_by_test_id("scan-length")
    said, title = length.inner_text(), undo_title(page)
    x, y = front_at(strips)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 30, y, steps=4)
    page.keyboard.press("Escape")
    page.mouse.up()
    expect(length).to_have_text(said, use_inner_text=True)
    assert undo_title(page) == title

    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 30, y, steps=4)
    with page.expect_response(lambda answer: answer.url.endswith("/boundaries")) as kept:
        page.mouse.up()
    made = kept.value.json()["measurement"]
    assert made["front_line_1"] < vehicle["measurement"]["front_line_1"]
    expect(length).to_contain_text(f"{made['length_m']:.2f}")
    with page.expect_response(lambda answer: answer.url.endswith("/boundaries")):
        page.get_by_test_id("undo").get_by_role("button").click()
    # the lines come back as the machine's, with their uncertainty
    expect(length).to_have_text(said, use_inner_text=True)
    expect(undo_button(page)).to_have_attribute("title", title)
