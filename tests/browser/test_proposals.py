"""The confirm loop: proposed points are seen, moved by a key, and stored in a person's name, in Chromium."""

import pytest
from playwright.sync_api import Page, expect

from .server import Server
from .vehicles import TARGETS, click_at, open_pass, own_vehicle, put_proposals, stored, until, whole_passes

pytestmark = pytest.mark.usefixtures("kept")


def test_proposals_are_confirmed_one_vehicle_after_the_other(page: Page, demonstration: Server) -> None:
    passes = whole_passes("low_light")
    first, second = (own_vehicle(page, over=passes[-1 - i % len(passes)]) for i in range(2))
    put_proposals(demonstration, [first, second])
    page.goto(f"/surveys/{first.survey}/measure?vehicle={first.vehicle['id']}")
    expect(page.get_by_test_id("proposed-card-roof")).to_contain_text("±")
    expect(page.get_by_test_id("proposed-card-taillight")).to_contain_text("±")
    expect(page.get_by_test_id("proposed")).to_contain_text("click it yourself")
    assert stored(page, first.vehicle["id"]) == {}

    # the roof's key goes to its point, an arrow moves it; then all of it is confirmed
    page.keyboard.press("1")
    page.keyboard.press("ArrowUp")
    expect(page.get_by_test_id("proposed-card-roof")).to_contain_text("moved by you")
    expect(page.get_by_test_id("proposed-card-roof")).to_contain_text("±")
    page.keyboard.press("Enter")
    until(page, first.vehicle["id"], lambda have: {"roof", "taillight"} <= set(have))
    have = stored(page, first.vehicle["id"])
    assert (have["roof"]["made"], have["taillight"]["made"]) == ("moved", "confirmed")
    assert have["taillight"]["created_by"]["name"]

    # the eye is clicked by hand on the same contact; then the next vehicle comes by itself
    expect(page.locator("#measure-hint")).to_contain_text("click the driver’s eye")
    click_at(page, first.pixels["driver_eye"])
    until(page, first.vehicle["id"], lambda have: "driver_eye" in have)
    assert stored(page, first.vehicle["id"])["driver_eye"]["made"] == "clicked"
    expect(page.get_by_test_id(f"pass-{first.vehicle['number']}")).not_to_have_attribute(
        "aria-current", "true"
    )

    # one undo takes back what one key confirmed; Esc turns proposals down, and points are clicked by hand
    open_pass(page, second.vehicle["number"])
    expect(page.get_by_test_id("proposed-card-roof")).to_contain_text("±")
    page.keyboard.press("Enter")
    until(page, second.vehicle["id"], lambda have: set(have) == {"roof", "taillight"})
    page.keyboard.press("Control+z")
    until(page, second.vehicle["id"], lambda have: have == {})
    expect(page.get_by_test_id("proposed-card-roof")).to_contain_text("±")
    page.keyboard.press("Escape")
    expect(page.get_by_test_id("proposed-card-roof")).to_have_count(0)
    page.keyboard.press("Enter")
    assert stored(page, second.vehicle["id"]) == {}
    click_at(page, second.pixels["contact_rear"])
    click_at(page, second.pixels["roof"])
    until(page, second.vehicle["id"], lambda have: "roof" in have)
    assert stored(page, second.vehicle["id"])["roof"]["made"] == "clicked"


def test_a_contact_alone_is_taken_and_the_targets_are_clicked_on_it(
    page: Page, demonstration: Server
) -> None:
    one = own_vehicle(page)
    put_proposals(demonstration, [one], ())
    page.goto(f"/surveys/{one.survey}/measure?vehicle={one.vehicle['id']}")
    expect(page.get_by_test_id("proposed-card-contact")).to_be_visible()
    expect(page.get_by_test_id("proposed")).to_contain_text("Confirm the contact")
    page.keyboard.press("Enter")
    expect(page.get_by_test_id("proposed-card-contact")).to_have_count(0)
    expect(page.locator("#measure-hint")).to_contain_text("edge of the roof")
    assert stored(page, one.vehicle["id"]) == {}
    click_at(page, one.pixels["roof"])
    until(page, one.vehicle["id"], lambda have: "roof" in have)
    assert stored(page, one.vehicle["id"])["roof"]["made"] == "clicked"


def test_a_click_elsewhere_puts_another_contact_than_the_proposed_one(
    page: Page, demonstration: Server
) -> None:
    one = own_vehicle(page)
    put_proposals(demonstration, [one], ())
    page.goto(f"/surveys/{one.survey}/measure?vehicle={one.vehicle['id']}")
    expect(page.get_by_test_id("proposed-card-contact")).to_be_visible()
    click_at(page, one.pixels["contact_front"])
    expect(page.get_by_test_id("proposed-card-contact")).to_have_count(0)
    click_at(page, one.pixels["roof"])
    until(page, one.vehicle["id"], lambda have: "roof" in have)
    assert stored(page, one.vehicle["id"])["roof"]["made"] in ("clicked", "snapped")


def test_enter_goes_on_once_all_that_is_asked_for_is_there(page: Page, demonstration: Server) -> None:
    one = own_vehicle(page)
    page.goto(one.address)
    row = page.get_by_test_id(f"pass-{one.vehicle['number']}")
    expect(row).to_have_attribute("aria-current", "true")
    click_at(page, one.pixels["contact_rear"])
    page.keyboard.press("Enter")  # nothing is measured yet: it stays
    for target in TARGETS:
        click_at(page, one.pixels[target])
        until(page, one.vehicle["id"], lambda have, target=target: target in have)
    expect(page.locator("#measure-hint")).to_contain_text("Done")
    expect(row).to_have_attribute("aria-current", "true")
    page.keyboard.press("Enter")
    expect(row).not_to_have_attribute("aria-current", "true")
