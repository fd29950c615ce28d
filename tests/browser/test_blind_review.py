"""A reviewer clicks blind before the first click is shown, sees both, accepts; then clicks two more again."""

import re
from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import APIRequestContext, Browser, Locator, Page, expect

from .conftest import choose_plan
from .kept import WAITS
from .picture import on_screen
from .server import Server
from .test_journey import invited


def click_at(page: Page, point: list[float]) -> None:
    """A click on a point of the picture, wherever the picture is on the screen."""
    page.mouse.click(*on_screen(page, point))


def again(page: Page, first: dict[str, Any], dx: float = 0.4) -> None:
    for at in (first["contact"], first["target_point"]):
        click_at(page, [at[0] + dx, at[1] - dx])


def on_frame(page: Page, frame: int) -> Locator:
    return page.get_by_role("application", name=f"Frame {frame}", exact=True)


def back_to(page: Page, measurement_id: int) -> None:
    """By the keys, one row at a time: other tests may have left what stands between."""
    rows = page.locator("[data-measurement]")
    numbers = rows.evaluate_all("rows => rows.map((row) => Number(row.dataset.measurement))")
    current = page.locator("[data-measurement][aria-current=true]")
    at = numbers.index(int(current.get_attribute("data-measurement") or 0))
    to = numbers.index(measurement_id)
    assert to != at
    step = 1 if to > at else -1
    for place in range(at + step, to + step, step):
        page.keyboard.press("j" if step > 0 else "k")
        expect(rows.nth(place)).to_have_attribute("aria-current", "true")


@pytest.fixture
def review(page: Page, browser: Browser, demonstration: Server, survey_id: int) -> Iterator[Page]:
    """Another person's browser; what they clicked again is withdrawn in the end."""
    other = invited(page, browser, demonstration, "Blanca Blind", "reviewer")
    ask = other.request
    yield other.new_page()
    for vehicle in ask.get(f"/api/surveys/{survey_id}/vehicles").json():
        for measurement in vehicle["measurements"]:
            for told in ask.get(f"/api/measurements/{measurement['id']}/repeats").json():
                withdraw(ask, told["repeat"])
    other.close()


def withdraw(ask: APIRequestContext, repeat: dict[str, Any]) -> None:
    if repeat["created_by"]["name"] == "Blanca Blind" and not repeat["withdrawn"]:
        address = f"/api/measurements/{repeat['id']}?revision={repeat['revision']}"
        assert ask.delete(address, headers={"X-Sightline": "1"}).ok


@pytest.mark.usefixtures("kept")
def test_a_second_click_before_the_first_is_shown(page: Page, review: Page, survey_id: int) -> None:
    choose_plan(page, survey_id, 1)
    review.goto(f"/surveys/{survey_id}/review")
    panel = review.get_by_test_id("blind-panel")
    expect(panel).to_be_visible()
    expect(panel).not_to_contain_text(re.compile(r"\d\.\d{3}"))  # no height
    expect(review.get_by_test_id("review-accept")).to_have_count(0)
    expect(review.locator("[aria-current=true]")).to_contain_text("click it again")
    queue = review.request.get(f"/api/surveys/{survey_id}/review-queue").json()
    open_id = int(review.locator("[aria-current=true]").get_attribute("data-measurement") or 0)
    first = next(item["measurement"] for item in queue if item["measurement"]["id"] == open_id)
    expect(review.locator(".frame-loading--on")).to_have_count(0)
    expect(review.locator(".point-mark")).to_have_count(0)
    review.keyboard.press("a")  # nothing to accept yet
    again(review, first)
    words = review.get_by_test_id("comparisons")
    expect(words).to_contain_text("You clicked it again")
    expect(words).to_contain_text(re.compile("Agree: difference .*, limit"))
    known = review.request.get(f"/api/measurements/{open_id}/repeats").json()
    assert known[-1]["repeat"]["created_by"]["name"] == "Blanca Blind"
    expect(review.get_by_test_id("second-clicks").locator(".point-mark")).to_have_count(2 * len(known))
    assert review.request.get(f"/api/measurements/{open_id}").json()["review"]["verdict"] in WAITS
    review.get_by_role("button", name="Accept").click()
    expect(review.locator("[aria-current=true]")).not_to_have_attribute("data-measurement", str(open_id))
    # what cannot be measured (other tests leave such) has nothing to be clicked again
    review.get_by_role("button", name="click it again").first.click()
    expect(panel).to_be_visible()
    expect(panel.get_by_test_id("review-reject")).to_be_visible()
    back_to(review, open_id)  # what was judged can be gone back to
    expect(review.get_by_role("button", name="Reopen it")).to_be_visible()
    choose_plan(page, survey_id, 0)

    before = review.request.get(f"/api/surveys/{survey_id}/repeats").json()["repeats"]
    review.goto(f"/surveys/{survey_id}/repeats")
    expect(review.get_by_test_id("repeats-targets")).to_contain_text("All targets")
    review.get_by_role("link", name="Repeat 10 measurements by anyone").click()
    progress = review.get_by_test_id("again-progress")
    drawn = review.request.get(f"/api/surveys/{survey_id}/repeats/sample?only_own=false").json()
    for n, one in enumerate(drawn[:2]):
        expect(progress).to_contain_text(f"{n + 1} of 10")
        expect(on_frame(review, one["frame"])).to_be_visible()
        expect(review.locator(".frame-loading--on")).to_have_count(0)
        again(review, review.request.get(f"/api/measurements/{one['measurement_id']}").json())
    expect(progress).to_contain_text("3 of 10")
    review.keyboard.press("Control+z")
    expect(progress).to_contain_text("2 of 10")
    review.keyboard.press("Escape")
    expect(review.get_by_role("heading", name="Repeatability")).to_be_visible()
    assert review.request.get(f"/api/surveys/{survey_id}/repeats").json()["repeats"] == before + 1
