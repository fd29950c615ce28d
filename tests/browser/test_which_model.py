"""Which car is it: the models that fit what was measured, taken by key, and the word where one cannot fit."""

from uuid import uuid4

import pytest
from playwright.sync_api import Page, expect

from .server import Server
from .vehicles import own_vehicle


@pytest.mark.parametrize("size", [(1440, 900), (1024, 768)])
def test_a_model_is_taken_by_key_and_one_that_cannot_fit_is_said(
    page: Page, demonstration: Server, size: tuple[int, int]
) -> None:
    page.set_viewport_size({"width": size[0], "height": size[1]})
    one = own_vehicle(page, demonstration)
    page.goto(one.address)
    panel = page.get_by_role("region", name="Models that fit")
    expect(panel).to_contain_text("Nothing that the catalogue knows was measured")
    made = page.request.post(
        f"/api/vehicles/{one.vehicle['id']}/measurements",
        headers={"X-Sightline": "1"},
        data={
            "client_key": str(uuid4()),
            "target": "roof",
            "frame": one.frame,
            "contact": one.pixels["contact_rear"],
            "target_point": one.pixels["roof"],
        },
    )
    assert made.ok, made.text()
    page.reload()
    rows = page.get_by_role("listbox", name="Models that fit").get_by_role("option")
    expect(rows).to_have_count(5)
    expect(rows.first).to_contain_text("roof")

    make = page.get_by_label("Make", exact=True)
    make.fill("haldmann t75")
    expect(page.get_by_role("listbox", name="Make").get_by_role("option")).to_have_count(1)
    make.press("ArrowDown")
    make.press("Enter")
    said = page.get_by_test_id("cannot-fit")
    expect(said).to_contain_text("Haldmann T75 cannot fit: roof −")

    page.keyboard.press("Shift+M")
    expect(page.get_by_role("listbox", name="Models that fit")).to_be_focused()
    page.keyboard.press("2")
    name = str(rows.nth(1).locator("strong").text_content())
    expect(make).to_have_value(name)
    expect(said).to_be_empty()
    assert page.evaluate("document.activeElement === document.body")
    page.keyboard.press("Control+z")
    expect(make).to_have_value("Haldmann")
    page.keyboard.press("Shift+M")
    page.keyboard.press("Enter")
    expect(said).to_be_empty()
    panel.scroll_into_view_if_needed()
