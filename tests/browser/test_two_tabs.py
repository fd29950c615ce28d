"""Two people at one vehicle, and a connection that comes and goes: nobody's work is lost or stored twice."""

import re
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, BrowserContext, Locator, Page, Route, expect

from .picture import on_screen
from .server import Server
from .vehicles import OwnVehicle, click_at, own_vehicle, stored, until
from .waits import keep_toasts


@pytest.fixture
def one(page: Page, demonstration: Server) -> OwnVehicle:
    return own_vehicle(page)


@pytest.fixture
def colleague(page: Page, browser: Browser, demonstration: Server, one: OwnVehicle) -> Iterator[Page]:
    """Another operator on another machine, with the same vehicle open."""
    made = page.request.post(
        "/api/people",
        headers={"X-Sightline": "1"},
        data={"name": "Olga Operator", "email": f"olga{time.time_ns()}@example.org", "role": "operator"},
    )
    assert made.ok, made.text()
    context = browser.new_context(base_url=demonstration.url, viewport={"width": 1440, "height": 900})
    theirs = context.new_page()
    theirs.goto(made.json()["link"])
    theirs.wait_for_url(lambda url: "sign-in" not in url)
    opened(theirs, one)
    yield theirs
    context.close()


def opened(page: Page, one: OwnVehicle) -> Page:
    page.goto(one.address)
    expect(page.get_by_test_id(f"pass-{one.vehicle['number']}")).to_have_attribute("aria-current", "true")
    expect(page.get_by_label("Year")).to_be_visible()
    on_screen(page, (0, 0))
    return page


def commit(field: Locator, text: str) -> None:
    """Types into a field and waits until the server has answered."""
    with field.page.expect_response(lambda answer: answer.request.method == "PUT" and answer.ok):
        field.fill(text)
        field.press("Enter")


def record(page: Page, one: OwnVehicle) -> dict[str, object]:
    vehicle: dict[str, object] = page.request.get(f"/api/vehicles/{one.vehicle['id']}").json()
    return vehicle


def test_the_second_is_told_who_and_when_and_nothing_is_lost(
    page: Page, colleague: Page, one: OwnVehicle
) -> None:
    opened(page, one)
    page.get_by_label("Year").fill("1999")  # begun here, not yet told to the server

    commit(colleague.get_by_label("Source of the height"), "sales brochure")
    commit(colleague.get_by_label("Year"), "1998")

    page.get_by_label("Year").press("Enter")
    told = page.get_by_test_id("vehicle-conflict")
    expect(told).to_contain_text("Olga Operator")
    expect(told).to_contain_text(re.compile(r"\d\d:\d\d"))
    expect(told).to_contain_text("mine: 1999")
    expect(told).to_contain_text("theirs: 1998")
    assert record(page, one)["year"] == 1998  # nothing was overwritten without a choice

    told.get_by_text("mine: 1999").click()
    with page.expect_response(lambda answer: answer.request.method == "PUT" and answer.ok):
        told.get_by_role("button", name="Save this").click()
    expect(told).to_have_count(0)
    expect(page.get_by_label("Source of the height")).to_have_value("sales brochure")
    now = record(page, one)
    assert (now["year"], now["height_source"]) == (1999, "sales brochure")


def test_changes_to_different_fields_are_both_kept(page: Page, colleague: Page, one: OwnVehicle) -> None:
    keep_toasts(page)
    opened(page, one)
    page.get_by_label("Notes").fill("roof box")
    commit(colleague.get_by_label("Year"), "2017")
    page.get_by_label("Notes").blur()
    expect(page.get_by_text(re.compile("Olga Operator.*both are kept"))).to_be_visible()
    expect(page.get_by_label("Year")).to_have_value("2017")
    expect(page.get_by_test_id("save-state")).to_contain_text(re.compile(r"saved \d"))
    now = record(page, one)
    assert (now["year"], now["notes"]) == (2017, "roof box")


def test_two_tabs_of_one_person_see_each_other(context: BrowserContext, page: Page, one: OwnVehicle) -> None:
    keep_toasts(page)
    opened(page, one)
    other = opened(context.new_page(), one)
    expect(page.get_by_text("Also open in another tab")).to_be_visible()
    click_roof(other, one)
    expect(other.get_by_test_id("measurement-row-roof")).to_have_attribute("data-state", "saved")
    row = page.get_by_test_id("measurement-row-roof")
    expect(row).to_have_attribute("data-state", "saved")
    expect(row).to_contain_text("±")


def click(page: Page, one: OwnVehicle, name: str) -> None:
    click_at(page, one.pixels[name])


def click_roof(page: Page, one: OwnVehicle) -> None:
    page.get_by_test_id("target-roof").click()
    click(page, one, "contact_rear")
    expect(page.get_by_test_id("axes")).to_be_visible()
    click(page, one, "roof")


