"""A vehicle measured free shows no proposal; the Repeats page says what showing them does. In Chromium."""

import pytest
from playwright.sync_api import Page, expect

from .server import Server
from .vehicles import click_at, draw_free, open_pass, own_vehicle, put_proposals, until, whole_passes


@pytest.mark.usefixtures("kept")
def test_a_vehicle_measured_free_shows_no_proposal(page: Page, demonstration: Server) -> None:
    passes = whole_passes("day")
    ones = [own_vehicle(page, "day", passes[i % len(passes)]) for i in range(2)]
    free, shown = ones
    put_proposals(demonstration, ones)
    draw_free(demonstration, free)
    page.goto(free.address)
    expect(page.get_by_test_id("proposed")).to_contain_text("Suggestions are hidden for this vehicle")
    expect(page.get_by_test_id("proposed-card-roof")).to_have_count(0)
    x, y = free.pixels["contact_rear"]
    click_at(page, (x + 1, y - 4))
    click_at(page, free.pixels["roof"])
    until(page, free.vehicle["id"], lambda have: have.get("roof", {}).get("made") == "clicked")
    expect(page.get_by_test_id("snap")).to_have_count(0)

    open_pass(page, shown.vehicle["number"])
    expect(page.get_by_test_id("proposed-card-roof")).to_contain_text("±")
    page.keyboard.press("Enter")
    until(page, shown.vehicle["id"], lambda have: have.get("roof", {}).get("made") == "confirmed")

    page.goto(f"/surveys/{free.survey}/repeats")
    panel = page.get_by_test_id("anchoring")
    expect(panel).to_contain_text("Too few: five vehicles of each kind are needed.")
    expect(panel).to_contain_text("Goal: below 2.0 mm")
    page.get_by_test_id("free-plan").select_option("20")
    expect(page.get_by_test_id("free-plan")).to_have_value("20")
    page.reload()
    expect(page.get_by_test_id("free-plan")).to_have_value("20")
