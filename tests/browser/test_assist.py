"""The assistants in the browser: still cameras, a proposal drawn until taken, a brightened picture."""

from typing import Any

from playwright.sync_api import Page, expect

from .picture import on_screen
from .server import Server
from .vehicles import own_vehicle
from .waits import wait_until


def drift_of(page: Page, recording_id: int) -> dict[str, Any]:
    """What the background job finds of a recording's camera."""

    def found() -> dict[str, Any]:
        told: dict[str, Any] = page.request.get(f"/api/recordings/{recording_id}/drift").json()
        return told

    return wait_until(page, lambda: found()["check"], found)


def test_still_cameras_a_proposal_and_a_brightened_picture(
    page: Page, demonstration: Server, survey_id: int
) -> None:
    recordings = page.request.get(f"/api/surveys/{survey_id}/recordings").json()
    for recording in recordings:
        check = drift_of(page, recording["id"])
        assert check["state"] == "still" and check["bumps"] == [], check["words"]
        assert check["floor_px"] < 0.15 and "No camera movement detected" in check["words"][0]["message"]
    page.goto(f"/surveys/{survey_id}/recordings")
    expect(page.get_by_text("No camera movement detected, within")).to_have_count(2)

    one = own_vehicle(page)
    x, y = one.pixels["contact_rear"]
    page.goto(one.address)
    expect(page.get_by_test_id(f"pass-{one.vehicle['number']}")).to_have_attribute("aria-current", "true")
    expect(page.locator("#measure-hint")).to_contain_text("click where the tyre meets the road")
    page.mouse.move(*on_screen(page, (x + 6, y - 5)))
    page.keyboard.press("a")
    expect(page.get_by_test_id("contact-proposal")).to_contain_text("suggested contact, u = ")
    expect(page.get_by_test_id("axes")).to_have_count(0)

    expect(page.get_by_test_id("display-only")).to_have_count(0)
    page.keyboard.press("i")
    expect(page.get_by_test_id("display-only")).to_have_text("brightened (display only)")
    page.keyboard.press("i")
    expect(page.get_by_test_id("display-only")).to_have_count(0)

    page.keyboard.press("Enter")
    expect(page.get_by_test_id("axes")).to_have_count(1)
    expect(page.get_by_test_id("contact-proposal")).to_have_count(0)
    page.keyboard.press("Escape")
