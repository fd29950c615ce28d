"""A vehicle followed through its pass by one key: shown, looked at, kept as one revision, taken back."""

from pathlib import Path

from playwright.sync_api import Page, expect

from .server import Server
from .test_second_frame import click, far_vehicle, measured, pixels, shown_frame


def test_a_pass_is_followed_by_one_key_and_kept(page: Page, demonstration: Server, screenshots: Path) -> None:
    own = far_vehicle(page, demonstration)
    survey, vehicle, one = own.survey, own.vehicle, own.truth
    frame = one["best_frames"]["taillight"]
    first = pixels(one, frame)
    contact = next(name for name in ("contact_rear", "contact_front") if name in first)
    page.goto(
        f"/surveys/{survey}/measure?recording={vehicle['recording_id']}&frame={frame}&vehicle={vehicle['id']}"
    )
    shown_frame(page, frame)
    expect(page.locator("#measure-hint")).to_contain_text("click where the tyre meets the road")
    page.keyboard.press("3")
    click(page, first[contact])
    expect(page.locator("#measure-hint")).not_to_contain_text("click where the tyre meets the road")
    click(page, first["taillight"])
    row = page.get_by_test_id("measurement-row-taillight")
    expect(row).to_have_attribute("data-state", "saved")

    page.keyboard.press("Shift+S")
    panel = page.get_by_test_id("whole-pass")
    expect(panel).to_contain_text("not saved yet")
    expect(panel).to_contain_text("excluded")
    page.keyboard.press("f")
    shown_frame(page, frame + 1)
    expect(page.get_by_test_id("followed-points").locator("text")).not_to_have_count(0)
    expect(page.locator(".timeline__span--followed")).not_to_have_count(0)
    page.screenshot(path=screenshots / "whole-pass-shown.png")
    page.set_viewport_size({"width": 1024, "height": 768})
    page.screenshot(path=screenshots / "whole-pass-shown-1024.png")
    page.set_viewport_size({"width": 1440, "height": 900})
    assert measured(page, vehicle["id"])["followed"] is None
    page.keyboard.press("Escape")
    expect(panel).to_have_count(0)

    page.keyboard.press("Shift+S")
    panel.get_by_role("button", name="Save this height").click()
    expect(page.get_by_test_id("pass-said")).to_contain_text("From the whole pass")
    page.screenshot(path=screenshots / "whole-pass-kept.png")
    stored = measured(page, vehicle["id"])
    assert stored["revision"] == 2 and stored["status"] == "ok" and stored["followed"] is not None
    assert abs(stored["height_m"] - one["true_heights_m"]["taillight"]) <= stored["U95_height_m"]

    page.keyboard.press("Control+z")
    expect(page.get_by_test_id("pass-said")).to_have_count(0)
    expect(row).to_have_attribute("data-state", "saved")
    assert measured(page, vehicle["id"])["followed"] is None
