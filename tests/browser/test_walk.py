"""What is chosen by a menu or within a page is in its address: Back, Forward and a reload show the same."""

import re
from collections.abc import Callable

import pytest
from playwright.sync_api import BrowserContext, Page

from .walking import begin, same, shown, there_and_back, walking


def test_menus_of_the_bar_lead_where_a_reload_stays(context: BrowserContext) -> None:
    with walking(context) as walker:
        survey = begin(walker)
        in_survey = f"/surveys/{survey}/measure"
        ways = {
            ("/", ": account"): ("Account",),
            ("/", "^Admin$"): ("People", "Audit"),
            (in_survey, "go to another step"): ("Review", "Checks"),
        }
        for (here, menu), names in ways.items():
            walker.goto(here)
            start = shown(walker, twice=True)
            for name in names:
                there_and_back(walker, start, chosen(walker, menu, name), name)


def chosen(walker: Page, menu: str, name: str) -> Callable[[], None]:
    def choose() -> None:
        walker.get_by_role("button", name=re.compile(menu)).click()
        walker.locator(".menu__item").get_by_text(name, exact=True).click()

    return choose


@pytest.mark.parametrize("of_each", [1, pytest.param(None, marks=pytest.mark.proof)], ids=["one", "all"])
def test_what_is_chosen_within_a_page_is_in_its_address(context: BrowserContext, of_each: int | None) -> None:
    """Of measured vehicles and of the line scan's one, or all; the tabs and the review's queue."""
    with walking(context) as walker:
        survey = begin(walker)
        vehicles = walker.request.get(f"/api/surveys/{survey}/vehicles").json()
        measured = [one["number"] for one in vehicles if one["measurements"]]
        scan = walker.request.get(f"/api/surveys/{survey}/scans").json()[0]["id"]
        passed = walker.request.get(f"/api/scans/{scan}/vehicles").json()
        assert measured and passed
        choices = {
            "measure": [f"[data-testid=pass-{number}]" for number in measured[:of_each]],
            f"scan?scan={scan}": [
                f"[data-testid=scan-vehicle-{one['number']}] button" for one in passed[:of_each]
            ],
            "checks": ['.page-tabs a:has-text("Direction")'],
            "planning": ['.page__head label:has-text("line scan")'],
            "review": ["[data-measurement]:not([aria-current])"],
        }
        for name, of_page in choices.items():
            walker.goto(f"/surveys/{survey}/{name}")
            shown(walker)
            for one in of_page:
                walker.locator(one).first.click()
                there = shown(walker, twice=True)
                walker.reload()
                same(walker, shown(walker), there, f"reload of {one}")
