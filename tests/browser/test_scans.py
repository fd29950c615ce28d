"""The line-scan bench in a real browser: vehicles, boundaries by keyboard, wheels by two clicks, undo."""

import re
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Locator, Page, expect

from .conftest import wait_for_demonstration


@pytest.fixture
def scan(page: Page) -> dict[str, Any]:
    """The demonstration's line scan."""
    page.goto("/")
    survey_id = wait_for_demonstration(page)
    found: dict[str, Any] = page.request.get(f"/api/surveys/{survey_id}/scans").json()[0]
    return found


def vehicle_of(page: Page, scan: dict[str, Any], number: int) -> dict[str, Any]:
    all_of_it = page.request.get(f"/api/scans/{scan['id']}/vehicles").json()
    return next(one for one in all_of_it if one["number"] == number)


def x_of(strips: Locator, line: float, first: float, last: float) -> float:
    """Where a line lies in a window that shows a vehicle with a quarter of it before and behind."""
    box = strips.bounding_box()
    assert box
    span = last - first
    return box["x"] + (line - first + 0.25 * span) / (1.5 * span) * box["width"]


def test_the_bench_from_the_list_to_a_corrected_and_reviewed_vehicle(
    page: Page, scan: dict[str, Any], screenshots: Path
) -> None:
    page.goto(f"/surveys/{scan['survey_id']}/scans")
    card = page.get_by_test_id(f"scan-{scan['id']}")
    expect(card).to_contain_text("vehicles")
    card.get_by_role("link", name="Open the bench").click()
    expect(page).to_have_url(re.compile(rf"scan\?scan={scan['id']}"))
    before = vehicle_of(page, scan, 2)["measurement"]
    row = page.get_by_test_id("scan-vehicle-2")
    row.get_by_role("button").click()
    speed, length = page.get_by_test_id("scan-speed"), page.get_by_test_id("scan-length")
    expect(speed).to_contain_text(f"{before['speed_mps'] * 3.6:.2f}")
    expect(length).to_contain_text(f"{before['length_m']:.3f}")
    expect(page.get_by_test_id("figure-speed-profile-2").locator("svg")).to_be_visible()

    # the front at camera 1 by keyboard, ten lines earlier: a longer vehicle, a revision, an undo
    strips = page.get_by_test_id("strips")
    strips.focus()
    page.keyboard.press("q")
    page.keyboard.press("w")
    with page.expect_response(lambda answer: answer.url.endswith("/boundaries")) as stored:
        page.keyboard.press("Shift+ArrowLeft")
    changed = stored.value.json()["measurement"]
    assert changed["front_line_1"] == pytest.approx(before["front_line_1"] - 10)
    assert changed["placed_by_person"] and changed["revision"] == before["revision"] + 1
    expect(length).to_contain_text(f"{changed['length_m']:.3f}")
    with page.expect_response(lambda answer: answer.url.endswith("/boundaries")):
        page.get_by_test_id("undo").get_by_role("button").click()
    expect(length).to_contain_text(f"{before['length_m']:.3f}")
    page.screenshot(path=screenshots / "scan-bench.png")

    # both hubs by two clicks
    third = vehicle_of(page, scan, 4)["measurement"]
    page.get_by_test_id("scan-vehicle-4").get_by_role("button").click()
    expect(speed).to_contain_text(f"{third['speed_mps'] * 3.6:.2f}")
    strips.focus()
    page.keyboard.press("q")
    page.keyboard.press("u")
    asked = page.locator(".strips__asked")
    expect(asked).to_contain_text("front wheel")
    first, last = third["front_line_1"], max(third["rear_line_1"], third["rear_line_2"])
    lines = [first + share * (third["rear_line_1"] - first) for share in (0.2, 0.8)]
    box = strips.bounding_box()
    assert box
    page.mouse.click(x_of(strips, lines[0], first, last), box["y"] + 60)
    expect(asked).to_contain_text("rear wheel")
    with page.expect_response(lambda answer: answer.url.endswith("/wheels")) as placed:
        page.mouse.click(x_of(strips, lines[1], first, last), box["y"] + 60)
    wheelbase = placed.value.json()["measurement"]
    assert wheelbase["front_wheel_line"] == pytest.approx(lines[0], abs=0.02 * (last - first))
    expect(page.get_by_test_id("scan-wheelbase")).to_contain_text(f"{wheelbase['wheelbase_m']:.3f}")


def test_an_empty_survey_says_what_to_do_and_takes_two_strips(page: Page) -> None:
    headers = {"X-Sightline": "1"}
    made = page.request.post("/api/surveys", data={"name": "Strips"}, headers=headers)
    page.goto(f"/surveys/{made.json()['id']}/scans")
    send = page.get_by_role("button", name="Read it and find the vehicles")
    expect(send).to_be_disabled()
    page.locator("input[type=file]").set_input_files(
        [{"name": name, "mimeType": "image/png", "buffer": b"no picture"} for name in ("a.png", "b.png")]
    )
    expect(page.get_by_label("Camera 2")).to_contain_text("b.png")
    expect(send).to_be_enabled()
    send.click()
    expect(page.get_by_text("Enter the distance between the two scanning planes.")).to_be_visible()
    page.get_by_label("Baseline").fill("0.593")
    page.get_by_label("Lines a second").fill("4882.8")
    send.click()
    problem = page.get_by_role("alert").first
    expect(problem).to_contain_text("a.png")
