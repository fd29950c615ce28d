"""Known heights and a check target: typed, kept, undone; its measured lamp stands in a row of its own."""

from collections.abc import Iterator
from uuid import uuid4

import pytest
from playwright.sync_api import Page, expect

from .server import Server
from .vehicles import OwnVehicle, own_vehicle, until_stored


def counted(page: Page, survey: int) -> list[int]:
    """How many heights, vehicles and roofs with a known height count, of all verdicts."""
    found = page.request.get(f"/api/statistics?survey={survey}&state=all").json()["counted"]
    return [found[name] for name in ("measurements", "vehicles", "with_reference")]


@pytest.fixture
def one(page: Page, demonstration: Server) -> Iterator[OwnVehicle]:
    """A vehicle of this test's own, and gone after it: a check target counts in the survey's figures."""
    made = own_vehicle(page)
    yield made
    assert page.request.delete(f"/api/vehicles/{made.vehicle['id']}", headers={"X-Sightline": "1"}).ok


def test_a_check_target_is_declared_and_has_a_row_of_its_own(page: Page, one: OwnVehicle) -> None:
    page.goto(one.address)
    before = counted(page, one.survey)
    known = page.get_by_test_id("known-heights")
    known.locator("summary").click()
    known.get_by_role("checkbox", name="Check target").check()
    expect(known).to_contain_text("A check target needs a known height")
    lamp = known.get_by_role("group", name="Known height of the taillight")
    for label, text in (("Taillight", "0.7"), ("u", "0.002"), ("Source", "tape")):
        lamp.get_by_label(label, exact=True).fill(text)
        lamp.get_by_label(label, exact=True).press("Tab")
    expect(known).not_to_contain_text("A check target needs a known height")
    expect(page.get_by_test_id(f"pass-{one.vehicle['number']}")).to_contain_text("check target")
    until_stored(page, one.vehicle["id"], "known_taillight_source", "tape")
    made = page.request.post(
        f"/api/vehicles/{one.vehicle['id']}/measurements",
        headers={"X-Sightline": "1"},
        data={
            "client_key": str(uuid4()),
            "target": "taillight",
            "frame": one.frame,
            "contact": one.pixels["contact_rear"],
            "target_point": one.pixels["taillight"],
        },
    )
    assert made.ok, made.text()
    height_m = made.json()["height_m"]
    page.goto(f"/statistics?survey={one.survey}&state=all&tab=errors")
    row = page.get_by_test_id("known-taillight-check")
    expect(row).to_contain_text("Taillight, lower edge, check targets")
    expect(row.locator("td").nth(1)).to_contain_text(f"{1000 * (height_m - 0.7):.1f}".replace("-", "−"))
    assert counted(page, one.survey) == before

    page.goto(one.address)
    expect(known.get_by_role("checkbox", name="Check target")).to_be_checked()
    expect(lamp.get_by_label("Source", exact=True)).to_have_value("tape")
    known.get_by_role("checkbox", name="Check target").uncheck()
    expect(page.get_by_test_id(f"pass-{one.vehicle['number']}")).not_to_contain_text("check target")
    page.keyboard.press("Escape")
    page.locator("body").press("Control+z")
    expect(known.get_by_role("checkbox", name="Check target")).to_be_checked()
