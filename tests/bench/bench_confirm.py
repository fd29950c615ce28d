"""The confirm loop for ten vehicles in Chromium: keys and clicks of each, and how long the machine takes.

`python -m tests.bench.bench_confirm [data folder of a small demonstration]`. Proposals are put into the table
where the points truly are, once of all three targets, once as they are made today (no eye). What a person
adds is told by the keystroke-level model (Card, Moran and Newell 1980): a look is M = 1.35 s, a key
K = 0.28 s, pointing P = 1.1 s, a button B = 0.1 s; a second figure takes one M for every point looked at.
"""

from __future__ import annotations

import shutil
import statistics
import sys
import tempfile
import time
from itertools import pairwise
from pathlib import Path

from playwright.sync_api import Page, sync_playwright

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
        for targets in (("roof", "driver_eye", "taillight"), ("roof", "taillight")):
            told(targets, run(page, server, targets))
        browser.close()


def run(page: Page, server: Server, targets: tuple[str, ...]) -> list[float]:
    """Seconds from the last key or click on a vehicle to the next one's points and heights, of each."""
    passes = whole_passes(server, "day")
    ones = [own_vehicle(page, server, "day", passes[i % len(passes)]) for i in range(VEHICLES + 1)]
    put_proposals(server, ones, targets)
    page.goto(f"/surveys/{ones[0].survey}/measure?vehicle={ones[0].vehicle['id']}")
    waits: list[float] = []
    wait_for(page, ones[0])
    for one, after in pairwise(ones):
        page.keyboard.press("Enter")
        if "driver_eye" not in targets:
            page.locator("#measure-hint").get_by_text("driver's eye").first.wait_for()
            click_at(page, one.pixels["driver_eye"])
        begun = time.perf_counter()
        wait_for(page, after)
        waits.append(time.perf_counter() - begun)
        until(page, one.vehicle["id"], lambda have: set(have) >= {"roof", "driver_eye", "taillight"})
    return waits


def wait_for(page: Page, one: OwnVehicle) -> None:
    """Until a vehicle is open with its picture, its points and their heights."""
    page.locator(f'[data-vehicle="{one.vehicle["id"]}"][aria-current="true"]').wait_for()
    page.locator('[data-testid="proposed"] button:not([disabled]) kbd', has_text="Enter").wait_for()


def told(targets: tuple[str, ...], waits: list[float]) -> None:
    by_hand = len({"roof", "driver_eye", "taillight"} - set(targets))
    looks = len(targets) + 1
    wait = statistics.median(waits)
    hand = by_hand * (M + P + 2 * B)
    print(
        f"{len(targets)} of 3 targets proposed and right, {len(waits)} vehicles: "
        f"{1 + by_hand} keys and clicks a vehicle"
    )
    print(f"  waiting for the next vehicle: median {wait:.2f} s, longest {max(waits):.2f} s")
    print(
        f"  keystroke-level model, one look a vehicle: {M + K + hand + wait:.1f} s; "
        f"one look a point: {looks * M + K + hand + wait:.1f} s"
    )


if __name__ == "__main__":
    main()
