"""A contact click goes to the tyre, is shown with its way, and one undo puts it back, in Chromium."""

from math import dist

from playwright.sync_api import Page, expect

from .picture import on_screen
from .server import Server
from .vehicles import click_at, own_vehicle, stored, until


def test_a_click_above_the_contact_goes_to_the_tyre(page: Page, demonstration: Server) -> None:
    one = own_vehicle(page, "day")
    x, y = one.pixels["contact_rear"]
    page.goto(one.address)
    expect(page.locator("#measure-hint")).to_contain_text("click where the tyre meets the road")
    click_at(page, (x + 2, y - 14))
    expect(page.get_by_test_id("snap")).to_contain_text("snapped to the tyre, u = 0.")

    # one key puts it back to the click, and it is not taken there again
    page.keyboard.press("Control+z")
    expect(page.get_by_test_id("snap")).to_have_count(0)
    expect(page.locator("#measure-hint")).not_to_contain_text("click where the tyre meets the road")
    page.keyboard.press("Control+y")
    expect(page.get_by_test_id("snap")).to_have_count(1)
    click_at(page, one.pixels["roof"])
    until(page, one.vehicle["id"], lambda have: "roof" in have)
    roof = stored(page, one.vehicle["id"])["roof"]
    assert roof["made"] == "snapped" and dist(roof["contact"], (x, y)) < 1.5, (roof["contact"], (x, y))
    from_px = roof["snapped_from_x_px"], roof["snapped_from_y_px"]
    assert dist(from_px, (x + 2, y - 14)) < 2

    # with Shift held a click stays where it is
    page.keyboard.press("t")
    page.mouse.move(*on_screen(page, (x + 2, y - 6)))
    page.keyboard.down("Shift")
    page.mouse.click(*on_screen(page, (x + 2, y - 6)))
    page.keyboard.up("Shift")
    click_at(page, one.pixels["driver_eye"])
    until(page, one.vehicle["id"], lambda have: "driver_eye" in have)
    eye = stored(page, one.vehicle["id"])["driver_eye"]
    assert eye["made"] == "clicked" and dist(eye["contact"], (x + 2, y - 6)) < 1.5, eye["contact"]
