"""The tour of the demonstration: offered once, walked by keys, skipped, and begun again from the menu."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Page, StorageState, expect

from .server import Server
from .test_screens import AXE, look_at, places, settle

__all__ = ["places"]  # a fixture of every screen's

STEPS = 7


@pytest.fixture(params=[pytest.param("en-GB", marks=pytest.mark.proof), "fr-FR"])
def page(
    request: pytest.FixtureRequest, browser: Browser, demonstration: Server, admin_state: StorageState
) -> Iterator[Page]:
    """A signed-in page of somebody who has not seen the tour in this browser, without the CSP that keeps axe
    out.
    """
    context = browser.new_context(
        base_url=demonstration.url,
        viewport={"width": 1440, "height": 900},
        storage_state=admin_state,
        locale=request.param,
        bypass_csp=True,
        reduced_motion="reduce",
    )
    context.add_init_script(path=AXE)
    yield context.new_page()
    context.close()


def test_the_tour_is_walked_by_keys_and_offered_once(
    page: Page, places: dict[str, int], screenshots: Path
) -> None:
    overview = f"/surveys/{places['survey']}"
    page.goto(overview)
    offered = page.get_by_role("button", name="Faire la visite").or_(page.get_by_text("Take the tour"))
    take = offered.inner_text()
    french = take == "Faire la visite"
    again = "Visite de la démonstration" if french else "Tour of the demonstration"
    page.get_by_role("button", name=take, exact=True).press("Enter")
    panel = page.locator(".tour")
    seen = []
    for step in range(1, STEPS + 1):
        expect(panel.locator("h2")).to_contain_text(f"{step} sur 7" if french else f"{step} of 7")
        expect(panel.locator("h2")).to_be_focused()
        settle(page)
        assert look_at(page, f"tour-{step}", "fr" if french else "en", screenshots) == []
        seen.append((page.url, panel.locator("p").inner_text()))
        # from the words that are read out, the last button of the panel goes on
        for _ in range(panel.get_by_role("button").count()):
            page.keyboard.press("Tab")
        if step < STEPS:
            page.keyboard.press("Enter")
    assert len({url for url, _ in seen}) == len({words for _, words in seen}) == STEPS
    page.keyboard.press("Enter")
    expect(panel).to_have_count(0)
    page.goto(overview)
    expect(page.locator("main h1")).to_be_visible()
    settle(page)
    expect(page.get_by_role("button", name=take, exact=True)).to_have_count(0)
    page.locator(".topbar__person").click()
    page.get_by_role("button", name=again, exact=True).click()
    expect(panel.locator("h2")).to_be_focused()
    page.keyboard.press("Escape")
    expect(panel).to_have_count(0)


def test_who_does_not_want_it_is_not_asked_again(page: Page, places: dict[str, int]) -> None:
    page.goto(f"/surveys/{places['survey']}")
    offer = page.get_by_role("button", name="Plus tard").or_(page.get_by_role("button", name="Not now"))
    offer.click()
    expect(offer).to_have_count(0)
    page.reload()
    expect(page.locator("main h1")).to_be_visible()
    expect(offer).to_have_count(0)
