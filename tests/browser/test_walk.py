"""What is chosen by a menu or within a page is in its address: Back, Forward and a reload show the same."""

import re

from playwright.sync_api import BrowserContext

from .walking import arrived, begin, same, shown, walking


def test_menus_of_the_bar_lead_where_a_reload_stays(context: BrowserContext) -> None:
    with walking(context) as walker:
        survey = begin(walker)
        ways = [("/", ": account", name) for name in ("Account", "Users", "Audit trail")]
        ways += [
            (f"/surveys/{survey}/measure", "go to another step", name) for name in ("Review", "Validation")
        ]
        for here, menu, name in ways:
            walker.goto(here)
            start = shown(walker)
            walker.get_by_role("button", name=re.compile(menu)).click()
            walker.locator(".menu__item").get_by_text(name, exact=True).click()
            there = arrived(walker, start)
            walker.go_back()
            same(walker, arrived(walker, there), start, f"back from {name}")
            walker.go_forward()
            same(walker, arrived(walker, start), there, f"forward to {name}")
            walker.reload()
            same(walker, shown(walker), there, f"reload of {name}")


def test_what_is_chosen_within_a_page_is_in_its_address(context: BrowserContext) -> None:
    """Each measured vehicle, each vehicle of the line scan, the tabs and the review's queue."""
    with walking(context) as walker:
        survey = begin(walker)
        vehicles = walker.request.get(f"/api/surveys/{survey}/vehicles").json()
        measured = [one["number"] for one in vehicles if one["measurements"]]
        scan = walker.request.get(f"/api/surveys/{survey}/scans").json()[0]["id"]
        passed = walker.request.get(f"/api/scans/{scan}/vehicles").json()
        assert measured and passed
        choices = {
            "measure": [f"[data-testid=pass-{number}]" for number in measured],
            f"scan?scan={scan}": [f"[data-testid=scan-vehicle-{one['number']}] button" for one in passed],
            "checks": ['.page__head label:has-text("Road alignment")'],
            "planning": ['.page__head label:has-text("line scan")'],
            "review": ["[data-measurement]:not([aria-current])"],
        }
        for name, chosen in choices.items():
            walker.goto(f"/surveys/{survey}/{name}")
            shown(walker)
            for one in chosen:
                walker.locator(one).first.click()
                there = shown(walker)
                walker.reload()
                same(walker, shown(walker), there, f"reload of {one}")
