"""Ten vehicles in Chromium, each way of measuring one: keys and clicks, and how long the machine takes.

`python -m tests.bench.bench_confirm [data folder of a small demonstration]`. Proposals are put into the table
where the points truly are, once of all three targets, once without the eye, once of the contact alone, once
none (by hand); each without and with make and model, one taken last (a digit) or typed. What a person
adds is told by the keystroke-level model (Card, Moran and Newell 1980) of the keys and clicks that the
bench really sends: a look or decision is M = 1.35 s, a key K = 0.28 s, pointing P = 1.1 s, a press or release
of the button B = 0.1 s. A second figure takes one M for every proposed point that is looked at.
"""

from __future__ import annotations

import shutil
import statistics
import sys
import tempfile
import time
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

from playwright.sync_api import Page, expect, sync_playwright

from tests.browser.conftest import chromium_path, made_once, wait_for_demonstration
from tests.browser.server import Server, start
from tests.browser.vehicles import (
    OwnVehicle,
    click_at,
    own_vehicle,
    put_proposals,
    until,
    whole_passes,
)

VEHICLES = 10
TARGETS = ("roof", "driver_eye", "taillight")
M, K, P, B = 1.35, 0.28, 1.1, 0.1


def main() -> None:
    given = Path(sys.argv[1]) if len(sys.argv) > 1 else None
    with tempfile.TemporaryDirectory() as folder:
        data_dir = Path(folder) / "run"
        shutil.copytree(given or made_once(Path(folder) / "made"), data_dir)
        server = start("demo", data_dir)
        try:
            server.wait(300)
            look(server)
        finally:
            server.stop()


def look(server: Server) -> None:
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=chromium_path(), args=["--no-sandbox", "--disable-gpu"]
        )
        page = browser.new_page(base_url=server.url, viewport={"width": 1440, "height": 900})
        page.goto(server.sign_in_link())
        page.wait_for_url(lambda url: "sign-in" not in url)
        wait_for_demonstration(page)
        for targets in (TARGETS, ("roof", "taillight"), (), None):
            for model in ("", "typed", "taken last"):
                told(*run(page, server, targets, model))
        browser.close()


@dataclass
class Hand:
    """A person's hand in the browser: what it does to one vehicle is counted."""

    page: Page
    keys: int = 0
    clicks: int = 0
    looks: int = 0

    def press(self, *keys: str) -> None:
        for key in keys:
            self.page.keyboard.press(key)
            self.keys += 1 + key.count("+")

    def click(self, at: tuple[float, float]) -> None:
        click_at(self.page, at)
        self.clicks += 1

    def model_s(self, wait_s: float, more_looks: int = 0) -> float:
        """The keystroke-level model's time."""
        return (self.looks + more_looks) * M + self.keys * K + self.clicks * (P + 2 * B) + wait_s


#: Targets that are proposed beside the contact; None: not even that, all is by hand.
Proposed = tuple[str, ...] | None
Run = tuple[Proposed, str, list[Hand], list[float], list[float]]


def run(page: Page, server: Server, targets: Proposed, model: str) -> Run:
    """Of each vehicle what the hand did, seconds until the next one stands, and seconds in all."""
    passes = whole_passes("day")
    ones = [own_vehicle(page, "day", passes[i % len(passes)]) for i in range(VEHICLES + 1)]
    if targets is not None:
        put_proposals(server, ones, targets)
    page.goto(f"/surveys/{ones[0].survey}/measure?vehicle={ones[0].vehicle['id']}")
    hands, waits, all_ = [], [], []
    wait_for(page, ones[0], targets)
    for one, after in pairwise(ones):
        hand, begun = Hand(page), time.perf_counter()
        last_of_all = model == "taken last" and targets is None  # the digit brings the next vehicle with it
        if not last_of_all:
            record(hand, model)
        measure(hand, one, targets)
        if targets is None:
            until(page, one.vehicle["id"], lambda have: set(have) >= set(TARGETS))
            page.locator("#measure-hint").get_by_text("Done").wait_for()  # the page has read it again
            hand.looks += last_of_all
            hand.press("6" if last_of_all else "Enter")
            page.locator(f'[data-vehicle="{one.vehicle["id"]}"]:not([aria-current="true"])').wait_for()
            open_next(page, after)
        last = time.perf_counter()
        wait_for(page, after, targets)
        hands.append(hand)
        waits.append(time.perf_counter() - last)
        all_.append(time.perf_counter() - begun)
        until(page, one.vehicle["id"], lambda have: set(have) >= set(TARGETS))
        if model:
            until_named(page, one)
    return targets, model, hands, waits, all_


