"""The statistics page in Chromium: `python tests/bench/bench_statistics_page.py [COUNT ...]`, seconds.

Until the table and the first two figures, all that is in view, are drawn, in a browser that has the app's
code; on a SQLite of its own. Cold: from the click on the survey's link, when the server has never counted
it; the others: from opening the address.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from playwright.sync_api import Browser, Page

from backend.settings import Settings
from backend.storage import database
from tests.bench.seed import seed
from tests.bench.web_ground import chromium, serving, sign_in_link

GOALS_S = {100_000: 1.0, 1_000_000: 5.0}
READY = "[data-testid^=figure-] svg"
FIGURES = 2
SEEDED = "olga@example.org"  # one of the people whom the seed brings


def signed_in(browser: Browser, url: str, folder: Path) -> Page:
    """A page that has been opened before, when nothing was there to count."""
    page = browser.new_context(base_url=url, viewport={"width": 1440, "height": 900}).new_page()
    page.goto(sign_in_link(folder, SEEDED))
    page.wait_for_url(lambda address: "sign-in" not in address)
    page.goto("/statistics?last_day=2000-01-01")
    page.get_by_test_id("stat-counted").get_by_text("0 measurements").wait_for()
    return page


def opened(page: Page, path: str) -> float:
    """Seconds from opening the address in the browser to its figures."""
    begun = time.perf_counter()
    page.goto(path, wait_until="commit")
    page.locator(READY).nth(FIGURES - 1).wait_for(timeout=120_000)
    return time.perf_counter() - begun


def clicked(page: Page, survey_id: int) -> float:
    """Seconds from the click on a survey's link to its figures."""
    page.goto(f"/surveys/{survey_id}", wait_until="networkidle")
    link = page.get_by_role("link", name="Statistics").first
    begun = time.perf_counter()
    link.click()
    page.locator(READY).nth(FIGURES - 1).wait_for(timeout=120_000)
    return time.perf_counter() - begun


def measure(count: int, browser: Browser) -> None:
    with tempfile.TemporaryDirectory(prefix="sightline-bench-") as name:
        folder = Path(name)
        engine = database.make_engine(Settings(data_dir=folder).database_url)
        database.migrate(engine)
        survey_id = seed(database.session_factory(engine), count).survey.id
        engine.dispose()
        with serving("serve", folder) as server:
            page = signed_in(browser, server.url, folder)
            path = f"/statistics?survey={survey_id}"
            cold = clicked(page, survey_id)
            filtered = opened(page, f"{path}&lighting=daytime")
            again = opened(page, path)
            page.context.close()
    print(
        f"{count} measurements: cold {cold:.2f} s (asked {GOALS_S.get(count, 0):.0f}), "
        f"another filter {filtered:.2f} s, the same again {again:.2f} s; load {os.getloadavg()[0]:.1f}",
        flush=True,
    )


def main(counts: list[int]) -> int:
    with chromium() as browser:
        for count in counts:
            measure(count, browser)
    return 0


if __name__ == "__main__":
    sys.exit(main([int(word) for word in sys.argv[1:]] or list(GOALS_S)))