@pytest.mark.parametrize("choice", ["Keep theirs", "Save mine as a new revision"])
def test_two_people_on_one_target_choose_and_what_comes_after_is_stored(
    page: Page, colleague: Page, one: OwnVehicle, screenshots: Path, choice: str
) -> None:
    """Both have the vehicle open; whoever clicks later sees both heights, and their next click goes out."""
    opened(page, one)
    click_roof(colleague, one)
    until(page, one.vehicle["id"], lambda have: set(have) == {"roof"})
    theirs = stored(page, one.vehicle["id"])["roof"]
    row = page.get_by_test_id("measurement-row-roof")
    page.get_by_test_id("target-roof").click()
    click(page, one, "contact_rear")
    expect(page.get_by_test_id("axes")).to_be_visible()
    x, y = one.pixels["roof"]
    click_at(page, (x, y + 6))
    told = page.get_by_test_id("measurement-conflict")
    expect(told).to_contain_text("Olga Operator")
    click(page, one, "driver_eye")
    expect(page.get_by_test_id("measurement-row-driver_eye")).to_have_attribute("data-state", "saved")
    expect(told).to_contain_text(f"{theirs['height_m']:.3f}")
    page.screenshot(path=screenshots / "conflict-of-two-people.png")
    told.get_by_role("button", name=choice).click()
    expect(told).to_have_count(0)
    expect(row).to_have_attribute("data-state", "saved")
    expect(page.get_by_test_id("save-state")).to_contain_text(re.compile(r"saved \d"))
    now = stored(page, one.vehicle["id"])
    assert set(now) == {"roof", "driver_eye"}
    kept = choice == "Keep theirs"
    assert now["roof"]["revision"] == (1 if kept else 2)
    assert (now["roof"]["height_m"] == theirs["height_m"]) is kept


def revisions(page: Page, one: OwnVehicle) -> list[tuple[str, int]]:
    """(target, revision) of everything the server has of the vehicle, withdrawn or not."""
    vehicle = page.request.get(f"/api/vehicles/{one.vehicle['id']}").json()
    return [(m["target"], m["revision"]) for m in vehicle["measurements"]]


def test_a_click_without_a_connection_is_stored_once_it_is_back(
    context: BrowserContext, page: Page, one: OwnVehicle
) -> None:
    opened(page, one)
    page.get_by_test_id("target-roof").click()
    click(page, one, "contact_rear")
    expect(page.get_by_test_id("axes")).to_be_visible()
    context.set_offline(True)
    click(page, one, "roof")
    row = page.get_by_test_id("measurement-row-roof")
    expect(row).to_have_attribute("data-state", "saving")
    expect(page.get_by_text("not yet saved…")).to_be_visible()
    expect(page.get_by_test_id("save-state")).to_contain_text("1 not yet saved")
    expect(page.get_by_text("The server cannot be reached")).to_be_visible()
    click(page, one, "driver_eye")
    expect(page.get_by_test_id("save-state")).to_contain_text("2 not yet saved")

    context.set_offline(False)
    for name in ("roof", "driver_eye"):
        expect(page.get_by_test_id(f"measurement-row-{name}")).to_have_attribute("data-state", "saved")
    expect(page.get_by_text("The server cannot be reached")).to_have_count(0)
    assert sorted(revisions(page, one)) == [("driver_eye", 1), ("roof", 1)]


def test_a_lost_answer_does_not_store_twice(page: Page, one: OwnVehicle) -> None:
    opened(page, one)
    lost: list[int] = []

    def lose_the_answer(route: Route) -> None:
        """The server hears the first request; the page never hears the answer."""
        if route.request.method == "POST" and not lost:
            lost.append(route.fetch().status)
            route.abort("connectionreset")
        else:
            route.continue_()

    page.route(re.compile(r"/api/vehicles/\d+/measurements$"), lose_the_answer)
    click_roof(page, one)
    row = page.get_by_test_id("measurement-row-roof")
    expect(row).to_have_attribute("data-state", "saved")
    assert lost and lost[0] < 300
    assert revisions(page, one) == [("roof", 1)]


def test_a_click_not_yet_stored_survives_a_reload(page: Page, one: OwnVehicle) -> None:
    opened(page, one)
    page.on("dialog", lambda dialog: dialog.accept())
    pattern = re.compile(r"/api/vehicles/\d+/measurements$")
    page.route(pattern, lambda route: route.abort("connectionrefused"))
    click_roof(page, one)
    expect(page.get_by_test_id("save-state")).to_contain_text("1 not yet saved")
    assert revisions(page, one) == []
    page.unroute(pattern)
    opened(page, one)
    until(page, one.vehicle["id"], lambda have: set(have) == {"roof"})
    expect(page.get_by_test_id("measurement-row-roof")).to_have_attribute("data-state", "saved")
    wanted = one.pixels["roof"]
    assert (
        max(
            abs(a - b)
            for a, b in zip(stored(page, one.vehicle["id"])["roof"]["target_point"], wanted, strict=True)
        )
        < 1
    )
    assert revisions(page, one) == [("roof", 1)]


def test_a_click_kept_by_a_closed_tab_is_sent_by_the_next_at_once(
    context: BrowserContext, page: Page, one: OwnVehicle
) -> None:
    opened(page, one)
    pattern = re.compile(r"/api/vehicles/\d+/measurements$")
    page.route(pattern, lambda route: route.abort("connectionrefused"))
    click_roof(page, one)
    expect(page.get_by_test_id("save-state")).to_contain_text("1 not yet saved")
    page.close(run_before_unload=False)
    other = context.new_page()
    assert revisions(other, one) == []
    opened(other, one)
    expect(other.get_by_test_id("measurement-row-roof")).to_have_attribute("data-state", "saved")
    assert revisions(other, one) == [("roof", 1)]