def until_named(page: Page, one: OwnVehicle) -> None:
    """Waits until the server has make and model, which the page sends when it leaves a vehicle."""
    end = time.monotonic() + 10
    while True:
        made = page.request.get(f"/api/vehicles/{one.vehicle['id']}").json()
        if (made["make"], made["model"]) == ("Haldmann", "T75"):
            return
        assert time.monotonic() < end, made
        page.wait_for_timeout(50)


def record(hand: Hand, model: str) -> None:
    """Make and model, by a digit or by letters; then the frame has the keys again."""
    if not model:
        return
    hand.looks += 1
    hand.press(*("Shift+C", "h", "a", "l", "d", "Space", "t", "7", "Enter") if model == "typed" else "6")
    expect(hand.page.get_by_label("Model", exact=True)).to_have_value("T75")


def measure(hand: Hand, one: OwnVehicle, targets: Proposed) -> None:
    """All three targets: those proposed by Enter, the rest by clicks."""
    hand.looks += 1
    if targets is None:
        hand.click(one.pixels["contact_rear"])
    else:
        hand.press("Enter")
    hand.looks += not targets  # as before there were proposals: one for the contact, one for the targets
    for target in TARGETS:
        if target in (targets or ()):
            continue
        noun = {"driver_eye": "driver's eye", "taillight": "taillight", "roof": "roof"}[target]
        hand.page.locator("#measure-hint").get_by_text(noun).first.wait_for()
        hand.looks += bool(targets)
        hand.click(one.pixels[target])


def open_next(page: Page, after: OwnVehicle) -> None:
    """By hand the page goes on to the next that waits, which may be another's: the bench's own is opened."""
    if not page.locator(f'[data-vehicle="{after.vehicle["id"]}"][aria-current="true"]').count():
        page.locator(f'[data-vehicle="{after.vehicle["id"]}"]').click()


def wait_for(page: Page, one: OwnVehicle, targets: Proposed) -> None:
    """Until a vehicle is open with its picture, its points and their heights."""
    page.locator(f'[data-vehicle="{one.vehicle["id"]}"][aria-current="true"]').wait_for()
    if targets is not None:
        page.locator('[data-testid="proposed"] button:not([disabled]) kbd', has_text="Enter").wait_for()
    else:
        page.locator("#measure-hint").get_by_text("click where the tyre meets the road").wait_for()


def told(targets: Proposed, model: str, hands: list[Hand], waits: list[float], all_: list[float]) -> None:
    hand, wait = hands[-1], statistics.median(waits)
    way = f"{len(targets)} of 3 targets proposed and right" if targets else "contact proposed and right"
    way = "by hand" if targets is None else way
    print(
        f"{way}, make and model {model or 'not asked for'}, {len(waits)} vehicles: "
        f"{hand.keys} keys and {hand.clicks} clicks a vehicle"
    )
    print(
        f"  in Chromium: the next vehicle stands after {wait:.2f} s (median), {max(waits):.2f} s at most; "
        f"each {', '.join(f'{one:.1f}' for one in all_)} s without looking"
    )
    more = f"; one look a point {hand.model_s(wait, len(targets)):.1f} s" if targets else ""
    print(f"  keystroke-level model: {hand.model_s(wait):.1f} s{more}", flush=True)


if __name__ == "__main__":
    main()
