"""The checks page: an inset from the survey's own roofs, both tyres clicked and undone, a turn looked at."""

import re

import pytest
from playwright.sync_api import Page, expect

from .picture import on_screen
from .server import Server
from .vehicles import OwnVehicle, own_vehicle


def press_at(page: Page, point: list[float]) -> None:
    """Click on a pixel of the picture."""
    x, y = on_screen(page, point)
    page.mouse.move(x, y)
    page.mouse.click(x, y)


def both_tyres(one: OwnVehicle) -> tuple[int, list[float], list[float]]:
    """(frame, rear, front) of a vehicle's tyre contacts in the picture, furthest apart."""
    tyres = [
        (f["frame"], f["pixels"]["contact_rear"], f["pixels"]["contact_front"])
        for f in one.truth["frames"]
        if {"contact_rear", "contact_front"} <= set(f["pixels"])
    ]
    frame, rear, front = max(tyres, key=lambda seen: abs(seen[1][0] - seen[2][0]))
    return int(frame), rear, front


@pytest.mark.usefixtures("kept")
def test_insets_are_used_with_their_origin(page: Page, survey_id: int) -> None:
    page.goto(f"/surveys/{survey_id}/checks")
    roof = page.get_by_test_id("insets-check").locator("tbody").filter(has_text="Roof, cars")
    expect(roof.get_by_text("estimate", exact=True)).to_be_visible()
    expect(page.get_by_test_id("inset-drawing")).to_be_visible()
    # what is in force agrees with the vehicles and is as sure: there is nothing to use
    expect(roof.get_by_text("Agrees with the current inset")).to_be_visible()
    expect(roof.get_by_role("button")).to_have_count(0)
    survey = page.request.get(f"/api/surveys/{survey_id}").json()
    body = {name: survey[name] for name in ("name", "site", "description", "version")}
    wrong = {"inset_m": 1.2, "u_inset_m": 0.1, "note": "a guess"}
    put = page.request.put(
        f"/api/surveys/{survey_id}", headers={"X-Sightline": "1"}, data={**body, "insets": {"roof": wrong}}
    )
    assert put.ok, put.text()
    page.reload()
    button = roof.get_by_role("button", name=re.compile(r"Use 0\.\d\d m \(u = 0\.\d\d m\) for roofs of cars"))
    offered = re.findall(r"0\.\d\d", button.inner_text())
    button.click()
    expect(roof.get_by_text("manufacturers' heights of")).to_be_visible()
    expect(roof.get_by_text("estimate", exact=True)).to_have_count(0)
    now = page.request.get(f"/api/surveys/{survey_id}").json()["insets"]["roof"]
    assert [f"{now['inset_m']:.2f}", f"{now['u_inset_m']:.2f}"] == offered


def test_both_tyres_are_clicked_undone_and_refused(page: Page, demonstration: Server) -> None:
    own = own_vehicle(page, "day")
    survey_id, number = own.survey, own.vehicle["number"]
    vehicles = page.request.get(f"/api/surveys/{survey_id}/vehicles").json()
    before = next(one for one in vehicles if one["number"] == number - 1)
    page.goto(f"/surveys/{survey_id}/checks?tab=traffic")
    expect(page.get_by_test_id("wheel-pair")).to_be_visible()
    expect(page.get_by_test_id("traffic-verdict")).to_contain_text("agrees with the traffic")
    # from the pass before by key, as somebody who goes through them does
    page.goto(f"/surveys/{survey_id}/checks?tab=traffic&vehicle={before['id']}")
    expect(page.locator("[data-testid^=heading-][aria-current=true]")).to_have_attribute(
        "data-testid", f"heading-{number - 1}"
    )
    row = page.get_by_test_id(f"heading-{number}")
    page.keyboard.press("n")
    expect(row).to_have_attribute("aria-current", "true")
    expect(row).to_contain_text("–")
    frame, rear, front = both_tyres(own)
    page.keyboard.press("g")
    page.get_by_test_id("frame-box").fill(str(frame))
    page.keyboard.press("Enter")
    expect(page.get_by_role("application")).to_have_attribute("aria-label", f"Frame {frame}")
    expect(page.locator(".frame-loading--on")).to_have_count(0)
    hint = page.locator("#traffic-hint")

    press_at(page, rear)
    expect(hint).to_contain_text("other tyre on the same side")
    expect(page.get_by_test_id("axes")).to_be_visible()
    press_at(page, [rear[0] + 6, rear[1]])
    expect(page.locator(".traffic__refused [role=alert]")).to_contain_text("m apart on the road")
    expect(row).to_contain_text("–")

    press_at(page, rear)
    expect(hint).to_contain_text("other tyre on the same side")
    press_at(page, front)
    expect(page.get_by_test_id("wheel-pair")).to_be_visible()
    expect(row).to_contain_text("°")
    pairs = page.request.get(f"/api/surveys/{survey_id}/checks/traffic").json()["pairs"]
    stored = next(one for one in pairs if one["vehicle_number"] == number)
    assert stored["frame"] == frame and abs(stored["first"][0] - rear[0]) < 1.0

    # the verdict says that none is needed, so none is offered
    expect(page.get_by_role("button", name=re.compile("Rotate the road axes by"))).to_have_count(0)

    page.keyboard.press("Control+z")
    expect(row).to_contain_text("–")
    assert all(
        one["vehicle_number"] != number
        for one in page.request.get(f"/api/surveys/{survey_id}/checks/traffic").json()["pairs"]
    )
