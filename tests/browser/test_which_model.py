"""Which car is it: the models that fit what was measured, taken by key, and the word where one cannot fit."""

import re
from uuid import uuid4

import pytest
from playwright.sync_api import Page, expect

from .server import Server
from .vehicles import TARGETS, click_at, open_pass, own_vehicle, until, until_stored
from .waits import keep_toasts


@pytest.mark.parametrize("size", [(1440, 900), pytest.param((1024, 768), marks=pytest.mark.proof)])
def test_a_model_is_taken_by_key_and_one_that_cannot_fit_is_said(
    page: Page, demonstration: Server, size: tuple[int, int]
) -> None:
    page.set_viewport_size({"width": size[0], "height": size[1]})
    one = own_vehicle(page)
    page.goto(one.address)
    panel = page.get_by_role("region", name="Models that fit")
    expect(panel).to_contain_text("No size in the catalogue has been measured")
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
    expect(rows.nth(1)).to_be_visible()
    # a roof is held against the model afterwards: it ranks nothing, and what it rules out is not offered
    rank = page.get_by_test_id("which-model-rank")
    expect(rank).to_contain_text("No length of this vehicle is measured")
    expect(rank).to_contain_text("not fit the measured sizes")
    names = rows.locator("strong").all_text_contents()
    assert names == sorted(names)
    for text in rows.all_text_contents():
        assert "roof" not in text and "fit" not in text

    make = page.get_by_label("Make", exact=True)
    make.fill("haldmann t75")
    expect(page.get_by_role("listbox", name="Make").get_by_role("option")).to_have_count(1)
    make.press("Enter")
    said = page.get_by_test_id("cannot-fit")
    expect(said).to_contain_text("Haldmann T75 does not fit: roof −")

    page.keyboard.press("Shift+M")
    expect(page.get_by_role("listbox", name="Models that fit")).to_be_focused()
    page.keyboard.press("2")
    name = str(rows.nth(1).locator("strong").text_content())
    expect(make).to_have_value(name)
    expect(said).to_be_empty()
    chosen = page.get_by_test_id("model-chosen")
    expect(chosen).to_contain_text("The model was chosen by its sizes (roof).")
    assert page.evaluate("document.activeElement === document.body")
    page.keyboard.press("Control+z")
    expect(make).to_have_value("Haldmann")
    expect(chosen).to_have_count(0)
    page.keyboard.press("Shift+M")
    page.keyboard.press("Enter")
    expect(said).to_be_empty()
    expect(chosen).to_contain_text("Its heights are not used as references")
    until_stored(page, one.vehicle["id"], "model_chosen_by", "size")
    until_stored(page, one.vehicle["id"], "model_sizes", "height")
    panel.scroll_into_view_if_needed()
    # somebody sees the badge: said by an act of its own, and unsaid by undo
    page.get_by_role("button", name="Confirm the model").click()
    expect(chosen).to_contain_text("then confirmed on the vehicle")
    expect(chosen.get_by_role("button")).to_have_count(0)
    until_stored(page, one.vehicle["id"], "model_chosen_by", "seen")
    page.locator("body").press("Control+z")
    expect(chosen).to_contain_text("Its heights are not used as references")
    until_stored(page, one.vehicle["id"], "model_chosen_by", "size")


def test_the_models_taken_last_are_taken_by_a_digit(page: Page, demonstration: Server) -> None:
    one, two = own_vehicle(page), own_vehicle(page)
    page.goto(one.address)
    make, model = page.get_by_label("Make", exact=True), page.get_by_label("Model", exact=True)
    expect(page.get_by_test_id(f"pass-{one.vehicle['number']}")).to_have_attribute("aria-current", "true")
    expect(make).to_be_visible()
    # nothing was taken yet: the key goes to the field, letters and Enter at once take the best row
    page.keyboard.press("Shift+C")
    expect(make).to_be_focused()
    page.keyboard.type("haldmann t75")
    page.keyboard.press("Enter")
    expect(model).to_have_value("T75")
    expect(make).to_have_value("Haldmann")
    assert page.evaluate("document.activeElement === document.body")

    open_pass(page, two.vehicle["number"])
    expect(make).to_have_value("")
    expect(page.get_by_role("region", name="Recently used models")).to_contain_text("Haldmann T75")
    page.keyboard.press("7")  # there is no second one
    page.keyboard.press("6")
    expect(model).to_have_value("T75")
    expect(make).to_have_value("Haldmann")
    page.keyboard.press("Control+z")
    expect(model).to_have_value("")


def test_a_model_that_is_the_last_thing_asked_for_brings_the_next_vehicle(
    page: Page, demonstration: Server
) -> None:
    keep_toasts(page)
    one = own_vehicle(page)
    page.goto(one.address)
    row = page.get_by_test_id(f"pass-{one.vehicle['number']}")
    make = page.get_by_label("Make", exact=True)
    expect(make).to_be_visible()
    page.keyboard.press("Shift+C")
    page.keyboard.type("haldmann t75")
    page.keyboard.press("Enter")
    expect(make).to_have_value("Haldmann")
    page.keyboard.press("Control+z")
    expect(make).to_have_value("")
    click_at(page, one.pixels["contact_rear"])
    for target in TARGETS:
        click_at(page, one.pixels[target])
        until(page, one.vehicle["id"], lambda have, target=target: target in have)
    expect(page.locator("#measure-hint")).to_contain_text("Done")
    page.keyboard.press("6")
    expect(row).not_to_have_attribute("aria-current", "true")
    expect(page.locator(".toast", has_text="Haldmann T75")).to_be_visible()
    open_pass(page, one.vehicle["number"])
    expect(make).to_have_value("Haldmann")
    page.wait_for_url(re.compile(rf"vehicle={one.vehicle['id']}\b"))
    page.reload()
    expect(make).to_have_value("Haldmann")
    made = page.request.get(f"/api/vehicles/{one.vehicle['id']}").json()
    assert (made["make"], made["model"]) == ("Haldmann", "T75")
